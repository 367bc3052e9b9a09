#include "ViewerRun.h"

#include "Interruption.h"
#include "ScreenText.h"

#include <QApplication>
#include <iostream>

namespace palpate
{
namespace
{
constexpr int ImageDelay = 500;  // ms: the last results are drawn, the hand is at rest
constexpr int LookInterval = 50; // ms
} // namespace

ViewerRun::ViewerRun(StudyController& study, MainWindow& window, const ViewerOptions& options)
    : Study(study), Window(window), Options(options)
{
  std::vector<std::filesystem::path> files;
  for (const QString& file : options.Files)
  {
    files.emplace_back(file.toStdString());
  }
  connect(&study, &StudyController::StepsChanged, this, &ViewerRun::GoOn);
  connect(&this->Looks, &QTimer::timeout, this, &ViewerRun::EndIfAsked);
  this->Looks.start(LookInterval);
  study.OpenFiles(files);
}

// Timers also run while a dialog waits for an answer; exit ends its loop too.
void ViewerRun::EndIfAsked()
{
  if (Interruption::WasAsked())
  {
    this->Looks.stop();
    this->Study.Close();
    QApplication::exit(Interruption::ExitCode());
  }
}

void ViewerRun::GoOn()
{
  // Before anything is made of unwanted structures.
  if (this->Options.ShowsDemo && !this->HasChosen && !this->Study.State().Structures.empty())
  {
    this->HasChosen = true;
    this->ChooseDemo();
    return;
  }
  if (this->Study.IsBusy())
  {
    return;
  }
  if (this->Options.StartsTouch && !this->HasTouched)
  {
    this->HasTouched = true;
    this->Study.StartTouch();
    return;
  }
  disconnect(&this->Study, &StudyController::StepsChanged, this, &ViewerRun::GoOn);
  if (!this->Options.Screenshot.isEmpty())
  {
    QTimer::singleShot(ImageDelay, this, &ViewerRun::TakeScreenshot);
  }
}

// Star-shaped deep structures, as in the examples of `palpate fit`.
void ViewerRun::ChooseDemo()
{
  static const QStringList Names{"Thalamus_L", "Thalamus_R", "Pallidum_L",    "Pallidum_R",
                                 "Amygdala_L", "Amygdala_R", "Cerebelum_9_L", "Cerebelum_9_R"};
  StudyState next = this->Study.State();
  for (SceneStructure& structure : next.Structures)
  {
    const bool isChosen = Names.contains(QString::fromStdString(structure.Name));
    structure.IsVisible = isChosen;
    structure.IsTouchable = isChosen;
  }
  this->Study.Change("Choose the structures of the demonstration", next);
  this->Window.Messages()->Clear(); // on the structure shown by default
}

void ViewerRun::TakeScreenshot()
{
  const bool isSaved = this->Window.SaveScreenshot(this->Options.Screenshot);
  // Nobody sees them in a window that closes.
  for (const QString& line : this->Window.Messages()->Text().split('\n', Qt::SkipEmptyParts))
  {
    std::cerr << Printable(line.toStdString()) << std::endl;
  }
  const bool isOpened = this->Options.Files.isEmpty() || !(this->Study.State() == StudyState());
  this->Study.Close();
  QApplication::exit(isSaved && isOpened ? 0 : 1);
}
} // namespace palpate
