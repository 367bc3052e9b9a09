#include "ComparedHandle.h"

#include "BodyComparison.h"
#include "BodyMotion.h"
#include "BodyRelation.h"
#include "ErrorText.h"
#include "GridArgument.h"
#include "LocalThickness.h"
#include "MirroredBody.h"
#include "ModelHandle.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
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
                           palpate_error* error, SpreadOf spread = SpreadOf::VoxelCenters)
{
  const std::string& message = status.Message();
  const bool isPredicate =
      !message.empty() && std::islower(static_cast<unsigned char>(message.front())) != 0;
  const Status named = isPredicate ? Status::Failure(name + " " + message) : status;
  if (Told(named, error) == 0)
  {
    return nullptr;
  }
  auto made = std::make_unique<palpate_compared>();
  made->Body = std::move(body);
  made->Spread = spread;
  return made.release();
}

// A mask on a grid, as the interface has it.
struct MaskArgument
{
  const uint8_t* Inside;
  const int* Size;
  const double* Origin;
  const double* Spacing;
  const double* Axes;
};

palpate_compared* MaskOf(const MaskArgument& mask,
                         Status (*make)(VoxelMask, const IndexToWorld&, ComparedBody&),
                         SpreadOf spread, palpate_error* error)
{
  return Guarded(error,
                 {{mask.Inside, "inside"},
                  {mask.Size, "size"},
                  {mask.Origin, "origin"},
                  {mask.Spacing, "spacing"},
                  {mask.Axes, "axes"}},
                 [&]() -> palpate_compared*
                 {
                   IndexToWorld toWorld;
                   const Status placed =
                       PlaceGrid(mask.Size, mask.Origin, mask.Spacing, mask.Axes, toWorld);
                   if (Told(placed, error) == 0)
                   {
                     return nullptr;
                   }
                   ComparedBody body;
                   const Status status =
                       make(CroppedMask(mask.Inside, mask.Size, mask.Spacing), toWorld, body);
                   return Compared(status, "the mask", std::move(body), error, spread);
                 });
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

constexpr std::size_t FeatureCount = 20; // the first members of palpate_shape

// Null, with the error set, of a body that has no inside.
std::shared_ptr<const RelatedBody> RelatedOf(const palpate_compared& body, const char* name,
                                             palpate_error* error)
{
  const std::scoped_lock lock(body.Making);
  if (body.Related == nullptr)
  {
    RelatedBody made;
    if (const Status status = RelatedBody::Make(body.Body, body.Spread, made); !status.IsOk())
    {
      Told(Status::Failure(std::string(name) + " " + status.Message()), error);
      return nullptr;
    }
    body.Related = std::make_shared<const RelatedBody>(std::move(made));
  }
  return body.Related;
}

void CopyShape(const RelatedBody& body, const std::vector<ShapeFeature>& features,
               palpate_shape& shape)
{
  double* number = &shape.volume;
  for (const ShapeFeature& feature : features)
  {
    *number++ = feature.Value;
  }
  Copy(body.Spread().Mean, shape.centroid);
  const Matrix3 axes = body.Spread().Axes();
  for (int axis = 0; axis < 3; ++axis)
  {
    Copy(axes.col(axis), shape.axes + 3 * axis);
  }
}

int CopyThickness(const palpate_compared* body, ThicknessRule rule, double* thickness,
                  palpate_error* error)
{
  return Guarded(
      error, {{body, "body"}, {thickness, "thickness"}},
      [&]
      {
        if (RelatedOf(*body, "the body", error) == nullptr)
        {
          return 0;
        }
        const PlacedMask* mask = body->Body.Mask();
        ThicknessSettings settings =
            mask != nullptr ? ThicknessSettings::OfVoxels(mask->ToWorld.Axes) : ThicknessSettings();
        settings.Rule = rule;
        const std::vector<double> found = LocalThicknessOf(body->Body.Surface(), settings);
        std::copy(found.begin(), found.end(), thickness);
        return 1;
      });
}

// Null, with the error set, of a body that is no tube.
std::shared_ptr<const Calibre> TubeOf(const palpate_compared& body, palpate_error* error)
{
  const auto related = RelatedOf(body, "the body", error);
  const std::scoped_lock lock(body.Making);
  if (related != nullptr && body.Tube == nullptr)
  {
    Calibre made;
    if (const Status status = MeasureCalibre(related->Samples(), made); !status.IsOk())
    {
      Told(Status::Failure("the body " + status.Message()), error);
      return nullptr;
    }
    body.Tube = std::make_shared<const Calibre>(std::move(made));
  }
  return related != nullptr ? body.Tube : nullptr;
}

palpate_section SectionOf(const CalibreSection& from)
{
  palpate_section section{from.Along, {}, {}, from.Area, from.Least, from.Largest};
  Copy(from.Center, section.center);
  Copy(from.Axis, section.axis);
  return section;
}

palpate_relation RelationOf(const BodyRelation& found)
{
  palpate_relation relation{};
  relation.kind = static_cast<int>(found.Is);
  relation.distance = found.Distance();
  relation.wall = found.Wall.Distance;
  Copy(found.Wall.PointOfOne, relation.first_point);
  Copy(found.Wall.PointOfOther, relation.second_point);
  relation.shared_volume = found.SharedVolume;
  relation.contact_areas[0] = found.One.ContactArea;
  relation.contact_areas[1] = found.Other.ContactArea;
  Copy(found.Offset, relation.offset);
  relation.axes_angle = found.AxesAngle;
  return relation;
}

bool AreMargins(double contact, const std::vector<double>& margins)
{
  const auto isGood = [](double margin) { return std::isfinite(margin) && margin >= 0.0; };
  return isGood(contact) && std::all_of(margins.begin(), margins.end(), isGood) &&
         std::is_sorted(margins.begin(), margins.end());
}
} // namespace
} // namespace palpate

using namespace palpate;

palpate_compared* palpate_compared_of_mask(const uint8_t* inside, const int size[3],
                                           const double origin[3], const double spacing[3],
                                           const double axes[9], palpate_error* error)
{
  return MaskOf({inside, size, origin, spacing, axes}, ComparedBody::OfMask, SpreadOf::VoxelCenters,
                error);
}

palpate_compared* palpate_compared_of_mask_shape(const uint8_t* inside, const int size[3],
                                                 const double origin[3], const double spacing[3],
                                                 const double axes[9], palpate_error* error)
{
  return MaskOf({inside, size, origin, spacing, axes}, ComparedBody::OfMaskShape, SpreadOf::Inside,
                error);
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

void palpate_compared_measure(const palpate_compared* body, double* volume, double* area)
{
  if (AreGiven({{body, "body"}, {volume, "volume"}, {area, "area"}}, nullptr))
  {
    *volume = body->Body.Volume();
    *area = body->Body.Area();
  }
}

palpate_compared* palpate_compared_mirror(const palpate_compared* body,
                                          const palpate_compared* onto, double* turn,
                                          double shift[3], palpate_error* error)
{
  return Guarded(error, {{body, "body"}, {onto, "onto"}, {turn, "turn"}, {shift, "shift"}},
                 [&]
                 {
                   ComparedBody mirrored = body->Body;
                   MirrorMatch match;
                   const Status status = MirrorOnto(onto->Body, {}, mirrored, match);
                   palpate_compared* const made =
                       Compared(status, "the mirror image", std::move(mirrored), error);
                   if (made != nullptr)
                   {
                     *turn = match.Turn;
                     Copy(match.Shift, shift);
                   }
                   return made;
                 });
}

int palpate_compared_motion(const palpate_compared* from, const palpate_compared* to,
                            const double* landmarks, size_t landmark_count, palpate_motion* motion,
                            double* moved, palpate_error* error)
{
  return Guarded(error,
                 {{from, "from"},
                  {to, "to"},
                  {landmarks, "landmarks", landmark_count},
                  {motion, "motion"},
                  {moved, "moved", landmark_count}},
                 [&]
                 {
                   std::vector<Vector3> places;
                   for (std::size_t i = 0; i < landmark_count; ++i)
                   {
                     places.push_back(VectorOf(landmarks + 3 * i));
                   }
                   BodyMotion found;
                   if (const Status status =
                           FindBodyMotion(from->Body, to->Body, places, {}, found);
                       !status.IsOk())
                   {
                     SetError(error, "the body " + status.Message());
                     return 0;
                   }
                   *motion = {found.Turn, {}, found.Rest};
                   Copy(found.Shift, motion->shift);
                   for (const Vector3& landmark : found.Landmarks)
                   {
                     Copy(landmark, moved);
                     moved += 3;
                   }
                   return 1;
                 });
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

int palpate_compared_shape(const palpate_compared* body, palpate_shape* shape, palpate_error* error)
{
  return Guarded(error, {{body, "body"}, {shape, "shape"}},
                 [&]
                 {
                   const auto related = RelatedOf(*body, "the body", error);
                   std::vector<ShapeFeature> features;
                   if (related == nullptr || Told(related->Features(features), error) == 0)
                   {
                     return 0;
                   }
                   static_assert(offsetof(palpate_shape, centroid) ==
                                 FeatureCount * sizeof(double));
                   CopyShape(*related, features, *shape);
                   return 1;
                 });
}

int palpate_compared_thickness(const palpate_compared* body, double* thickness,
                               palpate_error* error)
{
  return CopyThickness(body, ThicknessRule::Spheres, thickness, error);
}

int palpate_compared_ray_thickness(const palpate_compared* body, double* thickness,
                                   palpate_error* error)
{
  return CopyThickness(body, ThicknessRule::Rays, thickness, error);
}

size_t palpate_compared_calibre(const palpate_compared* body, palpate_section* sections,
                                size_t capacity, double* length, palpate_error* error)
{
  return Guarded(error, {{body, "body"}, {sections, "sections", capacity}, {length, "length"}},
                 [&]
                 {
                   const auto tube = TubeOf(*body, error);
                   if (tube == nullptr)
                   {
                     return std::size_t{0};
                   }
                   *length = tube->Length;
                   const std::size_t count = std::min(capacity, tube->Sections.size());
                   std::transform(tube->Sections.begin(),
                                  tube->Sections.begin() + static_cast<std::ptrdiff_t>(count),
                                  sections, SectionOf);
                   return tube->Sections.size();
                 });
}

int palpate_relate(const palpate_compared* first, const palpate_compared* second, double contact,
                   const double* margins, size_t margin_count, palpate_relation* relation,
                   double* near_areas, double* near_volumes, palpate_error* error)
{
  return Guarded(
      error,
      {{first, "first"},
       {second, "second"},
       {margins, "margins", margin_count},
       {relation, "relation"},
       {near_areas, "near_areas", margin_count},
       {near_volumes, "near_volumes", margin_count}},
      [&]
      {
        const RelationSettings settings{contact, {margins, margins + margin_count}};
        if (!AreMargins(contact, settings.Margins))
        {
          SetError(error, "a margin is negative, not finite, or less than the one "
                          "before it");
          return 0;
        }
        const auto one = RelatedOf(*first, "the first body", error);
        const auto other = one != nullptr ? RelatedOf(*second, "the second body", error) : nullptr;
        BodyRelation found;
        if (other == nullptr || Told(RelateBodies(*one, *other, settings, {}, found), error) == 0)
        {
          return 0;
        }
        *relation = RelationOf(found);
        for (std::size_t i = 0; i < margin_count; ++i)
        {
          near_areas[2 * i] = found.One.Near[i].Area;
          near_areas[2 * i + 1] = found.Other.Near[i].Area;
          near_volumes[2 * i] = found.One.Near[i].Volume;
          near_volumes[2 * i + 1] = found.Other.Near[i].Volume;
        }
        return 1;
      });
}
