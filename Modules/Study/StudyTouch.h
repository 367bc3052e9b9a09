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
/// Current state of a touch.
struct StudyTouchReading : TouchSessionReading
{
  int TouchedId = 0;          ///< of the structure touched most deeply; 0 without contact
  std::string Safety;         ///< state of the safety chain as text
  std::string DeviceProblem;  ///< one message; may be empty
  std::string Guidance;       ///< what the user should do now; may be empty
  PeriodStatistics Periods;   ///< ns from tick to tick; misses are skipped ticks
  PeriodStatistics Durations; ///< ns that ticks took; misses are late ticks
  StudyDrillReading Drill;    ///< empty if nothing is drilled
};

/// Touch of a study: a session whose scene follows the study's state. Owner thread only; it blocks
/// only in Start, Stop and StartRecording.
class PALPATESTUDY_EXPORT StudyTouch
{
public:
  /// Keeps the address of the clock.
  explicit StudyTouch(Clock& clock, const RealtimeRequest& request = {});
  StudyTouch(const StudyTouch&) = delete;
  StudyTouch& operator=(const StudyTouch&) = delete;

  /// Starts with an open device; `contacts` are those of `state` (see ContactsOf). Fails, and
  /// closes it, if there is nothing to touch or the tool cannot touch it. `staysOff`: without force
  /// until SwitchForcesOn.
  Status Start(std::unique_ptr<HapticDevice> opened, const StudyState& state,
               const std::vector<SceneContact>& contacts, bool staysOff = false);
  bool IsRunning() const { return this->Session.IsRunning(); }
  /// Outputs 0 N and closes the device. The recording is kept.
  void Stop();

  /// Switches to `state`; no effect if nothing relevant to touch differs. The servo keeps running,
  /// and contacts continue without a force step (SceneEntry::Continuing). If `state` cannot be
  /// touched, the previous one stays. Device and rate take effect at the next Start.
  Status Update(const StudyState& state, const std::vector<SceneContact>& contacts);
  /// Sets the device's axes in the world, if the placement makes them follow the camera; takes
  /// effect at the next Update.
  void TurnAxes(const Matrix3& rotation) { this->CameraAxes = rotation; }
  /// Brings the whole scene into reach at the next Update, with forces faded in, since the hand may
  /// be anywhere in it. Otherwise the workspace stays where it was when the touch started, so that
  /// the hand does not jump.
  void FitWorkspace() { this->Automatic.reset(); }
  /// The ScenePlacement::CenterWorld that puts the workspace's centre at `centerWorld`, given the
  /// displacement by the clutch.
  Vector3 PlacementFor(const Vector3& centerWorld) const { return centerWorld - this->Moved(); }
  const WorkspaceFrame& Frame() const { return this->Session.Frame(); }

  /// 0 N from the next tick on, until SwitchForcesOn; the hand is still tracked.
  void SwitchForcesOff();
  void SwitchForcesOn();

  /// Moves a simulated device's hand towards `targetWorld` (mm), as close as the device reaches.
  /// Returns false, without effect, for a device with its own hand.
  bool MoveHand(const Vector3& targetWorld);
  /// Where the tool would rest on what can be touched, from `from` to `to` (world, mm).
  std::optional<TouchRay::Rest> RestBetween(const Vector3& from, const Vector3& to)
  {
    return this->Session.RestBetween(from, to);
  }
  std::optional<TouchRay::Rest> RestInPlane(const Vector3& point, const Vector3& right,
                                            const Vector3& up, double reach)
  {
    return this->Session.RestInPlane(point, right, up, reach);
  }
  bool HasRestAround(const Vector3& point, const Vector3& right, const Vector3& up, double reach)
  {
    return this->Session.HasRestAround(point, right, up, reach);
  }
  /// A pointing hand presses and lifts; see TouchSession.
  void LiftHand() { this->Session.LiftHand(); }
  void PressHand() { this->Session.PressHand(); }
  double PushFor(double force, int structure) const
  {
    return this->Session.PushFor(force, structure);
  }
  /// Places a simulated hand in front of the scene, as seen by a viewer.
  bool PlaceHand(const Vector3& towardsViewerWorld);
  /// mm from the tool to the nearest structure, for devices that are slow near one.
  void TellDistance(double distance) noexcept { this->Session.TellDistance(distance); }
  /// Target of the simulated hand (mm); moves with the workspace.
  Vector3 HandWorld() const { return this->Session.HandWorld(); }
  /// The device's clutch button unless another is set, from 0: a Falcon's centre.
  static constexpr int ClutchButton = 2;
  /// See TouchSession::SetClutchButton.
  void SetClutchButton(int button) { this->Session.SetClutchButton(button); }
  /// The button used as the drill's pedal; read by the servo itself.
  static constexpr int DrillButton = 0;

  /// Sets the forbidden structures from the next Start or Update on.
  void Forbid(std::vector<StudyForbidden> forbidden) { this->Forbidden = std::move(forbidden); }
  /// Sets the distances to structures that guide from the next Start or Update on.
  void Guide(GuideDistances distances) { this->Distances = std::move(distances); }
  /// From the next Update on a device feels only this field, as of an organ that it holds, and no
  /// structure; null, and after Stop: structures again.
  void Hold(std::shared_ptr<const ForceField> field) { this->Held = std::move(field); }
  /// Drilling; its state is kept when a touch ends.
  StudyDrill& Drill() { return this->Drilled; }
  const StudyDrill& Drill() const { return this->Drilled; }
  /// The drill's pedal, and commands to the drill's editor, during a touch.
  void RunDrill(bool runs);
  void Command(DrillCommand command);

  /// Call at least ten times per second; also passes ticks to a recording.
  const StudyTouchReading& Poll();
  /// Warnings for the user, such as a stiffness that the device may not render stably.
  const std::vector<std::string>& Warnings() const { return this->Advice; }
  double Rate() const { return this->Settings.Rate; } ///< Hz, of the servo
  /// Of the running device.
  const DeviceCapabilities& Capabilities() const { return this->Session.Device().Capabilities(); }

  /// Starts recording; see TouchSession::StartRecording.
  Status StartRecording(const std::filesystem::path& path);
  bool IsRecording() const { return this->Session.IsRecording(); }
  /// Of the current or the last recording.
  const std::filesystem::path& RecordingFile() const { return this->RecordedTo; }
  Status StopRecording() { return this->Session.StopRecording(); }

private:
  // All inputs of a published scene.
  struct Feelable
  {
    std::vector<SceneStructure> Structures;
    std::vector<SceneContact> Contacts;
    std::vector<DrillLaw> Laws; // without wear while drilling is off
    std::uint64_t DrillRevision = 0;
    std::vector<GuideSettings> Guides;
    GuideDistances Distances;
    std::shared_ptr<const ForceField> Held;
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
  GuideDistances Distances;
  std::shared_ptr<const ForceField> Held;
  Feelable Felt;
  Matrix3 CameraAxes = Matrix3::Identity();
  std::optional<WorkspaceFrame> Automatic;
  Vector3 MovedBefore = Vector3::Zero(); // mm, clutch displacement before the workspace was fitted
  std::filesystem::path RecordedTo;
  StudyTouchReading Reading;
  std::vector<std::string> Advice;
  TouchSession Session; // destroyed first
};
} // namespace palpate
