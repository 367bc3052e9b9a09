#include "TaskHand.h"

#include "ForcePerception.h"
#include "HandPath.h"
#include "Refusal.h"
#include "SimulatedDevice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::uint64_t TicksBetweenPolls = 1000; // fewer than a servo keeps
constexpr double Margin = 15.0;                   // mm outside of all structures
constexpr double PressSpeed = 12.0;               // mm/s
constexpr double NoticedForce = 0.1;              // N, some JNDs of a small force
constexpr double SeenDepth = 0.5;                 // mm that a tool is seen to be in a wall
constexpr double Avoidance = 1.0;                 // mm, of a reaction
constexpr double DriftSeconds = 0.5;              // time constant of drift and avoidance

// A hand that follows its target without ringing, on a mechanism with hardly any friction, so that
// tremor has the published size.
SimulatedSettings DeviceOfHand(double rate)
{
  SimulatedSettings settings;
  settings.Hand.HandDamping = 0.02;
  settings.Hand.Friction = 0.02;
  settings.Rate = rate;
  return settings;
}

HandPath PathAlong(const std::vector<Vector3>& points, double speed)
{
  std::vector<HandPath::Place> places;
  for (const Vector3& point : points)
  {
    const double passed = places.empty() ? 0.0 : (point - places.back().PointWorld).norm() / speed;
    if (places.empty() || passed > 0.0)
    {
      places.push_back({places.empty() ? 0.0 : places.back().Time + passed, point});
    }
  }
  return HandPath(std::move(places));
}

double LeastJerk(double part)
{
  return part * part * part * (10.0 + part * (6.0 * part - 15.0));
}
} // namespace

TaskHand::TaskHand(const PreparedTouch& touch, const TaskSettings& task, bool hasForce,
                   const HandSkill& skill, const Vector3& from, std::uint64_t seed)
    : Skill(skill), First(touch.Scene), FeelsForce(hasForce), Random(seed),
      Tremor(touch.Settings.Rate), SceneCenter(touch.Scene->BoundsWorld().center()),
      SceneRadius(0.5 * touch.Scene->BoundsWorld().diagonal().norm() +
                  touch.Scene->Tool.BoundingRadius() + Margin),
      Radius(touch.Scene->Tool.BoundingRadius()), Period(1.0 / touch.Settings.Rate),
      Frame(touch.Frame), Watch(task, hasForce, Radius), Schedule(0, std::llround(1e9 * Period)),
      Session(Time), Aim(SceneCenter + SceneRadius * from)
{
  auto device = std::make_unique<SimulatedDevice>(this->Time, DeviceOfHand(touch.Settings.Rate));
  device->LeadHand(this->Frame.ToDevice(this->Aim));
  RequireInput(device->Open());
  ServoSettings servo;
  servo.Rate = touch.Settings.Rate;
  servo.ModelInterval = touch.Settings.ModelInterval;
  this->Session.Open(std::move(device), servo);
  RequireInput(this->Session.Begin(*touch.Scene, touch.Frame));
  if (!hasForce)
  {
    this->Session.Loop().SwitchOff();
  }
}

void TaskHand::Feel(TouchScene scene)
{
  RequireInput(
      this->Session.Publish(std::move(scene), this->Session.Frame(), SceneEntry::Continuing));
}

Vector3 TaskHand::Errors(double deviation)
{
  const double x = this->Error(deviation);
  const double y = this->Error(deviation);
  return {x, y, this->Error(deviation)};
}

Vector3 TaskHand::See(const Vector3& pointWorld, const Vector3& normal)
{
  const Vector3 error = this->Errors(this->Skill.AimDeviation);
  return pointWorld + error - error.dot(normal) * normal +
         this->Error(this->Skill.SightDepthDeviation) * normal;
}

bool TaskHand::Tick(const Vector3& aimWorld)
{
  if (this->Watch.IsOver())
  {
    return false;
  }
  this->Aim = aimWorld;
  const double force = Vector3(this->Now.ForceDevice).norm();
  const Vector3 size = this->Skill.Tremor + Vector3::Constant(this->Skill.TremorPerNewton * force);
  const Vector3 trembling = size.cwiseProduct(this->Tremor.Next(this->Random));
  this->Session.LeadHand(this->Frame.ToDevice(aimWorld) + trembling);
  this->Time.WaitUntil(this->Schedule.Deadline());
  TickInfo tick = this->Schedule.Begin(this->Time.Now());
  tick.BootTime = this->Time.BootTime();
  this->Session.Loop().Tick(tick);
  this->Now = this->Session.Loop().Latest();
  this->Watch.Take(this->Now);
  if (++this->Ticks % TicksBetweenPolls == 0)
  {
    this->Session.Poll();
  }
  return true;
}

void TaskHand::MoveTo(const Vector3& toolWorld, double speed)
{
  const Vector3 start = this->Aim;
  const double length = (toolWorld - start).norm();
  const Vector3 end = toolWorld + this->Errors(this->Skill.MovementDeviation * length);
  constexpr double Shortest = 0.15; // s
  const int ticks = static_cast<int>(std::ceil(std::max(Shortest, length / speed) / this->Period));
  for (int i = 1; i <= ticks; ++i)
  {
    const double part = LeastJerk(static_cast<double>(i) / ticks);
    if (!this->Tick(start + part * (end - start)))
    {
      return;
    }
  }
}

void TaskHand::TravelTo(const Vector3& toolWorld)
{
  constexpr double Stride = 0.5; // rad
  const auto directionOf = [this](const Vector3& point)
  { return Vector3((point - this->SceneCenter).stableNormalized()); };
  const Vector3 goal = directionOf(toolWorld);
  Vector3 here = directionOf(this->Aim);
  this->MoveTo(this->SceneCenter + this->SceneRadius * here);
  while (!this->Watch.IsOver())
  {
    const Eigen::AngleAxisd turn(Eigen::Quaterniond::FromTwoVectors(here, goal));
    here = Eigen::AngleAxisd(std::min(turn.angle(), Stride), turn.axis()) * here;
    this->MoveTo(this->SceneCenter + this->SceneRadius * here);
    if (turn.angle() <= Stride)
    {
      break;
    }
  }
  this->MoveTo(toolWorld);
}

void TaskHand::Hold(double seconds)
{
  const int ticks = static_cast<int>(std::lround(seconds / this->Period));
  for (int i = 0; i < ticks && this->Tick(this->Aim); ++i)
  {
  }
}

void TaskHand::PressTo(double depth, const Vector3& direction, double most)
{
  const double wanted = std::max(0.1, depth + this->Error(this->Skill.PressDeviation));
  const double step = PressSpeed * this->Period;
  for (double pushed = 0.0; pushed < most; pushed += step)
  {
    if ((this->Now.Structure >= 0 && this->Now.Depth >= wanted) ||
        !this->Tick(this->Aim + step * direction))
    {
      return;
    }
  }
}

bool TaskHand::ReachForContact(const Vector3& direction, double most)
{
  const double step = PressSpeed * this->Period;
  double felt = -1.0; // s since a force was there
  for (double moved = 0.0; moved < most; moved += step)
  {
    if (felt >= this->Skill.TouchDelay)
    {
      return true;
    }
    felt = felt >= 0.0 || Vector3(this->Now.ForceDevice).norm() >= NoticedForce
               ? std::max(felt, 0.0) + this->Period
               : felt;
    if (!this->Tick(this->Aim + step * direction))
    {
      return false;
    }
  }
  return false;
}

double TaskHand::PerceiveForce(double seconds)
{
  const int ticks = static_cast<int>(std::lround(seconds / this->Period));
  double sum = 0.0;
  int count = 0;
  while (count < ticks && this->Tick(this->Aim))
  {
    sum += Vector3(this->Now.ForceDevice).norm();
    ++count;
  }
  const double force = count > 0 ? sum / count : 0.0;
  return force + this->Error(this->Skill.PerceptDeviation * ForcePerception::JustNoticeable(force));
}

void TaskHand::Follow(const std::vector<Vector3>& points, bool avoidsContact)
{
  const HandPath line = PathAlong(points, this->Skill.FollowingSpeed);
  this->Watch.KeepTrace(true);
  const double delay = this->FeelsForce ? this->Skill.TouchDelay : this->Skill.SightDelay;
  const double kept = std::exp(-this->Period / DriftSeconds);
  const double renewed = this->Skill.DriftDeviation * std::sqrt(1.0 - kept * kept);
  Vector3 drift = this->Errors(this->Skill.DriftDeviation);
  Vector3 avoided = Vector3::Zero();
  Vector3 away = Vector3::Zero();
  double waited = -1.0; // s since a contact was noticed
  for (double time = 0.0; time < line.Duration() + this->Period; time += this->Period)
  {
    drift = kept * drift + this->Errors(renewed);
    avoided *= kept;
    const bool isNoticed = this->FeelsForce ? Vector3(this->Now.ForceWorld).norm() >= NoticedForce
                                            : this->Now.Depth >= SeenDepth;
    if (avoidsContact && this->Now.Structure >= 0 && isNoticed && waited < 0.0)
    {
      away = (Vector3(this->Now.ProxyWorld) - Vector3(this->Now.ProbeWorld)).stableNormalized();
      waited = 0.0;
    }
    waited += waited >= 0.0 ? this->Period : 0.0;
    if (waited >= delay)
    {
      avoided += Avoidance * away;
      waited = -1.0;
    }
    if (!this->Tick(line.At(time) + drift + avoided))
    {
      return;
    }
  }
  this->Watch.KeepTrace(false);
}

std::optional<TouchRay::Rest> TaskHand::Look(const Vector3& from, const Vector3& to)
{
  return this->Session.RestBetween(from, to);
}
} // namespace palpate
