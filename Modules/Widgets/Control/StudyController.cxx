#include "StudyController.h"

#include "DicomPreview.h"
#include "ExceptionMessage.h"
#include "MaskFolder.h"
#include "Progress.h"
#include "SeriesDialog.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t MostPreviews = 200; // series after these are offered without

// Of series among which the user will choose.
void ReadPreviews(std::vector<DicomSeriesChoice>& series, const ProgressFunction& progress)
{
  const std::size_t count = series.size() > 1 ? std::min(series.size(), MostPreviews) : 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    ReportProgress(progress, static_cast<double>(i) / static_cast<double>(count),
                   "Reading previews");
    series[i].Preview = ReadDicomPreview(series[i].Slices, SeriesDialog::PreviewSide);
  }
}

constexpr int LookMilliseconds = 16; // a frame at 60 Hz
constexpr int LooksAStep = 6;
} // namespace

StudyController::StudyController(Clock& clock, const RealtimeRequest& request)
    : Time(clock), Priority(request), Open(clock, request)
{
  connect(&this->Timer, &QTimer::timeout, this, &StudyController::Look);
  this->Timer.start(LookMilliseconds);
}

void StudyController::Announce()
{
  Q_EMIT StateChanged();
  this->LookSoon();
}

void StudyController::LookSoon()
{
  this->LooksToSteps = 0;
  this->Look();
}

StudyStepState StudyController::StateOf(SceneStep step)
{
  const StudyStepState reading = this->Opening.StateOf(step);
  return reading.Is != StudyStepState::Kind::NotWanted ? reading
                                                       : this->Open.Pipeline().StateOf(step);
}

QString StudyController::TouchedTitle() const
{
  const SceneStructure* touched = FindStructure(this->State(), this->Felt.TouchedId);
  return touched != nullptr                                ? ScreenString(TitleOf(*touched))
         : this->Felt.TouchedId == StudyDrawn::StructureId ? "the drawn organ"
                                                           : QString();
}

StudyOpening::Outcome StudyController::OutcomeOf(const std::filesystem::path& file)
{
  return {[this, name = QString::fromStdString(StudyPath(file).string())]
          { Q_EMIT FileOpened(name); },
          [this](const std::string& message) { this->Report(message); }};
}

void StudyController::Try(const std::function<void()>& act)
{
  try
  {
    act();
  }
  catch (const std::exception& error)
  {
    this->Report(MessageOf(error));
  }
  this->Announce();
}

void StudyController::New()
{
  this->OpenState(this->First);
}

void StudyController::OpenState(const StudyState& state)
{
  Q_EMIT Leaving();
  this->Roles.clear();
  this->Opening.Cancel();
  this->Open.New(state);
  this->Announce();
}

bool StudyController::Recover(const std::filesystem::path& folder)
{
  bool isOpen = false;
  this->Try(
      [&]
      {
        this->Open.Recover(folder);
        this->Opening.Cancel();
        isOpen = true;
      });
  return isOpen;
}

void StudyController::BeginWith(const StudyState& first)
{
  const bool isUntouched = this->State() == this->First && this->Open.File().empty() &&
                           !this->Open.History().CanRedo() && !this->IsReplaying();
  this->First = first;
  if (isUntouched && first != this->State())
  {
    this->Open.New(first);
    this->Announce();
  }
}

void StudyController::OpenFiles(const std::vector<std::filesystem::path>& files)
{
  const bool isWaiting = !this->Roles.empty();
  this->Roles.insert(this->Roles.end(), files.begin(), files.end());
  if (!isWaiting)
  {
    this->Opened.clear();
    this->TakeRole();
  }
}

void StudyController::TakeRole()
{
  if (this->Roles.empty())
  {
    return;
  }
  const std::filesystem::path file = this->Roles.front();
  const auto goOn = [this]
  {
    if (!this->Roles.empty())
    {
      this->Roles.erase(this->Roles.begin());
    }
    this->TakeRole();
  };
  StudyJob job;
  job.Work = [this, file, goOn](const ProgressFunction&)
  {
    const StudyFileRole role = RoleOf(file);
    return StudyJob::Delivery(
        [this, file, role, goOn]
        {
          // Deferred until after the delivery: a question to the user processes events.
          QTimer::singleShot(0, this,
                             [this, file, role, goOn]
                             {
                               this->OpenAs(role, file);
                               goOn();
                             });
        });
  };
  job.Fail = [this, goOn](const std::string& message)
  {
    this->Report(message);
    goOn();
  };
  this->Open.Jobs().Start(std::move(job));
}

void StudyController::OpenAs(StudyFileRole role, const std::filesystem::path& file)
{
  const bool isFirst = this->Opened.insert(role).second;
  switch (role)
  {
  case StudyFileRole::Session:
    if (!this->MayLeave || this->MayLeave())
    {
      this->OpenSession(file);
    }
    break;
  case StudyFileRole::Segmentation:
    isFirst ? this->OpenSegmentation(file) : this->AddSegmentation(file);
    break;
  case StudyFileRole::Volume:
    isFirst ? this->OpenVolume(file) : this->AddVolume(file);
    break;
  case StudyFileRole::Recording:
    this->OpenReplay(file);
    break;
  case StudyFileRole::Scene:
    this->Opening.OpenScene(file, this->OutcomeOf(file));
    break;
  case StudyFileRole::Markups:
    this->Opening.AddMarkups(file, this->OutcomeOf(file));
    break;
  case StudyFileRole::Model:
  case StudyFileRole::Surface:
    this->Opening.AddStructure(file, this->OutcomeOf(file));
    break;
  }
  this->LookSoon();
}

void StudyController::AddThreshold(const StudyThreshold& threshold)
{
  this->Try([&] { this->Open.AddThreshold(threshold); });
}

void StudyController::OpenVolume(const std::filesystem::path& file)
{
  this->ReadVolume(file, &StudyOpening::OpenVolume);
}

void StudyController::AddVolume(const std::filesystem::path& file)
{
  this->ReadVolume(file, &StudyOpening::AddVolume);
}

void StudyController::ReadVolume(const std::filesystem::path& file, VolumeOpening open)
{
  std::error_code failure;
  if (RoleByName(file))
  {
    this->OpenFiles({file});
  }
  else if (IsMaskFolder(file))
  {
    this->OpenSegmentation(file);
  }
  else if (std::filesystem::is_directory(file, failure))
  {
    this->OpenFolder(file, open);
  }
  else
  {
    this->ReadVolumeNow(file, {}, open);
  }
}

void StudyController::ReadVolumeNow(const std::filesystem::path& file, const std::string& series,
                                    VolumeOpening open)
{
  // A file that is opened again is reported again.
  (this->Opening.*open)(file, series, this->OutcomeOf(file));
  this->LookSoon();
}

// A folder may have thousands of slices: their headers are read in the background.
void StudyController::OpenFolder(const std::filesystem::path& folder, VolumeOpening open)
{
  ++this->Folders;
  StudyJob job;
  job.Work = [this, folder, open](const ProgressFunction& progress)
  {
    std::vector<DicomSeriesChoice> found = FindDicomSeriesBelow(folder);
    ReadPreviews(found, progress);
    return StudyJob::Delivery(
        [this, open, series = std::move(found)]
        {
          // Deferred until after the delivery: a question to the user processes events.
          QTimer::singleShot(0, this, [this, series, open] { this->TakeSeries(series, open); });
        });
  };
  job.Fail = [this](const std::string& message)
  {
    --this->Folders;
    this->Report(message);
  };
  this->Open.Jobs().Start(std::move(job));
}

void StudyController::TakeSeries(const std::vector<DicomSeriesChoice>& series, VolumeOpening open)
{
  const bool isAsked = series.size() > 1 && this->WhichSeries;
  const int chosen = isAsked ? this->WhichSeries(series) : 0;
  --this->Folders;
  if (chosen >= 0)
  {
    const DicomSeriesChoice& one = series.at(static_cast<std::size_t>(chosen));
    this->ReadVolumeNow(one.Folder, one.Series, open);
  }
}

void StudyController::OpenSegmentation(const std::filesystem::path& file)
{
  if (RoleByName(file))
  {
    this->OpenFiles({file});
    return;
  }
  this->Opening.OpenSegmentation(file, this->OutcomeOf(file));
  this->LookSoon();
}

void StudyController::AddSegmentation(const std::filesystem::path& file)
{
  this->Open.AddSegmentation(file, [this](const std::string& message) { this->Report(message); });
  this->LookSoon();
}

void StudyController::OpenSession(const std::filesystem::path& file)
{
  this->Try(
      [&]
      {
        Q_EMIT Leaving();
        this->Open.Open(file);
        this->Opening.Cancel();
        Q_EMIT FileOpened(QString::fromStdString(StudyPath(file).string()));
      });
}

void StudyController::RelocateFile(const std::filesystem::path& missing,
                                   const std::filesystem::path& moved)
{
  this->Try([&] { this->Open.RelocateFile(missing, moved); });
}

bool StudyController::Save(const std::filesystem::path& file)
{
  bool isSaved = false;
  this->Try(
      [&]
      {
        this->Open.Save(file);
        isSaved = true;
        Q_EMIT Saved();
        Q_EMIT FileOpened(QString::fromStdString(StudyPath(file).string()));
      });
  return isSaved;
}

void StudyController::Change(const QString& message, const StudyState& next, const QString& gesture)
{
  if (this->Open.Change(message.toStdString(), next, gesture.toStdString()))
  {
    this->WantsTouch = false;
    this->Announce();
  }
}

void StudyController::ChangeView(const StudyView& view)
{
  if (!(view == this->State().View))
  {
    this->Open.ChangeView(view);
    Q_EMIT ViewChanged();
  }
}

void StudyController::Undo()
{
  if (this->Open.Undo())
  {
    this->Announce();
  }
}

void StudyController::Redo()
{
  if (this->Open.Redo())
  {
    this->Announce();
  }
}

void StudyController::CancelStep(SceneStep step)
{
  this->Opening.Cancel(step);
  this->Open.CancelStep(step);
  this->LookSoon();
}

void StudyController::ResumeStep(SceneStep step)
{
  this->Open.ResumeStep(step);
  this->LookSoon();
}

void StudyController::StartTouch()
{
  this->WantsTouch = false;
  this->Open.StartTouch();
  this->LookAtProblems(); // what is tried again is told again
  this->Look();
}

void StudyController::StopTouch()
{
  this->WantsTouch = false;
  this->Open.StopTouch();
  this->Look();
}

void StudyController::OpenDrilled(const std::filesystem::path& file)
{
  this->Open.OpenDrilled(file, [this](const std::string& message) { this->Report(message); });
  this->LookSoon();
}

void StudyController::Write(const std::filesystem::path& file, StudyWriting::Writing write)
{
  this->Open.Writing().Start(file, std::move(write),
                             [this](const std::string& message) { this->Report(message); });
  this->LookSoon();
}

void StudyController::StartRecording(const std::filesystem::path& file)
{
  const Status status = this->Open.Touch().StartRecording(file);
  if (!status.IsOk())
  {
    this->Report(status.Message());
  }
  this->Look();
}

void StudyController::StopRecording()
{
  const Status status = this->Open.Touch().StopRecording();
  if (!status.IsOk())
  {
    this->Report(status.Message());
  }
  this->Look();
}

void StudyController::OpenReplay(const std::filesystem::path& file)
{
  this->Open.OpenReplay(StudyPath(file));
  this->LookAtProblems();
  this->Look();
}

void StudyController::CloseReplay()
{
  this->Open.CloseReplay();
  this->Look();
}

void StudyController::ExportReplay(const std::filesystem::path& file)
{
  this->Open.ExportReplay(file);
  this->LookAtProblems();
}

void StudyController::PlayReplay(bool isPlayed)
{
  if (StudyReplay* replay = this->Open.Replay())
  {
    isPlayed ? replay->Play() : replay->Pause();
    Q_EMIT ReplayChanged();
  }
}

bool StudyController::Close()
{
  this->IsClosed = true;
  this->Timer.stop();
  this->Roles.clear();
  this->IsEnded = this->Open.Close();
  return this->IsEnded;
}

void StudyController::Look()
{
  if (this->IsClosed)
  {
    return;
  }
  if (this->Open.Deliver() > 0)
  {
    this->LooksToSteps = 0;
    Q_EMIT StateChanged();
  }
  if (this->Revision != this->Open.Pipeline().Revision())
  {
    this->Revision = this->Open.Pipeline().Revision();
    Q_EMIT ProductsChanged();
  }
  if (this->WantsTouch && !this->Open.Contacts().empty())
  {
    this->StartTouch();
  }
  // Progress is for reading, so it is updated less often.
  if (this->LooksToSteps-- <= 0)
  {
    this->LooksToSteps = LooksAStep;
    this->LookAtSteps();
  }
  this->LookAtTouch();
  this->LookAtReplay();
  this->LookAtDrill();
}

// A message goes with its cause, and comes again with it.
void StudyController::LookAtProblems()
{
  const std::vector<std::string> now = this->Problems.Now(this->Felt);
  for (const std::string& told : this->Told)
  {
    if (std::find(now.begin(), now.end(), told) == now.end())
    {
      Q_EMIT ProblemEnded(ScreenString(told));
    }
  }
  const std::vector<std::string> before = std::exchange(this->Told, now);
  for (const std::string& problem : now)
  {
    if (std::find(before.begin(), before.end(), problem) == before.end())
    {
      this->Report(problem);
    }
  }
}

void StudyController::LookAtSteps()
{
  bool isMaking = this->Open.IsOpeningDevice() || this->Open.IsAddingSegmentation() ||
                  this->Open.IsReadingDrilled() || this->Opening.IsReading();
  for (const SceneStep step : StudyProblems::Steps)
  {
    const StudyStepState::Kind state = this->Open.Pipeline().StateOf(step).Is;
    isMaking = isMaking || state == StudyStepState::Kind::Running ||
               state == StudyStepState::Kind::NeedsUpdate;
  }
  this->IsMaking = isMaking;
  this->LookAtProblems();
  Q_EMIT StepsChanged();
}

void StudyController::LookAtTouch()
{
  if (this->IsTouching())
  {
    this->Felt = this->Open.Touch().Poll();
    if (this->Felt.Newest.IsDrilling && !this->Felt.Drill.Hold.empty())
    {
      this->LookAtProblems(); // the key may be held for a moment only
    }
    Q_EMIT Touched();
  }
  this->Open.WatchDevice(this->Felt);
  const std::pair<bool, bool> now(this->IsTouching(), this->Open.IsAwaitingDevice());
  if (std::exchange(this->WasTouching, now) != now)
  {
    Q_EMIT TouchChanged();
  }
}

// While touch is off, what was drilled changes with files and structures.
void StudyController::LookAtDrill()
{
  const StudyDrill& drill = this->Open.Touch().Drill();
  if (this->DrillRevision != drill.Revision() && !this->IsTouching() && !this->IsReplaying())
  {
    this->DrillRevision = drill.Revision();
    this->Felt.Drill = drill.Last();
    Q_EMIT DrilledChanged();
  }
}

void StudyController::LookAtReplay()
{
  StudyReplay* replay = this->Open.Replay();
  if (replay != this->Replayed)
  {
    this->Replayed = replay;
    --this->DrillRevision; // a replay does not show what was drilled
    if (replay != nullptr)
    {
      Q_EMIT FileOpened(QString::fromStdString(replay->File().string()));
    }
    Q_EMIT ReplayChanged();
  }
  if (replay == nullptr)
  {
    return;
  }
  const bool wasPlaying = replay->IsPlaying();
  this->Felt = this->Open.PollReplay();
  if (wasPlaying || !this->Felt.NewTicks.empty())
  {
    Q_EMIT Touched();
  }
  if (wasPlaying != replay->IsPlaying())
  {
    Q_EMIT ReplayChanged();
  }
}
} // namespace palpate
