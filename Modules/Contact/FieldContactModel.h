#pragma once

#include "ContactModel.h"
#include "FieldSolid.h"

#include <memory>
#include <utility>

namespace palpate
{
/// A structure whose surface is the boundary of a field's material. Supports tools with a shell of
/// points; a sphere without one gets as many points as its size in voxels requires.
class FieldContactModel final : public ContactModel
{
public:
  static constexpr int FewestPoints = 6;
  static constexpr int MostPoints = 400;

  /// Fails as FieldSolid::Make.
  static Status Make(const std::shared_ptr<const ScalarField>& field, int material,
                     std::shared_ptr<const ContactModel>& contact);

  /// Number of shell points for a sphere (radius in mm): within the limits, enough that the sphere
  /// is nowhere more than 0.05 voxel lower than its nearest point, and that objects as wide as a
  /// voxel do not slip between them.
  static int PointCountFor(double radius, double voxelSize) noexcept;
  /// The tool with its own shell, or a sphere with PointCountFor points.
  static ToolShape ShellFor(const ToolShape& tool, double voxelSize);

  Eigen::AlignedBox3d BoundsWorld() const noexcept override { return this->Solid->BoundsWorld(); }
  Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                     std::unique_ptr<ContactTracker>& tracker) const override;
  Status MakeGaps(const ToolShape& tool, const SurfaceFriction& friction,
                  std::unique_ptr<ToolGaps>& gaps) const override;
  std::size_t Bytes() const noexcept override { return this->Solid->Bytes(); }

private:
  explicit FieldContactModel(std::shared_ptr<const FieldSolid> solid) : Solid(std::move(solid)) {}

  std::shared_ptr<const FieldSolid> Solid;
};
} // namespace palpate
