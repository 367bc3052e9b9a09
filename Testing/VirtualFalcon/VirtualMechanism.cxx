#include "VirtualMechanism.h"

#include <algorithm>
#include <cmath>

namespace palpate::test
{
namespace
{
constexpr std::int64_t LongestStep = 50'000; // ns
constexpr std::array<double, 3> LegDirections{105.0, -15.0, -135.0};

double Radians(double degrees)
{
  return degrees * M_PI / 180.0;
}
} // namespace

VirtualMechanism::VirtualMechanism(const VirtualMechanismSettings& settings)
    : Settings(settings), Hand(settings.Hand, settings.Start)
{
  this->ForgetHome();
}

void VirtualMechanism::ForgetHome()
{
  this->Errors = this->Settings.CounterErrors;
  this->Homed = 0;
  this->IsHoming = false;
  this->Motors = {};
  this->LastCounts = this->TrueCounts();
}

Vector3 VirtualMechanism::InLeg(int leg, const Vector3& position) const
{
  const double phi = Radians(LegDirections[static_cast<std::size_t>(leg)]);
  const Vector3 turned = Eigen::AngleAxisd(-phi, Vector3::UnitZ()) * position;
  return turned - Vector3(this->Settings.BaseRadial, this->Settings.BaseTangential, 0.0);
}

// The knee moves around the base joint; the grip's joint lies at the distance of the shin's
// projected length from it, in the leg's plane.
std::array<double, 3> VirtualMechanism::AnglesAt(const Vector3& position) const
{
  std::array<double, 3> angles{};
  for (int leg = 0; leg < 3; ++leg)
  {
    const Vector3 p = this->InLeg(leg, position);
    const double aside = p[1] + this->Settings.PlatformTangential;
    const double reach = this->Settings.Offsets +
                         std::sqrt(this->Settings.Shin * this->Settings.Shin - aside * aside);
    const double radial = p[0] + this->Settings.PlatformRadial;
    const double thigh = this->Settings.Thigh;
    const double k =
        (radial * radial + p[2] * p[2] + thigh * thigh - reach * reach) / (2.0 * thigh);
    // radial cos + height sin = k, by the tangent of half the angle.
    const double root = std::sqrt(radial * radial + p[2] * p[2] - k * k);
    angles[static_cast<std::size_t>(leg)] =
        std::remainder(2.0 * std::atan2(p[2] - root, k + radial), 2.0 * M_PI);
  }
  return angles;
}

VirtualMechanism::Gradient VirtualMechanism::GradientOf(int leg, const Vector3& position,
                                                        double angle) const
{
  const Vector3 p = this->InLeg(leg, position);
  const double thigh = this->Settings.Thigh;
  const double radial = p[0] + this->Settings.PlatformRadial - thigh * std::cos(angle);
  const double height = p[2] - thigh * std::sin(angle);
  const double aside = p[1] + this->Settings.PlatformTangential;
  const double length = std::hypot(radial, height);
  const double shin = std::sqrt(this->Settings.Shin * this->Settings.Shin - aside * aside);
  const double phi = Radians(LegDirections[static_cast<std::size_t>(leg)]);
  const Vector3 inLeg(radial / length, aside / shin, height / length);
  return {Eigen::AngleAxisd(phi, Vector3::UnitZ()) * inLeg,
          thigh * (radial * std::sin(angle) - height * std::cos(angle)) / length};
}

Vector3 VirtualMechanism::MotorForce() const
{
  const std::array<double, 3> angles = this->Angles();
  Vector3 force = Vector3::Zero();
  for (int leg = 0; leg < 3; ++leg)
  {
    const auto i = static_cast<std::size_t>(leg);
    const Gradient g = this->GradientOf(leg, this->Position(), angles[i]);
    const double torque = -this->Motors[i] / this->Settings.CountsPerNewtonMillimeter;
    force -= torque / g.ByAngle * g.ByPosition;
  }
  return force.allFinite() ? force : Vector3::Zero();
}

std::array<int, 3> VirtualMechanism::TrueCounts() const
{
  const std::array<double, 3> angles = this->Angles();
  std::array<int, 3> counts = this->LastCounts;
  for (std::size_t leg = 0; leg < 3; ++leg)
  {
    if (std::isfinite(angles[leg]))
    {
      counts[leg] = static_cast<int>(
          std::lround((angles[leg] - this->Settings.HomeAngle) / this->Settings.AnglePerCount));
    }
  }
  return counts;
}

std::array<std::int16_t, 3> VirtualMechanism::Counters() const
{
  const std::array<int, 3> counts = this->TrueCounts();
  std::array<std::int16_t, 3> counters{};
  for (std::size_t leg = 0; leg < 3; ++leg)
  {
    counters[leg] = static_cast<std::int16_t>(counts[leg] + this->Errors[leg]);
  }
  return counters;
}

void VirtualMechanism::PassIndices()
{
  const std::array<int, 3> counts = this->TrueCounts();
  for (std::size_t leg = 0; leg < 3; ++leg)
  {
    const auto [low, high] = std::minmax(counts[leg], this->LastCounts[leg]);
    const int index = this->Settings.IndexCount;
    if (this->IsHoming && low <= index && index <= high)
    {
      this->Errors[leg] = 0;
      this->Homed |= 1U << leg;
    }
  }
  this->LastCounts = counts;
}

Vector3 VirtualMechanism::TargetAt(std::int64_t time) const
{
  return this->Settings.Path != nullptr ? this->Settings.Path(1e-9 * static_cast<double>(time))
                                        : this->Settings.Start;
}

void VirtualMechanism::AdvanceTo(std::int64_t now)
{
  // Time has no fixed origin: motion begins with the first call.
  this->Reached = this->Reached < 0 ? now : this->Reached;
  while (this->Reached < now)
  {
    // A rigid hand needs steps only to pass its index on the way.
    const std::int64_t longest = this->Settings.IsRigid ? 20 * LongestStep : LongestStep;
    const std::int64_t end = std::min(now, this->Reached + longest);
    const double step = 1e-9 * static_cast<double>(end - this->Reached);
    const Vector3 target = this->TargetAt(end);
    if (this->Settings.IsRigid)
    {
      this->Hand = SimulatedHand(this->Settings.Hand, target);
    }
    else
    {
      const Vector3 before = this->TargetAt(this->Reached);
      this->Hand.Advance(before, (target - before) / step, this->MotorForce(), step);
    }
    this->Reached = end;
    this->PassIndices();
  }
}
} // namespace palpate::test
