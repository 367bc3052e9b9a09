#pragma once

#include "Clock.h"
#include "DrillWorker.h"
#include "EndBeforeExit.h"
#include "HapticDevice.h"
#include "PeriodStatistics.h"
#include "RealtimeThread.h"
#include "ServoThread.h"
#include "TouchRecorder.h"
#include "TouchScene.h"
#include "TouchWatch.h"
#include "WorkspaceClutch.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// The state of a session at its last poll.
struct TouchSessionReading
{
  TouchState Newest;                ///< while the clutch is held, with the tool where it stays
  std::vector<TouchState> NewTicks; ///< since the poll before, oldest first
  std::vector<TouchChange> Changes; ///< within them
  bool IsClutched = false;          ///< the tool is held, and touch is off
  std::uint64_t LostTicks = 0;      ///< that no poll has seen
  std::uint64_t RecordedTicks = 0;  ///< of the current or the last recording
  std::string RecordingProblem;     ///< why a recording ended early; empty without
};

/// A scene while it is touched: an open device, its servo, the workspace's place and its clutch, a
/// recording, and the worker that drills. Used by the command line, the window and VTK's
/// interactor style alike. For one owner thread; only Start, Stop and the start of a recording
/// wait.
class TouchSession
{
public:
  /// Keeps the address of the clock.
  explicit TouchSession(Clock& clock, const RealtimeRequest& request = {});
  TouchSession(const TouchSession&) = delete;
  TouchSession& operator=(const TouchSession&) = delete;
  /// Stops, forces first.
  ~TouchSession() { this->Stop(); }

  /// The button of the device, from 0, that is the clutch; -1 for none.
  void SetClutchButton(int button) { this->ClutchButton = button; }

  /// Takes a device that is open, for servos of these settings. What was touched before stops.
  void Open(std::unique_ptr<HapticDevice> opened, const ServoSettings& settings);
  bool IsOpen() const { return this->Opened != nullptr; }
  HapticDevice& Device() { return *this->Opened; }
  const HapticDevice& Device() const { return *this->Opened; }

  /// Makes the servo for a scene, without a thread: the caller ticks Loop().
  Status Begin(TouchScene scene, const WorkspaceFrame& frame);
  /// Begin, and then a thread that ticks at the servo's rate.
  Status Start(TouchScene scene, const WorkspaceFrame& frame);
  bool IsRunning() const { return this->Thread != nullptr; }
  /// Ends the ticks with 0 N; the device stays open, and what was felt can still be polled.
  void Pause();
  /// 0 N; the device is closed and a recording is finished.
  void Stop();

  /// Touches another scene from the next tick on; see Servo::Publish. Where it is refused the
  /// scene before stays.
  Status Publish(TouchScene scene, const WorkspaceFrame& frame, SceneEntry entry);
  /// The scene that is touched; null before the first.
  const std::shared_ptr<const TouchScene>& Scene() const { return this->Current; }
  const WorkspaceFrame& Frame() const { return this->Place; }
  /// How far the clutch has moved the workspace since Begin, mm.
  const Vector3& Moved() const { return this->ClutchMoved; }

  /// Executes what the servo orders to be drilled, from now on; null for nothing.
  void UseEditor(std::shared_ptr<DrillEditor> editor);

  /// The servo of a session that runs.
  Servo& Loop() { return this->Thread->Loop(); }
  const ServoStatistics& Statistics() { return this->Thread->Statistics(); }
  const RealtimeGrant& Grant() const { return this->Thread->Grant(); }

  /// Leads the hand of a simulated device to a place of the device (mm). False, without effect, for
  /// a device with a hand of its own.
  bool LeadHand(const Vector3& handDevice);
  /// Where such a hand is led (mm); it moves with the workspace.
  Vector3 HandWorld() const { return this->Place.ToWorld(this->Hand); }

  /// Takes what happened since the last poll; some ten times a second or more often. A recording
  /// takes its ticks here.
  const TouchSessionReading& Poll();

  /// Records from now on. A session replays from its first tick, so the servo of one that runs
  /// starts again for it, and forces fade in.
  Status StartRecording(const std::filesystem::path& path, BackgroundWriter::Limits limits = {});
  bool IsRecording() const { return this->Recorder != nullptr; }
  Status StopRecording();

private:
  Status Send(std::shared_ptr<const TouchScene> scene, SceneEntry entry);
  void MakeServo();
  Status Run();
  void TakeTicks();
  void HoldClutch(bool isHeld, const TouchState& now);

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
  Vector3 ClutchMoved = Vector3::Zero();
  Vector3 Hand = Vector3::Zero(); // mm, in the device
  TouchWatch Watch;
  std::unique_ptr<TouchRecorder> Recorder;
  TouchSessionReading Reading;
};
} // namespace palpate
