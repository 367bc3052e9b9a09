#pragma once

#include "DeviceSample.h"
#include "Status.h"
#include "ToolPose.h"

namespace palpate
{
/// Where the device's frame lies in the world: world = origin + scale * rotation * device. With a
/// scale above 1 small motions of the hand become large ones in the world.
class DeviceFrame
{
public:
  DeviceFrame() = default;
  /// `scale` in mm of the world per mm of the device; `originWorld` in mm.
  DeviceFrame(const Matrix3& rotation, double scale, const Vector3& originWorld);

  /// Refuses what is no rotation (a mirror would swap the patient's sides), a scale that is not
  /// positive, and what is no number.
  Status Check() const;

  ToolPose PoseWorld(const DeviceSample& sample) const noexcept;
  /// A length in the world (mm) as one of the hand (mm).
  Vector3 LengthDevice(const Vector3& lengthWorld) const noexcept
  {
    return this->Rotation.transpose() * lengthWorld / this->Scale;
  }
  /// Directions and forces are turned, not scaled.
  Vector3 TurnedToDevice(const Vector3& world) const noexcept
  {
    return this->Rotation.transpose() * world;
  }
  Vector3 TurnedToWorld(const Vector3& device) const noexcept { return this->Rotation * device; }

private:
  Matrix3 Rotation = Matrix3::Identity();
  Eigen::Quaterniond Turn = Eigen::Quaterniond::Identity();
  double Scale = 1.0;
  Vector3 OriginWorld = Vector3::Zero();
};
} // namespace palpate
