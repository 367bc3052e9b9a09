#pragma once

#include "FieldSampler.h"
#include "Status.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace palpate
{
/// The signed distance (mm, negative inside) to a structure, with a gradient that is continuous
/// everywhere: a cubic B-spline through distances on a grid, slightly smoothed, so that the
/// gradient turns within some nodes where several parts of the surface are equally near. Immutable,
/// shared by threads.
class StructureDistance
{
public:
  struct Place
  {
    double Distance = 0.0;                   ///< mm
    Vector3 GradientWorld = Vector3::Zero(); ///< mm per mm
  };

  /// `field` has one channel, the distances, which are right up to `reach` (mm) to either side. It
  /// must be a cubic B-spline with samples everywhere (FieldBuilder::KeepAll), and its distances at
  /// the grid's border must be beyond the reach. Looks at every node.
  static Status Make(std::shared_ptr<const ScalarField> field, double reach,
                     std::shared_ptr<const StructureDistance>& made);

  /// Nothing outside of the grid and for a point that is not finite.
  std::optional<Place> At(const Vector3& pointWorld) const noexcept;
  double Reach() const noexcept { return this->Farthest; } ///< mm
  /// Largest length of the gradient within the reach, mm per mm; about 1.
  double Steepest() const noexcept { return this->LargestSlope; }
  /// Largest change of the gradient within the reach, per mm, as differences between nodes have it.
  double Bend() const noexcept { return this->LargestBend; }
  Eigen::AlignedBox3d BoundsWorld() const noexcept;
  std::size_t Bytes() const noexcept { return this->Sampler.Field().Bytes(); }

private:
  StructureDistance(std::shared_ptr<const ScalarField> field, double reach)
      : Sampler(std::move(field)), Farthest(reach)
  {
  }
  void Survey();
  void SurveyAt(const Vector3& node);

  FieldSampler Sampler;
  double Farthest;           // mm
  double LargestSlope = 0.0; // mm per mm
  double LargestBend = 0.0;  // 1/mm
};
} // namespace palpate
