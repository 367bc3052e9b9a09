#include "WindowMeasures.h"

#include "FitResult.h"

#include <QApplication>
#include <QElapsedTimer>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace palpate::bench
{
namespace
{
constexpr const char* HeadFile = "/usr/share/mricron/templates/ch2.nii.gz";      // Colin 27
constexpr const char* SecondFile = "/usr/share/mricron/templates/ch2bet.nii.gz"; // its brain
constexpr int Turns = 5;
constexpr const char* LabelsFile = "/usr/share/mricron/templates/aal.nii.gz";
constexpr const char* StructureName = "Thalamus_L";
constexpr double PressDepth = 1.5; // mm
constexpr int PathPoints = 2000;
constexpr double RoundSeconds = 8.0;
constexpr int Moments = 16; // at which a window is closed while it is opening a head
constexpr double MomentSeconds = 0.08;

void WaitUntil(const std::function<bool()>& isTrue)
{
  while (!isTrue())
  {
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
}

double SecondsOf(const QElapsedTimer& timer)
{
  return 1e-9 * static_cast<double>(timer.nsecsElapsed());
}

void Extend(WindowStretch& stretch, const WindowStretch& part)
{
  stretch.Seconds += part.Seconds;
  stretch.Ticks += part.Ticks;
  stretch.Touching += part.Touching;
  stretch.Images.resize(part.Images.size());
  std::transform(part.Images.begin(), part.Images.end(), stretch.Images.begin(),
                 stretch.Images.begin(), std::plus<>());
}

// The head, with one visible and touchable structure.
void OpenHead(StudyController& study)
{
  study.OpenVolume(HeadFile);
  study.OpenSegmentation(LabelsFile);
  WaitUntil([&study] { return !study.State().Structures.empty(); });
  StudyState next = study.State();
  for (SceneStructure& structure : next.Structures)
  {
    const bool isChosen = structure.Name == StructureName;
    structure.IsVisible = isChosen;
    structure.IsTouchable = isChosen;
  }
  next.Fit.Model = FitSettings::ModelKind::Radial;
  next.View.SlicesFollowProbe = true;
  study.Change("Choose one structure", next);
}

void ChangeDegree(StudyController& study, int degree)
{
  StudyState next = study.State();
  for (SceneStructure& structure : next.Structures)
  {
    structure.Degree = degree;
  }
  study.Change("Change the degree", next);
}
} // namespace

WindowMeasures::WindowMeasures(double seconds)
    : Length(seconds), Study(std::make_unique<StudyController>(this->Time)),
      Window(std::make_unique<MainWindow>(*this->Study))
{
  if (!std::filesystem::exists(HeadFile))
  {
    throw std::runtime_error(std::string(HeadFile) + " is not there; install mricron-data");
  }
  this->Window->resize(1280, 800);
  this->Window->show();
  OpenHead(*this->Study);
  this->Settle();
  this->MakePath();
  QObject::connect(this->Study.get(), &StudyController::Touched, this->Window.get(),
                   [this] { this->TakeTicks(); });
}

WindowMeasures::~WindowMeasures()
{
  this->Study->Close();
}

void WindowMeasures::Settle()
{
  int quiet = 0; // a finished step may start another one
  QObject::connect(this->Study.get(), &StudyController::StepsChanged, this->Window.get(),
                   [this, &quiet] { quiet = this->Study->IsBusy() ? 0 : quiet + 1; });
  WaitUntil([&quiet] { return quiet > 3; });
  QObject::disconnect(this->Study.get(), &StudyController::StepsChanged, this->Window.get(),
                      nullptr);
}

// Around the structure, tilted, so that all three slices move.
void WindowMeasures::MakePath()
{
  for (const SceneStructure& structure : this->Study->State().Structures)
  {
    const auto fit =
        this->Study->Current().Pipeline().Newest<FitResult>(SceneStep::Model, structure.Id);
    if (fit == nullptr || !structure.IsTouchable)
    {
      continue;
    }
    for (int p = 0; p < PathPoints; ++p)
    {
      const double angle = 2.0 * M_PI * p / PathPoints;
      const Vector3 direction =
          Vector3(std::cos(angle), std::sin(angle), 0.6 * std::sin(2.0 * angle)).normalized();
      this->Path.push_back(fit->Radial()->CenterWorld() +
                           (fit->Radial()->Radius(direction) - PressDepth) * direction);
    }
  }
  if (this->Path.empty())
  {
    throw std::runtime_error(std::string(StructureName) + " has no model");
  }
}

void WindowMeasures::StartTouch()
{
  this->Study->StartTouch();
  WaitUntil([this] { return this->Study->IsTouching(); });
  // A hand that starts far away takes some time, and is at rest when it arrives.
  WaitUntil(
      [this]
      {
        this->Study->Current().Touch().MoveHand(this->Path.front());
        return this->Study->Reading().TouchedId != 0;
      });
}

void WindowMeasures::TakeTicks()
{
  if (this->Taking == nullptr)
  {
    return;
  }
  WindowStretch& stretch = *this->Taking;
  for (const TouchState& tick : this->Study->Reading().NewTicks)
  {
    if (this->LastTick >= 0)
    {
      stretch.Periods.Add(tick.Tick.Started - this->LastTick);
    }
    this->LastTick = tick.Tick.Started;
    const bool isFaulty = tick.Safety.Fault != SafetyFault::None;
    stretch.Faults += isFaulty && !this->WasFaulty ? 1 : 0;
    this->WasFaulty = isFaulty;
    ++stretch.Ticks;
    stretch.Touching += tick.Structure >= 0 ? 1 : 0;
  }
}

// A copy, since a file that is already open is not read again.
std::filesystem::path WindowMeasures::NewCopy(int number) const
{
  const auto file = this->Copies / ("head" + std::to_string(number) + ".nii.gz");
  std::filesystem::copy_file(HeadFile, file);
  return file;
}

WindowStretch WindowMeasures::Measure(const std::string& name, const Act& act)
{
  return this->Measure(name, act, this->Length);
}

WindowStretch WindowMeasures::Measure(const std::string& name, const Act& act, double seconds)
{
  WindowStretch stretch;
  stretch.Name = name;
  this->StartTouch();
  const std::uint64_t missed = this->Study->Reading().Periods.Misses();
  std::vector<int> before;
  for (const ViewPane* pane : this->Window->Views()->Panes())
  {
    before.push_back(pane->RenderCount());
  }
  this->LastTick = -1;
  this->Taking = &stretch;
  QElapsedTimer timer;
  timer.start();
  while (SecondsOf(timer) < seconds)
  {
    const double round = std::fmod(SecondsOf(timer) / RoundSeconds, 1.0);
    this->Study->Current().Touch().MoveHand(
        this->Path[static_cast<std::size_t>(round * PathPoints)]);
    act(stretch, SecondsOf(timer));
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  stretch.Seconds = SecondsOf(timer);
  this->Taking = nullptr;
  stretch.Missed = this->Study->Reading().Periods.Misses() - missed;
  stretch.Durations = this->Study->Reading().Durations;
  const auto panes = this->Window->Views()->Panes();
  for (std::size_t p = 0; p < before.size(); ++p)
  {
    stretch.Images.push_back(panes[p]->RenderCount() - before[p]);
  }
  this->Study->StopTouch();
  return stretch;
}

std::vector<WindowStretch> WindowMeasures::Stretches()
{
  std::vector<WindowStretch> all;
  this->Window->hide();
  all.push_back(this->Measure("hidden", [](WindowStretch&, double) {}));
  this->Window->show();
  all.push_back(this->Measure("drawing four views", [](WindowStretch&, double) {}));
  all.push_back(this->Measure("resizing",
                              [this](WindowStretch& stretch, double seconds)
                              {
                                if (seconds > 0.1 * stretch.Events)
                                {
                                  const int step = ++stretch.Events % 20;
                                  this->Window->resize(1280 - 15 * step, 800 - 10 * step);
                                }
                              }));
  this->Window->resize(1280, 800);
  all.push_back(this->Measure("loading a volume",
                              [this](WindowStretch& stretch, double)
                              {
                                if (!this->Study->IsBusy())
                                {
                                  this->Study->OpenVolume(this->NewCopy(stretch.Events++));
                                }
                              }));
  // Degrees that were not fitted yet, since earlier results are available at once.
  all.push_back(this->Measure("refitting",
                              [this](WindowStretch& stretch, double)
                              {
                                if (!this->Study->IsBusy() && stretch.Events < 40)
                                {
                                  ChangeDegree(*this->Study, 13 + stretch.Events++);
                                }
                              }));
  return all;
}

void WindowMeasures::ShowSecondVolume(bool isShown)
{
  StudyState next = this->Study->State();
  next.Volumes.at(0).IsVisible = isShown;
  this->Study->Change("Show the second volume", next);
  vtkImageDisplay* images = this->Window->Contents().Images();
  WaitUntil(
      [&] { return !this->Study->IsBusy() && images->GetNumberOfOverlays() == (isShown ? 1 : 0); });
}

std::vector<WindowStretch> WindowMeasures::Blending()
{
  std::vector<WindowStretch> all(2);
  this->Study->AddVolume(SecondFile);
  WaitUntil([this] { return !this->Study->State().Volumes.empty(); });
  for (int turn = 0; turn < Turns; ++turn)
  {
    for (const bool isBlended : {false, true})
    {
      this->ShowSecondVolume(isBlended);
      const WindowStretch part = this->Measure(
          "", [](WindowStretch&, double) {}, this->Length / Turns);
      Extend(all[isBlended ? 1 : 0], part);
    }
  }
  all[0].Name = "one volume";
  all[1].Name = "a second one blended";
  return all;
}

// The running work, for display.
std::string WorkOf(StudyController& study)
{
  std::string work;
  for (const SceneStep step : {SceneStep::Volume, SceneStep::Segmentation, SceneStep::Surface,
                               SceneStep::Samples, SceneStep::Model, SceneStep::Touch})
  {
    if (study.Current().Pipeline().StateOf(step).Is == StudyStepState::Kind::Running)
    {
      work += (work.empty() ? "" : ", ") + std::string(NameOf(step));
    }
  }
  return work.empty() ? "nothing" : work;
}

std::vector<WindowClosing> WindowMeasures::Closings()
{
  std::vector<WindowClosing> all;
  FileQuestions questions;
  questions.WhetherToSave = [](QWidget*) { return FileQuestions::Answer::Discard; };
  for (int moment = 0; moment <= Moments; ++moment)
  {
    SteadyClock time;
    StudyController study(time);
    MainWindow window(study, questions);
    window.resize(1280, 800);
    window.show();
    OpenHead(study);
    QElapsedTimer timer;
    timer.start();
    WaitUntil([&] { return SecondsOf(timer) > MomentSeconds * moment; });
    const bool isLast = moment == Moments;
    if (isLast)
    {
      WaitUntil([&study] { return !study.IsBusy(); });
      study.StartTouch();
      WaitUntil([&study] { return study.IsTouching(); });
    }
    WindowClosing closing{isLast ? "touch, felt" : WorkOf(study)};
    timer.restart();
    window.close();
    closing.Milliseconds = 1e3 * SecondsOf(timer);
    closing.HasEnded = study.HasEnded();
    all.push_back(closing);
  }
  return all;
}
} // namespace palpate::bench
