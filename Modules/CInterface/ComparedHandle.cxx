#include "ComparedHandle.h"

#include "BodyComparison.h"
#include "ErrorText.h"
#include "GridArgument.h"
#include "ModelHandle.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr double None = std::numeric_limits<double>::quiet_NaN();

// Messages of kernels are sentences, or begin with what the body has or is.
palpate_compared* Compared(const Status& status, const std::string& name, ComparedBody&& body,
                           palpate_error* error)
{
  const std::string& message = status.Message();
  const bool isPredicate =
      !message.empty() && std::islower(static_cast<unsigned char>(message.front())) != 0;
  const Status named = isPredicate ? Status::Failure(name + " " + message) : status;
  return Told(named, error) != 0 ? new palpate_compared{std::move(body)} : nullptr;
}

palpate_distances DistancesOf(const DistanceSummary& summary, double signedMean)
{
  return {summary.Mean, summary.Rms, summary.Percentile95, summary.Largest, signedMean};
}

palpate_comparison ComparisonOf(const ComparedBody& first, const ComparedBody& reference,
                                const BodyComparison& found)
{
  palpate_comparison comparison{};
  comparison.dice = found.Overlap ? found.Overlap->Dice() : None;
  comparison.jaccard = found.Overlap ? found.Overlap->Jaccard() : None;
  comparison.volumes[0] = first.Volume();
  comparison.volumes[1] = reference.Volume();
  comparison.areas[0] = first.Area();
  comparison.areas[1] = reference.Area();
  comparison.both = DistancesOf(found.Both, None);
  comparison.to_reference = DistancesOf(found.OneToOther.Unsigned, found.OneToOther.SignedMean);
  comparison.to_first = DistancesOf(found.OtherToOne.Unsigned, found.OtherToOne.SignedMean);
  comparison.hausdorff95 = found.Hausdorff95();
  for (std::size_t side = 0; side < 6; ++side)
  {
    comparison.side_bias[side] = found.Bias ? found.Bias->Sides[side].Mean : None;
  }
  return comparison;
}

void CopyValues(const DistanceMap& map, double* distances)
{
  if (distances != nullptr)
  {
    std::copy(map.Values.begin(), map.Values.end(), distances);
  }
}
} // namespace
} // namespace palpate

using namespace palpate;

palpate_compared* palpate_compared_of_mask(const uint8_t* inside, const int size[3],
                                           const double origin[3], const double spacing[3],
                                           const double axes[9], palpate_error* error)
{
  return Guarded(error,
                 {{inside, "inside"},
                  {size, "size"},
                  {origin, "origin"},
                  {spacing, "spacing"},
                  {axes, "axes"}},
                 [&]() -> palpate_compared*
                 {
                   IndexToWorld toWorld;
                   const Status placed = PlaceGrid(size, origin, spacing, axes, toWorld);
                   if (Told(placed, error) == 0)
                   {
                     return nullptr;
                   }
                   ComparedBody body;
                   const Status status =
                       ComparedBody::OfMask(CroppedMask(inside, size, spacing), toWorld, body);
                   return Compared(status, "the mask", std::move(body), error);
                 });
}

palpate_compared* palpate_compared_of_mesh(const double* points, size_t point_count,
                                           const int32_t* triangles, size_t triangle_count,
                                           palpate_error* error)
{
  return Guarded(error, {{points, "points", point_count}, {triangles, "triangles", triangle_count}},
                 [&]
                 {
                   IndexedMesh mesh;
                   for (std::size_t i = 0; i < point_count; ++i)
                   {
                     mesh.Points.push_back(VectorOf(points + 3 * i));
                   }
                   for (std::size_t i = 0; i < triangle_count; ++i)
                   {
                     const int32_t* corners = triangles + 3 * i;
                     mesh.Triangles.push_back({corners[0], corners[1], corners[2]});
                   }
                   ComparedBody body;
                   const Status status = ComparedBody::OfMesh(std::move(mesh), body);
                   return Compared(status, "the mesh", std::move(body), error);
                 });
}

palpate_compared* palpate_compared_of_model(const palpate_model* model, palpate_error* error)
{
  return Guarded(error, {{model, "model"}},
                 [&]
                 {
                   ComparedBody body;
                   const Status status = ComparedBody::OfModel(model->Document.Surface, body);
                   return Compared(status, "the model", std::move(body), error);
                 });
}

void palpate_compared_free(palpate_compared* body)
{
  delete body;
}

size_t palpate_compared_point_count(const palpate_compared* body)
{
  return body != nullptr ? body->Body.Surface().Points.size() : 0;
}

size_t palpate_compared_triangle_count(const palpate_compared* body)
{
  return body != nullptr ? body->Body.Surface().Triangles.size() : 0;
}

void palpate_compared_surface(const palpate_compared* body, double* points, int32_t* triangles)
{
  if (!AreGiven({{body, "body"}, {points, "points"}, {triangles, "triangles"}}, nullptr))
  {
    return;
  }
  for (const Vector3& point : body->Body.Surface().Points)
  {
    Copy(point, points);
    points += 3;
  }
  for (const std::array<int, 3>& corners : body->Body.Surface().Triangles)
  {
    triangles = std::copy(corners.begin(), corners.end(), triangles);
  }
}

int palpate_compare(const palpate_compared* first, const palpate_compared* reference,
                    const double* tolerances, size_t tolerance_count,
                    palpate_comparison* comparison, double* surface_dice, double* first_distances,
                    double* reference_distances, palpate_error* error)
{
  return Guarded(
      error,
      {{first, "first"},
       {reference, "reference"},
       {tolerances, "tolerances", tolerance_count},
       {comparison, "comparison"},
       {surface_dice, "surface_dice", tolerance_count}},
      [&]
      {
        const std::vector<double> limits(tolerances, tolerances + tolerance_count);
        if (!std::all_of(limits.begin(), limits.end(),
                         [](double limit) { return std::isfinite(limit) && limit >= 0.0; }))
        {
          SetError(error, "a tolerance is negative or not finite");
          return 0;
        }
        BodyComparison found;
        if (Told(CompareBodies(first->Body, reference->Body, limits, {}, found), error) == 0)
        {
          return 0;
        }
        *comparison = ComparisonOf(first->Body, reference->Body, found);
        for (std::size_t i = 0; i < limits.size(); ++i)
        {
          surface_dice[i] = found.Tolerances[i].SurfaceDice;
        }
        CopyValues(found.OneToOther, first_distances);
        CopyValues(found.OtherToOne, reference_distances);
        return 1;
      });
}
