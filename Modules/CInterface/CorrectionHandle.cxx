#include "CorrectionHandle.h"

#include "ErrorText.h"
#include "GridArgument.h"
#include "IcosahedronDirections.h"
#include "MaskEdits.h"
#include "ModelHandle.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr int PulledFrequency = 24;

SurfacePull PullOf(const palpate_pull& given)
{
  SurfacePull pull{VectorOf(given.place), given.displacement, {}, given.width, given.second_width};
  if (given.has_target != 0)
  {
    pull.TargetWorld = VectorOf(given.target);
  }
  return pull;
}

int EditMask(palpate_correction* correction, const CorrectionStep& step, palpate_error* error)
{
  return Guarded(error, {{correction, "correction"}},
                 [&]
                 {
                   if (correction->Mask == nullptr)
                   {
                     SetError(error, "a model has no voxels to edit; pull its surface");
                     return 0;
                   }
                   return Told(correction->Mask->Apply(step), error);
                 });
}

// What is pulled, whichever it is.
Status PullsOf(palpate_correction& correction, const SurfaceCorrection*& pulls)
{
  pulls = &correction.Pulls;
  const MaskCorrection* surface = nullptr;
  return correction.Mask != nullptr ? correction.Mask->Surface(surface, pulls) : Status::Success();
}

std::vector<std::array<int, 3>> TrianglesOf(palpate_correction& correction)
{
  const MaskCorrection* surface = nullptr;
  const SurfaceCorrection* pulls = nullptr;
  if (correction.Mask != nullptr && correction.Mask->Surface(surface, pulls).IsOk())
  {
    return surface->Surface().Triangles;
  }
  return IcosahedronDirections(PulledFrequency).Triangles();
}

void CopyAll(const std::vector<Vector3>& vectors, double* numbers)
{
  for (std::size_t n = 0; n < vectors.size() && numbers != nullptr; ++n)
  {
    Copy(vectors[n], numbers + 3 * n);
  }
}
} // namespace
} // namespace palpate

using namespace palpate;

palpate_correction* palpate_correction_of_model(const palpate_model* model, palpate_error* error)
{
  return Guarded(
      error, {{model, "model"}},
      [&]
      {
        const OrganModel& start = model->Document.Surface;
        return new palpate_correction{nullptr, start, StartOfModel(start, PulledFrequency), {}};
      });
}

palpate_correction* palpate_correction_of_mask(const uint8_t* inside, const uint8_t* barrier,
                                               const int size[3], const double origin[3],
                                               const double spacing[3], const double axes[9],
                                               palpate_error* error)
{
  return Guarded(
      error,
      {{inside, "inside"},
       {size, "size"},
       {origin, "origin"},
       {spacing, "spacing"},
       {axes, "axes"}},
      [&]() -> palpate_correction*
      {
        IndexToWorld toWorld;
        if (Told(PlaceGrid(size, origin, spacing, axes, toWorld), error) == 0)
        {
          return nullptr;
        }
        VoxelMask mask = CroppedMask(inside, size, spacing);
        if (mask.Inside.empty())
        {
          SetError(error, "the mask has no voxels");
          return nullptr;
        }
        const std::array<int, 3> of{size[0], size[1], size[2]};
        MaskCorrection::Barrier closed;
        if (barrier != nullptr)
        {
          const auto row = static_cast<std::size_t>(size[0]);
          const auto slice = row * static_cast<std::size_t>(size[1]);
          closed = [=, voxels = std::vector<uint8_t>(
                           barrier, barrier + slice * static_cast<std::size_t>(size[2]))](
                       const std::array<int, 3>& at)
          {
            return voxels[static_cast<std::size_t>(at[2]) * slice +
                          static_cast<std::size_t>(at[1]) * row +
                          static_cast<std::size_t>(at[0])] != 0;
          };
        }
        return new palpate_correction{
            std::make_unique<CorrectedMask>(std::move(mask), toWorld, of, std::move(closed)),
            {},
            {},
            of};
      });
}

void palpate_correction_free(palpate_correction* correction)
{
  delete correction;
}

int palpate_correction_pull(palpate_correction* correction, const palpate_pull* pull,
                            palpate_error* error)
{
  return Guarded(error, {{correction, "correction"}, {pull, "pull"}},
                 [&]
                 {
                   return Told(correction->Mask != nullptr ? correction->Mask->Apply(PullOf(*pull))
                                                           : correction->Pulls.Pull(PullOf(*pull)),
                               error);
                 });
}

int palpate_correction_preview(palpate_correction* correction, const palpate_pull* pull,
                               double* displacements, palpate_error* error)
{
  return Guarded(error,
                 {{correction, "correction"}, {pull, "pull"}, {displacements, "displacements"}},
                 [&]
                 {
                   const SurfaceCorrection* pulls = nullptr;
                   Eigen::Matrix3Xd found;
                   if (Told(PullsOf(*correction, pulls), error) == 0 ||
                       Told(pulls->Preview(PullOf(*pull), found), error) == 0)
                   {
                     return 0;
                   }
                   std::copy_n(found.data(), found.size(), displacements);
                   return 1;
                 });
}

int palpate_correction_remove_islands(palpate_correction* correction, palpate_error* error)
{
  return EditMask(correction, IslandRemoval{}, error);
}

int palpate_correction_fill(palpate_correction* correction, palpate_error* error)
{
  return EditMask(correction, CavityFilling{}, error);
}

int palpate_correction_smooth(palpate_correction* correction, double deviation,
                              palpate_error* error)
{
  return EditMask(correction, SurfaceSmoothing{deviation}, error);
}

int palpate_correction_cut(palpate_correction* correction, const double point[3],
                           const double normal[3], palpate_error* error)
{
  return AreGiven({{point, "point"}, {normal, "normal"}}, error)
             ? EditMask(correction, PlaneCut{VectorOf(point), VectorOf(normal)}, error)
             : 0;
}

int palpate_correction_undo(palpate_correction* correction)
{
  if (correction == nullptr)
  {
    return 0;
  }
  if (correction->Mask != nullptr)
  {
    return correction->Mask->Undo() ? 1 : 0;
  }
  const int had = correction->Pulls.Pulls().empty() ? 0 : 1;
  correction->Pulls.Undo();
  return had;
}

int palpate_correction_surface(palpate_correction* correction, size_t* point_count,
                               size_t* triangle_count, double* points, double* normals,
                               double* displacements, int32_t* triangles, palpate_error* error)
{
  return Guarded(error,
                 {{correction, "correction"},
                  {point_count, "point_count"},
                  {triangle_count, "triangle_count"}},
                 [&]
                 {
                   const SurfaceCorrection* pulls = nullptr;
                   if (Told(PullsOf(*correction, pulls), error) == 0)
                   {
                     return 0;
                   }
                   const std::vector<std::array<int, 3>> faces = TrianglesOf(*correction);
                   *point_count = pulls->Points().size();
                   *triangle_count = faces.size();
                   CopyAll(pulls->Points(), points);
                   CopyAll(pulls->Directions(), normals);
                   if (displacements != nullptr)
                   {
                     std::copy_n(pulls->Displacements().data(), pulls->Displacements().size(),
                                 displacements);
                   }
                   for (std::size_t n = 0; n < faces.size() && triangles != nullptr; ++n)
                   {
                     std::copy(faces[n].begin(), faces[n].end(), triangles + 3 * n);
                   }
                   return 1;
                 });
}

int palpate_correction_mask(palpate_correction* correction, uint8_t* inside, palpate_error* error)
{
  return Guarded(error, {{correction, "correction"}, {inside, "inside"}},
                 [&]
                 {
                   if (correction->Mask == nullptr)
                   {
                     SetError(error, "a corrected model has no mask");
                     return 0;
                   }
                   const VoxelMask& mask = correction->Mask->Mask();
                   std::size_t at = 0;
                   for (int k = 0; k < correction->Size[2]; ++k)
                   {
                     for (int j = 0; j < correction->Size[1]; ++j)
                     {
                       for (int i = 0; i < correction->Size[0]; ++i, ++at)
                       {
                         inside[at] = HasVoxel(mask, {i, j, k}) ? 1 : 0;
                       }
                     }
                   }
                   return 1;
                 });
}

palpate_model* palpate_correction_model(palpate_correction* correction, palpate_error* error)
{
  return Guarded(error, {{correction, "correction"}},
                 [&]() -> palpate_model*
                 {
                   if (correction->Mask != nullptr)
                   {
                     SetError(error, "a corrected mask has no model; fit one to it");
                     return nullptr;
                   }
                   OrganModel made;
                   const Status status =
                       ModelCorrection::Apply(correction->Start, correction->Pulls, made);
                   return Told(status, error) != 0
                              ? new palpate_model({std::move(made), {}, nullptr})
                              : nullptr;
                 });
}
