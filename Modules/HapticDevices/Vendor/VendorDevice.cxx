#include "VendorDevice.h"

#include "ClampedLength.h"
#include "ForceDimensionArm.h"
#include "OpenHapticsArm.h"

#include <utility>

namespace palpate
{
namespace
{
constexpr std::int64_t ForceHolds = 20'000'000; // ns without Apply
} // namespace

VendorDevice::VendorDevice(Clock& clock, std::unique_ptr<VendorArm> arm)
    : Time(clock), Arm(std::move(arm))
{
}

std::string VendorDevice::Problem() const
{
  return this->State() == DeviceState::Error ? this->Arm->Trouble() : "";
}

Status VendorDevice::Open()
{
  if (this->State() != DeviceState::Closed)
  {
    return Status::Failure("The device is open already.");
  }
  Status status = this->Arm->Open();
  if (!status.IsOk())
  {
    return status;
  }
  this->MustEnd = false;
  this->MostForce = this->Arm->Abilities().MaximumForce;
  this->MostTorque = this->Arm->Abilities().MaximumTorque;
  this->Last = {};
  this->Last.Time = this->Time.Now();
  this->Newest.Publish(this->Last);
  this->Wanted.Publish({});
  this->Life = DeviceState::Homing; // until the first step
  status = this->Arm->Run([this] { return this->Step(); });
  if (!status.IsOk())
  {
    this->Close();
  }
  return status;
}

void VendorDevice::Close() noexcept
{
  if (this->State() != DeviceState::Closed)
  {
    this->MustEnd = true;
    this->Arm->End();
    this->Life = DeviceState::Closed;
  }
}

// The last one pushes 0 N, and turns with 0 N mm.
bool VendorDevice::Step() noexcept
{
  DeviceSample now;
  bool isWell = this->Arm->Measure(now);
  const Command& command = this->Wanted.Latest();
  const std::int64_t time = this->Time.Now();
  const bool pushes = isWell && !this->MustEnd && time - command.Time <= ForceHolds;
  const Command shown = pushes ? command : Command();
  isWell = this->Arm->Push(shown.Force, shown.Torque) && isWell;
  if (!isWell)
  {
    // What the library still takes of it: the failure may have come with a force.
    static_cast<void>(this->Arm->Measure(now));
    static_cast<void>(this->Arm->Push(Vector3::Zero(), Vector3::Zero()));
    this->Life = DeviceState::Error;
    return false;
  }
  now.Sequence = this->Last.Sequence + 1;
  now.Time = time;
  this->Last = now;
  this->Newest.Publish(now);
  DeviceState homing = DeviceState::Homing;
  this->Life.compare_exchange_strong(homing, DeviceState::Ready);
  return !this->MustEnd;
}

bool VendorDevice::Read(DeviceSample& sample) noexcept
{
  const DeviceState state = this->State();
  if (state != DeviceState::Homing && state != DeviceState::Ready)
  {
    return false;
  }
  sample = this->Newest.Latest();
  if (state == DeviceState::Homing)
  {
    sample.Time = this->Time.Now();
  }
  return true;
}

bool VendorDevice::ApplyWrench(const Vector3& force, const Vector3& torque) noexcept
{
  const DeviceState state = this->State();
  if (state != DeviceState::Homing && state != DeviceState::Ready)
  {
    return false;
  }
  const bool isReady = state == DeviceState::Ready;
  this->Wanted.Publish({isReady ? ClampedLength(force, this->MostForce) : Vector3::Zero(),
                        isReady ? ClampedLength(torque, this->MostTorque) : Vector3::Zero(),
                        this->Time.Now()});
  return true;
}

Status RegisterVendorDevices(DeviceRegistry& registry)
{
  const auto search = [](auto make)
  {
    return [make](Clock& clock, std::vector<FoundDevice>& found)
    {
      VendorDevice device(clock, make());
      const Status status = device.Open();
      if (status.IsOk())
      {
        found.push_back({"", true, device.Capabilities().Name, device.Capabilities()});
      }
      return status;
    };
  };
  const Status status = registry.Add(
      "openhaptics",
      "a 3D Systems Touch or Touch X by OpenHaptics, where it is installed; openhaptics[:NAME]",
      [](Clock& clock, const std::string& argument, std::unique_ptr<HapticDevice>& device)
      {
        device = std::make_unique<VendorDevice>(clock, std::make_unique<OpenHapticsArm>(argument));
        return Status::Success();
      },
      search([] { return std::make_unique<OpenHapticsArm>(""); }),
      DeviceRegistry::Proof::UntriedOnHardware);
  if (!status.IsOk())
  {
    return status;
  }
  return registry.Add(
      "forcedimension",
      "an omega, delta, sigma or lambda by Force Dimension's SDK, where it is installed",
      [](Clock& clock, const std::string& argument, std::unique_ptr<HapticDevice>& device)
      {
        if (!argument.empty())
        {
          return Status::Failure("forcedimension takes no argument.");
        }
        device = std::make_unique<VendorDevice>(clock, std::make_unique<ForceDimensionArm>());
        return Status::Success();
      },
      search([] { return std::make_unique<ForceDimensionArm>(); }),
      DeviceRegistry::Proof::UntriedOnHardware);
}
} // namespace palpate
