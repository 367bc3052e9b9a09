#include "TouchRun.h"

#include "DecimalText.h"
#include "DeviceHoming.h"
#include "DeviceList.h"
#include "InputError.h"
#include "ManualClock.h"
#include "OpenBuiltInDevice.h"
#include "Refusal.h"
#include "SimulatedDevice.h"
#include "SoundingDevice.h"
#include "SteadyClock.h"
#include "StiffnessAdvice.h"
#include "TouchReplay.h"
#include "TouchSession.h"
#include "Units.h"
#include "WorkspaceFrame.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

namespace palpate
{
namespace
{
constexpr const char* SimulatedName = "simulated";
constexpr double DefaultDuration = 10.0; // s, without a path

// Throws for failures that are not input errors.
void Succeed(const Status& status)
{
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
}

// Makes the device with this name; a simulated hand follows `path` (device frame).
std::unique_ptr<HapticDevice> MakeDevice(const std::string& name, Clock& clock,
                                         std::function<Vector3(double)> path)
{
  std::string silent = name;
  const bool sounds = TakeSound(silent);
  std::unique_ptr<HapticDevice> device;
  if (silent == SimulatedName)
  {
    SimulatedSettings settings;
    settings.Path = std::move(path);
    device = std::make_unique<SimulatedDevice>(clock, settings);
  }
  else
  {
    RequireInput(MakeBuiltInDevice(silent, clock, device));
  }
  return sounds ? std::make_unique<SoundingDevice>(std::move(device)) : std::move(device);
}

// A sweep is repeated back and forth until the touch ends; other paths end.
double TimeOnPath(const PreparedTouch& touch, double time) noexcept
{
  const double once = touch.Path.Duration();
  if (!touch.IsSweep || !(once > 0.0))
  {
    return time;
  }
  const double passed = std::fmod(time, 2.0 * once);
  return passed <= once ? passed : 2.0 * once - passed;
}

// Between two places a hand that does not see the surface runs deeper than at them. Friction stops
// a device within a millimetre of its own.
std::string NoteOnSweep(const PreparedTouch& touch, const TouchTrace& trace)
{
  constexpr double Usual = 3.0;
  const double deepest = trace.Whole().Depth.Most;
  return touch.IsSweep && deepest > Usual * std::max(touch.SweepDepth, touch.Frame.Scale)
             ? "the sweep ran " + FixedText(deepest, 0) + " mm deep instead of " +
                   SignificantText(touch.SweepDepth) +
                   " mm: it goes straight from place to place, through what lies between them; "
                   "give a --path along the surface"
             : std::string();
}

// Virtual time waits for a slow disk.
BackgroundWriter::Limits RecordingLimits(bool isVirtual)
{
  BackgroundWriter::Limits limits;
  if (isVirtual)
  {
    limits.Patience = limits.EndPatience = std::chrono::minutes(1);
  }
  return limits;
}

// Accumulates the ticks of a touch into its result, in bounded memory.
class TouchResultCollector
{
public:
  TouchResultCollector(TouchResult& result, std::size_t structures) : Result(result)
  {
    result.TouchedSeconds.resize(structures);
  }

  // The next tick, which took `microseconds` to compute; 0 if unknown.
  void Add(const TouchState& state, float microseconds)
  {
    if (this->Result.Ticks++ == 0)
    {
      this->Start = state.Tick.Scheduled;
      this->Last = state.Tick.Started;
    }
    const double passed =
        SecondsPerNanosecond * static_cast<double>(state.Tick.Started - this->Last);
    TouchStretch tick = StretchOf(state, this->Start, this->Last);
    tick.Computation = {microseconds, microseconds};
    this->Result.Trace.Add(tick);
    this->Last = state.Tick.Started;
    if (state.Structure >= 0)
    {
      this->Result.TouchedSeconds[static_cast<std::size_t>(state.Structure)] += passed;
      this->Result.BeyondLinearSeconds += state.IsBeyondLinear ? passed : 0.0;
    }
    this->Result.BehindTicks += state.IsBehind ? 1 : 0;
    this->Result.LeastEnergy = std::min(this->Result.LeastEnergy, state.Safety.Energy);
    const bool isLasting = state.Safety.Fault != SafetyFault::None && !state.Safety.WillResume;
    if (this->Result.Fault == SafetyFault::None || (this->Result.HasResumed && isLasting))
    {
      this->Result.Fault = state.Safety.Fault;
      this->Result.HasResumed = state.Safety.WillResume;
    }
  }

private:
  TouchResult& Result;
  std::int64_t Start = 0; // ns
  std::int64_t Last = 0;  // ns
};

// A running session and its result.
class LiveTouch
{
public:
  LiveTouch(const PreparedTouch& touch, Clock& clock, const TouchRunSettings& settings)
      : Touch(touch), Guide(settings.Guide), Watcher(settings.Watcher),
        Keeper(Result, touch.Structures.size()), Watch(touch.Drill), Session(clock)
  {
    ServoSettings servo;
    servo.Rate = touch.Settings.Rate;
    servo.ModelInterval = touch.Settings.ModelInterval;
    auto device = MakeDevice(touch.Settings.Device, clock, this->PathOfDevice());
    Succeed(device->Open());
    this->Session.Open(std::move(device), servo);
    if (touch.Drill != nullptr)
    {
      this->Session.UseEditor(touch.Drill->SharedEditor());
    }
    if (!settings.Recording.empty())
    {
      RequireInput(this->Session.StartRecording(
          settings.Recording, RecordingLimits(settings.IsVirtual && !touch.IsRealTimeOnly)));
    }
  }

  TouchResult RunVirtual(ManualClock& clock, const ProgressFunction& progress)
  {
    RequireInput(this->Session.Begin(*this->Touch.Scene, this->Touch.Frame));
    Servo& servo = this->Session.Loop();
    const SteadyClock watch;
    FixedRateLoop loop(clock, this->Period());
    const auto ticks = static_cast<std::uint64_t>(this->Touch.Duration * this->Touch.Settings.Rate);
    constexpr std::uint64_t TicksBetweenReports = 1024;
    loop.Run(
        [&](const TickInfo& tick)
        {
          // A simulated hand moves when it is read; this does not count as tick time.
          DeviceSample ahead;
          this->Session.Device().Read(ahead);
          const double time = this->Touch.Duration * this->PartAt(tick.Number);
          this->Act(time);
          const std::int64_t start = watch.Now();
          servo.Tick(tick);
          const std::int64_t spent = watch.Now() - start;
          this->TakeOrders();
          this->LookOut(time, servo.Latest());
          this->NoteRemoval(time);
          this->Result.Durations.Add(spent);
          this->Fetch(1e-3F * static_cast<float>(spent));
          const bool goesOn = tick.Number % TicksBetweenReports != 0 ||
                              progress(this->PartAt(tick.Number), "touch");
          return goesOn && tick.Number + 1 < ticks;
        });
    return this->Finished();
  }

  TouchResult RunReal(Clock& clock, const ProgressFunction& progress)
  {
    this->Home(progress);
    RequireInput(this->Session.Start(*this->Touch.Scene, this->Touch.Frame));
    this->Result.ThreadAdvice = this->Session.Grant().Advice;
    const std::int64_t start = clock.Now();
    double passed = 0.0;
    constexpr auto Nap = std::chrono::milliseconds(20);
    while (passed < this->Touch.Duration && progress(passed / this->Touch.Duration, "touch"))
    {
      this->Act(passed);
      std::this_thread::sleep_for(Nap);
      const TouchState& newest = this->Session.Loop().Latest();
      this->LookOut(passed, newest);
      if (this->Watcher)
      {
        this->Watcher(newest);
      }
      this->NoteRemoval(passed);
      this->Fetch();
      passed = SecondsPerNanosecond * static_cast<double>(clock.Now() - start);
    }
    this->Session.Pause();
    this->Fetch();
    this->Result.Durations = this->Session.Statistics().Durations;
    this->Result.Periods = this->Session.Statistics().Periods;
    return this->Finished();
  }

private:
  std::int64_t Period() const
  {
    return static_cast<std::int64_t>(
        std::llround(1.0 / (SecondsPerNanosecond * this->Touch.Settings.Rate)));
  }
  double PartAt(std::uint64_t tick) const
  {
    return static_cast<double>(tick) / (this->Touch.Duration * this->Touch.Settings.Rate);
  }

  // Executes the script's actions up to a time (s).
  void Act(double time)
  {
    Servo& servo = this->Session.Loop();
    const std::vector<DrillAction>& actions = this->Touch.Actions;
    for (; this->Done < actions.size() && actions[this->Done].Time <= time; ++this->Done)
    {
      const DrillAction::Kind kind = actions[this->Done].Do;
      if (kind == DrillAction::Kind::Start || kind == DrillAction::Kind::Stop)
      {
        servo.RunDrill(kind == DrillAction::Kind::Start);
      }
      else
      {
        servo.Command(CommandOf(kind));
      }
    }
  }

  void TakeOrders()
  {
    if (this->Touch.Drill != nullptr)
    {
      this->Touch.Drill->Editor().Take();
    }
  }

  void NoteRemoval(double time)
  {
    constexpr double Moments = 400.0;
    const double period = this->Touch.Duration / Moments;
    if (this->Touch.Drill != nullptr &&
        (this->Result.Removal.empty() || time >= this->Result.Removal.back().Time + period))
    {
      this->Result.Removal.push_back({time, this->Touch.Drill->Editor().RemovedVolumes()});
    }
  }

  void LookOut(double time, const TouchState& state)
  {
    for (const std::string& message : this->Watch.Look(time, state))
    {
      if (this->Guide)
      {
        this->Guide(message);
      }
    }
  }

  std::function<Vector3(double)> PathOfDevice() const
  {
    const PreparedTouch& touch = this->Touch;
    return [&touch](double time)
    {
      return Vector3((touch.Path.At(TimeOnPath(touch, time)) - touch.Frame.CenterWorld) /
                     touch.Frame.Scale);
    };
  }

  // Homes the device before forces start; if that fails or is stopped, the touch ends within its
  // first ticks.
  void Home(const ProgressFunction& progress)
  {
    if (this->Session.Device().State() != DeviceState::Homing)
    {
      return;
    }
    std::string said;
    HomeDevice(this->Session.Device(), 0.0,
               [&](const HomingView& view)
               {
                 if (this->Guide && view.Guidance != said && !view.Guidance.empty())
                 {
                   this->Guide(view.Guidance);
                 }
                 said = view.Guidance;
                 return progress(0.0, "homing");
               });
  }

  void Fetch(float microseconds = 0.0F)
  {
    const TouchSessionReading& now = this->Session.Poll();
    for (const TouchState& state : now.NewTicks)
    {
      this->Keeper.Add(state, microseconds);
    }
    this->NoteRecording(now.RecordingProblem);
  }

  // A recording that fails does not end the touch.
  void NoteRecording(const std::string& problem)
  {
    if (problem != this->Result.RecordingProblem && !problem.empty() && this->Guide)
    {
      this->Guide(problem);
    }
    this->Result.RecordingProblem = problem;
  }

  TouchResult Finished()
  {
    if (this->Session.IsRecording())
    {
      this->NoteRecording(this->Session.StopRecording().Message());
    }
    Servo& servo = this->Session.Loop();
    if (this->Touch.Drill != nullptr)
    {
      this->Result.RemovedVolumes = this->Touch.Drill->Editor().RemovedVolumes();
      this->Result.DrillProblem = this->Touch.Drill->Editor().Newest().Problem;
      this->Result.DrillOrders = servo.Latest().DrillOrders;
      this->Result.Approaches = this->Watch.Approaches();
    }
    this->Result.LostTicks = servo.LostTicks();
    this->Result.DeviceProblem = this->Session.Device().Problem();
    this->Result.SweepNote = NoteOnSweep(this->Touch, this->Result.Trace);
    return std::move(this->Result);
  }

  const PreparedTouch& Touch;
  const TouchGuide& Guide;
  const TouchWatcher& Watcher;
  TouchResult Result;
  TouchResultCollector Keeper;
  DrillWatch Watch;
  std::size_t Done = 0; // actions
  TouchSession Session;
};
} // namespace

PreparedTouch PrepareTouch(const SceneSettings& settings, const TouchScript& script,
                           const ProgressFunction& progress, BadMasks badMasks)
{
  PreparedTouch touch;
  BuiltScene built = BuildScene(settings, progress, badMasks);
  touch.LeftOut = std::move(built.LeftOut);
  if (built.Contacts.empty())
  {
    throw InputError("no structure of the scene is touchable; remove \"touched\": false from one "
                     "of its structures");
  }
  touch.Settings = std::move(built.Settings);
  touch.Drill = DrillContext::Make(touch.Settings, built.Contacts, built.Protections);
  if (touch.Drill == nullptr && !script.Actions.empty())
  {
    throw InputError(
        "no structure of the scene is drilled; give one of its structures a \"drill\"");
  }
  touch.Actions = script.Actions;
  touch.Structures = std::move(built.Touched);
  auto scene = std::make_shared<TouchScene>(
      MakeTouchScene(touch.Settings, built.Contacts, {}, built.Distances));
  if (touch.Drill != nullptr)
  {
    touch.Drill->PutInto(*scene);
  }
  ManualClock clock;
  const DeviceCapabilities device = MakeDevice(settings.Device, clock, {})->Capabilities();
  touch.Frame = WorkspaceFrame::Around(*scene, device);
  touch.Frame.Scale = settings.Placement.Scale.value_or(touch.Frame.Scale);
  touch.Frame.CenterWorld = settings.Placement.CenterWorld.value_or(touch.Frame.CenterWorld);
  scene->Frame = touch.Frame.ForDevice();
  RequireInput(scene->Check());
  touch.Path = script.Path;
  std::string silent = settings.Device;
  const bool sounds = TakeSound(silent);
  if (touch.Path.IsEmpty() && silent == SimulatedName)
  {
    RequireInput(SweepOf(*scene, script.SweepDepth, script.SweepSpeed,
                         script.Duration.value_or(std::numeric_limits<double>::infinity()),
                         touch.Path));
    touch.IsSweep = true;
    touch.SweepDepth = script.SweepDepth;
  }
  const double duration = touch.Path.IsEmpty() ? DefaultDuration : touch.Path.Duration();
  touch.Duration = script.Duration.value_or(duration);
  touch.IsRealTimeOnly = sounds || IsPluggedIn(silent);
  touch.Warnings = std::move(built.Warnings);
  const std::vector<std::string> stiffness = StiffnessWarnings(*scene, device, settings.Rate);
  touch.Warnings.insert(touch.Warnings.end(), stiffness.begin(), stiffness.end());
  touch.Scene = std::move(scene);
  return touch;
}

TouchResult RunTouch(const PreparedTouch& touch, const TouchRunSettings& settings,
                     const ProgressFunction& progress)
{
  if (settings.IsVirtual && !touch.IsRealTimeOnly)
  {
    ManualClock clock;
    return LiveTouch(touch, clock, settings).RunVirtual(clock, progress);
  }
  SteadyClock machine;
  Clock& clock = settings.Time != nullptr ? *settings.Time : machine;
  return LiveTouch(touch, clock, settings).RunReal(clock, progress);
}

TouchComparison CompareTouch(const PreparedTouch& touch, const std::filesystem::path& recording)
{
  auto read = std::make_shared<TouchRecording>();
  RequireInput(ReadTouchRecording(recording.string(), *read));
  ReplayComparison comparison;
  BeforeReplayedTick beforeTick;
  if (touch.Drill != nullptr)
  {
    beforeTick = [&touch](const TouchState& tick)
    { touch.Drill->Editor().Take(tick.DrillVersion); };
  }
  RequireInput(ReplayTouch(std::move(read), {touch.Scene}, comparison, beforeTick));
  if (touch.Drill != nullptr)
  {
    touch.Drill->Editor().Take();
  }
  return {comparison.Ticks, comparison.DifferentTicks, comparison.LargestDifference};
}
} // namespace palpate
