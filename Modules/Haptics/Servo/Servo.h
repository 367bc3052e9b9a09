#pragma once

#include "HapticDevice.h"
#include "LatestValue.h"
#include "RingBuffer.h"
#include "SafetyChain.h"
#include "ServoScene.h"
#include "SnapshotSlot.h"
#include "TouchState.h"
#include "VelocityEstimate.h"

#include <atomic>
#include <memory>

namespace palpate
{
struct ServoSettings
{
  double Rate = 1000.0;                ///< Hz, of ticks
  int ModelInterval = 1;               ///< ticks from one question to the models to the next
  double VelocityTimeConstant = 0.003; ///< s
  double RampDuration = 0.3;           ///< s
  double MaximumSlew = 2000.0;         ///< N/s
  /// Buttons of the device that are the drill's pedal, a bit each as in DeviceSample; 0: none.
  std::uint32_t PedalButtons = 0;
  /// Ticks kept for a recording until somebody fetches them; 0 keeps one.
  std::size_t RecordedTicks = 4096;
};

/// The way from a device's position to its force, one tick at a time: read, map to the world,
/// follow every structure in reach, add the forces, pass the safety chain, apply, publish. What a
/// tick does depends on its TickInfo, the device's samples and the scene alone, so that
/// a recorded session gives the same forces to the last bit.
///
/// Publish, Reclaim, Command: one publishing thread. Tick: the servo thread. Latest: one reading
/// thread. PopRecorded: one recording thread. Rearm, SwitchOff, RunDrill, LiftPedals: any. Resume:
/// while no thread ticks.
class Servo
{
public:
  /// Keeps the address of the device, which must outlive it and whose capabilities it takes as
  /// they are now: open it before.
  Servo(HapticDevice& device, const ServoSettings& settings);

  /// Makes what the servo needs to feel `scene`, which it then takes over in its next tick. Refuses
  /// a scene that cannot be felt; the one before stays.
  ///
  /// Anew it fades in from nothing. Continuing, structures of the same id go on: their proxies stay
  /// where they are in the world, whatever became of shape, law, tool and frame, and go to the
  /// probe from there; the force goes from what it was to what it is now within HandoverDuration,
  /// and what only now is round the tool is felt more and more, as at a start. Where nothing was
  /// felt yet, nothing can go on.
  Status Publish(std::shared_ptr<const TouchScene> scene, SceneEntry entry = SceneEntry::Anew);
  /// Destroys scenes that the servo has done with; Publish does it too.
  void Reclaim() noexcept { this->Scenes.Reclaim(); }

  /// Switches forces on again after a fault, from the next tick on.
  void Rearm() noexcept { this->RearmWanted.store(true, std::memory_order_release); }
  /// 0 N from the next tick on, until Rearm; the tool is followed all the same.
  void SwitchOff() noexcept { this->OffWanted.store(true, std::memory_order_release); }

  /// The drill's pedal: while it is down what is touched and has wear gives way. A fault takes it
  /// up. The device's PedalButtons are a second one, read in the tick itself; one that is down at
  /// the first tick or during a fault counts only once it was released.
  void RunDrill(bool runs) noexcept { this->Pedal.store(runs, std::memory_order_release); }
  /// Takes up both pedals: one that is held has to be pressed again. Before a Publish, nothing of
  /// that scene is cut by a pedal that was held already.
  void LiftPedals() noexcept
  {
    this->Pedal.store(false, std::memory_order_release);
    this->LiftWanted.store(true, std::memory_order_release);
  }
  /// For who edits what is drilled (TouchDrill::Link); each of the next ticks takes one. False
  /// where so many wait that this one is lost.
  bool Command(DrillCommand command) noexcept { return this->Commands.Push(command); }

  /// Before ticks go on after a pause of any length: motion is forgotten, the pedal is up, and
  /// forces fade in from 0 N. A fault stays.
  void Resume() noexcept;
  void Tick(const TickInfo& tick) noexcept;

  const TouchState& Latest() noexcept { return this->Newest.Latest(); }
  /// The oldest tick that was not fetched yet; false where there is none.
  bool PopRecorded(TouchState& state) noexcept { return this->Recorded.Pop(state); }
  /// Ticks that were lost since nobody fetched them in time.
  std::uint64_t LostTicks() const noexcept { return this->Recorded.Dropped(); }

private:
  // What the models said to the newest sample.
  struct Answer
  {
    ServoScene::Feeling Felt;
    Vector3 AmbientForce = Vector3::Zero(); // N, device's frame
    ToolPose Pose;
  };

  // What other threads wanted since the last tick.
  struct Change
  {
    bool IsRearmed = false;
    bool IsContinued = false; // the scene, by another one
    DrillCommand Command = DrillCommand::None;
  };

  Change TakeOver(const TickObservation& now) noexcept;
  bool TakeOverScene() noexcept;
  DrillCommand TakeCommand(bool endsStroke) noexcept;
  bool IsPedalDown(const TickObservation& now) noexcept;
  void ReleaseButton() noexcept;
  void ReleasePedal() noexcept;
  void OrderCuts() noexcept;
  TickObservation Observe(const TickInfo& tick) noexcept;
  void Feel(const TickObservation& now) noexcept;
  FollowStep StepTo(const DeviceSample& sample, double passed) noexcept;
  void ForgetMotion() noexcept;
  SafetyInput InputOf(const TickObservation& now) const noexcept;
  bool Send(const Vector3& force) noexcept;
  TouchState StateOf(const TickObservation& now, const Vector3& force) noexcept;

  // Exchanged with other threads, on cache lines of their own.
  RingBuffer<TouchState> Recorded;
  SnapshotSlot<ServoScene> Scenes;
  LatestValue<TouchState> Newest;
  RingBuffer<DrillCommand> Commands{16};

  // The servo thread's own.
  ToolPose LastAsked; // at the last question to the models
  Answer Current;
  HapticDevice& Device;
  std::uint64_t SceneCount = 0;
  ServoSettings Settings;
  VelocityEstimate HandVelocity; // mm/s, device's frame
  DeviceSample LastFelt;
  double MostForce; // N, of the device
  SafetyChain Safety;
  Vector3 Carrying;     // N, of the device's gravity compensation
  int MostUntaken;      // ticks in a row whose force the device may leave
  int UntakenTicks = 0; // in a row, of a device that is Ready
  int TicksSinceModel = 0;
  std::atomic<bool> RearmWanted{false}; // any thread's
  std::atomic<bool> OffWanted{false};   // any thread's
  std::atomic<bool> LiftWanted{false};  // any thread's, of the button
  std::atomic<bool> Pedal{false};       // any thread's
  bool IsDrilling = false;              // in this tick
  bool IsButtonPedal = false;           // a pedal button was pressed and runs the drill
  bool WasButtonDown = true;            // in the last tick
  double TickTime = 0.0;                // s, of this tick
  std::uint64_t OrderCount = 0;         // that were given so far
  bool HasFelt = false;
  bool CarriesOn = false; // the next step is the first of a scene that continues another one
};
} // namespace palpate
