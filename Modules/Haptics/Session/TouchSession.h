#pragma once

#include "Clock.h"
#include "DrillWorker.h"
#include "EndBeforeExit.h"
#include "HandPress.h"
#include "HapticDevice.h"
#include "PeriodStatistics.h"
#include "RealtimeThread.h"
#include "ServoThread.h"
#include "TouchRay.h"
#include "TouchRecorder.h"
#include "TouchScene.h"
#include "TouchWatch.h"
#include "WorkspaceClutch.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// The state of a session at its last poll.
struct TouchSessionReading
{
  TouchState Newest;                ///< while the clutch is held, with the tool's held position
  std::vector<TouchState> NewTicks; ///< since the last poll, oldest first
  std::vector<TouchChange> Changes; ///< within them
  bool IsClutched = false;          ///< the clutch is held, and touch is off
  std::uint64_t LostTicks = 0;      ///< that no poll has returned
  std::uint64_t RecordedTicks = 0;  ///< of the current or the last recording
  std::string RecordingProblem;     ///< why a recording ended early; empty without
};

/// A scene while it is touched: an open device, its servo, the workspace and its clutch, a
/// recording, and the drill worker. Used by the command line, the window and VTK's interactor style
/// alike. For one owner thread; only Start, Stop and the start of a recording wait.
class TouchSession
{
public:
  /// Keeps the address of the clock.
  explicit TouchSession(Clock& clock, const RealtimeRequest& request = {});
  TouchSession(const TouchSession&) = delete;
  TouchSession& operator=(const TouchSession&) = delete;
  /// Stops, forces first.
  ~TouchSession() { this->Stop(); }

  /// The device's clutch button, from 0; -1 for none. Takes effect in the next tick; a clutch that
  /// is held is released.
  void SetClutchButton(int button);

  /// Adopts an open device, for servos with these settings. Stops the current session.
  void Open(std::unique_ptr<HapticDevice> opened, const ServoSettings& settings);
  bool IsOpen() const { return this->Opened != nullptr; }
  HapticDevice& Device() { return *this->Opened; }
  const HapticDevice& Device() const { return *this->Opened; }

  /// Creates the servo for a scene, without a thread: the caller ticks Loop().
  Status Begin(TouchScene scene, const WorkspaceFrame& frame);
  /// Begin, and then a thread that ticks at the servo's rate.
  /// `staysOff`: 0 N from the first tick on, until a person allows forces.
  Status Start(TouchScene scene, const WorkspaceFrame& frame, bool staysOff = false);
  bool IsRunning() const { return this->Thread != nullptr; }
  /// Stops ticking with 0 N; the device stays open, and remaining ticks can still be polled.
  void Pause();
  /// 0 N; the device is closed and a recording is finished.
  void Stop();

  /// Changes the scene from the next tick on; see Servo::Publish. If it fails, the previous scene
  /// stays. `keepsTool`: a frame of another scale or rotation is moved so that a touching tool
  /// stays in place and keeps its contact; Moved then includes that motion.
  Status Publish(TouchScene scene, WorkspaceFrame frame, SceneEntry entry, bool keepsTool = false);
  /// The current scene; null before the first.
  const std::shared_ptr<const TouchScene>& Scene() const { return this->Current; }
  const WorkspaceFrame& Frame() const { return this->Place; }
  /// How far the clutch, and changes that kept the tool, have moved the workspace since Begin, mm.
  const Vector3& Moved() const { return this->AllMoved; }

  /// Executes the servo's drill orders from now on; null for none.
  void UseEditor(std::shared_ptr<DrillEditor> editor);

  /// The servo of a running session.
  Servo& Loop() { return this->Thread->Loop(); }
  const ServoStatistics& Statistics() { return this->Thread->Statistics(); }
  const RealtimeGrant& Grant() const { return this->Thread->Grant(); }

  /// Moves the hand of a simulated device to a place of the device (mm). Returns false, without
  /// effect, for a real device.
  bool LeadHand(const Vector3& handDevice);
  /// What a display measured: mm of the world from the tool to the nearest structure.
  void TellDistance(double distance) noexcept
  {
    if (this->IsOpen())
    {
      this->Opened->TellDistance(distance / this->Place.Scale);
    }
  }
  /// Goal of such a hand (mm); it moves with the workspace.
  Vector3 HandWorld() const { return this->Place.ToWorld(this->Hand); }

  /// Where the tool comes to rest on the scene, as it is drilled, if it moves from `from` to `to`
  /// (world, mm): 0.6 mm of the hand outside.
  std::optional<TouchRay::Rest> RestBetween(const Vector3& from, const Vector3& to);
  /// The rest nearest to a point (world, mm) along lines in a plane that two unit vectors span: of
  /// a tool at the point if something can be touched, or contains it, within `reach` mm.
  std::optional<TouchRay::Rest> RestInPlane(const Vector3& point, const Vector3& right,
                                            const Vector3& up, double reach);
  /// Whether RestInPlane may find one: tried at the point and at eight around it.
  bool HasRestAround(const Vector3& point, const Vector3& right, const Vector3& up, double reach);
  /// For hands that point: from LiftHand to PressHand the hand moves without contacts and forces.
  /// PressHand is for a hand that was led to a rest; it takes effect once the hand is there.
  void LiftHand();
  void PressHand();
  /// How far (mm of the world) beyond a structure's surface such a hand, which holds its device
  /// with 0.5 N/mm, has to aim to push with `force` (N); at most 25 mm of the hand. Takes
  /// milliseconds.
  double PushFor(double force, int structure) const;

  /// Returns what happened since the last poll; call it about ten times a second or more often.
  /// Also passes the ticks to a recording.
  const TouchSessionReading& Poll();

  /// Records from now on. A session replays from its first tick, so a running servo is restarted
  /// for it, and forces fade in.
  Status StartRecording(const std::filesystem::path& path, BackgroundWriter::Limits limits = {});
  bool IsRecording() const { return this->Recorder != nullptr; }
  Status StopRecording();

private:
  void MakeServo();
  Status Run();
  void TakeTicks();
  void AimThroughScene();
  void HoldClutch(bool isHeld, const TouchState& now);
  Vector3 ShiftThatKeepsTool(const WorkspaceFrame& frame);

  Clock& Time;
  RealtimeRequest Request;
  ServoSettings Settings;
  int ClutchButton = -1;
  std::unique_ptr<HapticDevice> Opened; // before the thread that uses it
  std::unique_ptr<EndBeforeExit> End;   // while there is a device
  std::unique_ptr<ServoThread> Thread;
  std::shared_ptr<const TouchScene> Current;
  std::shared_ptr<DrillEditor> Editor;
  DrillWorker Drill;
  WorkspaceFrame Place;
  WorkspaceClutch Clutch;
  Vector3 AllMoved = Vector3::Zero();
  Vector3 Hand = Vector3::Zero(); // mm, in the device
  std::optional<TouchRay> Ray;    // through the current scene
  std::uint64_t RayNumber = 0;    // of the drilled versions that it knows
  HandPress Press;
  TouchWatch Watch;
  std::unique_ptr<TouchRecorder> Recorder;
  TouchSessionReading Reading;
};
} // namespace palpate
