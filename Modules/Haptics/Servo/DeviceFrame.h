#pragma once

#include "DeviceSample.h"
#include "Status.h"
#include "ToolPose.h"

namespace palpate
{
/// Pose of the device's frame in the world: world = origin + scale * rotation * device. A scale
/// above 1 magnifies motions of the hand.
class DeviceFrame
{
public:
  DeviceFrame() = default;
  /// `scale` in mm of the world per mm of the device; `originWorld` in mm.
  DeviceFrame(const Matrix3& rotation, double scale, const Vector3& originWorld);

  /// Fails for a matrix that is not a rotation (a mirror would swap the patient's sides), a scale
  /// that is not positive, and numbers that are not finite.
  Status Check() const;

  ToolPose PoseWorld(const DeviceSample& sample) const noexcept;
  /// Converts a length in the world (mm) to one of the hand (mm).
  Vector3 LengthDevice(const Vector3& lengthWorld) const noexcept
  {
    return this->Rotation.transpose() * lengthWorld / this->Scale;
  }
  /// mm of the world per mm of the hand, along the device's axes; its transpose turns changes per
  /// mm of the world into changes per mm of the hand.
  Matrix3 WorldPerDevice() const noexcept { return this->Scale * this->Rotation; }
  /// Directions and forces are rotated, not scaled.
  Vector3 TurnedToDevice(const Vector3& world) const noexcept
  {
    return this->Rotation.transpose() * world;
  }
  Vector3 TurnedToWorld(const Vector3& device) const noexcept { return this->Rotation * device; }
  /// From the tool's to the device's frame, of an orientation in the world.
  Eigen::Quaterniond OrientationDevice(const Eigen::Quaterniond& world) const noexcept
  {
    return this->Turn.conjugate() * world;
  }
  /// mm of the world per mm of the hand.
  double Magnification() const noexcept { return this->Scale; }

  friend bool operator==(const DeviceFrame& a, const DeviceFrame& b) noexcept
  {
    return a.Rotation == b.Rotation && a.Scale == b.Scale && a.OriginWorld == b.OriginWorld;
  }
  friend bool operator!=(const DeviceFrame& a, const DeviceFrame& b) noexcept { return !(a == b); }

private:
  Matrix3 Rotation = Matrix3::Identity();
  Eigen::Quaterniond Turn = Eigen::Quaterniond::Identity();
  double Scale = 1.0;
  Vector3 OriginWorld = Vector3::Zero();
};
} // namespace palpate
