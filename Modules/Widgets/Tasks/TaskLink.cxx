#include "TaskLink.h"

#include "InputError.h"
#include "OutputFolder.h"
#include "ReadyTask.h"
#include "SceneTool.h"
#include "ScreenString.h"
#include "TaskFile.h"
#include "TaskResults.h"
#include "TrialState.h"
#include "Units.h"

#include <QDesktopServices>
#include <QProgressDialog>
#include <QUrl>

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr const char* TaskName = "task.json";
constexpr std::uint64_t ReadySeed = 1;

QString MinutesText(double seconds)
{
  const auto whole = static_cast<int>(std::ceil(std::max(0.0, seconds)));
  return QString("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

// A side of the camera, as SpacePane::LookFrom takes it: that of a nodule, or across a path.
int CameraSide(TaskKind kind, const TaskTarget& target)
{
  Vector3 direction = kind == TaskKind::Nodule ? target.Side : Vector3(0.0, -1.0, 0.0);
  int axis = 0;
  if (kind == TaskKind::Path)
  {
    Vector3 least = target.Points.front().PointWorld;
    Vector3 most = least;
    for (const TaskPoint& point : target.Points)
    {
      least = least.cwiseMin(point.PointWorld);
      most = most.cwiseMax(point.PointWorld);
    }
    (most - least).minCoeff(&axis);
    direction = Vector3::Unit(axis);
  }
  direction.cwiseAbs().maxCoeff(&axis);
  constexpr int Sides[3][2] = {{3, 2}, {0, 1}, {5, 4}}; // negative and positive of R-L, A-P, I-S
  return Sides[axis][direction[axis] > 0.0 ? 1 : 0];
}
} // namespace

TaskLink::TaskLink(const TaskSurroundings& around, QWidget* parent)
    : QObject(parent), Around(around), Study(around.Study), Between(new TaskPage(parent)),
      Over(new TaskStrip(parent))
{
  connect(this->Between, &TaskPage::StartAsked, this, &TaskLink::Start);
  connect(this->Between, &TaskPage::PauseAsked, this, &TaskLink::Pause);
  connect(this->Between, &TaskPage::StopAsked, this, &TaskLink::Stop);
  connect(this->Between, &TaskPage::FolderAsked, this,
          [this] {
            QDesktopServices::openUrl(
                QUrl::fromLocalFile(QString::fromStdString(this->Folder.string())));
          });
  connect(this->Over, &TaskStrip::NextAsked, this, &TaskLink::EndTrial);
  connect(this->Over, &TaskStrip::PauseAsked, this, &TaskLink::Pause);
  connect(this->Over, &TaskStrip::StopAsked, this, &TaskLink::Stop);
  connect(&this->Study, &StudyController::StepsChanged, this, &TaskLink::FollowSteps);
  connect(&this->Study, &StudyController::TouchChanged, this, &TaskLink::FollowTouch);
  connect(&this->Study, &StudyController::Touched, this, &TaskLink::FollowTicks);
}

TaskLink::~TaskLink()
{
  this->Over->Show({}, nullptr); // while what it works with is there
  this->CancelJob();
}

void TaskLink::AskForTask()
{
  const QStringList files =
      this->Around.Questions.ToOpen(this->Between->window(), "Run a task", "Tasks (*.json)");
  if (!files.isEmpty())
  {
    this->Open(files.front().toStdString());
  }
}

void TaskLink::OpenReady(TaskKind kind)
{
  const QString chosen =
      this->Around.Questions.Folder(this->Between->window(), "Folder for the task and its results");
  if (chosen.isEmpty())
  {
    return;
  }
  const std::filesystem::path folder = StudyPath(chosen.toStdString());
  std::error_code failure;
  if (!std::filesystem::exists(folder / TaskName, failure))
  {
    this->MakeReady(kind, folder);
    return;
  }
  this->Study.Try(
      [&]
      {
        if (ReadTask(folder / TaskName).Kind != kind)
        {
          throw InputError((folder / TaskName).string() +
                           " is another task; choose another folder.");
        }
        this->Open(folder / TaskName);
      });
}

void TaskLink::MakeReady(TaskKind kind, const std::filesystem::path& folder)
{
  auto* wait =
      new QProgressDialog("Making the phantoms...", "Cancel", 0, 100, this->Between->window());
  wait->setObjectName("task-making");
  wait->setAttribute(Qt::WA_DeleteOnClose);
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, kind, folder, wait](const ProgressFunction& progress)
  {
    MakeOutputFolder(folder);
    WriteReadyTask(kind, ReadySeed, folder, progress);
    return StudyJob::Delivery(
        [this, folder, wait]
        {
          wait->close();
          this->Open(folder / TaskName);
        });
  };
  job.Fail = [this, wait](const std::string& message)
  {
    wait->close();
    this->Study.Report(message);
  };
  const StudyJobs::Id id = this->Study.Current().Jobs().Start(std::move(job));
  connect(wait, &QProgressDialog::canceled, this,
          [this, id] { this->Study.Current().Jobs().Cancel(id); });
  connect(&this->Study, &StudyController::StepsChanged, wait,
          [this, id, wait]
          {
            if (const auto progress = this->Study.Current().Jobs().ProgressOf(id))
            {
              wait->setValue(static_cast<int>(99.0 * progress->Fraction));
            }
          });
  wait->show();
}

void TaskLink::Open(const std::filesystem::path& file)
{
  this->Study.Try(
      [&]
      {
        const TaskSettings task = ReadTask(file);
        auto* form = new TaskForm(task, StudyPath(file).parent_path() / "results",
                                  this->Study.State().Device, this->Around.Questions,
                                  this->Between->window());
        form->setAttribute(Qt::WA_DeleteOnClose);
        connect(form, &QDialog::accepted, this, [this, task, form] { this->Begin(task, *form); });
        form->open();
      });
}

void TaskLink::Begin(const TaskSettings& task, TaskForm& form)
{
  if (this->IsOpen() || !this->Around.MayLeave())
  {
    return;
  }
  this->Task = task;
  this->Run = form.TakeRun();
  this->Folder = form.Folder();
  this->Device = form.Device();
  this->Participant = form.Participant().Number;
  this->Rest({});
}

QString TaskLink::ProgressText() const
{
  const TaskTrial& trial = *this->Run->Trial();
  return QString(trial.IsTraining ? "Training, trial %1 of %2" : "Trial %1 of %2")
      .arg(trial.Number)
      .arg(this->Run->Plan().size());
}

void TaskLink::Rest(const QString& told)
{
  this->Now = Phase::Resting;
  this->Told = told;
  this->Study.StopTouch();
  this->Watch.reset();
  this->Activity = nullptr;
  this->Over->Show({}, nullptr);
  this->Over->hide();
  this->PausedAt = this->Study.Now();
  if (this->Run->Trial() == nullptr)
  {
    this->WriteResults();
  }
  else
  {
    this->ReadTrial();
    this->ShowPage();
  }
  Q_EMIT Changed();
}

void TaskLink::ShowPage()
{
  const bool isPaused = this->Run->State() == TaskState::Paused;
  const TaskTrial& trial = *this->Run->Trial();
  const QString what = trial.IsTraining ? "training" : QString("trial %1").arg(trial.Number);
  TaskPage::Content page;
  page.Title = ScreenString(this->Task.Title.empty() ? this->Task.Id : this->Task.Title);
  page.Progress = ProgressText() + (isPaused ? ": pause" : "");
  page.Text = QString::fromStdString(this->Task.Instructions) + "\n\n" +
              (this->Condition().HasForce
                   ? "This trial is with force."
                   : "This trial is without force: nothing pushes back, and the tool is shown "
                     "where your hand is.");
  page.Text += this->Task.MostSeconds > 0.0
                   ? "\nIt ends after " + MinutesText(this->Task.MostSeconds) + " minutes."
                   : QString();
  page.Start = (isPaused ? "Resume " : "Start ") + what;
  page.CanPause = !isPaused;
  page.Stop = "Stop";
  this->Between->Show(page);
  this->ShowPause();
}

// A pause that the plan has lasts as long as the task says.
void TaskLink::ShowPause()
{
  const double passed =
      SecondsPerNanosecond * static_cast<double>(this->Study.Now() - this->PausedAt);
  const double left = this->Run->IsPauseDue() ? this->Task.PauseSeconds - passed : 0.0;
  const QString line = left > 0.0 ? "The pause lasts " + MinutesText(left) + " more." : this->Told;
  this->Between->ShowState(line, left <= 0.0 && this->IsRead);
}

// In the background, while the instructions are read.
void TaskLink::ReadTrial()
{
  this->IsRead = false;
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, first = this->Study.NewState(), device = this->Device, kind = this->Task.Kind,
              target = this->Target(), condition = this->Condition()](const ProgressFunction&)
  {
    return StudyJob::Delivery(
        [this, state = TrialState(first, device, kind, target, condition)]
        {
          this->Job.reset();
          this->Study.OpenState(state);
          this->IsRead = true;
        });
  };
  job.Fail = [this](const std::string& message)
  {
    this->Job.reset();
    this->Told = ScreenString(message);
  };
  this->CancelJob();
  this->Job = this->Study.Current().Jobs().Start(std::move(job));
}

void TaskLink::CancelJob()
{
  if (this->Job)
  {
    this->Study.Current().Jobs().Cancel(*std::exchange(this->Job, std::nullopt));
  }
}

void TaskLink::Pause()
{
  this->Interrupt({});
  this->Study.Try(
      [this]
      {
        this->Run->Pause();
        this->ShowPage();
      });
}

void TaskLink::Start()
{
  this->Study.Try(
      [this]
      {
        if (this->Run->State() == TaskState::Paused)
        {
          this->Run->Resume();
        }
        this->Activity = MakeTrialActivity(
            this->Task.Kind,
            {this->Study, this->Around.Contents, this->Around.Drawing, this->Around.Correcting,
             this->Around.Matching, this->Target(), this->Condition().HasForce},
            this->Over);
        this->Over->Show(this->ProgressText(), this->Activity);
        this->Over->ShowTime("Getting ready...");
        this->Over->show();
        this->Now = Phase::Preparing;
        Q_EMIT Changed();
      });
}

void TaskLink::FollowSteps()
{
  if (this->Now == Phase::Resting && this->Run->Trial() != nullptr)
  {
    this->ShowPause();
  }
  const bool isOpening = this->Study.IsTouching() || this->Study.Current().IsOpeningDevice();
  if (this->Now == Phase::Opening && !isOpening)
  {
    this->Rest(ScreenString(this->Study.Current().TouchProblem()));
  }
  if (this->Now == Phase::Preparing)
  {
    this->Around.Views.Space()->LookFrom(CameraSide(this->Task.Kind, this->Target()));
    if (!this->Study.IsBusy())
    {
      this->Now = Phase::Opening;
      this->Study.StartTouch();
    }
  }
}

void TaskLink::FollowTouch()
{
  if ((this->Now == Phase::Running || this->Now == Phase::Arming) && !this->Study.IsTouching())
  {
    this->Interrupt("Touch has ended.");
  }
  if (this->Now != Phase::Opening || !this->Study.IsTouching())
  {
    return;
  }
  if (this->Task.IsRecorded)
  {
    const std::string name = TaskRun::LogName(this->Participant).stem().string() + "-trial-" +
                             std::to_string(this->Run->Trial()->Number) + "-attempt-" +
                             std::to_string(this->Run->Attempts() + 1) + ".touch";
    this->Study.StartRecording(this->Folder / name);
    if (!this->Study.IsRecording())
    {
      this->Rest("The trial cannot be recorded.");
      return;
    }
  }
  const bool hasForce = this->Condition().HasForce;
  this->Around.ShowHandOnly(!hasForce);
  // A mouse pushes nothing: what it meets can only be seen.
  this->Around.Contents.HideForce(this->Study.Current().Touch().Capabilities().HasMotors);
  if (!hasForce)
  {
    this->Study.Current().Touch().SwitchForcesOff();
  }
  this->Now = Phase::Arming;
}

// What ends by itself, as with the mouse on a busy machine, is waited for.
bool TaskLink::HasCondition() const
{
  const SafetyReport& safety = this->Study.Reading().Newest.Safety;
  return this->Condition().HasForce ? safety.Fault == SafetyFault::None || safety.WillResume
                                    : safety.Fault == SafetyFault::SwitchedOff;
}

void TaskLink::FollowTicks()
{
  const StudyTouchReading& reading = this->Study.Reading();
  if (this->Now == Phase::Arming && reading.Newest.HasSample && this->HasCondition() &&
      (reading.Newest.Safety.IsArmed || !this->Condition().HasForce))
  {
    this->BeginTrial();
    return;
  }
  if (this->Now != Phase::Running)
  {
    return;
  }
  if (!this->HasCondition())
  {
    this->Interrupt(ScreenString(reading.Safety));
    return;
  }
  for (const TouchState& tick : reading.NewTicks)
  {
    this->Watch->Take(tick);
  }
  this->Activity->Take(reading.Newest, *this->Watch);
  this->ShowTime();
  if (this->Watch->IsOver() || this->Activity->IsDone())
  {
    this->EndTrial();
  }
}

void TaskLink::ShowTime()
{
  const double passed = this->Watch->Measured().Seconds;
  this->Over->ShowTime(this->Task.MostSeconds > 0.0
                           ? MinutesText(this->Task.MostSeconds - passed) + " left"
                           : MinutesText(passed));
}

void TaskLink::BeginTrial()
{
  try
  {
    this->Run->Start();
  }
  catch (const InputError& error)
  {
    this->Rest(ScreenString(error.what()));
    return;
  }
  this->Watch.emplace(this->Task, this->Condition().HasForce,
                      MakeTool(this->Study.State().Tool).BoundingRadius());
  this->Now = Phase::Running;
  this->Over->Enable(true);
  this->Around.Views.Space()->Canvas()->setFocus();
  this->Activity->Begin();
  this->ShowTime();
}

// Forces are off before anything is measured or written.
void TaskLink::EndTrial()
{
  if (this->Now != Phase::Running)
  {
    return;
  }
  this->Now = Phase::Resting; // the end of the touch does not interrupt it
  TaskConduct conduct = this->Watch->Measured();
  if (conduct.End == TaskEnd::Done && !this->Activity->HasAnswer())
  {
    conduct.End = TaskEnd::GivenUp;
  }
  this->Study.StopTouch();
  const std::string& unrecorded = this->Study.Current().Touch().Poll().RecordingProblem;
  QString told = conduct.End == TaskEnd::Time    ? "The time is over."
                 : conduct.End == TaskEnd::Force ? "The trial ended since the force was too large."
                                                 : "";
  const bool wasTraining = this->Run->Trial()->IsTraining;
  try
  {
    const bool isSuccess = this->Run->End(this->Activity->Answer(), conduct).IsSuccess;
    told += !wasTraining ? ""
            : isSuccess  ? " The training was within the tolerance."
                         : " The training was not within the tolerance.";
  }
  catch (const InputError& error)
  {
    this->Run->Interrupt();
    told = ScreenString(error.what());
  }
  if (!unrecorded.empty())
  {
    this->Study.Report(unrecorded);
  }
  this->Rest(told.trimmed());
}

void TaskLink::Interrupt(const QString& why)
{
  if (this->Now == Phase::Closed || this->Now == Phase::Resting)
  {
    return;
  }
  const bool hasBegun = this->Now == Phase::Running;
  this->Now = Phase::Resting;
  if (hasBegun)
  {
    this->Run->Interrupt();
  }
  this->Rest(why + (hasBegun ? " The trial begins again." : ""));
}

void TaskLink::WriteResults()
{
  this->Between->Show({ScreenString(this->Task.Title), "Finished", "", "", false, "", ""});
  this->Between->ShowState("Writing the results...", false);
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, folder = this->Folder](const ProgressFunction&)
  {
    WriteTaskResults(ReadTaskResults(folder), folder);
    return StudyJob::Delivery(
        [this]
        {
          this->Finish("All trials are done: thank you.\n\nresults.csv has a row for each trial "
                       "of all participants; analysis.R compares the conditions (Rscript "
                       "analysis.R).");
        });
  };
  job.Fail = [this](const std::string& message) { this->Finish(ScreenString(message)); };
  this->Job = this->Study.Current().Jobs().Start(std::move(job));
}

void TaskLink::Finish(const QString& text)
{
  this->Job.reset();
  this->Between->Show(
      {ScreenString(this->Task.Title), "Finished", text, "", false, "Open folder", "Close"});
  this->Between->ShowState(ScreenString(this->Folder.string()), false);
}

void TaskLink::Stop()
{
  this->Interrupt({});
  this->CancelJob();
  this->Around.ShowHandOnly(false);
  this->Around.Contents.HideForce(false);
  this->Run.reset();
  this->Now = Phase::Closed;
  this->Between->hide();
  this->Study.New();
  Q_EMIT Changed();
}
} // namespace palpate
