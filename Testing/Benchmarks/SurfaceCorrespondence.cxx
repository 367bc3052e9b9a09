#include "SurfaceCorrespondence.h"

#include "IcosahedronDirections.h"
#include "MappedSurface.h"
#include "NoisyMask.h"
#include "ShapeField.h"
#include "SurfaceModelFit.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <random>
#include <tuple>

namespace palpate::bench
{
namespace
{
constexpr int SurfaceDegree = 12;
constexpr double Coarser = 1.17;
constexpr double Far = 5.0; // mm

Status FitLabel(const PlacedLabel& label, bool isRepaired, double coarser,
                std::optional<SurfaceModel>& model)
{
  MappedSurfaceSettings settings;
  settings.Surface.Field.Spacing =
      coarser > 1.0 ? coarser * ShapeFieldSpacing(label.Mask, settings.Surface.Field) : 0.0;
  settings.Triangles = static_cast<int>(settings.Triangles / (coarser * coarser));
  MappedSurface mapped;
  Status status = MakeMappedSurface(label.Mask, label.ToWorld, settings, {}, mapped);
  if (status.IsOk() && !isRepaired)
  {
    status = CheckTopology(mapped.Topology, {});
  }
  SurfaceModelFitOptions options;
  options.Degree = SurfaceDegree;
  SurfaceModelFitResult fit;
  if (status.IsOk())
  {
    status = FitSurfaceModel(mapped.Mesh, mapped.Directions, options, fit);
  }
  if (status.IsOk())
  {
    model = fit.Surface;
  }
  return status;
}

Matrix3 LeftToRight()
{
  return Vector3(-1.0, 1.0, 1.0).asDiagonal();
}

// The mirrored body, with right-handed axes: the order of the first index is reversed too.
PlacedLabel Mirrored(const PlacedLabel& label)
{
  PlacedLabel mirrored = label;
  VoxelMask& mask = mirrored.Mask;
  for (std::size_t row = 0; row < mask.Inside.size(); row += static_cast<std::size_t>(mask.Size[0]))
  {
    const auto first = mask.Inside.begin() + static_cast<std::ptrdiff_t>(row);
    std::reverse(first, first + mask.Size[0]);
  }
  // The box keeps its index range, so index i becomes first + last - i.
  const double sum = 2.0 * mask.StartIndex[0] + mask.Size[0] - 1.0;
  const Vector3 across = label.ToWorld.Axes.col(0);
  mirrored.ToWorld.Axes.col(0) = -across;
  mirrored.ToWorld.Origin += sum * across;
  mirrored.ToWorld.Axes = LeftToRight() * mirrored.ToWorld.Axes;
  mirrored.ToWorld.Origin = LeftToRight() * mirrored.ToWorld.Origin;
  return mirrored;
}

SurfaceCorrespondence::Distance DistanceOf(const SurfaceModel& model,
                                           const std::function<Vector3(const Vector3&)>& other)
{
  const IcosahedronDirections sphere(10);
  SurfaceCorrespondence::Distance distance;
  for (const Vector3& u : sphere.Directions())
  {
    const double apart = (model.Point(u) - other(u)).norm();
    distance.Mean += apart / static_cast<double>(sphere.Directions().size());
    distance.FarShare += apart > Far ? 1.0 / static_cast<double>(sphere.Directions().size()) : 0.0;
    distance.Largest = std::max(distance.Largest, apart);
  }
  return distance;
}
} // namespace

Status MeasureCorrespondence(const PlacedLabel& label, bool isRepaired,
                             SurfaceCorrespondence& correspondence)
{
  std::mt19937_64 random(21);
  PlacedLabel noisy = label;
  noisy.Mask = test::WithNoise(label.Mask, 0.15, random);
  std::optional<SurfaceModel> model, noise, grid, mirror;
  Status status = FitLabel(label, isRepaired, 1.0, model);
  for (const auto& [variant, coarser, fitted] :
       {std::tuple(noisy, 1.0, &noise), std::tuple(label, Coarser, &grid),
        std::tuple(Mirrored(label), 1.0, &mirror)})
  {
    if (status.IsOk())
    {
      status = FitLabel(variant, isRepaired, coarser, *fitted);
    }
  }
  if (status.IsOk())
  {
    const Matrix3 turn = LeftToRight();
    correspondence.Noise = DistanceOf(*model, [&](const Vector3& u) { return noise->Point(u); });
    correspondence.Grid = DistanceOf(*model, [&](const Vector3& u) { return grid->Point(u); });
    correspondence.Mirror = DistanceOf(*model, [&](const Vector3& u)
                                       { return Vector3(turn * mirror->Point(turn * u)); });
  }
  return status;
}
} // namespace palpate::bench
