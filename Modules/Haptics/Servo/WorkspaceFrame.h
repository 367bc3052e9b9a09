#pragma once

#include "DeviceCapabilities.h"
#include "DeviceFrame.h"
#include "TouchScene.h"

namespace palpate
{
/// Pose and scale of a device's workspace in the world, to be set by the user: world = center +
/// scale * rotation * device.
struct WorkspaceFrame
{
  Matrix3 Rotation = Matrix3::Identity();
  double Scale = 1.0;                    ///< mm of the world per mm of the device
  Vector3 CenterWorld = Vector3::Zero(); ///< mm

  /// A frame in the patient's axes that contains the whole scene with a margin, with a scale of at
  /// least 1. For a scene without structures: the default.
  static WorkspaceFrame Around(const TouchScene& scene, const DeviceCapabilities& device);

  Vector3 ToDevice(const Vector3& pointWorld) const
  {
    return this->Rotation.transpose() * (pointWorld - this->CenterWorld) / this->Scale;
  }
  Vector3 ToWorld(const Vector3& pointDevice) const
  {
    return this->CenterWorld + this->Scale * (this->Rotation * pointDevice);
  }
  /// The place of the device (mm) within its `workspace` nearest to a place in the world: goal of a
  /// simulated hand that is moved on screen. An empty, that is unknown, workspace does not limit
  /// it.
  Vector3 NearestInReach(const Vector3& pointWorld, const Eigen::AlignedBox3d& workspace) const;
  /// Initial position of such a hand (mm, device): in front of the scene's centre, as far towards
  /// the viewer as the workspace reaches.
  Vector3 FirstHand(const Vector3& towardsViewerWorld, const Eigen::AlignedBox3d& workspace) const;
  DeviceFrame ForDevice() const { return {this->Rotation, this->Scale, this->CenterWorld}; }

  friend bool operator==(const WorkspaceFrame& a, const WorkspaceFrame& b)
  {
    return a.Rotation == b.Rotation && a.Scale == b.Scale && a.CenterWorld == b.CenterWorld;
  }
  friend bool operator!=(const WorkspaceFrame& a, const WorkspaceFrame& b) { return !(a == b); }
};

/// Millimetres of a scene per millimetre of a device, so that the workspace contains the scene with
/// a margin; at least 1.
double ReachingScale(const TouchScene& scene, const DeviceCapabilities& device);
} // namespace palpate
