#pragma once

#include "Study.h"
#include "StudyFileRole.h"

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
/// The study that a window shows, as signals. All that the window wants done goes through here; it
/// looks by a timer what was made and felt meanwhile.
class StudyController : public QObject
{
  Q_OBJECT

public:
  /// Keeps the address of the clock, which is the servo's.
  explicit StudyController(Clock& clock, const RealtimeRequest& request = {});

  Study& Current() { return this->Open; }
  const StudyState& State() const { return this->Open.State(); }
  const StudyTouchReading& Reading() const { return this->Felt; }
  bool IsTouching() { return this->Open.Touch().IsRunning(); }
  bool IsRecording() { return this->Open.Touch().IsRecording(); }
  /// Whether a recorded touch is looked at; Reading is what it has at its moment.
  bool IsReplaying() const { return this->Open.Replay() != nullptr; }
  /// Whether something is to be read, made or opened.
  bool IsBusy() const { return !this->Roles.empty() || this->Folders > 0 || this->IsMaking; }

  /// What answers whether the study may be left for another one that is among files. None: yes.
  void AskBeforeLeaving(std::function<bool()> mayLeave) { this->MayLeave = std::move(mayLeave); }
  /// What answers which of several series is meant, as FileQuestions::Series. None: the reader says
  /// that there are several.
  void AskForSeries(std::function<int(const QStringList&)> series)
  {
    this->WhichSeries = std::move(series);
  }
  void New();
  /// Whatever they are, one after the other; what each is is found out beside the window.
  void OpenFiles(const std::vector<std::filesystem::path>& files);
  /// A file, or a folder of DICOM slices.
  void OpenVolume(const std::filesystem::path& file);
  void OpenSegmentation(const std::filesystem::path& file);
  void OpenSession(const std::filesystem::path& file);
  void RelocateFile(const std::filesystem::path& missing, const std::filesystem::path& moved);
  /// False, with a message, where the file cannot be written.
  bool Save(const std::filesystem::path& file);

  /// A step; see StudyHistory.
  void Change(const QString& sentence, const StudyState& next, const QString& gesture = {});
  void EndGesture() { this->Open.EndGesture(); }
  /// Looks elsewhere; no step.
  void ChangeView(const StudyView& view);
  void Undo();
  void Redo();

  /// See Study.
  void MeasureQuality();
  void UseRecommendedQuality();
  void AddIsoValue(double iso);

  void CancelStep(SceneStep step);
  void ResumeStep(SceneStep step);

  void StartTouch();
  void StopTouch();
  void SwitchForcesOff();
  void SwitchForcesOn();
  void MoveHand(const Vector3& targetWorld);
  void MoveWorkspace(const Vector3& centerWorld, const QString& gesture);
  void FitWorkspace();
  /// What was drilled earlier, while nothing is touched. Throws InputError.
  void OpenDrilled(const std::filesystem::path& file);
  void StartRecording(const std::filesystem::path& file);
  void StopRecording();

  /// See Study::OpenReplay.
  void OpenReplay(const std::filesystem::path& file);
  void CloseReplay();
  void ExportReplay(const std::filesystem::path& file);
  /// Only while it is replaying.
  void PlayReplay(bool isPlayed);
  /// The device's axes in the world, where they follow the camera.
  void TurnAxes(const Matrix3& rotation);

  /// A sentence for the user, from wherever in the window.
  void Report(const std::string& sentence);
  /// Forces first, then what is at work; nothing happens after this. False as Study::Close.
  bool Close();
  /// What Close answered.
  bool HasEnded() const { return this->IsEnded; }

Q_SIGNALS:
  void StateChanged();    ///< another step, or another study
  void ViewChanged();     ///< looked elsewhere
  void ProductsChanged(); ///< something was made
  void StepsChanged();    ///< how steps of the pipeline stand
  void FileOpened(const QString& file);
  void TouchChanged();  ///< began or ended
  void Touched();       ///< there is a new reading
  void ReplayChanged(); ///< opened or closed, played or paused
  void Problem(const QString& sentence);

private:
  void Look();
  void LookAtTouch();
  void LookAtReplay();
  void Tell(const std::string& problem, std::string& told);
  void LookAtNotes();
  void LookAtSteps();
  void LookAtProtection();
  void Tell(SceneStep step, const std::string& sentence);
  void Announce();
  void TakeRole();
  void OpenAs(StudyFileRole role, const std::filesystem::path& file);
  void OpenFolder(const std::filesystem::path& folder);
  void TakeSeries(const std::filesystem::path& folder, const QStringList& series);
  void OpenVolumeNow(const std::filesystem::path& file, const std::string& series);
  void Try(const std::function<void()>& act);

  Study Open;
  StudyTouchReading Felt;
  QTimer Timer;
  std::vector<std::filesystem::path> Roles; ///< files whose role is to be found out
  int Folders = 0;                          ///< whose series are being looked up
  std::function<bool()> MayLeave;
  std::function<int(const QStringList&)> WhichSeries;
  std::map<SceneStep, std::set<std::string>> Told; ///< what failed or was replaced, and was said
  std::weak_ptr<const Volume> NotedVolume;         ///< whose notes were told
  std::weak_ptr<const Segmentation> NotedLabels;
  std::string ToldOfTouch;
  std::string ToldOfReplay;
  std::uint64_t Revision = 0;
  int LooksToSteps = 0;
  bool IsMaking = false;
  bool WasTouching = false;
  bool WasReplaying = false;
  bool IsClosed = false;
  bool IsEnded = false;
};
} // namespace palpate
