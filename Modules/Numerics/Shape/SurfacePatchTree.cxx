#include "SurfacePatchTree.h"

#include <limits>

namespace palpate
{
SurfacePatchTree::SurfacePatchTree(const SphericalHarmonicModel& model,
                                   const RadiusDerivativeBounds& bounds, int levels)
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
  this->Spheres.resize(inner);
  this->Patches.resize(finest);
  for (int root = 0; root < RootCount; ++root)
  {
    this->Build(model, bounds, root, this->Roots[static_cast<std::size_t>(root)]);
  }
}

SurfacePatchTree::Sphere SurfacePatchTree::Build(const SphericalHarmonicModel& model,
                                                 const RadiusDerivativeBounds& bounds, int node,
                                                 const SphericalTriangle& triangle)
{
  this->Caps[static_cast<std::size_t>(node)] = triangle.Cap();
  if (!this->IsInner(node))
  {
    return this->BuildPatch(model, bounds, node);
  }
  std::array<Sphere, 4> parts;
  Vector3 center = Vector3::Zero();
  const std::array<SphericalTriangle, 4> triangles = triangle.Split();
  for (std::size_t i = 0; i < 4; ++i)
  {
    parts[i] = this->Build(model, bounds, FirstPart(node) + static_cast<int>(i), triangles[i]);
    center += 0.25 * parts[i].Center;
  }
  Sphere& sphere = this->Spheres[static_cast<std::size_t>(node)];
  sphere = {center, 0.0};
  for (const Sphere& part : parts)
  {
    sphere.Radius = std::max(sphere.Radius, (part.Center - center).norm() + part.Radius);
  }
  return sphere;
}

SurfacePatchTree::Sphere SurfacePatchTree::BuildPatch(const SphericalHarmonicModel& model,
                                                      const RadiusDerivativeBounds& bounds,
                                                      int node)
{
  const auto& [direction, reach] = this->CapOf(node);
  const auto sample = model.EvaluateSecondOrder(direction);
  const double change =
      reach * (sample.SurfaceGradient.norm() +
               reach * (0.5 * sample.SurfaceHessian.norm() + reach * bounds.Radius[3] / 6.0));
  this->Lowest = std::min(this->Lowest, sample.Radius - change);
  this->Highest = std::max(this->Highest, sample.Radius + change);

  const SurfacePatch patch(direction, sample, reach, bounds.PointThird);
  this->Patches[static_cast<std::size_t>(node - this->InnerCount())] = patch;
  return {patch.Point + 0.5 * (patch.High + patch.Low) * patch.Normal,
          std::hypot(patch.Radius, 0.5 * (patch.High - patch.Low))};
}

SphericalTriangle SurfacePatchTree::Triangle(int node) const noexcept
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
} // namespace palpate
