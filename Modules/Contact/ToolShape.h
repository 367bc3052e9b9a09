#pragma once

#include "Status.h"
#include "Vector3.h"

#include <memory>
#include <vector>

namespace palpate
{
class ToolSkeleton;

/// The shape of a tool, immutable: a sphere around the origin of its frame, or any closed surface
/// as a shell of points with inward normals. Lengths are mm, in the tool's frame.
class ToolShape
{
public:
  /// Points of the published shell: the directions to the neighbours of a voxel.
  static constexpr int NeighbourCount = 26;
  static constexpr int MinimumCount = 4;
  static constexpr int MaximumCount = 4096;

  /// Radius 0 is a point. Models that need a shell create their own.
  static ToolShape Sphere(double radius);
  /// A sphere with a shell of `count` points: 6 and 26 are the directions to the face neighbours
  /// and to all neighbours of a voxel, others lie on a spiral of equal areas.
  static ToolShape SpherePoints(double radius, int count);
  /// Along z, `length` between the centres of the end spheres. A radius above 0 gives it balls.
  static ToolShape Capsule(double radius, double length, int count);
  /// Along z, centred at the origin, with flat ends.
  static ToolShape Cylinder(double radius, double length, int count);
  /// `semiAxes` along x, y, z.
  static ToolShape Ellipsoid(const Vector3& semiAxes, int count);
  /// Points of any closed surface and their inward normals, which are normalised here.
  static ToolShape FromSurfacePoints(std::vector<Vector3> points, std::vector<Vector3> normals);

  /// Fails for lengths that are negative or not finite, counts outside the limits, and normals that
  /// are zero or not one for each point.
  Status Check() const;

  /// The balls of a tool that turns as it touches; null for the other tools.
  const ToolSkeleton* Skeleton() const noexcept { return this->Balls.get(); }
  bool IsSphere() const noexcept { return this->Spherical; }
  double Radius() const noexcept { return this->SphereRadius; } ///< of a sphere, else 0
  /// The radius (mm) of a sphere around the origin that contains the tool.
  double BoundingRadius() const noexcept { return this->Extent; }
  const std::vector<Vector3>& Points() const noexcept { return this->ShellPoints; }
  /// Inward unit normals, one for each point.
  const std::vector<Vector3>& Normals() const noexcept { return this->ShellNormals; }

private:
  ToolShape() = default;
  void AddPoint(const Vector3& point, const Vector3& inward);

  bool Spherical = false;
  bool HasShell = false;
  double SphereRadius = 0.0;
  double Extent = 0.0;
  std::vector<Vector3> ShellPoints;
  std::vector<Vector3> ShellNormals;
  std::shared_ptr<const ToolSkeleton> Balls;
};
} // namespace palpate
