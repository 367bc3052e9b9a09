#include "StabilityProbe.h"

#include "LoopSchedule.h"
#include "ManualClock.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace palpate
{
namespace
{
// s of a trial: pressing, then going down, then holding still, of which the end is watched.
constexpr double PressingEnd = 1.0;
constexpr double HoldingStart = 1.25;
constexpr double EarlierStart = 1.45;
constexpr double LaterStart = 1.65;
constexpr double End = 1.85;

constexpr double Stroke = 3.0; // mm to either side

constexpr const char* NothingToPress = "The scene has no structure to press.";

std::function<Vector3(double)> PathOf(const StabilityTrial& trial)
{
  const Vector3 along = trial.Outward.unitOrthogonal();
  return [=](double time)
  {
    const double pressed = std::min(time, PressingEnd);
    const double phase = 2.0 * M_PI * trial.Frequency * pressed;
    // Half a period more leads from the highest to the lowest.
    const double down = std::clamp((time - PressingEnd) / (HoldingStart - PressingEnd), 0.0, 1.0);
    return Vector3(Stroke * std::sin(0.3 * phase) * along +
                   trial.Depth * std::cos(phase + M_PI * down) * trial.Outward);
  };
}

// Keeps the books of each contact apart: what one took in is no credit for the next.
class ContactBooks
{
public:
  explicit ContactBooks(int ticksOfDelay) : Quiet(ticksOfDelay + 1) {}

  // `takenIn` since the start, at a tick that gives out `isPushing` or not.
  void Add(double takenIn, bool isPushing)
  {
    this->TicksOfQuiet = isPushing ? this->TicksOfQuiet : this->TicksOfQuiet + 1;
    if (isPushing && this->TicksOfQuiet > this->Quiet)
    {
      // The tool entered after the tick before.
      this->Opening = this->Before;
      this->IsOpen = true;
    }
    this->TicksOfQuiet = isPushing ? 0 : this->TicksOfQuiet;
    this->Before = takenIn;
    if (this->IsOpen)
    {
      this->Least = std::min(this->Least, takenIn - this->Opening);
    }
  }
  double LeastEnergy() const { return this->Least; }

private:
  int Quiet; // ticks after which no force of an earlier contact is on its way any more
  int TicksOfQuiet = 0;
  bool IsOpen = false;
  double Opening = 0.0;
  double Before = 0.0;
  double Least = 0.0;
};

// What goes to and fro, and not what creeps.
class RestingMotion
{
public:
  void Add(const Vector3& position)
  {
    this->Path += this->HasFirst ? (position - this->Last).norm() : 0.0;
    this->First = this->HasFirst ? this->First : position;
    this->Last = position;
    this->HasFirst = true;
  }
  double ToAndFro() const { return this->Path - (this->Last - this->First).norm(); }

private:
  bool HasFirst = false;
  Vector3 First = Vector3::Zero();
  Vector3 Last = Vector3::Zero();
  double Path = 0.0;
};

class Trial
{
public:
  explicit Trial(const StabilityTrial& trial)
      : Device(Time, DeviceOf(trial)), Loop(Device, trial.Loop),
        Period(std::llround(1e9 / trial.Loop.Rate)),
        Books(static_cast<int>(std::ceil(trial.Device.Delay * trial.Loop.Rate)))
  {
  }

  Status Run(const TouchScene& scene, StabilityObservation& observation)
  {
    Status status = this->Device.Open();
    if (status.IsOk())
    {
      status = this->Loop.Publish(std::make_shared<TouchScene>(scene));
    }
    if (!status.IsOk())
    {
      return status;
    }
    observation = {};
    LoopSchedule schedule(0, this->Period);
    while (1e-9 * static_cast<double>(this->Time.Now()) < End &&
           observation.Fault == SafetyFault::None)
    {
      this->Time.WaitUntil(schedule.Deadline());
      this->Loop.Tick(schedule.Begin(this->Time.Now()));
      this->Note(observation);
    }
    observation.LeastEnergy = this->Books.LeastEnergy();
    observation.EarlierMotion = this->Earlier.ToAndFro();
    observation.LaterMotion = this->Later.ToAndFro();
    return status;
  }

private:
  static SimulatedSettings DeviceOf(const StabilityTrial& trial)
  {
    SimulatedSettings device = trial.Device;
    device.Path = PathOf(trial);
    return device;
  }

  void Note(StabilityObservation& observation)
  {
    const TouchState& state = this->Loop.Latest();
    const SimulatedHand& hand = this->Device.Hand();
    this->Books.Add(hand.Energy().TakenIn(), !Vector3(state.ForceDevice).isZero(0.0));
    observation.Deepest = std::max(observation.Deepest, state.Structure < 0 ? 0.0 : state.Depth);
    observation.Fault = state.Safety.Fault;
    const double time = 1e-9 * static_cast<double>(this->Time.Now());
    if (time >= EarlierStart)
    {
      (time < LaterStart ? this->Earlier : this->Later).Add(hand.Position());
    }
  }

  ManualClock Time;
  SimulatedDevice Device;
  Servo Loop;
  std::int64_t Period; // ns
  ContactBooks Books;
  RestingMotion Earlier;
  RestingMotion Later;
};
} // namespace

Status ObserveStability(const TouchScene& scene, const StabilityTrial& trial,
                        StabilityObservation& observation)
{
  if (scene.Structures.empty())
  {
    return Status::Failure(NothingToPress);
  }
  return Trial(trial).Run(scene, observation);
}

Status FindStableBorder(const TouchScene& scene, const StabilityTrial& trial, double likelyStable,
                        const std::function<bool(const StabilityObservation&)>& isStable,
                        double& border)
{
  constexpr double Step = 1.25;
  constexpr double Range = 64.0;
  constexpr double Accuracy = 1.01;
  TouchScene pressed = scene;
  Status status = Status::Success();
  const auto holds = [&](double stiffness)
  {
    StabilityObservation observation;
    pressed.Structures.front().Law.Stiffness = stiffness;
    status = ObserveStability(pressed, trial, observation);
    return status.IsOk() && observation.Fault == SafetyFault::None && isStable(observation);
  };
  if (pressed.Structures.empty())
  {
    return Status::Failure(NothingToPress);
  }
  double stable = holds(likelyStable) ? likelyStable : likelyStable / Range;
  border = 0.0;
  if (stable < likelyStable && !holds(stable))
  {
    return status;
  }
  double failing = Step * stable;
  while (failing < Range * likelyStable && holds(failing))
  {
    stable = failing;
    failing *= Step;
  }
  border = Range * likelyStable;
  if (failing >= border)
  {
    return status;
  }
  while (failing > Accuracy * stable)
  {
    const double middle = std::sqrt(stable * failing);
    (holds(middle) ? stable : failing) = middle;
  }
  border = stable;
  return status;
}
} // namespace palpate
