#include "EventProbe.h"
#include "MarkPlacer.h"
#include "MeshFormats.h"
#include "SurfaceFile.h"
#include "TouchRecorder.h"
#include "ViewPicture.h"
#include "WholeFile.h"
#include "WindowTest.h"

#include "vtkSphereSource.h"

#include <QImage>

namespace palpate::responsiveness_test
{
namespace
{
constexpr int Side = 144;           // voxels
constexpr double Spacing = 0.5;     // mm
constexpr double BoneRadius = 25.0; // mm
constexpr double NerveRadius = 4.0; // mm

// A window with a CT of a sphere of bone, of a size at which each job takes longer than an event
// may: done in an event, it would fail the test.
class ResponsivenessTest : public test::WindowTest
{
protected:
  void SetUp() override
  {
    test::WindowTest::SetUp();
    test::LabelGrid grid;
    grid.Size = {{Side, Side, Side}};
    grid.Spacing = {{Spacing, Spacing, Spacing}};
    grid.CenterOnOrigin();
    WriteImage(this->Ct,
               test::MakeLabelImage<short>(
                   grid,
                   [](double x, double y, double z) { return std::hypot(x, y, z) < BoneRadius; },
                   1000));
    WriteImage(this->Nerve, test::MakeLabelImage(grid, [](double x, double y, double z)
                                                 { return std::hypot(x, y, z) < NerveRadius; }));
  }
  // Runs until it is done; no event may take too long meanwhile.
  void Watch(const char* job, const std::function<void()>& start,
             const std::function<bool()>& isDone)
  {
    QApplication::processEvents();
    test::EventProbe probe;
    start();
    WaitUntil(isDone);
    const double worst = probe.WorstMilliseconds();
    RecordProperty(job, std::to_string(worst));
    EXPECT_LT(worst, test::EventProbe::MostMilliseconds) << job;
  }
  bool IsUpToDate(SceneStep step, int id = 0)
  {
    return this->Study->Current().Pipeline().StateOf(step, id).Is == StudyStepState::Kind::UpToDate;
  }
  int IdOf(std::size_t row) { return this->Study->State().Structures.at(row).Id; }
  // Bone of the CT that is drilled, next to a nerve.
  void OpenScene()
  {
    this->Study->OpenVolume(this->Ct);
    WaitUntil([this] { return this->IsUpToDate(SceneStep::Volume); });
    this->Study->AddThreshold({500.0, {}, 0, "Bone"});
    this->Study->AddSegmentation(this->Nerve);
    WaitUntil([this] { return this->Study->State().Structures.size() == 2; });
    StudyState next = this->Study->State();
    next.Structures[0].Drill.Wear = 2.0;
    next.Structures[1].IsTouchable = false;
    this->Study->Change("Drill", next);
    this->Settle();
  }
  // Cuts as a servo orders them.
  void Drill()
  {
    StudyDrill& drill = this->Study->Current().Touch().Drill();
    const auto& study = this->Study->Current();
    drill.Follow(study.State(), study.Contacts(), {});
    for (std::uint64_t n = 0; n < 40; ++n)
    {
      CutOrder order;
      order.Number = n;
      order.Site = 0;
      order.From.PositionWorld = Vector3(BoneRadius - 0.2 * static_cast<double>(n), 0.0, 0.0);
      order.To.PositionWorld = Vector3(BoneRadius - 0.2 * static_cast<double>(n), 5.0, 0.0);
      ASSERT_TRUE(drill.Editor()->Link()->Orders.Push(order));
    }
    drill.Editor()->Take();
    drill.Finish();
    // The window reads it some time later.
    WaitUntil([this] { return !this->Study->Reading().Drill.Drilled.empty(); });
  }

  std::filesystem::path Ct = this->Phantom.Folder / "ct.nrrd";
  std::filesystem::path Nerve = this->Phantom.Folder / "nerve.nrrd";
};

TEST_F(ResponsivenessTest, WhileAVolumeIsRead)
{
  this->OpenPhantom(); // the first frame of the views compiles shaders, once in a program
  const auto former = this->Study->Current().Pipeline().Newest<Volume>(SceneStep::Volume);
  this->Watch(
      "volume", [this] { this->Study->OpenVolume(this->Ct); },
      [&]
      {
        return this->IsUpToDate(SceneStep::Volume) &&
               this->Study->Current().Pipeline().Newest<Volume>(SceneStep::Volume) != former;
      });
}

TEST_F(ResponsivenessTest, WhileTheForbiddenIsFound)
{
  this->OpenScene();
  StudyState next = this->Study->State();
  next.Structures[1].IsForbidden = true;
  this->Watch(
      "protection", [&] { this->Study->Change("Forbid", next); },
      [this] { return this->IsUpToDate(SceneStep::Protection, this->IdOf(1)); });
}

TEST_F(ResponsivenessTest, WhileWhatWasDrilledIsExported)
{
  this->OpenScene();
  this->Drill();
  for (const char* name : {"left.nrrd", "left.stl"})
  {
    const std::filesystem::path file = this->Phantom.Folder / name;
    this->SavedTo = QString::fromStdString(file.string());
    this->Watch(
        name, [this] { this->Button("drill-export")->click(); },
        [this] { return this->IsWritten(); });
    EXPECT_TRUE(std::filesystem::exists(file)) << this->Messages();
  }
}

TEST_F(ResponsivenessTest, WhileADrilledSessionIsSavedAndOpened)
{
  this->OpenScene();
  this->Drill();
  const std::filesystem::path file = this->Phantom.Folder / "case.palpate.json";
  this->Watch(
      "save", [&] { ASSERT_TRUE(this->Study->Save(file)); }, [] { return true; });
  this->Study->New();
  this->Watch(
      "open", [&] { this->Study->OpenSession(file); },
      [this]
      {
        const auto& drilled = this->Study->Reading().Drill.Drilled;
        return !drilled.empty() && drilled[0].RemovedVolume > 1.0;
      });
}

TEST_F(ResponsivenessTest, WhileAPictureIsWritten)
{
  QImage picture(3000, 2000, QImage::Format_RGB32);
  for (int y = 0; y < picture.height(); ++y)
  {
    for (int x = 0; x < picture.width(); ++x)
    {
      picture.setPixel(x, y, static_cast<unsigned>(x * x + 3 * x * y + y * y));
    }
  }
  const auto file = this->Phantom.Folder / "figure.png";
  this->Watch(
      "picture",
      [&]
      {
        this->Study->Write(file, [picture, file](const ProgressFunction&)
                           { WritePicture(picture, file); });
      },
      [this] { return this->IsWritten(); });
  EXPECT_EQ(QImage(QString::fromStdString(file.string())).size(), picture.size());
}

TEST_F(ResponsivenessTest, WhileAToolIsRead)
{
  constexpr int Resolution = 300;
  const auto file = this->Phantom.Folder / "tool.stl";
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(Resolution);
  sphere->SetPhiResolution(Resolution);
  sphere->Update();
  WriteSurface(file, sphere->GetOutput());
  this->OpenScene();
  StudyState next = this->Study->State();
  next.Tool.Kind = TouchToolSettings::Shape::Surface;
  next.Tool.File = file;
  this->Watch(
      "tool", [&] { this->Study->Change("Touch by a surface", next); },
      [this]
      {
        const auto kind = this->Study->Current().Pipeline().StateOf(SceneStep::Tool).Is;
        return kind == StudyStepState::Kind::UpToDate || kind == StudyStepState::Kind::Failed;
      });
  EXPECT_TRUE(this->IsUpToDate(SceneStep::Tool)) << this->Messages();
}

TEST_F(ResponsivenessTest, WhileARecordingIsReadAndExported)
{
  this->OpenPhantom(); // the first frame of the views compiles shaders, once in a program
  constexpr std::size_t Ticks = 60000;
  const auto file = this->Phantom.Folder / "long.touch";
  TouchRecorder recorder;
  ASSERT_TRUE(recorder.Start(file.string(), RecordedSession()).IsOk());
  for (std::size_t n = 0; n < Ticks; ++n)
  {
    TouchState tick;
    tick.Tick.Number = n;
    tick.Tick.Started = 1'000'000 * static_cast<std::int64_t>(n);
    tick.HasSample = true;
    ASSERT_TRUE(recorder.Take(tick).IsOk());
  }
  ASSERT_TRUE(recorder.Finish().IsOk());
  this->Watch(
      "recording", [&] { this->Study->OpenFiles({file}); },
      [this] { return this->Study->IsReplaying(); });
  const auto table = this->Phantom.Folder / "ticks.csv";
  this->Watch(
      "ticks", [&] { this->Study->ExportReplay(table); },
      [&] { return std::filesystem::exists(table); });
}

TEST_F(ResponsivenessTest, WhileALargeSurfaceIsPreparedForAMeasurement)
{
  constexpr int Resolution = 500; // half a million triangles
  constexpr double Radius = 20.0;
  const auto file = this->Phantom.Folder / "large.stl";
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(Radius);
  sphere->SetThetaResolution(Resolution);
  sphere->SetPhiResolution(Resolution);
  sphere->Update();
  WriteSurface(file, sphere->GetOutput());
  this->OpenPhantom(); // the first frame of the views compiles shaders, once in a program
  const std::size_t before = this->Study->State().Structures.size();
  this->Study->OpenFiles({file});
  WaitUntil([&] { return this->Study->State().Structures.size() > before; });
  this->Settle();
  DrawAll(*this->Window->Views());
  MarkPlacer& marks = *this->Window->findChild<MarkPlacer*>();
  marks.Choose(MeasurementKind::Thickness);
  this->Watch(
      "measurement", [&] { marks.Place(Vector3(0.0, 0.0, Radius)); },
      [this] { return !this->Study->State().Measurements.empty(); });
  EXPECT_NEAR(*ValueOf(this->Study->State().Measurements[0]), 2.0 * Radius, 1e-2);
}

TEST_F(ResponsivenessTest, ProbeSeesABusyEvent)
{
  test::EventProbe probe;
  bool isOver = false;
  QTimer::singleShot(0,
                     [&isOver]
                     {
                       timespec used{};
                       const auto isBusy = [&used]
                       {
                         clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
                         return used.tv_sec;
                       };
                       const auto end = isBusy() + 2;
                       while (isBusy() < end)
                       {
                       }
                       isOver = true;
                     });
  WaitUntil([&isOver] { return isOver; });
  EXPECT_GT(probe.WorstMilliseconds(), 2.0 * test::EventProbe::MostMilliseconds);
}
} // namespace
} // namespace palpate::responsiveness_test
