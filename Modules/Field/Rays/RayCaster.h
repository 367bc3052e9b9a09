#pragma once

#include "FieldHit.h"
#include "InstructionSet.h"
#include "ScalarField.h"

#include <cstddef>
#include <memory>

namespace palpate
{
struct FieldRay
{
  Vector3 Origin = Vector3::Zero();
  Vector3 Direction = Vector3::UnitX(); ///< of any length but zero; the unit of t
};

/// An interval of a ray's parameter, which may be infinite; both ends belong to it. Empty if From >
/// To.
struct RayInterval
{
  double From = 0.0;
  double To = 1.0;
};

/// Finds where rays cross the boundaries of a field's materials. The inside is closed: it contains
/// the iso-value. Outside the grid there is no material, so the grid's border closes materials that
/// reach it.
///
/// A boundary that is crossed is found, however thin the wall: in each cell the field along the ray
/// is a polynomial, whose crossings are isolated and solved. The same hit has the same bits for
/// every interval that contains it, and for single rays and batches. To continue after a hit, start
/// at the next number above its T.
///
/// Queries neither allocate nor lock, and may come from any number of threads.
class RayCaster
{
public:
  /// This processor must support `set`; it affects the time of batches, but no result.
  explicit RayCaster(std::shared_ptr<const ScalarField> field,
                     InstructionSet set = FastestInstructionSet());
  const ScalarField& Field() const noexcept { return *this->Data; }

  /// The first boundary of the wanted materials with tMin <= t <= tMax, which may be infinite.
  /// Index: voxels along i, j, k.
  FieldHit CastIndex(const FieldRay& rayIndex, double tMin, double tMax,
                     MaterialSet materials = AllMaterials) const noexcept;
  /// The same in the world, patient LPS in mm.
  FieldHit CastWorld(const FieldRay& rayWorld, double tMin, double tMax,
                     MaterialSet materials = AllMaterials) const noexcept;
  /// CastWorld for many rays, each with its interval; four at once if the instruction set has the
  /// lanes for it.
  void CastAllWorld(const FieldRay* raysWorld, const RayInterval* intervals, std::size_t count,
                    FieldHit* hits, MaterialSet materials = AllMaterials) const noexcept;

private:
  void CastInLanes(const FieldRay* raysWorld, const RayInterval* intervals, std::size_t count,
                   FieldHit* hits, MaterialSet materials) const noexcept;

  std::shared_ptr<const ScalarField> Data;
  InstructionSet Set;
};
} // namespace palpate
