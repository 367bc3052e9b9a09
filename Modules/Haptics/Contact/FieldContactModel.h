#pragma once

#include "ContactModel.h"
#include "FieldSolid.h"

#include <memory>

namespace palpate
{
/// How a tool's proxy is put on a field's surface.
enum class FieldContactMode
{
  Proxy,         ///< where no point of the shell is inside, with friction
  PublishedShell ///< by the mean of the points' ways out: the published law, without friction
};

/// A structure whose surface is where a material of a field begins. Its tools are shells of points;
/// a sphere without one gets so many as its size in voxels asks for.
class FieldContactModel final : public ContactModel
{
public:
  static constexpr int FewestPoints = 6;
  static constexpr int MostPoints = 400;

  /// Refuses what FieldSolid refuses.
  static Status Make(const std::shared_ptr<const ScalarField>& field, int material,
                     FieldContactMode mode, std::shared_ptr<const ContactModel>& contact);

  /// Points of a sphere's shell (radius in mm): so many, within the limits, that the sphere is
  /// nowhere more than 0.05 voxel lower than its nearest point, and that what is as wide as a voxel
  /// does not slip between them.
  static int PointCountFor(double radius, double voxelSize) noexcept;
  /// The tool with a shell: its own, or so many points of a sphere.
  static ToolShape ShellFor(const ToolShape& tool, double voxelSize);

  Eigen::AlignedBox3d BoundsWorld() const noexcept override;
  Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                     std::unique_ptr<ContactTracker>& tracker) const override;
  std::size_t Bytes() const noexcept override;

private:
  FieldContactModel(std::shared_ptr<const FieldSolid> solid, FieldContactMode mode);

  std::shared_ptr<const FieldSolid> Solid;
  FieldContactMode Mode;
};
} // namespace palpate
