#pragma once

#include "Status.h"
#include "ToolSkeleton.h"
#include "Vector3.h"

#include <functional>
#include <memory>
#include <vector>

namespace palpate
{
/// The shape of a tool, immutable: a sphere around the origin of its frame, or a body of balls
/// (ToolSkeleton) that turns as it touches. Either has a shell of points, by which fields find it.
/// Lengths are mm, in the tool's frame.
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
  /// Along z, `length` between the centres of the end spheres.
  static ToolShape Capsule(double radius, double length, int count);
  /// A ball of `radius` around the origin, which cuts, on a shaft along z whose other end is
  /// `length` away. A needle has a shaft of its own radius.
  static ToolShape Drill(double radius, double shaftRadius, double length, int count);
  /// Along z, centred at the origin, with flat ends, whose rims are rounded by a tenth of the
  /// radius.
  static ToolShape Cylinder(double radius, double length, int count);
  /// `semiAxes` along x, y, z.
  static ToolShape Ellipsoid(const Vector3& semiAxes, int count);
  /// Points of any closed surface and their inward normals, which are normalised here: balls that
  /// touch the surface from inside there, with a quarter of the points' distance as radius.
  static ToolShape FromSurfacePoints(std::vector<Vector3> points, std::vector<Vector3> normals);

  /// The same tool with `count` points, as far as it is given by lengths, and its surface `smaller`
  /// (mm) farther in; a shaft is as thick as it was.
  ToolShape Variant(int count, double smaller) const { return this->Make(count, smaller); }
  /// The same with about one point for each square of `spacing` (mm), from 100 to 600.
  ToolShape WithSpacing(double spacing) const;

  /// Fails for lengths that are negative or not finite, counts outside the limits, and normals that
  /// are zero or not one for each point.
  Status Check() const;

  /// The balls of a tool that turns as it touches; null for spheres, and for tools without volume.
  const ToolSkeleton* Skeleton() const noexcept { return this->Balls.get(); }
  bool IsSphere() const noexcept { return this->Spherical; }
  double Radius() const noexcept { return this->SphereRadius; } ///< of a sphere, else 0
  /// The radius (mm) of a sphere around the origin that contains the tool.
  double BoundingRadius() const noexcept { return this->Extent; }
  const std::vector<Vector3>& Points() const noexcept { return this->ShellPoints; }
  /// Inward unit normals, one for each point.
  const std::vector<Vector3>& Normals() const noexcept { return this->ShellNormals; }
  /// The ball in the tool that touches its surface at the point of this number.
  ToolSkeleton::Ball BallAt(std::size_t point) const
  {
    const Rounding& round = this->Roundings[point];
    return {this->ShellPoints[point] + round.Radius * this->ShellNormals[point], round.Radius,
            round.Cuts};
  }

private:
  struct Rounding
  {
    double Radius = 0.0; // mm
    bool Cuts = true;
  };

  ToolShape() = default;
  void AddPoint(const Vector3& point, const Vector3& inward, double radius, bool cuts = true);
  void AddCapsulePoints(double radius, double from, double to, int count, bool cuts);
  void UseSkeleton(ToolSkeleton skeleton);

  bool Spherical = false;
  bool HasShell = false;
  double SphereRadius = 0.0;
  double Extent = 0.0;
  double Area = 0.0; // mm^2; 0 if unknown
  std::vector<Vector3> ShellPoints;
  std::vector<Vector3> ShellNormals;
  std::vector<Rounding> Roundings;
  std::shared_ptr<const ToolSkeleton> Balls;
  std::function<ToolShape(int, double)> Make;
};
} // namespace palpate
