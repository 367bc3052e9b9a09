#pragma once

#include "FieldSampler.h"
#include "RayCaster.h"
#include "Status.h"

#include <cstddef>
#include <memory>

namespace palpate
{
/// One material of a field as a solid body, shared by its trackers. Immutable; queries are noexcept
/// and do not allocate. World is patient LPS, mm.
class FieldSolid
{
public:
  /// The surface near a point as a plane, by value over gradient there.
  struct Wall
  {
    bool IsKnown = false;  ///< false deep inside, where the field gives no direction to the surface
    double Distance = 0.0; ///< from the plane to the point, mm; negative inside
    Vector3 Normal = Vector3::UnitZ(); ///< outward unit normal
  };

  /// Fails if the field does not have the material.
  static Status Make(const std::shared_ptr<const ScalarField>& field, int material,
                     std::shared_ptr<const FieldSolid>& solid);
  /// Bounds of the bricks that contain a material, mm.
  static Eigen::AlignedBox3d BoundsOf(const ScalarField& field, int material);
  /// For a version of a drilled field: a solid with the bounds (mm) of the initial field.
  static Status Make(const std::shared_ptr<const ScalarField>& version, int material,
                     const Eigen::AlignedBox3d& boundsWorld,
                     std::shared_ptr<const FieldSolid>& solid);

  /// Of the whole field.
  std::size_t Bytes() const noexcept { return this->FieldBytes; }
  int Material() const noexcept { return this->Number; }
  const Eigen::AlignedBox3d& BoundsWorld() const noexcept { return this->Bounds; }
  double VoxelSize() const noexcept { return this->Voxel; } ///< the smallest spacing, mm

  /// 1 or 0 for each point.
  void AreInside(const Vector3* pointsWorld, std::size_t count,
                 unsigned char* inside) const noexcept
  {
    this->Sampler.AreInsideWorld(this->Number, pointsWorld, count, inside);
  }
  /// Inside, if the field has no samples because no surface is near enough, a ray searches one to
  /// two voxels along `outward`, a unit vector.
  Wall WallNear(const Vector3& pointWorld, const Vector3& outward) const noexcept;
  /// The fraction (0 to 1) of the path after which it first enters the solid; 1 if it never does. A
  /// path that starts inside is considered from where it leaves.
  double PartToEntry(const Vector3& fromWorld, const Vector3& path) const noexcept;
  /// Distance (mm) along a unit vector to the exit from the solid that contains the start; at most
  /// `reach`.
  double DistanceToExit(const Vector3& fromWorld, const Vector3& direction,
                        double reach) const noexcept;

private:
  FieldSolid(const std::shared_ptr<const ScalarField>& field, int material,
             const Eigen::AlignedBox3d& boundsWorld);
  Wall WallBySamples(const Vector3& pointIndex) const noexcept;
  Wall WallByRay(const Vector3& pointWorld, const Vector3& outward) const noexcept;
  void JoinBorder(const Vector3& pointIndex, Wall& wall) const noexcept;

  FieldSampler Sampler;
  RayCaster Caster;
  int Number;
  std::size_t FieldBytes;
  Eigen::AlignedBox3d Bounds;
  double Voxel;
};
} // namespace palpate
