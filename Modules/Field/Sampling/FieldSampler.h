#pragma once

#include "InstructionSet.h"
#include "ScalarField.h"
#include "Vector3.h"

#include <memory>

namespace palpate
{
namespace inside
{
struct Kernel;
}

/// Origin of a sample.
enum class SampleKind
{
  Outside,  ///< the point is not in the grid: there is no value, and no material
  Constant, ///< far from surfaces: one value for the whole brick, zero gradient
  Sampled   ///< interpolated between nodes
};

struct FieldSample
{
  SampleKind Kind = SampleKind::Outside;
  double Value = 0.0;
};

/// The gradient is in the frame of the query: per voxel along i, j, k (Index), or per mm (World).
struct FieldGradientSample
{
  SampleKind Kind = SampleKind::Outside;
  double Value = 0.0;
  Vector3 Gradient = Vector3::Zero();
};

/// Samples a field and tests which materials contain a point. World is patient LPS in mm; Index is
/// continuous, with nodes at whole numbers. Queries neither allocate nor lock, and may come from
/// any number of threads. Channels and materials must exist in the field.
class FieldSampler
{
public:
  /// This processor must support `set`; it affects the time of batches, but no result.
  explicit FieldSampler(std::shared_ptr<const ScalarField> field,
                        InstructionSet set = FastestInstructionSet());
  const ScalarField& Field() const noexcept { return *this->Data; }

  FieldSample ValueIndex(int channel, const Vector3& pointIndex) const noexcept;
  FieldSample ValueWorld(int channel, const Vector3& pointWorld) const noexcept;
  FieldGradientSample ValueAndGradientIndex(int channel, const Vector3& pointIndex) const noexcept;
  FieldGradientSample ValueAndGradientWorld(int channel, const Vector3& pointWorld) const noexcept;

  /// Whether all of a material's conditions hold at a point; they do at the iso-value itself.
  bool IsInsideIndex(int material, const Vector3& pointIndex) const noexcept;
  bool IsInsideWorld(int material, const Vector3& pointWorld) const noexcept;
  /// IsInside for each point, 1 or 0. Several points at once if the material has one condition and
  /// the interpolation is trilinear.
  void AreInsideWorld(int material, const Vector3* pointsWorld, std::size_t count,
                      unsigned char* inside) const noexcept;

private:
  std::shared_ptr<const ScalarField> Data;
  const inside::Kernel* Kernel;
};
} // namespace palpate
