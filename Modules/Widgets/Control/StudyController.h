#pragma once

#include "DicomFolders.h"
#include "ScreenString.h"
#include "Study.h"
#include "StudyFile.h"
#include "StudyOpening.h"
#include "StudyProblems.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// Connects a study to a window by signals. All actions of the window go through it; a timer polls
/// for new results and touch readings.
class StudyController : public QObject
{
  Q_OBJECT

public:
  /// Keeps the address of the clock, which is the servo's.
  explicit StudyController(Clock& clock, const RealtimeRequest& request = {});

  Study& Current() { return this->Open; }
  /// Of servos.
  Clock& ServoClock() { return this->Time; }
  const RealtimeRequest& Request() const { return this->Priority; }
  /// Of the servo's clock, ns.
  std::int64_t Now() const { return this->Time.Now(); }
  /// What a new study begins with.
  const StudyState& NewState() const { return this->First; }
  const StudyState& State() const { return this->Open.State(); }
  const StudyTouchReading& Reading() const { return this->Felt; }
  bool IsTouching() { return this->Open.Touch().IsRunning(); }
  /// Whether a structure is touchable; and whether there is an image whose values could be.
  bool CanTouch() const
  {
    return HasTouchable(this->State()) || this->Open.Drawn().Organ().Surface() != nullptr;
  }
  /// What the tool touches; empty: nothing.
  QString TouchedTitle() const;
  bool HasValues() { return this->Open.Pipeline().Newest<Volume>(SceneStep::Volume) != nullptr; }
  bool IsRecording() { return this->Open.Touch().IsRecording(); }
  /// Whether a recorded touch is replayed; Reading is then the one at its current time.
  bool IsReplaying() const { return this->Open.Replay() != nullptr; }
  /// Whether something is being read, computed or opened.
  bool IsBusy() const
  {
    return !this->Roles.empty() || this->Folders > 0 || this->Opening.IsReading() ||
           this->Open.IsReadingDrilled() || this->IsMaking;
  }
  /// The pipeline's, or that of a file which is being read for the step before the study changes.
  StudyStepState StateOf(SceneStep step);

  /// Asked whether the study may be closed when opened files include another one. None: always.
  void AskBeforeLeaving(std::function<bool()> mayLeave) { this->MayLeave = std::move(mayLeave); }
  /// Asked which of several series to open, as FileQuestions::Series. None: the reader reports an
  /// error for several series.
  void AskForSeries(std::function<int(const std::vector<DicomSeriesChoice>&)> series)
  {
    this->WhichSeries = std::move(series);
  }
  void New();
  /// Starts a new study with this state, which does not count as changed.
  void OpenState(const StudyState& state);
  /// See Study::Recover. Returns false, with a message, if that fails.
  bool Recover(const std::filesystem::path& folder);
  /// What new studies begin with, and with them one in which nothing was done yet.
  void BeginWith(const StudyState& first);
  /// Opens files of any kind, one after the other; their kinds are detected in the background. Of
  /// several volumes or segmentations the first replaces what is open, the others are added.
  void OpenFiles(const std::vector<std::filesystem::path>& files);
  /// A file, or a folder of DICOM slices. These two read in the background first: a file that
  /// cannot be read gives a message and changes nothing. Sessions, scenes, models and surfaces are
  /// opened as what they are.
  void OpenVolume(const std::filesystem::path& file);
  void AddVolume(const std::filesystem::path& file); ///< see Study::AddVolume
  void OpenSegmentation(const std::filesystem::path& file);
  /// See Study::AddSegmentation.
  void AddSegmentation(const std::filesystem::path& file);
  void OpenSession(const std::filesystem::path& file);
  void RelocateFile(const std::filesystem::path& missing, const std::filesystem::path& moved);
  /// Returns false, with a message, if the file cannot be written.
  bool Save(const std::filesystem::path& file);

  /// An undo step; see StudyHistory.
  void Change(const QString& message, const StudyState& next, const QString& gesture = {});
  void EndGesture() { this->Open.EndGesture(); }
  /// Changes the view; not an undo step.
  void ChangeView(const StudyView& view);
  void Undo();
  void Redo();

  /// See Study.
  void MeasureQuality()
  {
    this->Open.MeasureQuality();
    this->Announce();
  }
  void UseRecommendedQuality()
  {
    this->Open.UseRecommendedQuality();
    this->Announce();
  }
  void AddThreshold(const StudyThreshold& threshold);

  void CancelStep(SceneStep step);
  void ResumeStep(SceneStep step);

  void StartTouch();
  /// As soon as something that can be touched is made, unless the study changes before.
  void StartTouchSoon()
  {
    this->WantsTouch = true;
    this->LookSoon();
  }
  void StopTouch();
  void HearTouches(bool areHeard) { this->Open.HearTouches(areHeard); }
  void MoveWorkspace(const Vector3& centerWorld, const QString& gesture)
  {
    this->Open.MoveWorkspace(centerWorld, gesture.toStdString());
    this->Announce();
  }
  void FitWorkspace()
  {
    this->Open.FitWorkspace();
    this->Announce();
  }
  /// See Study::OpenDrilled.
  void OpenDrilled(const std::filesystem::path& file);
  /// Writes a file in the background; see StudyWriting.
  void Write(const std::filesystem::path& file, StudyWriting::Writing write);
  void StartRecording(const std::filesystem::path& file);
  void StopRecording();

  /// See Study::OpenReplay.
  void OpenReplay(const std::filesystem::path& file);
  void CloseReplay();
  void ExportReplay(const std::filesystem::path& file);
  /// No effect without a replay.
  void PlayReplay(bool isPlayed);

  /// Shows a message to the user, from anywhere in the window.
  void Report(const std::string& message) { Q_EMIT Problem(ScreenString(message)); }
  /// Acts, reporting an error to the user.
  void Try(const std::function<void()>& act);
  /// Switches forces off, then cancels work; nothing happens afterwards. Returns Study::Close.
  bool Close();
  /// The result of Close.
  bool HasEnded() const { return this->IsEnded; }

Q_SIGNALS:
  void StateChanged();                  ///< another undo step, or another study
  void ViewChanged();                   ///< another crosshair, window, level or layout
  void ProductsChanged();               ///< the pipeline has new results
  void StepsChanged();                  ///< status of the pipeline's steps
  void FileOpened(const QString& file); ///< it could be read
  void Saved();                         ///< to Study::File
  void Leaving();                       ///< the study is about to be replaced
  void TouchChanged();                  ///< began or ended, or waits for a lost device
  void Touched();                       ///< a new reading
  void DrilledChanged();                ///< what was drilled, while touch is off
  void ReplayChanged();                 ///< opened or closed, played or paused
  void Problem(const QString& message);
  void ProblemEnded(const QString& message); ///< its cause has gone

private:
  void Look();
  void LookAtTouch();
  void LookAtDrill();
  void LookAtReplay();
  void LookAtSteps();
  void LookAtProblems();
  void Announce();
  void TakeRole();
  StudyOpening::Outcome OutcomeOf(const std::filesystem::path& file);
  void LookSoon();
  void OpenAs(StudyFileRole role, const std::filesystem::path& file);
  /// How a volume is read: StudyOpening::OpenVolume or AddVolume.
  using VolumeOpening = void (StudyOpening::*)(const std::filesystem::path& file,
                                               const std::string& series,
                                               StudyOpening::Outcome outcome);
  void ReadVolume(const std::filesystem::path& file, VolumeOpening open);
  void OpenFolder(const std::filesystem::path& folder, VolumeOpening open);
  void TakeSeries(const std::vector<DicomSeriesChoice>& series, VolumeOpening open);
  void ReadVolumeNow(const std::filesystem::path& file, const std::string& series,
                     VolumeOpening open);

  Clock& Time;
  RealtimeRequest Priority; ///< of servos
  Study Open;
  StudyOpening Opening{this->Open};
  StudyState First; ///< of a new study
  StudyTouchReading Felt;
  QTimer Timer;
  std::vector<std::filesystem::path> Roles; ///< files whose kind is not yet known
  std::set<StudyFileRole> Opened;           ///< kinds of the files that were asked for with them
  int Folders = 0;                          ///< number of folders whose series are being listed
  std::function<bool()> MayLeave;
  std::function<int(const std::vector<DicomSeriesChoice>&)> WhichSeries;
  StudyProblems Problems{this->Open};
  std::vector<std::string> Told; ///< problems that are there
  std::uint64_t Revision = 0;
  std::uint64_t DrillRevision = 0;
  int LooksToSteps = 0;
  bool IsMaking = false;
  std::pair<bool, bool> WasTouching; ///< and whether a lost device was awaited
  bool WantsTouch = false;
  const StudyReplay* Replayed = nullptr; ///< at the last look
  bool IsClosed = false;
  bool IsEnded = false;
};
} // namespace palpate
