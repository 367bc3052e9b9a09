#pragma once

#include "ContactModel.h"
#include "HapticDevice.h"
#include "TouchScene.h"
#include "TouchState.h"

#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>

namespace palpate::test
{
/// Faults of a WallModel.
enum class WallFault
{
  None,
  Invalid, ///< the tracker reports it
  NaNProxy,
  InfiniteProxy,
  HugeDepth, ///< finite, but implausible
  NaNNormal,
  NoNormal ///< the zero vector
};

/// Counters of a wall's tracker, its fault, whether its proxy is behind and how far beside the
/// tool's origin it touches, settable from any thread.
struct WallControl
{
  std::atomic<int> Questions{0};
  std::atomic<WallFault> Fault{WallFault::None};
  std::atomic<bool> IsBehind{false};
  std::atomic<double> Arm{0.0}; ///< mm, along y
};

/// The half-space below a height along z, a metre wide; the simplest exact contact model.
class WallModel final : public ContactModel
{
public:
  explicit WallModel(double heightWorld, std::shared_ptr<WallControl> control = nullptr)
      : Height(heightWorld),
        Control(control != nullptr ? std::move(control) : std::make_shared<WallControl>())
  {
  }

  Eigen::AlignedBox3d BoundsWorld() const noexcept override
  {
    return {Vector3(-500.0, -500.0, this->Height - 1000.0), Vector3(500.0, 500.0, this->Height)};
  }

  Status MakeTracker(const ToolShape& tool, const SurfaceFriction&,
                     std::unique_ptr<ContactTracker>& tracker) const override
  {
    if (!tool.IsSphere())
    {
      return Status::Failure("A wall supports spheres only.");
    }
    tracker = std::make_unique<Tracker>(this->Height + tool.Radius(), this->Control);
    return Status::Success();
  }

private:
  class Tracker final : public ContactTracker
  {
  public:
    Tracker(double height, std::shared_ptr<WallControl> control)
        : Height(height), Control(std::move(control))
    {
    }
    const Contact& Follow(const ToolPose& pose) noexcept override
    {
      ++this->Control->Questions;
      this->Depth(pose);
      this->Spoil(this->Control->Fault);
      return this->Felt;
    }
    void Release() noexcept override {}
    // Tests start inside it, and are pushed out.
    bool IsFreeAt(const ToolPose&) noexcept override
    {
      ++this->Control->Questions;
      return true;
    }

  private:
    void Depth(const ToolPose& pose) noexcept
    {
      const double depth = this->Height - pose.PositionWorld[2];
      this->Felt = {};
      this->Felt.IsValid = pose.PositionWorld.allFinite();
      this->Felt.IsTouching = depth > 0.0;
      this->Felt.Depth = this->Felt.IsTouching ? depth : 0.0;
      this->Felt.ProxyWorld = pose.PositionWorld + Vector3(0.0, 0.0, this->Felt.Depth);
      this->Felt.Turn = this->Control->Arm * this->Felt.Depth * Vector3::UnitX();
      this->Felt.IsBehind = this->Control->IsBehind;
    }
    void Spoil(WallFault fault) noexcept
    {
      constexpr double nan = std::numeric_limits<double>::quiet_NaN();
      Vector3& proxy = this->Felt.ProxyWorld;
      Vector3& normal = this->Felt.NormalWorld;
      this->Felt.IsValid = this->Felt.IsValid && fault != WallFault::Invalid;
      proxy[0] = fault == WallFault::NaNProxy ? nan : proxy[0];
      proxy[1] =
          fault == WallFault::InfiniteProxy ? std::numeric_limits<double>::infinity() : proxy[1];
      proxy[2] = fault == WallFault::HugeDepth ? 1e300 : proxy[2];
      normal[2] = fault == WallFault::NaNNormal ? nan : normal[2];
      normal[2] = fault == WallFault::NoNormal ? 0.0 : normal[2];
    }

    double Height; // mm, lower limit of the tool's centre
    std::shared_ptr<WallControl> Control;
    Contact Felt;
  };

  double Height;
  std::shared_ptr<WallControl> Control;
};

/// A scene with one wall, to be touched by a point.
inline TouchScene WallScene(double heightWorld, const ContactLaw& law,
                            std::shared_ptr<WallControl> control = nullptr)
{
  TouchScene scene;
  scene.Tool = ToolShape::Sphere(0.0);
  scene.Structures.push_back(
      {"wall", std::make_shared<WallModel>(heightWorld, std::move(control)), law, {}});
  return scene;
}

/// A device with a scripted position that records applied forces. It gives a new sample at each
/// Read, taken at SampleTime.
class ScriptedDevice final : public HapticDevice
{
public:
  ScriptedDevice()
  {
    this->Abilities.Name = "scripted device";
    this->Abilities.MaximumForce = 8.0;
    this->Abilities.MaximumDamping = 0.02;
    this->Abilities.Rate = 1000.0;
  }

  explicit ScriptedDevice(const DeviceCapabilities& abilities) : Abilities(abilities) {}

  const DeviceCapabilities& Capabilities() const noexcept override { return this->Abilities; }
  DeviceState State() const noexcept override { return this->Life; }
  std::string Problem() const override { return ""; }
  Status Open() override { return Status::Success(); }
  void Close() noexcept override {}
  bool Read(DeviceSample& sample) noexcept override
  {
    sample = this->Next;
    sample.Sequence = this->RepeatsSample ? sample.Sequence : ++this->Next.Sequence;
    return true;
  }
  bool Apply(const Vector3& force) noexcept override
  {
    this->Applied = this->RefusesForce ? this->Applied : force;
    this->AppliedTorque = this->RefusesForce ? this->AppliedTorque : Vector3::Zero();
    return !this->RefusesForce;
  }
  bool ApplyWrench(const Vector3& force, const Vector3& torque) noexcept override
  {
    const bool isTaken = this->Apply(force);
    this->AppliedTorque = isTaken ? torque : this->AppliedTorque;
    return isTaken;
  }
  void Show(const TouchState& state) noexcept override { this->Shown = state; }

  DeviceCapabilities Abilities;
  DeviceState Life = DeviceState::Ready;
  DeviceSample Next;
  bool RepeatsSample = false;
  bool RefusesForce = false;
  Vector3 Applied = Vector3::Zero();
  Vector3 AppliedTorque = Vector3::Zero();
  TouchState Shown;
};
} // namespace palpate::test
