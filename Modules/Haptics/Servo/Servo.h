#pragma once

#include "HapticDevice.h"
#include "LatestValue.h"
#include "RingBuffer.h"
#include "SafetyChain.h"
#include "ServoScene.h"
#include "SnapshotSlot.h"
#include "TouchState.h"
#include "TurnLimit.h"
#include "VelocityEstimate.h"

#include <atomic>
#include <memory>

namespace palpate
{
struct ServoSettings
{
  double Rate = 1000.0;                ///< Hz, of ticks
  int ModelInterval = 1;               ///< ticks between model queries
  double VelocityTimeConstant = 0.003; ///< s
  double RampDuration = 0.3;           ///< s
  double MaximumSlew = 2000.0;         ///< N/s
  /// Buttons of the device that act as the drill's pedal, one bit each as in DeviceSample; 0: none.
  std::uint32_t PedalButtons = 0;
  /// Buttons that act as HoldClutch, one bit each.
  std::uint32_t ClutchButtons = 0;
  /// Ticks kept for a recording until fetched; 0 keeps one.
  std::size_t RecordedTicks = 4096;
};

/// Computes the force for a device's position, one tick at a time: read, map to the world, track
/// every structure in reach, add the forces, pass the safety chain, apply, publish. A tick depends
/// on its TickInfo, the device's samples and the scene alone, so that a recorded session gives the
/// same forces to the last bit.
///
/// Publish, Reclaim, Command: one publishing thread. Tick: the servo thread. Latest: one reading
/// thread. PopRecorded: one recording thread. Rearm, SwitchOff, HoldClutch, SetClutchButtons,
/// ReleaseClutch, RunDrill, LiftPedals: any. Resume, StaysOff: while no thread ticks.
class Servo
{
public:
  /// Keeps the address of the device, which must outlive the servo. Copies its capabilities: open
  /// it before.
  Servo(HapticDevice& device, const ServoSettings& settings);

  /// Prepares `scene`, which the servo thread adopts in its next tick. Fails for an invalid scene;
  /// the previous one then stays.
  ///
  /// No scene pushes a hand that it finds inside a structure: that structure is buried, and exerts
  /// no force until the tool has left it. FadeIn: that holds for all structures. Continuing: those
  /// with the same id carry on if the tool touched them, has not jumped by more than 1 mm of the
  /// hand with a new frame, and is free at its old proxy or up to StructureFollower::MostLifted
  /// above it. Force and torque change from the old to the new one within HandoverDuration and,
  /// however stiff, large or magnified the new scene is, rise by what the hand pushes and turns on
  /// only (HandoverLimit). Force fields, such as guides, are not limited: they fade in within
  /// HandoverDuration. Continuing has no effect if nothing was rendered yet.
  Status Publish(std::shared_ptr<const TouchScene> scene, SceneEntry entry = SceneEntry::FadeIn);
  /// Destroys scenes that the servo no longer uses; Publish calls it too.
  void Reclaim() noexcept { this->Scenes.Reclaim(); }

  /// Switches forces on again after a fault, from the next tick on. Only without motors, faults of
  /// timing end by themselves too: contacts then carry on, and the drill's pedal is up.
  void Rearm() noexcept { this->RearmWanted.store(true, std::memory_order_release); }
  /// 0 N from the next tick on, until Rearm; the tool is still tracked.
  void SwitchOff() noexcept { this->OffWanted.store(true, std::memory_order_release); }

  /// Whether a person has switched forces off, also if no tick has consumed that yet, or has to end
  /// a fault.
  bool StaysOff() const noexcept;

  /// From the next tick on no structure and no force field of any scene is felt, until
  /// ReleaseClutch. Holding a ClutchButton does the same within the tick, however late other
  /// threads are.
  void HoldClutch() noexcept { this->ClutchWanted.store(true, std::memory_order_release); }
  /// Others from the next tick on, one bit each; one that is down then counts as pressed.
  void SetClutchButtons(std::uint32_t buttons) noexcept
  {
    this->ClutchButtons.store(buttons, std::memory_order_release);
  }
  /// Ends that, unless a ClutchButton is down. Publish the scene to return to before.
  void ReleaseClutch() noexcept { this->UnclutchWanted.store(true, std::memory_order_release); }

  /// The drill's pedal: while it is down, touched structures with wear are removed. A fault
  /// releases it. The device's PedalButtons are a second pedal, read in the tick itself; one that
  /// is down at the first tick or during a fault counts only after it was released.
  void RunDrill(bool runs) noexcept { this->Pedal.store(runs, std::memory_order_release); }
  /// Releases both pedals: a held one must be pressed again. Call it before Publish so that a held
  /// pedal cuts nothing of the new scene.
  void LiftPedals() noexcept
  {
    this->Pedal.store(false, std::memory_order_release);
    this->LiftWanted.store(true, std::memory_order_release);
  }
  /// Queues a command for the drill editor (TouchDrill::Link); one is consumed per tick. Returns
  /// false if the queue is full.
  bool Command(DrillCommand command) noexcept { return this->Commands.Push(command); }

  /// Call before ticks continue after a pause of any length: motion is reset, the pedal is up, and
  /// forces fade in from 0 N. A fault remains.
  void Resume() noexcept;
  void Tick(const TickInfo& tick) noexcept;

  const TouchState& Latest() noexcept { return this->Newest.Latest(); }
  /// The oldest tick not fetched yet; returns false if there is none.
  bool PopRecorded(TouchState& state) noexcept { return this->Recorded.Pop(state); }
  /// Ticks lost because they were not fetched in time.
  std::uint64_t LostTicks() const noexcept { return this->Recorded.Dropped(); }

private:
  // The models' results for the newest sample.
  struct Answer
  {
    ServoScene::Feeling Felt;
    ToolPose Pose;
  };

  // Requests of other threads since the last tick.
  struct Change
  {
    bool IsRearmed = false;
    bool IsContinued = false; // by another scene
    DrillCommand Command = DrillCommand::None;
  };

  Change TakeOver(const TickObservation& now) noexcept;
  bool TakeOverScene() noexcept;
  DrillCommand TakeCommand(bool endsStroke) noexcept;
  void TakeClutch(const TickObservation& now, bool isReleased) noexcept;
  bool IsPedalDown(const TickObservation& now) noexcept;
  void ReleaseButton() noexcept;
  void ReleasePedal() noexcept;
  void OrderCuts() noexcept;
  TickObservation Observe(const TickInfo& tick) noexcept;
  void Feel(const TickObservation& now) noexcept;
  FollowStep StepTo(const DeviceSample& sample, double passed) noexcept;
  void ForgetMotion() noexcept;
  SafetyInput InputOf(const TickObservation& now) const noexcept;
  bool Send(const Vector3& force, const Vector3& torque) noexcept;
  TouchState StateOf(const TickObservation& now, const Vector3& force) noexcept;

  // Exchanged with other threads, on separate cache lines.
  RingBuffer<TouchState> Recorded;
  SnapshotSlot<ServoScene> Scenes;
  LatestValue<TouchState> Newest;
  RingBuffer<DrillCommand> Commands{16};

  // Used by the servo thread only.
  ToolPose LastAsked; // at the last model query
  Answer Current;
  HapticDevice& Device;
  std::uint64_t SceneCount = 0;
  ServoSettings Settings;
  VelocityEstimate HandVelocity; // mm/s, device's frame
  TurnLimit Turning;             // of the device
  DeviceSample LastFelt;
  double MostForce;  // N, of the device
  double TurnLength; // mm, of the device
  SafetyChain Safety;
  Vector3 Carrying;     // N, for the device's gravity compensation
  int MostUntaken;      // consecutive ticks in which the device may refuse the force
  int UntakenTicks = 0; // consecutive, while the device is Ready
  int TicksSinceModel = 0;
  std::atomic<std::uint32_t> ClutchButtons; // set by any thread
  std::atomic<bool> RearmWanted{false};     // set by any thread
  std::atomic<bool> OffWanted{false};       // set by any thread
  std::atomic<bool> ClutchWanted{false};    // set by any thread
  std::atomic<bool> UnclutchWanted{false};  // set by any thread
  std::atomic<bool> LiftWanted{false};      // set by any thread, for the button
  std::atomic<bool> Pedal{false};           // set by any thread
  bool IsClutched = false;                  // in this tick
  bool IsDrilling = false;                  // in this tick
  bool IsButtonPedal = false;               // a pedal button was pressed and runs the drill
  bool WasButtonDown = true;                // in the last tick
  double TickTime = 0.0;                    // s, of this tick
  std::uint64_t OrderCount = 0;             // number of orders so far
  bool HasFelt = false;
  bool CarriesOn = false; // the next step is the first of a scene that continues another one
};
} // namespace palpate
