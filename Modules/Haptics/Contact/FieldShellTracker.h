#pragma once

#include "ContactTracker.h"
#include "FieldSolid.h"
#include "ToolShell.h"

#include <memory>

namespace palpate
{
/// The published method for a sub-voxel sphere tool: surface points inside the solid are traced
/// along their inward normals to the surface; the sum of these vectors gives the direction in which
/// the tool is pushed out, their mean length the distance. If more than half of the points touch,
/// the path back to the proxy is traced until half of them or fewer do, and the proxy stays there
/// (Petersik, Pflesser, Tiede, Hoehne and Leuwer, "Haptic volume interaction with anatomic models
/// at sub-voxel resolution", Haptics 2002).
///
/// In clefts and with many contacts, the mean is less than the depth: see FieldProxyTracker. A tool
/// that starts with every point inside gets no direction.
class FieldShellTracker final : public ContactTracker
{
public:
  FieldShellTracker(std::shared_ptr<const FieldSolid> solid, const ToolShape& tool);

  const Contact& Follow(const ToolPose& pose) noexcept override;
  void Release() noexcept override { this->HasProxy = false; }
  std::size_t Bytes() const noexcept override { return sizeof(*this) + this->Shell.Bytes(); }

private:
  Vector3 PushedOut(const Vector3& probe) const noexcept;
  Vector3 PathBack(const Vector3& probe) noexcept;
  bool IsOutsideAt(const Vector3& place) noexcept;

  std::shared_ptr<const FieldSolid> Solid;
  ToolShell Shell;
  double Reach; // mm; of tool points from the origin
  int MostTouching;
  bool HasProxy = false;
  Vector3 ProxyWorld = Vector3::Zero();
  Contact Felt;
};
} // namespace palpate
