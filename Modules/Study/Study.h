#pragma once

#include "FeltEdges.h"
#include "PalpateStudyModule.h"
#include "StudyCorrected.h"
#include "StudyDevice.h"
#include "StudyDrawn.h"
#include "StudyDrillFiles.h"
#include "StudyHistory.h"
#include "StudyJobs.h"
#include "StudyMarkups.h"
#include "StudyPipeline.h"
#include "StudyQuality.h"
#include "StudyReplay.h"
#include "StudyTouch.h"
#include "StudyWriting.h"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace palpate
{
/// Values of the volume that make a structure.
struct StudyThreshold
{
  double Lower = 0.0;
  std::optional<double> Upper;
  int WithinId = 0; ///< the structure, a label of a segmentation, that limits it; 0: none
  std::string Name; ///< empty: after its values
  int VolumeId = 0; ///< a further volume (see StudyVolume); 0: the first one
};

/// An open study: its state with undo and redo, its products, and its touch. One thread only, a
/// window's or a command's, which must call Deliver regularly.
class PALPATESTUDY_EXPORT Study
{
public:
  /// A segmentation with at most this many structures is shown and touched entirely by default; of
  /// more, only the first structure.
  static constexpr std::size_t MostShownUnasked = 8;

  /// Keeps the address of the clock, which is the servo's.
  explicit Study(Clock& clock, const RealtimeRequest& request = {});

  const StudyState& State() const { return this->Steps.Current(); }
  const StudyHistory& History() const { return this->Steps; }
  StudyPipeline& Pipeline() { return this->Made; }
  StudyTouch& Touch() { return this->Felt; }
  /// The organ that is drawn by touch.
  const StudyDrawn& Drawn() const { return this->Organ; }
  /// The structure that is being corrected.
  StudyCorrected& Corrected() { return this->Correcting; }
  /// See StudyCorrected::LetGo; touch is updated.
  void LetGoOfCorrected(bool isHeld)
  {
    this->Correcting.LetGo(isHeld);
    this->FollowByTouch();
  }
  /// While it is on, a hand feels edges of the volume around what is corrected.
  void FeelEdges(bool areFelt)
  {
    if (this->AreEdgesFelt != areFelt)
    {
      this->AreEdgesFelt = areFelt;
      this->FollowShapes();
      this->FollowByTouch();
    }
  }
  const FeltEdges& Edges() const { return this->EdgesThere; }
  /// Contacts that can be touched now.
  std::vector<SceneContact> Contacts() const;
  StudyJobs& Jobs() { return this->Work; }

  /// Starts a new study.
  void New(const StudyState& first = {}) { this->Begin(first, {}); }
  /// Opens a session file. Throws InputError, in which case the open study is unchanged; missing
  /// files that it names are no error (see MissingFiles).
  void Open(const std::filesystem::path& file);
  /// Opens what StudyRecovery kept in a folder, as a study that was changed and has no file, as
  /// Open. Throws InputError.
  void Recover(const std::filesystem::path& folder);
  /// Saves the session, and what was drilled in a file next to it. Throws InputError.
  void Save(const std::filesystem::path& file);
  /// The session file; empty if there is none yet.
  const std::filesystem::path& File() const { return this->SessionFile; }
  /// Where to save it: the session file, or that of a recovered study; may be empty.
  const std::filesystem::path& ProposedFile() const
  {
    return this->SessionFile.empty() ? this->FormerFile : this->SessionFile;
  }
  /// Whether there is something to be saved, not counting the view.
  bool IsChanged() const { return this->Steps.IsChanged() || this->Felt.Drill().IsChanged(); }
  /// Files that are written in the background.
  StudyWriting& Writing() { return this->Written; }

  /// Opens another volume, or another segmentation with its structures; each is an undo step.
  /// `series` as in VolumeChoice. Structures from other files are kept.
  void OpenVolume(const std::filesystem::path& file, const std::string& series = {});
  void OpenSegmentation(const std::filesystem::path& file);
  /// Shows a further volume over the first one, which it becomes if there is none; an undo step.
  void AddVolume(const std::filesystem::path& file, const std::string& series = {});
  /// Reads a further segmentation in the background, then adds its structures (see
  /// WithAddedStructuresOf), as one undo step. `fail` gets the message if it cannot be read.
  void AddSegmentation(const std::filesystem::path& file,
                       const std::function<void(const std::string& message)>& fail);
  bool IsAddingSegmentation() const { return !this->Adding.empty(); }
  /// Adds a model, a surface, or a region of the volume; an undo step. AddThreshold throws
  /// InputError without a volume, and for limits that contradict each other.
  void AddStructure(const std::filesystem::path& file);
  void AddThreshold(const StudyThreshold& threshold);
  void AddIsoValue(double iso) { this->AddThreshold({iso, {}, 0, {}}); }
  /// Adds the structures of a scene file and takes over its tool, device and rate (see WithScene);
  /// an undo step. OpenScene throws InputError. AddScene takes a scene that was read from `file`
  /// before, with resolved labels (see ReadWholeScene).
  void OpenScene(const std::filesystem::path& file);
  void AddScene(const std::filesystem::path& file, const SceneSettings& scene);
  /// Adds landmarks and measurements that were read from `file`; an undo step.
  void AddMarkups(const std::filesystem::path& file, const StudyMarkups& markups);
  /// See Relocate; an undo step.
  void RelocateFile(const std::filesystem::path& missing, const std::filesystem::path& moved);

  /// See StudyHistory.
  bool Change(const std::string& message, const StudyState& next, const std::string& gesture = {});
  void EndGesture() { this->Steps.EndGesture(); }
  void ChangeView(const StudyView& view) { this->Steps.ChangeView(view); }
  bool Undo() { return this->FollowIf(this->Steps.Undo()); }
  bool Redo() { return this->FollowIf(this->Steps.Redo()); }

  /// Measures the quality presets at every touchable label, on the worker; existing measurements of
  /// the same structure with the same tool are kept.
  void MeasureQuality() { this->Qualities.Measure(this->State(), this->WithTool()); }
  bool IsMeasuringQuality() const { return this->Qualities.IsMeasuring(); }
  /// One line per touchable structure.
  std::vector<QualityLine> QualityLines() const { return this->Qualities.Lines(this->State()); }
  /// Applies the recommended preset to each measured structure; an undo step.
  void UseRecommendedQuality()
  {
    this->Change("Use the recommended quality", this->Qualities.WithRecommended(this->State()));
  }

  /// See StudyPipeline; touch is updated.
  void CancelStep(SceneStep step);
  /// Resumes cancelled work, and retries failed work.
  void ResumeStep(SceneStep step);

  /// Opens the state's device in the background, then starts the touch. From then on another device
  /// of the state takes its place, and one that is unplugged is picked up again once it is back:
  /// without force until a person allows it, if it has motors.
  void StartTouch();
  /// Call with every reading of a touch.
  void WatchDevice(const StudyTouchReading& reading);
  /// Touches that begin from now on are heard, too (SoundingDevice).
  void HearTouches(bool areHeard) { this->AreHeard = areHeard; }
  void StopTouch();
  /// Moves the centre of the workspace (mm) during a touch; one undo step per `gesture`.
  void MoveWorkspace(const Vector3& centerWorld, const std::string& gesture);
  /// Brings all touchable structures into reach again; an undo step.
  void FitWorkspace();
  /// Sets the device's axes in the world, if the placement makes them follow the camera.
  void TurnAxes(const Matrix3& rotation);
  /// See StudyTouch::Hold.
  void Hold(std::shared_ptr<const ForceField> field)
  {
    this->Felt.Hold(std::move(field));
    this->FollowByTouch();
  }
  /// Reads a drilled state in the background, then restores it, interrupting touch; a stroke that
  /// can be undone. `fail` gets the message if it cannot be read or does not fit.
  void OpenDrilled(const std::filesystem::path& file,
                   const std::function<void(const std::string& message)>& fail);
  bool IsReadingDrilled() const { return this->DrillFiles.IsReading(); }
  /// Why what was drilled is not, or not entirely, restored; may be empty.
  std::string DrilledProblem() const;
  bool IsOpeningDevice() const { return this->Device.IsOpening(); }
  /// Whether touch has ended because the device was lost, and goes on with it.
  bool IsAwaitingDevice() const { return this->Device.IsAwaited(); }
  /// One line on a device that was lost, or is back and waits for a person to allow force; or
  /// empty.
  std::string DeviceNotice() const;
  /// Why a touch did not start, or does not follow the current state; may be empty.
  const std::string& TouchProblem() const { return this->Problem; }

  /// Reads a recorded touch in the background, then shows it. Touch and replay exclude each other:
  /// a running touch is stopped (forces first), an open replay is replaced, and StartTouch closes
  /// this one. A recording that cannot be read changes neither (see ReplayProblem).
  void OpenReplay(const std::filesystem::path& file);
  void CloseReplay();
  bool IsOpeningReplay() const { return this->Reading.has_value(); }
  /// Why a recording cannot be replayed or exported, or which part is missing; may be empty.
  const std::string& ReplayProblem() const { return this->Unplayable; }
  /// Null if no recording is open.
  StudyReplay* Replay() { return this->Played.get(); }
  const StudyReplay* Replay() const { return this->Played.get(); }
  /// Writes the recording in the background (see ExportTouch); failures are reported by
  /// ReplayProblem.
  void ExportReplay(const std::filesystem::path& file);
  /// Reads the recording at its current position. Its structures are matched with the study's
  /// touchable ones by number.
  const StudyTouchReading& PollReplay();

  /// Takes over finished results; returns their number.
  std::size_t Deliver();
  /// Switches off forces, then ends all work. Returns false if a job could not be stopped (see
  /// StudyJobs); then exit without waiting for it.
  bool Close(std::chrono::milliseconds longest = std::chrono::milliseconds(800));

private:
  void Begin(const StudyState& state, const std::filesystem::path& file);
  void Follow();
  void FollowShapes()
  {
    const StudyState& state = this->State();
    this->Organ.Follow(state);
    this->Correcting.Follow(state, state.Correction, state.SegmentationFile,
                            this->Made.Newest<Segmentation>(SceneStep::Segmentation));
    this->EdgesThere.Follow(this->AreEdgesFelt ? this->Made.Newest<Volume>(SceneStep::Volume)
                                               : nullptr,
                            state.Correction.StructureId, this->Contacts());
  }
  bool FollowIf(bool isChanged);
  void ChangeByFile(const std::string& message, const StudyState& next);
  void AdoptStructures();
  void PrepareTouch();
  void FollowByTouch();
  void FollowByDrill();
  void ReadDrilled(const std::filesystem::path& file);
  void TakeDevice(std::unique_ptr<HapticDevice> device);
  void EndTouch();
  StudyState WithTool();

  Clock& Time;
  StudyHistory Steps;
  StudyJobs Work;
  StudyPipeline Made{Work};
  StudyDrawn Organ{Work};
  StudyCorrected Correcting{Work};
  StudyQuality Qualities{Work};
  FeltEdges EdgesThere{Work};
  bool AreEdgesFelt = false;
  StudyTouch Felt;
  StudyDrillFiles DrillFiles{Work};
  StudyWriting Written{Work};
  std::filesystem::path SessionFile;
  std::filesystem::path FormerFile;       ///< of a recovered study
  std::set<std::filesystem::path> Unread; ///< segmentations whose structures are not yet taken over
  std::set<StudyJobs::Id> Adding;         ///< segmentations that are being read
  StudyDevice Device;
  bool IsBack = false; ///< the device, and force is still off
  std::optional<StudyJobs::Id> Reading;
  std::unique_ptr<StudyReplay> Played;
  TouchToolSettings ReadTool; ///< the last usable one, with its surface
  std::string Problem;
  bool LacksContacts = false; ///< which is the problem
  bool AreHeard = false;      ///< touches
  std::string Unplayable;
};

} // namespace palpate
