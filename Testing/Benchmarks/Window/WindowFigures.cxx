#include "WindowFigures.h"

#include "ImageWriter.h"
#include "LabelImages.h"
#include "MainWindow.h"
#include "SlicePainter.h"
#include "SteadyClock.h"
#include "StructureTable.h"
#include "TemporaryFolder.h"

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QProcess>

#include "vtkImageData.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <stdexcept>
#include <unistd.h>

namespace palpate::bench
{
namespace
{
const std::string Templates = "/usr/share/mricron/templates/"; // Colin 27 and AAL
constexpr int Starts = 5;
constexpr int Repetitions = 5;
constexpr int StartLimit = 60000; // ms

// As the program makes it.
struct OpenWindow
{
  OpenWindow() : Study(this->Time), Window(this->Study)
  {
    this->Window.resize(1280, 800);
    this->Window.show();
    QApplication::processEvents();
  }
  ~OpenWindow() { this->Study.Close(); }
  OpenWindow(const OpenWindow&) = delete;
  OpenWindow& operator=(const OpenWindow&) = delete;

  static void Until(const std::function<bool()>& isTrue)
  {
    while (!isTrue())
    {
      QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
  }
  // Four views of an image, with so many volumes over it.
  void UntilDrawn(int overlays)
  {
    vtkImageDisplay* images = this->Window.Contents().Images();
    Until(
        [&]
        {
          return !this->Study.IsBusy() && images->GetImage() != nullptr &&
                 images->GetNumberOfOverlays() == overlays;
        });
    this->UntilDrawn();
  }
  void UntilDrawn() const
  {
    for (ViewPane* pane : this->Window.Views()->Panes())
    {
      const int before = pane->RenderCount();
      pane->RequestRender();
      Until([&] { return pane->RenderCount() > before; });
    }
  }

  SteadyClock Time;
  StudyController Study;
  MainWindow Window;
};

std::int64_t ResidentBytes()
{
  std::ifstream pages("/proc/self/statm");
  std::int64_t all = 0;
  std::int64_t resident = 0;
  pages >> all >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

void Require(bool isTrue, const char* what)
{
  if (!isTrue)
  {
    throw std::runtime_error(std::string("wrong result: ") + what);
  }
}

std::int64_t BytesOf(vtkImageData* image)
{
  return static_cast<std::int64_t>(image->GetNumberOfPoints()) * image->GetScalarSize() *
         image->GetNumberOfScalarComponents();
}

// Until nothing is left to do at once.
double MillisecondsOf(const std::function<void()>& act)
{
  QElapsedTimer timer;
  timer.start();
  act();
  QApplication::processEvents();
  return 1e-6 * static_cast<double>(timer.nsecsElapsed());
}

std::size_t CountVisible(const StudyController& study)
{
  const auto& all = study.State().Structures;
  return static_cast<std::size_t>(std::count_if(
      all.begin(), all.end(), [](const SceneStructure& structure) { return structure.IsVisible; }));
}

// AAL's names without their file, so that no surface is made meanwhile.
std::vector<SceneStructure> StructuresOfAal()
{
  OpenWindow reading;
  reading.Study.OpenSegmentation(Templates + "aal.nii.gz");
  OpenWindow::Until([&] { return !reading.Study.State().Structures.empty(); });
  std::vector<SceneStructure> all = reading.Study.State().Structures;
  Require(all.size() == 116, "AAL has 116 structures");
  for (SceneStructure& structure : all)
  {
    structure.File = StudyPath("missing.nii.gz");
    structure.IsVisible = structure.IsTouchable = false;
  }
  return all;
}

// In a window that has already drawn the head.
StructureTimes TimeOnce(const std::vector<SceneStructure>& structures)
{
  OpenWindow open;
  open.Study.OpenVolume(Templates + "ch2.nii.gz");
  open.UntilDrawn(0);
  StudyState state = open.Study.State();
  state.Structures = structures;
  auto* table = open.Window.findChild<StructureTable*>("structures");
  auto* search = open.Window.findChild<QLineEdit*>("structure-search");
  const auto choose = [&](const char* name)
  { return [&, name] { open.Window.findChild<QAction*>(name)->trigger(); }; };
  StructureTimes times;
  times.List = MillisecondsOf([&] { open.Study.Change("Open", state); });
  Require(table->model()->rowCount() == 116, "all are listed");
  times.Search = MillisecondsOf([&] { search->setText("thal"); });
  Require(table->model()->rowCount() == 2, "two thalami are found");
  search->clear();
  QApplication::processEvents();
  times.ShowAll = MillisecondsOf(choose("structures-show-all"));
  Require(CountVisible(open.Study) == 116, "all are visible");
  times.ShowNone = MillisecondsOf(choose("structures-show-none"));
  Require(CountVisible(open.Study) == 0, "none is visible");
  return times;
}

// Over a head that is drawn.
void TimeOpening(StructureTimes& times)
{
  OpenWindow open;
  open.Study.OpenVolume(Templates + "ch2.nii.gz");
  open.UntilDrawn(0);
  QElapsedTimer timer;
  timer.start();
  open.Study.OpenSegmentation(Templates + "aal.nii.gz");
  OpenWindow::Until([&] { return open.Study.State().Structures.size() == 116; });
  open.Window.findChild<QAction*>("structures-show-all")->trigger();
  const auto& surfaces = open.Window.Contents().Surfaces();
  OpenWindow::Until([&] { return surfaces.size() == 116; });
  open.UntilDrawn();
  times.Opened = 1e-6 * static_cast<double>(timer.nsecsElapsed());
  OpenWindow::Until([&] { return !open.Study.IsBusy(); });
  times.Modelled = 1e-6 * static_cast<double>(timer.nsecsElapsed());
  Require(CountVisible(open.Study) == 116, "all are visible");
}
} // namespace

VolumeMemory MeasureVolumeMemory()
{
  const test::TemporaryFolder folder;
  test::LabelGrid grid;
  grid.Size = {{8, 8, 8}};
  WriteImage(folder / "tiny.nii.gz",
             test::MakeLabelImage<short>(
                 grid, [](double x, double, double) { return x < 4.0; }, 1));
  OpenWindow open;
  open.Study.OpenVolume(folder / "tiny.nii.gz");
  open.UntilDrawn(0);
  const std::int64_t before = ResidentBytes();
  open.Study.OpenVolume(Templates + "ch2.nii.gz");
  open.UntilDrawn(0);
  open.Study.AddVolume(Templates + "ch2better.nii.gz");
  open.UntilDrawn(1);
  open.Study.AddVolume(Templates + "ch2bet.nii.gz");
  open.UntilDrawn(2);
  VolumeMemory memory;
  memory.GrowthBytes = ResidentBytes() - before;
  const auto& content = open.Window.Contents().Images()->GetContent();
  memory.VolumeBytes = BytesOf(content.Image);
  for (const ImageLayer& layer : content.Over)
  {
    memory.VolumeBytes += BytesOf(layer.Image);
  }
  // Of the headers of these files, a byte a voxel.
  Require(memory.VolumeBytes == 2 * 181 * 217 * 181 + 301 * 370 * 316, "three volumes are shown");
  return memory;
}

StructureTimes MeasureStructures()
{
  const std::vector<SceneStructure> structures = StructuresOfAal();
  StructureTimes shortest = TimeOnce(structures);
  for (int repetition = 1; repetition < Repetitions; ++repetition)
  {
    const StructureTimes times = TimeOnce(structures);
    shortest.List = std::min(shortest.List, times.List);
    shortest.Search = std::min(shortest.Search, times.Search);
    shortest.ShowAll = std::min(shortest.ShowAll, times.ShowAll);
    shortest.ShowNone = std::min(shortest.ShowNone, times.ShowNone);
  }
  TimeOpening(shortest);
  return shortest;
}

StartTimes MeasureStart(const std::string& program)
{
  constexpr double Long = std::numeric_limits<double>::infinity();
  StartTimes shortest{Long, Long};
  for (int start = 0; start < Starts; ++start)
  {
    QProcess process;
    QElapsedTimer timer;
    timer.start();
    process.start(QString::fromStdString(program), {"--start"});
    for (double* time : {&shortest.Window, &shortest.Head})
    {
      while (!process.canReadLine() && process.waitForReadyRead(StartLimit))
      {
      }
      Require(process.readLine() == "drawn\n", "the started program has drawn");
      *time = std::min(*time, 1e-6 * static_cast<double>(timer.nsecsElapsed()));
    }
    process.waitForFinished(StartLimit);
  }
  return shortest;
}

void DrawFirstPictures()
{
  OpenWindow open;
  std::cout << "drawn" << std::endl;
  open.Study.OpenVolume(Templates + "ch2.nii.gz");
  open.UntilDrawn(0);
  std::cout << "drawn" << std::endl;
}
} // namespace palpate::bench
