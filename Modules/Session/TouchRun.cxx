#include "TouchRun.h"

#include "DeviceHoming.h"
#include "DeviceList.h"
#include "DrillKeeper.h"
#include "EndBeforeExit.h"
#include "InputError.h"
#include "ManualClock.h"
#include "OpenBuiltInDevice.h"
#include "Refusal.h"
#include "SceneKeeper.h"
#include "ServoThread.h"
#include "SimulatedDevice.h"
#include "SteadyClock.h"
#include "StiffnessAdvice.h"
#include "SurfaceTool.h"
#include "TouchRecorder.h"
#include "TouchReplay.h"
#include "TouchResultKeeper.h"
#include "TouchStandIns.h"
#include "WorkspaceFrame.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

namespace palpate
{
namespace
{
constexpr double Nano = 1e-9;
constexpr const char* SimulatedName = "simulated";
constexpr double DefaultDuration = 10.0; // s, where no path says how long

// What is not the user's fault.
void Succeed(const Status& status)
{
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
}

// The device of a name; its hand follows `path` (device's frame) where it has none of its own.
std::unique_ptr<HapticDevice> MakeDevice(const std::string& name, Clock& clock,
                                         std::function<Vector3(double)> path)
{
  if (name == SimulatedName)
  {
    SimulatedSettings settings;
    settings.Path = std::move(path);
    return std::make_unique<SimulatedDevice>(clock, settings);
  }
  std::unique_ptr<HapticDevice> device;
  RequireInput(MakeBuiltInDevice(name, clock, device));
  return device;
}

// A sweep is gone to and fro for as long as a touch lasts; other paths end.
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

OnDemandParts PartsOf(const PreparedTouch& touch)
{
  OnDemandParts parts{{}, touch.Degrees};
  for (const TouchableStructure& structure : touch.Structures)
  {
    if (structure.OnDemand != nullptr)
    {
      parts.Fields.push_back(structure.OnDemand);
    }
  }
  return parts;
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

// All of it while a tool touches.
class LiveTouch
{
public:
  LiveTouch(const PreparedTouch& touch, Clock& clock, const TouchRunSettings& settings)
      : Touch(touch), View(settings.View), Guide(settings.Guide),
        Keeper(Result, touch.Structures.size()), Watch(touch.Drill),
        IsRecording(!settings.Recording.empty()),
        Recorder(RecordingLimits(settings.IsVirtual && !touch.IsRealTimeOnly))
  {
    this->Settings.Rate = touch.Settings.Rate;
    this->Settings.ModelInterval = touch.Settings.ModelInterval;
    this->Device = MakeDevice(touch.Settings.Device, clock, this->PathOfDevice());
    Succeed(this->Device->Open());
    if (this->IsRecording)
    {
      RequireInput(this->Recorder.Start(settings.Recording.string(),
                                        {this->Settings, this->Device->Capabilities()}));
    }
  }
  ~LiveTouch()
  {
    this->Thread.reset();
    this->Device->Close();
  }
  LiveTouch(const LiveTouch&) = delete;
  LiveTouch& operator=(const LiveTouch&) = delete;

  TouchResult RunVirtual(ManualClock& clock, const ProgressFunction& progress)
  {
    Servo servo(*this->Device, this->Settings);
    RequireInput(servo.Publish(this->Touch.Scene));
    SceneKeeper keeper(PartsOf(this->Touch), this->Touch.Scene->Probe);
    this->LookAhead(keeper);
    const SteadyClock watch;
    FixedRateLoop loop(clock, this->Period());
    const auto ticks = static_cast<std::uint64_t>(this->Touch.Duration * this->Settings.Rate);
    constexpr std::uint64_t TicksBetweenReports = 1024;
    loop.Run(
        [&](const TickInfo& tick)
        {
          // A computed hand moves when it is read; that is no part of the tick's own time.
          DeviceSample ahead;
          this->Device->Read(ahead);
          const double time = this->Touch.Duration * this->PartAt(tick.Number);
          this->Act(servo, time);
          const std::int64_t start = watch.Now();
          servo.Tick(tick);
          const std::int64_t spent = watch.Now() - start;
          keeper.Look(Nano * static_cast<double>(tick.Started));
          this->TakeOrders();
          this->LookOut(time, servo.Latest());
          this->NoteRemoval(time);
          this->Result.Durations.Add(spent);
          this->Fetch(servo, 1e-3F * static_cast<float>(spent));
          const bool goesOn = tick.Number % TicksBetweenReports != 0 ||
                              progress(this->PartAt(tick.Number), "touch");
          return goesOn && tick.Number + 1 < ticks;
        });
    return this->Finished(servo, keeper);
  }

  TouchResult RunReal(Clock& clock, const ProgressFunction& progress)
  {
    this->Home(progress);
    this->Thread = std::make_unique<ServoThread>(*this->Device, clock, this->Settings);
    ServoThread& thread = *this->Thread;
    RequireInput(thread.Loop().Publish(this->Touch.Scene));
    SceneKeeper keeper(PartsOf(this->Touch), this->Touch.Scene->Probe);
    this->LookAhead(keeper);
    keeper.Start(clock);
    DrillKeeper drill(this->Touch.Drill);
    drill.Start();
    RequireInput(thread.Start({}));
    this->Result.ThreadAdvice = thread.Grant().Advice;
    const std::int64_t start = clock.Now();
    double passed = 0.0;
    while (passed < this->Touch.Duration && progress(passed / this->Touch.Duration, "touch"))
    {
      this->Act(thread.Loop(), passed);
      this->Look(thread.Loop(), clock, passed);
      this->LookOut(passed, thread.Loop().Latest());
      this->NoteRemoval(passed);
      this->SayLevel(thread.Loop().Latest());
      this->Fetch(thread.Loop());
      passed = Nano * static_cast<double>(clock.Now() - start);
    }
    this->Result.FramesPerSecond = static_cast<double>(this->Result.Frames.Count()) / passed;
    thread.Stop();
    keeper.Stop();
    drill.Stop();
    this->Fetch(thread.Loop());
    this->Result.Durations = thread.Statistics().Durations;
    this->Result.Periods = thread.Statistics().Periods;
    return this->Finished(thread.Loop(), keeper);
  }

private:
  // Where the process ends within RunReal: no force, and a recording that is whole.
  void EndNow() noexcept
  {
    if (this->Thread == nullptr || !this->Thread->IsRunning())
    {
      return; // nothing pushes
    }
    this->Thread->Stop();
    this->Device->Close();
    try
    {
      this->Fetch(this->Thread->Loop());
      if (this->IsRecording)
      {
        Succeed(this->Recorder.Finish());
      }
    }
    catch (const std::exception&)
    {
      // What was recorded so far stays under its temporary name.
    }
  }

  std::int64_t Period() const
  {
    return static_cast<std::int64_t>(std::llround(1.0 / (Nano * this->Settings.Rate)));
  }
  double PartAt(std::uint64_t tick) const
  {
    return static_cast<double>(tick) / (this->Touch.Duration * this->Settings.Rate);
  }

  // What the person who drills does until a time, s.
  void Act(Servo& servo, double time)
  {
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
    for (const std::string& sentence : this->Watch.Look(time, state))
    {
      if (this->Guide)
      {
        this->Guide(sentence);
      }
    }
  }

  // Where the first tick is known to be.
  void LookAhead(SceneKeeper& keeper) const
  {
    if (!this->Touch.Path.IsEmpty())
    {
      keeper.LookAt(this->Touch.Path.At(0.0), 0.0);
    }
  }

  std::function<Vector3(double)> PathOfDevice() const
  {
    const PreparedTouch& touch = this->Touch;
    return [&touch, middle = Vector3(touch.Scene->BoundsWorld().center())](double time)
    { return Vector3((touch.Path.At(TimeOnPath(touch, time)) - middle) / touch.Scale); };
  }

  // Before forces can start; where it fails or is stopped, the touch ends with its first ticks.
  void Home(const ProgressFunction& progress)
  {
    if (this->Device->State() != DeviceState::Homing)
    {
      return;
    }
    std::string said;
    HomeDevice(*this->Device, 0.0,
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

  // Draws a picture, or waits for about as long as one takes.
  void Look(Servo& servo, const Clock& clock, double time)
  {
    constexpr auto Nap = std::chrono::milliseconds(20);
    if (!this->View)
    {
      std::this_thread::sleep_for(Nap);
      return;
    }
    const std::int64_t start = clock.Now();
    this->View(time, servo.Latest());
    this->Result.Frames.Add(clock.Now() - start);
  }

  // Whenever something else is felt, since ticks took too long or have time again.
  void SayLevel(const TouchState& newest)
  {
    if (this->Guide && newest.Level != this->SaidLevel)
    {
      const std::string coarser =
          LevelText(*this->Touch.Scene, newest.Level, newest.Structure, this->Settings.Rate);
      this->Guide(coarser.empty() ? "Ticks have time again: the models themselves are felt."
                                  : coarser);
    }
    this->SaidLevel = newest.Level;
  }

  void Fetch(Servo& servo, float microseconds = 0.0F)
  {
    TouchState state;
    while (servo.PopRecorded(state))
    {
      this->Keeper.Add(state, microseconds);
      if (this->IsRecording)
      {
        this->NoteRecording(this->Recorder.Take(state));
      }
    }
  }

  // What cannot be recorded is touched all the same.
  void NoteRecording(const Status& status)
  {
    if (!status.IsOk())
    {
      this->IsRecording = false;
      this->Result.RecordingProblem = status.Message();
      if (this->Guide)
      {
        this->Guide(status.Message());
      }
    }
  }

  TouchResult Finished(Servo& servo, const SceneKeeper& keeper)
  {
    this->Result.CoarseTicks = keeper.CoarseTicks();
    this->Result.MissingParts = keeper.Problem();
    if (this->IsRecording)
    {
      this->NoteRecording(this->Recorder.Finish());
    }
    if (this->Touch.Drill != nullptr)
    {
      this->Result.RemovedVolumes = this->Touch.Drill->Editor().RemovedVolumes();
      this->Result.DrillProblem = this->Touch.Drill->Editor().Newest().Problem;
      this->Result.DrillOrders = servo.Latest().DrillOrders;
      this->Result.Approaches = this->Watch.Approaches();
    }
    this->Result.LostTicks = servo.LostTicks();
    this->Result.DeviceProblem = this->Device->Problem();
    this->Keeper.Close();
    return std::move(this->Result);
  }

  const PreparedTouch& Touch;
  const TouchViewer& View;
  const TouchGuide& Guide;
  ServoSettings Settings;
  std::unique_ptr<HapticDevice> Device;
  TouchResult Result;
  TouchResultKeeper Keeper;
  DrillWatch Watch;
  std::size_t Done = 0; // actions
  bool IsRecording;
  int SaidLevel = 0;
  TouchRecorder Recorder;
  std::unique_ptr<ServoThread> Thread; // in real time
  EndBeforeExit End{[this] { this->EndNow(); }};
};
} // namespace

PreparedTouch PrepareTouch(const TouchSettings& asked, const TouchScript& script,
                           const ProgressFunction& progress)
{
  PreparedTouch touch;
  touch.Settings = asked;
  const TouchSettings& settings = touch.Settings;
  if (settings.Tool.Kind == TouchToolSettings::Shape::Surface)
  {
    const auto& structures = settings.Structures;
    const bool cuts = std::any_of(structures.begin(), structures.end(),
                                  [](const TouchStructureSettings& s) { return s.IsDrilled(); });
    touch.Settings.Tool.Surface = SurfaceOf(settings.Tool, cuts);
  }
  TouchStructures made = MakeTouchStructures(settings, script.IsSeen, progress);
  if (made.Touched.empty())
  {
    throw InputError(
        "nothing of the scene is to be touched; leave \"touched\": false out of one of "
        "its structures");
  }
  touch.Drill = DrillBench::Make(settings, made, progress);
  if (touch.Drill == nullptr && !script.Actions.empty())
  {
    throw InputError(
        "nothing of the scene is to be drilled; give one of its structures a \"drill\"");
  }
  touch.Actions = script.Actions;
  touch.Structures = std::move(made.Touched);
  touch.OnlySeen = std::move(made.OnlySeen);
  touch.Degrees = std::move(made.Degrees);
  auto scene = std::make_shared<TouchScene>();
  scene->Tool = MakeTool(settings.Tool);
  if (!PartsOf(touch).IsEmpty())
  {
    scene->Probe = std::make_shared<LatestValue<PlainVector3>>();
  }
  for (const TouchableStructure& structure : touch.Structures)
  {
    scene->Structures.push_back(structure.Touch);
  }
  if (touch.Drill != nullptr)
  {
    touch.Drill->PutInto(*scene);
  }
  ManualClock clock;
  const DeviceCapabilities device = MakeDevice(settings.Device, clock, {})->Capabilities();
  touch.Scale = settings.Scale.value_or(ReachingScale(*scene, device));
  scene->Frame = DeviceFrame(Matrix3::Identity(), touch.Scale, scene->BoundsWorld().center());
  RequireInput(scene->Check());
  touch.Path = script.Path;
  if (touch.Path.IsEmpty() && settings.Device == SimulatedName)
  {
    SceneKeeper keeper(PartsOf(touch), scene->Probe);
    double time = 0.0; // a tool that is led from place to place has as much as it wants
    const auto comes = [&](const Vector3& place)
    {
      if (scene->Probe != nullptr)
      {
        scene->Probe->Publish(place);
        keeper.Look(time += 1.0);
      }
    };
    RequireInput(SweepOf(*scene, script.SweepDepth, script.SweepSpeed, touch.Path, comes));
    touch.IsSweep = true;
  }
  const double duration = touch.Path.IsEmpty() ? DefaultDuration : touch.Path.Duration();
  touch.Duration = script.Duration.value_or(duration);
  touch.IsRealTimeOnly = IsPluggedIn(settings.Device);
  touch.Warnings = StiffnessWarnings(*scene, device, settings.Rate);
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
  SceneKeeper keeper(PartsOf(touch), touch.Scene->Probe);
  if (!read->Ticks.empty())
  {
    keeper.LookAt(read->Ticks.front().ProbeWorld, 0.0);
  }
  ReplayWorkers workers;
  workers.AfterTick = [&keeper](double time) { keeper.Look(time); };
  if (touch.Drill != nullptr)
  {
    workers.BeforeTick = [&touch](const TouchState& tick)
    { touch.Drill->Editor().Take(tick.DrillVersion); };
  }
  RequireInput(ReplayTouch(std::move(read), {touch.Scene}, comparison, workers));
  if (touch.Drill != nullptr)
  {
    touch.Drill->Editor().Take();
  }
  return {comparison.Ticks, comparison.DifferentTicks, comparison.LargestDifference};
}
} // namespace palpate
