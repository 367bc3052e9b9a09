#pragma once

#include "PalpateStudyModule.h"
#include "QualityReport.h"
#include "StudyHistory.h"
#include "StudyJobs.h"
#include "StudyPipeline.h"
#include "StudyReplay.h"
#include "StudyTouch.h"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace palpate
{
/// What is open: its state with the steps back and forth, what is made of it, and its touch. For
/// one thread, a window's or a command's, which calls Deliver now and then.
class PALPATESTUDY_EXPORT Study
{
public:
  /// So many structures of a segmentation at most are shown and touched without being asked for; of
  /// more, the first alone.
  static constexpr std::size_t MostShownUnasked = 8;

  /// Keeps the address of the clock, which is the servo's.
  explicit Study(Clock& clock, const RealtimeRequest& request = {});

  const StudyState& State() const { return this->Steps.Current(); }
  const StudyHistory& History() const { return this->Steps; }
  StudyPipeline& Pipeline() { return this->Made; }
  StudyTouch& Touch() { return this->Felt; }
  /// What can be touched now.
  std::vector<SceneContact> Contacts() const;
  StudyJobs& Jobs() { return this->Work; }

  /// An empty one.
  void New() { this->Begin({}, {}); }
  /// A session file. Throws InputError, with what was open left as it was; files that it names and
  /// that are missing are no error (see MissingFiles).
  void Open(const std::filesystem::path& file);
  /// Throws InputError.
  void Save(const std::filesystem::path& file);
  /// The session file; empty where it has none yet.
  const std::filesystem::path& File() const { return this->SessionFile; }

  /// Another volume, or another segmentation with its own structures; each a step. `series` as
  /// VolumeChoice has it. Structures from other files stay.
  void OpenVolume(const std::filesystem::path& file, const std::string& series = {});
  void OpenSegmentation(const std::filesystem::path& file);
  /// Adds a model, a surface, or where the volume reaches a value; a step. An iso-value throws
  /// InputError without a volume that is one file.
  void AddStructure(const std::filesystem::path& file);
  void AddIsoValue(double iso);
  /// Adds the structures of a scene file and takes its tool, device and rate; a step. Throws
  /// InputError.
  void OpenScene(const std::filesystem::path& file);
  /// See Relocate; a step.
  void RelocateFile(const std::filesystem::path& missing, const std::filesystem::path& moved);

  /// See StudyHistory.
  bool Change(const std::string& sentence, const StudyState& next, const std::string& gesture = {});
  void EndGesture() { this->Steps.EndGesture(); }
  void ChangeView(const StudyView& view) { this->Steps.ChangeView(view); }
  bool Undo();
  bool Redo();

  /// Measures the quality presets at every touchable label, on the worker; what was measured of the
  /// same structure with the same tool is kept.
  void MeasureQuality();
  bool IsMeasuringQuality() const { return !this->Measuring.empty(); }
  /// A line for every touchable structure.
  std::vector<QualityLine> QualityLines() const;
  /// The recommended preset for each structure that was measured; a step.
  void UseRecommendedQuality();

  /// See StudyPipeline; what is touched follows.
  void CancelStep(SceneStep step);
  /// Resumes what was cancelled, and tries again what failed.
  void ResumeStep(SceneStep step);

  /// Opens the state's device beside the caller, then begins to touch.
  void StartTouch();
  void StopTouch();
  /// The middle of the workspace to there (mm), while something is touched; of one `gesture` a
  /// step.
  void MoveWorkspace(const Vector3& centerWorld, const std::string& gesture);
  /// All that can be touched is in reach again; a step.
  void FitWorkspace();
  /// The device's axes in the world, where the placement wants them to follow the camera.
  void TurnAxes(const Matrix3& rotation);
  bool IsOpeningDevice() const { return this->Opening.has_value(); }
  /// Why a touch did not begin, or does not follow what the state has become; empty without.
  const std::string& TouchProblem() const { return this->Problem; }

  /// Reads a recorded touch beside the caller, then shows it. Nobody touches and looks at a
  /// recording at once: what was going on of either ends, forces first, and StartTouch ends this.
  void OpenReplay(const std::filesystem::path& file);
  void CloseReplay();
  bool IsOpeningReplay() const { return this->Reading.has_value(); }
  /// Why a recording cannot be replayed or exported, or what of it is missing; empty without.
  const std::string& ReplayProblem() const { return this->Unplayable; }
  /// Null while no recording is open.
  StudyReplay* Replay() { return this->Played.get(); }
  const StudyReplay* Replay() const { return this->Played.get(); }
  /// Writes it beside the caller (see ExportTouch); ReplayProblem says why where it cannot.
  void ExportReplay(const std::filesystem::path& file);
  /// What the recording has at its moment. A structure of it is that one of the study's touchable
  /// ones which has its number.
  const StudyTouchReading& PollReplay();

  /// Takes what was made meanwhile; returns how many pieces.
  std::size_t Deliver();
  /// Forces first, then what is at work. False where something goes on by itself (see StudyJobs):
  /// then end the program without waiting for it.
  bool Close(std::chrono::milliseconds longest = std::chrono::milliseconds(800));

private:
  void Begin(const StudyState& state, const std::filesystem::path& file);
  void Follow();
  void AdoptStructures();
  void FollowByTouch();
  const QualityMeasurement* QualityOf(const SceneStructure& structure) const;
  void TakeDevice(std::unique_ptr<HapticDevice> device);
  StudyState WithTool();

  Clock& Time;
  StudyHistory Steps;
  StudyJobs Work;
  StudyPipeline Made{Work};
  StudyTouch Felt;
  std::filesystem::path SessionFile;
  std::set<std::filesystem::path> Unread; ///< segmentations whose structures are to be taken over
  std::optional<StudyJobs::Id> Opening;
  std::optional<StudyJobs::Id> Reading;
  std::unique_ptr<StudyReplay> Played;
  TouchToolSettings ReadTool; ///< the last one that could be felt, with its surface
  std::string Problem;
  std::string Unplayable;
  // Of a structure's presets.
  struct Quality
  {
    std::string Key; ///< everything that it was measured with
    std::shared_ptr<const QualityMeasurement> Measured;
    std::string Problem;
  };
  std::map<int, Quality> Qualities;
  std::map<int, StudyJobs::Id> Measuring;
};

/// A state with a structure for each label of its segmentation in place of those it had of that
/// file.
PALPATESTUDY_EXPORT StudyState WithStructuresOf(const StudyState& state,
                                                const Segmentation& segmentation);
} // namespace palpate
