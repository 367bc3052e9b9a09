#include "SampleDevice.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr double MillimetersPerCount = 0.05;
constexpr double CountsPerNewton = 500.0;
constexpr double LargestMotorValue = 4095.0;
} // namespace

SampleDevice::SampleDevice(Clock& clock, std::unique_ptr<SamplePort> port)
    : Time(clock), Port(std::move(port))
{
  this->Abilities.Name = "Sample device";
  this->Abilities.Workspace = {Vector3::Constant(-50.0), Vector3::Constant(50.0)};
  this->Abilities.MaximumForce = LargestMotorValue / CountsPerNewton;
  this->Abilities.MaximumStiffness = 1.0;
  this->Abilities.MaximumDamping = 0.01;
  this->Abilities.Resolution = MillimetersPerCount;
  this->Abilities.Rate = 1000.0;
}

std::string SampleDevice::Problem() const
{
  return this->State() == DeviceState::Error
             ? "The sample device does not answer: check its cable, then open it again."
             : "";
}

Status SampleDevice::Open()
{
  if (this->State() != DeviceState::Closed)
  {
    return Status::Failure("The sample device is open already.");
  }
  this->Life = DeviceState::Opening;
  if (!this->Port->Connect())
  {
    this->Life = DeviceState::Closed;
    return Status::Failure("There is no sample device: plug it in and switch it on.");
  }
  this->Motors = {};
  this->Life = DeviceState::Homing;
  return Status::Success();
}

void SampleDevice::Close() noexcept
{
  if (this->State() != DeviceState::Closed)
  {
    SamplePort::Reply ignored;
    static_cast<void>(this->Port->Exchange({}, ignored));
    this->Port->Disconnect();
    this->Life = DeviceState::Closed;
  }
}

bool SampleDevice::Read(DeviceSample& sample) noexcept
{
  const DeviceState state = this->State();
  if (state == DeviceState::Closed || state == DeviceState::Error)
  {
    return false;
  }
  SamplePort::Reply reply;
  if (!this->Port->Exchange(this->Motors, reply))
  {
    this->Life = DeviceState::Error;
    return false;
  }
  this->Life = reply.IsHomed ? DeviceState::Ready : DeviceState::Homing;
  this->Last.Position =
      Vector3(reply.Counts[0], reply.Counts[1], reply.Counts[2]) * MillimetersPerCount;
  this->Last.Time = this->Time.Now();
  ++this->Last.Sequence;
  sample = this->Last;
  return true;
}

bool SampleDevice::Apply(const Vector3& force) noexcept
{
  const DeviceState state = this->State();
  if (state == DeviceState::Closed || state == DeviceState::Error)
  {
    return false;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    // Clamped before narrowing: a number that wraps round would pull the other way.
    const double value =
        std::clamp(force[axis] * CountsPerNewton, -LargestMotorValue, LargestMotorValue);
    this->Motors[static_cast<std::size_t>(axis)] =
        state == DeviceState::Ready ? static_cast<std::int16_t>(std::lround(value))
                                    : std::int16_t{};
  }
  return true;
}
} // namespace palpate
