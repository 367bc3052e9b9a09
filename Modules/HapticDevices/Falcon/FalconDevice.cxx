#include "FalconDevice.h"

#include <algorithm>
#include <array>
#include <utility>

namespace palpate
{
namespace
{
constexpr double WorkspaceRadius = 40.0;             // mm
constexpr double Gravity = 9.81;                     // m/s^2
constexpr std::int64_t OldestPosition = 20'000'000;  // ns; older ones produce no force
constexpr std::int64_t LongestSilence = 200'000'000; // ns
constexpr std::int64_t FarewellInterval = 2'000'000; // ns
constexpr int Farewells = 3;                         // zero-torque packets before closing

// The smallest over all directions of the maximum force, at the worst place of the workspace.
double MaximumForceOf(const FalconKinematics& kinematics, double countsPerNewtonMillimeter)
{
  const double torque = LargestMotorValue / countsPerNewtonMillimeter;
  double least = kinematics.LeastForce(torque, kinematics.Center());
  for (const double x : {-1.0, 0.0, 1.0})
  {
    for (const double y : {-1.0, 0.0, 1.0})
    {
      for (const double z : {-1.0, 0.0, 1.0})
      {
        const Vector3 direction(x, y, z);
        const Vector3 edge = kinematics.Center() + WorkspaceRadius * direction.stableNormalized();
        least = std::min(least, kinematics.LeastForce(torque, edge));
      }
    }
  }
  return least;
}

// Stiffness and damping are values that Falcon programs found stable; damping and friction of the
// mechanism were never published.
DeviceCapabilities CapabilitiesOf(const FalconKinematics& kinematics,
                                  const FalconCalibration& calibration)
{
  DeviceCapabilities c;
  c.Name = "Novint Falcon";
  c.Buttons = 4;
  const Vector3 corner = Vector3::Constant(WorkspaceRadius);
  c.Workspace = {-corner, corner};
  c.MaximumForce = MaximumForceOf(kinematics, calibration.CountsPerNewtonMillimeter);
  c.MaximumStiffness = 1.0;
  c.MaximumDamping = 0.02;
  c.Resolution = 0.045;
  c.Delay = 0.0015;
  c.Rate = 1000.0;
  // The chip's timer is not synchronised with the servo; a lost reply takes as long to time out.
  c.LongestGap = 1e-9 * static_cast<double>(FalconExchange::ReplyDeadline);
  c.GravityCompensation = Vector3(0.0, Gravity * calibration.CarriedMass, 0.0);
  return c;
}
} // namespace

FalconDevice::FalconDevice(Clock& clock, std::unique_ptr<FalconLink> link, FalconSettings settings)
    : Time(clock), Link(std::move(link)), Settings(std::move(settings)),
      Kinematics(this->Settings.Calibration.Geometry),
      Abilities(CapabilitiesOf(this->Kinematics, this->Settings.Calibration)),
      Boot(*this->Link, clock), Exchange(*this->Link)
{
}

std::string FalconDevice::Problem() const
{
  switch (this->Failure.load())
  {
  case Fault::None:
    return "";
  case Fault::Unplugged:
    return "The Falcon was unplugged: plug it in and open it again.";
  case Fault::Silent:
    return "The Falcon does not answer any more: check its power supply and its cable, then open "
           "it again.";
  case Fault::HomeLost:
    return "The Falcon's encoders lost their zero: open it again and pull the handle out and push "
           "it in.";
  }
  return "";
}

std::string FalconDevice::Guidance() const
{
  if (this->State() != DeviceState::Homing)
  {
    return "";
  }
  std::string missing;
  const std::array<const char*, 3> legs{"top", "right", "left"};
  for (std::size_t leg = 0; leg < legs.size(); ++leg)
  {
    const bool isHomed = (this->HomedLegs >> leg & 1U) != 0;
    missing += isHomed ? "" : (missing.empty() ? "" : ", ") + std::string(legs.at(leg));
  }
  // If all legs have a zero, it only settles.
  return missing.empty() ? ""
                         : "Pull the handle all the way out, then push it all the way in; these "
                           "legs have no zero yet: " +
                               missing + ".";
}

std::string FalconDevice::ConnectionReport() const
{
  const FalconStatistics& s = this->Statistics();
  const std::string caution = this->Link->Caution();
  const auto count = [](std::uint64_t number, const char* what)
  { return std::to_string(number) + " " + what; };
  return count(s.Requests, "requests, ") + count(s.Replies, "replies, ") + count(s.Lost, "lost, ") +
         count(s.Unasked, "not asked for, ") + count(s.Implausible, "not believed; ") +
         count(s.SkippedBytes, "bytes belonged to none") + (caution.empty() ? "" : "; " + caution);
}

bool FalconDevice::IsInUse() const noexcept
{
  const DeviceState state = this->State();
  return state == DeviceState::Homing || state == DeviceState::Ready;
}

void FalconDevice::Forget() noexcept
{
  this->Failure = Fault::None;
  this->Homing = {};
  this->HomedLegs = 0;
  this->Last.Position = Vector3(Vector3::Zero());
  this->Last.Buttons = 0;
  this->Last.Time = this->Time.Now();
  this->Grip = this->Kinematics.Center();
  this->HasPosition = false;
  this->HasLapsed = false;
  this->Measured = this->Time.Now();
  this->Exchange.Restart(this->Time.Now());
}

Status FalconDevice::Open()
{
  if (this->State() != DeviceState::Closed)
  {
    return Status::Failure("The Falcon is open already.");
  }
  this->Life = DeviceState::Opening;
  Status status = this->Link->Open();
  if (status.IsOk())
  {
    status = this->Boot.Run(FalconFirmware::PathOf(this->Settings.FirmwarePath));
  }
  if (!status.IsOk())
  {
    this->Link->Close();
    this->Life = DeviceState::Closed;
    return status;
  }
  FalconRequest stop;
  stop.IsHoming = true;
  const FalconPacket packet = Encoded(stop);
  this->Link->ArmStop(packet.data(), packet.size());
  this->Forget();
  this->Life = DeviceState::Homing;
  return status;
}

void FalconDevice::Close() noexcept
{
  if (this->State() == DeviceState::Closed)
  {
    return;
  }
  for (int n = 0; n < Farewells && this->Link->SendStop(); ++n)
  {
    this->Time.WaitUntil(this->Time.Now() + FarewellInterval);
  }
  this->Link->Close();
  this->Failure = Fault::None;
  this->Life = DeviceState::Closed;
}

bool FalconDevice::Fail(Fault fault) noexcept
{
  // In case the device still receives.
  static_cast<void>(this->Link->SendStop());
  this->Failure = fault;
  this->Life = DeviceState::Error;
  return false;
}

void FalconDevice::Measure(const FalconReply& reply, std::int64_t now) noexcept
{
  const HomingWatch::Verdict verdict = this->Homing.Take(reply.Homed);
  this->HomedLegs = reply.Homed;
  const Vector3 counts(reply.Counts[0], reply.Counts[1], reply.Counts[2]);
  const bool isReady = this->State() == DeviceState::Ready;
  this->HasPosition =
      this->Kinematics.PositionAt(this->Kinematics.AnglesOf(counts), this->Grip, this->Grip);
  if (verdict == HomingWatch::Verdict::Lost)
  {
    this->Fail(Fault::HomeLost);
    return;
  }
  // A byte of a single reply may be wrong.
  this->Last.Buttons = reply.Buttons == this->Pressed ? reply.Buttons : this->Last.Buttons;
  this->Pressed = reply.Buttons;
  if (this->HasPosition || !isReady)
  {
    // While homing, samples are returned even if the counts have no valid position.
    this->Last.Position = Vector3(this->Grip - this->Kinematics.Center());
    this->Last.Time = now;
    ++this->Last.Sequence;
    this->Measured = now;
  }
  if (verdict == HomingWatch::Verdict::Homed && this->HasPosition && !isReady)
  {
    this->Life = DeviceState::Ready;
  }
}

bool FalconDevice::Read(DeviceSample& sample) noexcept
{
  if (!this->IsInUse())
  {
    return false;
  }
  const std::int64_t now = this->Time.Now();
  FalconReply reply;
  const bool isNew = this->Exchange.Receive(now, reply);
  if (this->Link->IsGone())
  {
    return this->Fail(Fault::Unplugged);
  }
  if (isNew)
  {
    this->Measure(reply, now);
  }
  if (this->Exchange.Silence(now) > LongestSilence)
  {
    return this->Fail(Fault::Silent);
  }
  sample = this->Last;
  return this->IsInUse();
}

bool FalconDevice::MotorsFor(const Vector3& force, std::int64_t now,
                             FalconNumbers& motors) const noexcept
{
  Vector3 torques;
  const bool isKnown = this->State() == DeviceState::Ready && this->HasPosition &&
                       now - this->Measured <= OldestPosition &&
                       this->Kinematics.TorquesFor(force, this->Grip, torques);
  motors = isKnown ? MotorValuesFor(torques, this->Settings.Calibration.CountsPerNewtonMillimeter)
                   : FalconNumbers{};
  return isKnown;
}

FalconDelivery FalconDevice::SendMotors(const FalconNumbers& motors) noexcept
{
  // Without the flag the homing bits are undefined.
  const FalconLight light =
      this->State() == DeviceState::Ready ? FalconLight::Green : FalconLight::Red;
  return this->Exchange.Send({motors, true, light}, this->Time.Now());
}

bool FalconDevice::Apply(const Vector3& force) noexcept
{
  if (!this->IsInUse())
  {
    return false;
  }
  FalconNumbers motors{};
  const bool isRendered = this->MotorsFor(force, this->Time.Now(), motors);
  const bool isFelt = this->State() == DeviceState::Ready && !force.isZero(0.0);
  // A force that was switched off for lack of a position must not return in one step: it is refused
  // until 0 N was requested, and then faded in again.
  this->HasLapsed = isFelt && (this->HasLapsed || !isRendered);
  const FalconDelivery delivery = this->SendMotors(this->HasLapsed ? FalconNumbers{} : motors);
  return delivery == FalconDelivery::Gone ? this->Fail(Fault::Unplugged)
                                          : delivery == FalconDelivery::Sent && !this->HasLapsed;
}
} // namespace palpate
