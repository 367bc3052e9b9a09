#pragma once

#include "PalpateStudyModule.h"
#include "SceneContacts.h"
#include "StudyDrill.h"
#include "StudyState.h"
#include "TouchSession.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// How a touch is going.
struct StudyTouchReading
{
  TouchState Newest;
  std::vector<TouchState> NewTicks; ///< since the last reading, oldest first
  int TouchedId = 0;                ///< of the structure touched most deeply; 0 without touch
  std::string Safety;               ///< what the safety chain does, in plain words
  std::string DeviceProblem;        ///< one message; empty without
  std::string Guidance;             ///< what the person should do now; empty without
  PeriodStatistics Periods;         ///< ns from tick to tick; misses are those left out
  PeriodStatistics Durations;       ///< ns that ticks took; misses are late ones
  std::uint64_t LostTicks = 0;      ///< that no reading has seen
  std::uint64_t RecordedTicks = 0;  ///< of the current or the last recording
  std::string RecordingProblem;     ///< why a recording ended early; empty without
  bool IsClutched = false;          ///< the tool is held, and touch is off
  StudyDrillReading Drill;          ///< empty where nothing is drilled
};

/// A study while it is touched: a session whose scene follows what the study becomes. For the
/// thread that owns it, which waits only in Start, Stop and where a recording begins.
class PALPATESTUDY_EXPORT StudyTouch
{
public:
  /// Keeps the address of the clock.
  explicit StudyTouch(Clock& clock, const RealtimeRequest& request = {});
  StudyTouch(const StudyTouch&) = delete;
  StudyTouch& operator=(const StudyTouch&) = delete;

  /// Begins with an open device. Fails, and closes it, where there is nothing to touch or the tool
  /// cannot touch it.
  Status Start(std::unique_ptr<HapticDevice> opened, const StudyState& state,
               const std::vector<SceneContact>& contacts);
  bool IsRunning() const { return this->Session.IsRunning(); }
  /// 0 N; the device is closed. What was recorded is kept.
  void Stop();

  /// Touches `state` from now on; no effect where it differs in nothing that can be felt. The servo
  /// goes on, and what is touched continues from how it was felt (SceneEntry::Continuing). A state
  /// that cannot be touched leaves the one before. Device and rate are taken by the next Start.
  Status Update(const StudyState& state, const std::vector<SceneContact>& contacts);
  /// The device's axes in the world, where the placement wants them to follow the camera: taken by
  /// the next Update.
  void TurnAxes(const Matrix3& rotation) { this->CameraAxes = rotation; }
  /// Makes all of the scene reachable again at the next Update, which fades in: the hand may be
  /// anywhere in it. Otherwise the workspace stays where it was when the touch began, lest the hand
  /// jump.
  void FitWorkspace() { this->Automatic.reset(); }
  /// What ScenePlacement::CenterWorld has to be for the workspace's centre to come to lie there:
  /// the clutch has moved it as well.
  Vector3 PlacementFor(const Vector3& centerWorld) const { return centerWorld - this->Moved(); }
  const WorkspaceFrame& Frame() const { return this->Session.Frame(); }

  /// 0 N from the next tick on, until SwitchForcesOn; the hand is followed all the same.
  void SwitchForcesOff();
  void SwitchForcesOn();

  /// Leads the hand of a simulated device there (mm), or as near to it as the device reaches.
  /// False, without effect, for a device with a hand of its own.
  bool MoveHand(const Vector3& targetWorld);
  /// Begins such a hand in front of the scene, as seen by a viewer.
  bool PlaceHand(const Vector3& towardsViewerWorld);
  /// Where it is led (mm); with the workspace it moves too.
  Vector3 HandWorld() const { return this->Session.HandWorld(); }
  /// The device's button, from 0, that holds the workspace while it is pressed: a Falcon's centre.
  static constexpr int ClutchButton = 2;
  /// The button that is the drill's pedal; the servo itself reads it.
  static constexpr int DrillButton = 0;

  /// What no drill may remove from the next Start or Update on.
  void Forbid(std::vector<StudyForbidden> forbidden) { this->Forbidden = std::move(forbidden); }
  /// What is drilled; it stays when a touch ends.
  StudyDrill& Drill() { return this->Drilled; }
  /// The drill's pedal, and commands to the drill's editor, while something is touched.
  void RunDrill(bool runs);
  void Command(DrillCommand command);

  /// For views, some ten times a second or more often; a recording takes its ticks here.
  const StudyTouchReading& Poll();
  /// What a person should know before pressing: stiffness that the device may not hold.
  const std::vector<std::string>& Warnings() const { return this->Advice; }
  double Rate() const { return this->Settings.Rate; } ///< Hz, of the servo
  /// Of the device that runs.
  const DeviceCapabilities& Capabilities() const { return this->Session.Device().Capabilities(); }

  /// Records from now on; see TouchSession::StartRecording.
  Status StartRecording(const std::filesystem::path& path);
  bool IsRecording() const { return this->Session.IsRecording(); }
  /// Of the current or the last recording.
  const std::filesystem::path& RecordingFile() const { return this->RecordedTo; }
  Status StopRecording() { return this->Session.StopRecording(); }

private:
  // Everything that a scene is made from.
  struct Feelable
  {
    std::vector<SceneStructure> Structures;
    std::vector<SceneContact> Contacts;
    std::vector<DrillLaw> Laws; // as the drill's hold leaves them
    std::uint64_t DrillRevision = 0;
    TouchToolSettings Tool;
    WorkspaceFrame Frame;
  };
  static bool IsSame(const Feelable& a, const Feelable& b);

  Status Publish(const StudyState& state, const std::vector<SceneContact>& contacts);
  Status PublishAll(const StudyState& state, const std::vector<SceneContact>& contacts);
  void HoldDrill();
  Vector3 Moved() const { return this->Session.Moved() - this->MovedBefore; }
  WorkspaceFrame FrameFor(const ScenePlacement& placement, const TouchScene& scene);
  void TakeReading(const TouchSessionReading& now);

  Clock& Time;
  ServoSettings Settings;
  StudyDrill Drilled;
  std::vector<StudyForbidden> Forbidden;
  Feelable Felt;
  Matrix3 CameraAxes = Matrix3::Identity();
  std::optional<WorkspaceFrame> Automatic;
  Vector3 MovedBefore = Vector3::Zero(); // mm, by the clutch before the workspace was fitted
  std::filesystem::path RecordedTo;
  StudyTouchReading Reading;
  std::vector<std::string> Advice;
  TouchSession Session; // ends first
};
} // namespace palpate
