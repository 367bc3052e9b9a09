#pragma once

#include "Clock.h"
#include "EndBeforeExit.h"
#include "HapticDevice.h"
#include "PalpateSessionModule.h"
#include "PeriodStatistics.h"
#include "RealtimeThread.h"
#include "ServoThread.h"
#include "StudyDrill.h"
#include "StudyScene.h"
#include "StudyState.h"
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
class TouchRecorder;

/// What a touch is like now.
struct StudyTouchReading
{
  TouchState Newest;
  std::vector<TouchState> NewTicks; ///< since the last reading, oldest first
  int TouchedLabel = 0;             ///< of the structure touched most deeply; 0 without touch
  std::string Safety;               ///< what the safety chain does, in plain words
  std::string Degraded;             ///< what is felt in place of the models; empty without
  std::string DeviceProblem;        ///< in one sentence; empty without
  std::string Guidance;             ///< what the person should do now; empty where nothing
  PeriodStatistics Periods;         ///< ns from tick to tick; misses are those left out
  PeriodStatistics Durations;       ///< ns that ticks took; misses are late ones
  std::uint64_t LostTicks = 0;      ///< that no reading has seen
  std::uint64_t RecordedTicks = 0;  ///< of the recording that goes on, or went on last
  std::string RecordingProblem;     ///< why a recording ended by itself; empty without
  bool IsClutched = false;          ///< the tool is held, and nothing is felt
  StudyDrillReading Drill;          ///< empty where nothing is drilled
};

/// A study while it is touched: a device, a servo on its thread, and the scene that follows what
/// the study becomes. For the thread that owns it, which never waits but in Start, Stop and where a
/// recording begins.
class PALPATESESSION_EXPORT StudyTouch
{
public:
  /// Keeps the address of the clock.
  explicit StudyTouch(Clock& clock, const RealtimeRequest& request = {});
  StudyTouch(const StudyTouch&) = delete;
  StudyTouch& operator=(const StudyTouch&) = delete;
  /// Stops, forces first.
  ~StudyTouch();

  /// Begins with an open device. Fails, and closes it, where there is nothing to touch or the tool
  /// cannot touch it.
  Status Start(std::unique_ptr<HapticDevice> opened, const StudyState& state,
               const std::vector<StudyContact>& contacts);
  bool IsRunning() const { return this->Thread != nullptr; }
  /// 0 N; the device is closed. What was recorded is kept.
  void Stop();

  /// Feels `state` from now on; nothing where nothing is different that can be felt. The servo goes
  /// on, and what is touched goes on from how it was felt (SceneEntry::Continuing). Where the state
  /// cannot be felt the one before stays. Device and rate are taken by the next Start.
  Status Update(const StudyState& state, const std::vector<StudyContact>& contacts);
  /// The device's axes in the world, where the placement wants them to follow the camera: taken by
  /// the next Update.
  void TurnAxes(const Matrix3& rotation) { this->CameraAxes = rotation; }
  /// Makes all of the scene reachable again at the next Update, which fades in: the hand may be
  /// anywhere in it. By itself the workspace stays where it was when the touch began, lest the hand
  /// jump.
  void FitWorkspace()
  {
    this->Automatic.reset();
    this->Moved.setZero();
  }
  /// What StudyPlacement::CenterWorld has to be for the workspace's middle to come to lie there:
  /// the clutch has moved it besides.
  Vector3 PlacementFor(const Vector3& centerWorld) const { return centerWorld - this->Moved; }
  const WorkspaceFrame& Frame() const { return this->Felt.Frame; }

  /// 0 N from the next tick on, until SwitchForcesOn; the hand is followed all the same.
  void SwitchForcesOff();
  void SwitchForcesOn();

  /// Where the hand of a simulated device wants to be (mm): there, or as near to it as the device
  /// reaches. False, and nothing else, for a device with a hand of its own.
  bool MoveHand(const Vector3& targetWorld);
  /// Begins such a hand before what is felt, as seen by a viewer.
  bool PlaceHand(const Vector3& towardsViewerWorld);
  /// Where it wants to be now (mm); with the workspace it moves too.
  Vector3 HandWorld() const { return this->Felt.Frame.ToWorld(this->Hand); }
  /// The device's button, from 0, that holds the workspace while it is pressed: a Falcon's middle.
  static constexpr int ClutchButton = 2;
  /// The button that is the drill's pedal; the servo itself reads it.
  static constexpr int DrillButton = 0;

  /// What no drill may remove from the next Start or Update on.
  void Forbid(std::vector<StudyForbidden> forbidden) { this->Forbidden = std::move(forbidden); }
  /// What is drilled; it stays when a touch ends.
  StudyDrill& Drill() { return this->Drilled; }
  /// The drill's pedal, and commands to who drills, while something is touched.
  void RunDrill(bool runs);
  void Command(DrillCommand command);

  /// For views, some ten times a second or oftener; a recording takes its ticks here.
  const StudyTouchReading& Poll();
  /// What a person should know before pressing: stiffness that the device may not hold.
  const std::vector<std::string>& Warnings() const { return this->Advice; }
  double Rate() const { return this->Settings.Rate; } ///< Hz, of the servo
  /// Of the device that runs.
  const DeviceCapabilities& Capabilities() const { return this->Device->Capabilities(); }

  /// Records from now on. The servo begins anew for it, since a session is felt again from its
  /// first tick: forces fade in.
  Status StartRecording(const std::filesystem::path& path);
  bool IsRecording() const { return this->Recorder != nullptr; }
  /// Of the recording that goes on, or went on last.
  const std::filesystem::path& RecordingFile() const { return this->RecordedTo; }
  Status StopRecording();

private:
  // All that a scene is made from.
  struct Feelable
  {
    struct One
    {
      int Label;
      std::shared_ptr<const TouchContact> Contact;
      double Stiffness;
      SurfaceFriction Friction;
      DrillLaw Drill;
    };
    std::vector<One> Structures;
    std::uint64_t DrillRevision = 0;
    TouchToolSettings Tool;
    WorkspaceFrame Frame;
  };
  static bool IsSame(const Feelable& a, const Feelable& b);

  Status Publish(const StudyState& state, const std::vector<StudyContact>& contacts);
  Status PublishAll(const StudyState& state, const std::vector<StudyContact>& contacts);
  void HoldDrill();
  WorkspaceFrame FrameFor(const StudyPlacement& placement, const TouchScene& scene);
  Status StartServo();
  Status Send(std::shared_ptr<const TouchScene> scene, SceneEntry entry);
  void HoldClutch(bool isHeld, const TouchState& now);
  void TakeTicks();
  bool LeadHand(const Vector3& handDevice);

  Clock& Time;
  RealtimeRequest Request;
  ServoSettings Settings;
  std::unique_ptr<HapticDevice> Device; // before the thread that uses it
  std::unique_ptr<EndBeforeExit> End;   // while there is a device
  std::unique_ptr<ServoThread> Thread;
  std::shared_ptr<const TouchScene> Scene;
  StudyDrill Drilled;
  std::vector<StudyForbidden> Forbidden;
  Feelable Felt;
  Matrix3 CameraAxes = Matrix3::Identity();
  std::optional<WorkspaceFrame> Automatic;
  TouchWatch Watch;
  WorkspaceClutch Clutch;
  Vector3 Moved = Vector3::Zero(); // mm, of the workspace by the clutch
  Vector3 Hand = Vector3::Zero();  // mm, in the device
  std::unique_ptr<TouchRecorder> Recorder;
  std::filesystem::path RecordedTo;
  StudyTouchReading Reading;
  std::vector<std::string> Advice;
};
} // namespace palpate
