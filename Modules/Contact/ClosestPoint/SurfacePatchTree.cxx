#include "SurfacePatchTree.h"

#include "CenteredSurfaceSample.h"
#include "ClosestPointDescent.h"

#include <limits>

namespace palpate
{
namespace
{
struct Range
{
  double Lowest;
  double Highest;
};

// Of R over a cap.
Range RangeOver(const SphericalCap& cap, const SampleOf<RadialModel>& sample,
                const RadiusDerivativeBounds& bounds)
{
  const double reach = cap.Radius;
  const double change =
      reach * (sample.SurfaceGradient.norm() +
               reach * (0.5 * sample.SurfaceHessian.norm() + reach * bounds.Radius[3] / 6.0));
  return {sample.Radius - change, sample.Radius + change};
}

// Of the distance from the centre, which may be inside or outside.
Range RangeOver(const SphericalCap& cap, const SampleOf<CenteredSurface>& sample,
                const PointDerivativeBounds& bounds)
{
  const double reach = cap.Radius;
  const double change =
      reach *
      (LargestFirst(sample) +
       reach * (0.5 * LargestSecond(sample) + reach * bounds.ThirdWithin(cap.Center, reach) / 6.0));
  return {0.0, sample.Point.norm() + change};
}
} // namespace

template <typename Surface>
SurfacePatchTreeOf<Surface>::SurfacePatchTreeOf(const Surface& surface, const Bounds& bounds,
                                                int levels)
    : Roots(SphericalTriangle::Icosahedron()), Lowest(std::numeric_limits<double>::infinity()),
      Highest(-Lowest)
{
  std::size_t inner = 0;
  std::size_t finest = RootCount;
  for (int level = 0; level < levels; ++level)
  {
    inner += finest;
    finest *= 4;
  }
  this->Caps.resize(inner + finest);
  this->Spheres.resize(inner + finest);
  this->Patches.resize(finest);
  for (int root = 0; root < RootCount; ++root)
  {
    this->Build(surface, bounds, root, this->Roots[static_cast<std::size_t>(root)]);
  }
}

template <typename Surface>
typename SurfacePatchTreeOf<Surface>::Ball
SurfacePatchTreeOf<Surface>::Build(const Surface& surface, const Bounds& bounds, int node,
                                   const SphericalTriangle& triangle)
{
  this->Caps[static_cast<std::size_t>(node)] = triangle.Cap();
  if (!this->IsInner(node))
  {
    return this->BuildPatch(surface, bounds, node);
  }
  std::array<Ball, 4> parts;
  Vector3 center = Vector3::Zero();
  const std::array<SphericalTriangle, 4> triangles = triangle.Split();
  for (std::size_t i = 0; i < 4; ++i)
  {
    parts[i] = this->Build(surface, bounds, FirstPart(node) + static_cast<int>(i), triangles[i]);
    center += 0.25 * parts[i].Center;
  }
  Ball& sphere = this->Spheres[static_cast<std::size_t>(node)];
  sphere = {center, 0.0};
  for (const Ball& part : parts)
  {
    sphere.Radius = std::max(sphere.Radius, (part.Center - center).norm() + part.Radius);
  }
  return sphere;
}

template <typename Surface>
typename SurfacePatchTreeOf<Surface>::Ball
SurfacePatchTreeOf<Surface>::BuildPatch(const Surface& surface, const Bounds& bounds, int node)
{
  const auto& [direction, reach] = this->CapOf(node);
  const auto sample = surface.EvaluateSecondOrder(direction);
  const Range range = RangeOver(this->CapOf(node), sample, bounds);
  this->Lowest = std::min(this->Lowest, range.Lowest);
  this->Highest = std::max(this->Highest, range.Highest);

  const auto within =
      ClosestPointDescentOf<Surface>::BoundsWithin(bounds, direction, sample, reach);
  const Patch patch(direction, sample, reach, within.Third);
  const auto finest = static_cast<std::size_t>(node - this->InnerCount());
  this->Patches[finest] = patch;
  return this->Spheres[static_cast<std::size_t>(node)] = {patch.Center(), patch.Extent()};
}

template <typename Surface>
SphericalTriangle SurfacePatchTreeOf<Surface>::Triangle(int node) const noexcept
{
  // The path up, then down again.
  std::array<int, 16> path{};
  std::size_t depth = 0;
  while (node >= RootCount)
  {
    path[depth] = (node - RootCount) % 4;
    node = (node - RootCount) / 4;
    ++depth;
  }
  SphericalTriangle triangle = this->Roots[static_cast<std::size_t>(node)];
  while (depth > 0)
  {
    --depth;
    triangle = triangle.Split()[static_cast<std::size_t>(path[depth])];
  }
  return triangle;
}

template class SurfacePatchTreeOf<RadialModel>;
template class SurfacePatchTreeOf<CenteredSurface>;
} // namespace palpate
