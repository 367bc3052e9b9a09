#include "SteeredDevice.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
SimulatedSettings SettingsOfHand()
{
  SimulatedSettings settings;
  settings.Resolution = 0.0;
  settings.WorkspaceRadius = SteeringSettings().Reach;
  return settings;
}
} // namespace

SteeredDevice::SteeredDevice(Clock& clock, std::unique_ptr<SteeringSource> source)
    : Source(std::move(source)), Hand(clock, SettingsOfHand()), Abilities(Hand.Capabilities())
{
  this->Abilities.Name = this->Source->Name();
  this->Abilities.DegreesOfFreedom = 6;
  this->Abilities.Buttons = this->Source->Buttons();
}

DeviceState SteeredDevice::State() const noexcept
{
  return this->HasFailed ? DeviceState::Error : this->Hand.State();
}

std::string SteeredDevice::Problem() const
{
  return this->HasFailed ? this->Source->Problem() : "";
}

Status SteeredDevice::Open()
{
  if (this->State() != DeviceState::Closed)
  {
    return Status::Failure("The device is open already.");
  }
  Status status = this->Source->Open();
  if (status.IsOk())
  {
    // In front of what a workspace has in its middle: a hand that is found inside feels nothing.
    const Vector3 start(0.0, 0.0, 0.9 * SteeringSettings().Reach);
    static_cast<void>(this->Hand.LeadHand(start));
    status = this->Hand.Open();
    this->Last = {};
    this->Told = std::numeric_limits<double>::quiet_NaN();
    this->Distance = std::numeric_limits<double>::infinity();
    this->Steered.Begin(start);
  }
  return status;
}

void SteeredDevice::Close() noexcept
{
  this->Source->Close();
  this->Hand.Close();
  this->HasFailed = false;
}

bool SteeredDevice::Read(DeviceSample& sample) noexcept
{
  SteeringInput input;
  if (this->State() == DeviceState::Closed || this->HasFailed)
  {
    return false;
  }
  if (!this->Source->Read(input))
  {
    this->HasFailed = true;
    return false;
  }
  if (!this->Hand.Read(sample))
  {
    return false;
  }
  const double period =
      this->Last.Sequence > 0 ? 1e-9 * static_cast<double>(sample.Time - this->Last.Time) : 0.0;
  this->Steered.Advance(input, sample.Position, this->DistanceNow(Vector3(sample.Position)),
                        period);
  static_cast<void>(this->Hand.LeadHand(this->Steered.Target()));
  Eigen::Map<Eigen::Vector4d>(sample.Orientation.data()) = this->Steered.Orientation().coeffs();
  sample.Buttons = input.Buttons;
  this->Last = sample;
  return true;
}

// A surface is nearer by no more than the hand has moved since its distance was told: whoever tells
// it late slows the hand down, and does not drive it into the surface.
double SteeredDevice::DistanceNow(const Vector3& handDevice) noexcept
{
  const double told = this->Told.exchange(std::numeric_limits<double>::quiet_NaN());
  if (!std::isnan(told))
  {
    this->Distance = told;
    this->ToldAt = handDevice;
  }
  return std::max(this->Distance - (handDevice - this->ToldAt).norm(), 0.0);
}

bool SteeredDevice::Apply(const Vector3& force) noexcept
{
  return !this->HasFailed && this->Hand.Apply(force);
}

void SteeredDevice::Show(const TouchState& state) noexcept
{
  this->Source->Show(state);
}
} // namespace palpate
