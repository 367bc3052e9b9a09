#pragma once

#include "FieldContactModel.h"
#include "ToolShell.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace palpate::test
{
/// The published method for a sub-voxel sphere tool, which ours is compared with: surface points
/// inside the solid are traced along their inward normals to the surface; the sum of these vectors
/// gives the direction in which the tool is pushed out, their mean length the distance. If more
/// than half of the points touch, the path back to the proxy is traced until half of them or fewer
/// do, and the proxy stays there (Petersik, Pflesser, Tiede, Hoehne and Leuwer, "Haptic volume
/// interaction with anatomic models at sub-voxel resolution", Haptics 2002).
///
/// In clefts and with many contacts, the mean is less than the depth: see FieldProxyTracker. A tool
/// that starts with every point inside gets no direction.
class PublishedShellTracker final : public ContactTracker
{
public:
  PublishedShellTracker(std::shared_ptr<const FieldSolid> solid, const ToolShape& tool)
      : Solid(std::move(solid)), Shell(tool), Reach(tool.BoundingRadius()),
        MostTouching(static_cast<int>(Shell.Count() / 2))
  {
  }

  const Contact& Follow(const ToolPose& pose) noexcept override
  {
    const Vector3 normal = this->Felt.NormalWorld;
    this->Felt = Contact();
    if (!pose.IsUsable())
    {
      return this->Felt;
    }
    const Vector3& probe = pose.PositionWorld;
    this->Felt.IsValid = true;
    this->Felt.Material = this->Solid->Material();
    this->Shell.Turn(pose.Orientation);
    const bool isFar = this->Solid->BoundsWorld().exteriorDistance(probe) > this->Reach;
    const int touching = isFar ? 0 : this->Shell.CountInside(*this->Solid, probe);
    this->ProxyWorld = touching > this->MostTouching && this->HasProxy ? this->PathBack(probe)
                       : touching > 0                                  ? this->PushedOut(probe)
                                                                       : probe;
    this->HasProxy = true;
    const Vector3 path = this->ProxyWorld - probe;
    this->Felt.IsTouching = touching > 0;
    this->Felt.ProxyWorld = this->ProxyWorld;
    this->Felt.Depth = path.norm();
    this->Felt.NormalWorld = this->Felt.Depth > 0.0 ? Vector3(path / this->Felt.Depth) : normal;
    return this->Felt;
  }
  void Release() noexcept override { this->HasProxy = false; }
  bool IsFreeAt(const ToolPose& pose) noexcept override
  {
    this->Shell.Turn(pose.Orientation);
    return pose.IsUsable() && this->Shell.CountInside(*this->Solid, pose.PositionWorld) == 0;
  }
  std::size_t Bytes() const noexcept override { return sizeof(*this) + this->Shell.Bytes(); }

private:
  // By the points last found inside.
  Vector3 PushedOut(const Vector3& probe) const noexcept
  {
    Vector3 sum = Vector3::Zero();
    double lengths = 0.0;
    int touching = 0;
    for (std::size_t i = 0; i < this->Shell.Count(); ++i)
    {
      if (this->Shell.IsInside(i))
      {
        const Vector3& inward = this->Shell.InwardNormal(i);
        const double length =
            this->Solid->DistanceToExit(probe + this->Shell.Offset(i), inward, this->Reach);
        sum += length * inward;
        lengths += length;
        ++touching;
      }
    }
    const double size = sum.norm();
    // Vectors that cancel up to rounding have no direction.
    return size > 1e-12 * lengths ? Vector3(probe + (lengths / touching / size) * sum) : probe;
  }

  // In quarters of a voxel; if those would be too many, in longer steps and then by bisection.
  Vector3 PathBack(const Vector3& probe) noexcept
  {
    constexpr double StepsPerVoxel = 4.0;
    constexpr double MostSteps = 64.0;
    const Vector3 path = this->ProxyWorld - probe;
    const double wanted = std::ceil(StepsPerVoxel * path.norm() / this->Solid->VoxelSize());
    const double steps = std::clamp(wanted, 1.0, MostSteps);
    double free = 1.0;
    for (int step = 1; step < static_cast<int>(steps) && free == 1.0; ++step)
    {
      free = this->IsOutsideAt(probe + step / steps * path) ? step / steps : 1.0;
    }
    double touching = free - 1.0 / steps;
    double length = wanted / steps; // in quarters of a voxel
    while (length > 1.0)
    {
      const double middle = 0.5 * (touching + free);
      (this->IsOutsideAt(probe + middle * path) ? free : touching) = middle;
      length *= 0.5;
    }
    return probe + free * path;
  }

  bool IsOutsideAt(const Vector3& place) noexcept
  {
    return this->Shell.CountInside(*this->Solid, place) <= this->MostTouching;
  }

  std::shared_ptr<const FieldSolid> Solid;
  ToolShell Shell;
  double Reach; // mm; of tool points from the origin
  int MostTouching;
  bool HasProxy = false;
  Vector3 ProxyWorld = Vector3::Zero();
  Contact Felt;
};

/// A material of a field, touched by the published method: without friction, and not by points.
class PublishedShellModel final : public ContactModel
{
public:
  explicit PublishedShellModel(std::shared_ptr<const FieldSolid> solid) : Solid(std::move(solid)) {}

  Eigen::AlignedBox3d BoundsWorld() const noexcept override { return this->Solid->BoundsWorld(); }
  Status MakeTracker(const ToolShape& tool, const SurfaceFriction& friction,
                     std::unique_ptr<ContactTracker>& tracker) const override
  {
    const ToolShape shell = FieldContactModel::ShellFor(tool, this->Solid->VoxelSize());
    if (!tool.Check().IsOk() || friction.Static > 0.0 || !(shell.BoundingRadius() > 0.0))
    {
      return Status::Failure("The published method supports neither friction nor point tools.");
    }
    tracker = std::make_unique<PublishedShellTracker>(this->Solid, shell);
    return Status::Success();
  }

private:
  std::shared_ptr<const FieldSolid> Solid;
};

inline Status MakePublishedShell(const std::shared_ptr<const ScalarField>& field, int material,
                                 std::shared_ptr<const ContactModel>& contact)
{
  std::shared_ptr<const FieldSolid> solid;
  Status status = FieldSolid::Make(field, material, solid);
  if (status.IsOk())
  {
    contact = std::make_shared<PublishedShellModel>(std::move(solid));
  }
  return status;
}
} // namespace palpate::test
