#pragma once

#include "DeviceCapabilities.h"
#include "DeviceFrame.h"
#include "TouchScene.h"

namespace palpate
{
/// Where a device's workspace lies in the world, to be moved, turned and scaled by a person:
/// world = center + scale * rotation * device.
struct WorkspaceFrame
{
  Matrix3 Rotation = Matrix3::Identity();
  double Scale = 1.0;                    ///< mm of the world per mm of the device
  Vector3 CenterWorld = Vector3::Zero(); ///< mm

  /// One in the patient's axes that reaches round all of a scene with a little to spare, never
  /// below life size. Of a scene without structures: the default.
  static WorkspaceFrame Around(const TouchScene& scene, const DeviceCapabilities& device);

  Vector3 ToDevice(const Vector3& pointWorld) const
  {
    return this->Rotation.transpose() * (pointWorld - this->CenterWorld) / this->Scale;
  }
  Vector3 ToWorld(const Vector3& pointDevice) const
  {
    return this->CenterWorld + this->Scale * (this->Rotation * pointDevice);
  }
  /// The place of the device (mm) within its `workspace` that is nearest to a place in the world:
  /// where a hand that is led from a screen goes. An empty workspace, which is not known, ends
  /// nowhere.
  Vector3 NearestInReach(const Vector3& pointWorld, const Eigen::AlignedBox3d& workspace) const;
  /// Where such a hand begins (mm, device): before the middle of what is felt, as far towards the
  /// viewer as the workspace reaches.
  Vector3 FirstHand(const Vector3& towardsViewerWorld, const Eigen::AlignedBox3d& workspace) const;
  DeviceFrame ForDevice() const { return {this->Rotation, this->Scale, this->CenterWorld}; }

  friend bool operator==(const WorkspaceFrame& a, const WorkspaceFrame& b)
  {
    return a.Rotation == b.Rotation && a.Scale == b.Scale && a.CenterWorld == b.CenterWorld;
  }
  friend bool operator!=(const WorkspaceFrame& a, const WorkspaceFrame& b) { return !(a == b); }
};

/// Millimetres of a scene for one of a device, so that it reaches round all of it with a little to
/// spare; never below life size.
double ReachingScale(const TouchScene& scene, const DeviceCapabilities& device);
} // namespace palpate
