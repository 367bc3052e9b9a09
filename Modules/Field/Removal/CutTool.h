#pragma once

#include "FieldGrid.h"
#include "Status.h"
#include "Vector3.h"

#include <memory>
#include <vector>

namespace palpate
{
/// The shape of a tool that removes material, as the signed distance (mm) to its surface in its own
/// frame, negative inside. Immutable; queries neither allocate nor lock.
class CutTool
{
public:
  static CutTool Sphere(double radius);
  /// Along z, centred at the origin.
  static CutTool Cylinder(double radius, double length);
  /// Any closed surface, by its signed distances (mm, negative inside, i fastest) on a grid in the
  /// tool's frame. Interpolated between nodes; beyond the grid the distance to the grid is added.
  static CutTool Surface(const FieldGrid& grid, std::vector<double> distances);

  /// Fails for lengths that are not positive and finite, for distances that are not finite or not
  /// one per node, and for a surface that reaches the border of its grid or encloses nothing.
  Status Check() const;

  double Distance(const Vector3& point) const noexcept;
  /// The radius (mm) of a sphere around the origin that contains the tool.
  double BoundingRadius() const noexcept { return this->Extent; }
  bool IsSphere() const noexcept { return this->Kind == Shape::Sphere; }

private:
  enum class Shape
  {
    Sphere,
    Cylinder,
    Surface
  };
  struct Sampled
  {
    FieldGrid Grid;
    std::vector<double> Distances;

    double At(const Vector3& pointIndex) const noexcept;
  };
  CutTool(Shape kind, double radius, double halfLength);
  double DistanceToCylinder(const Vector3& point) const noexcept;
  double DistanceBySamples(const Vector3& point) const noexcept;
  Status CheckSamples() const;

  Shape Kind;
  double Radius;
  double HalfLength;
  double Extent;
  std::shared_ptr<const Sampled> Samples;
};
} // namespace palpate
