// A volume in the 3-D view: from the panel's tick to pixels.
#include "VolumeRenderingLink.h"
#include "WindowTest.h"

#include "vtkVolumeCollection.h"

#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QListWidget>
#include <QTimer>

#include <random>

namespace palpate::volume_rendering_test
{
namespace
{
// The phantom's volume, a sphere of 16 mm around the origin, without its structures.
class VolumeRenderingTest : public test::WindowTest
{
protected:
  void SetUp() override
  {
    test::WindowTest::SetUp();
    this->OpenPhantom();
    StudyState next = this->Study->State();
    for (SceneStructure& structure : next.Structures)
    {
      structure.IsVisible = structure.IsTouchable = false;
    }
    this->Study->Change("Hide all", next);
    this->Space()->Renderer()->GradientBackgroundOff();
    this->Space()->Renderer()->SetBackground(0.0, 0.0, 0.0);
    this->Draw();
  }
  QCheckBox* Tick() const { return this->Window->findChild<QCheckBox*>("volume-in-3d"); }
  QComboBox* Preset() const { return this->Window->findChild<QComboBox*>("volume-preset-3d"); }
  SpacePane* Space() const { return this->Window->Views()->Space(); }
  int Shown() const { return this->Space()->Renderer()->GetVolumes()->GetNumberOfItems(); }
  void Draw() { DrawAll(*this->Window->Views()); }
  QImage Picture() { return this->Space()->Canvas()->grab().toImage(); }
  // Brightness of the 3-D view at a point of the world, from 0 to 255.
  int At(const Vector3& world)
  {
    const QImage picture = this->Picture();
    const QPointF place = this->PlaceOf(world) * picture.devicePixelRatio();
    return qGray(picture.pixel(place.toPoint()));
  }
  void SwitchByMouse()
  {
    Click(this->Tick(), QPointF(6.0, 0.5 * this->Tick()->height()));
    const auto* link = this->Window->findChild<VolumeRenderingLink*>();
    WaitUntil([&] { return !this->Study->IsBusy() && !link->IsBusy(); });
    this->Draw();
  }
  static void Press(QWidget* widget, int key)
  {
    QKeyEvent down(QEvent::KeyPress, key, Qt::NoModifier);
    QCoreApplication::sendEvent(widget, &down);
  }
};

TEST_F(VolumeRenderingTest, IsOffAtFirstAndTakesNothing)
{
  EXPECT_TRUE(this->Tick()->isEnabled());
  EXPECT_FALSE(this->Tick()->isChecked());
  EXPECT_FALSE(this->Preset()->isEnabled());
  EXPECT_EQ(this->Shown(), 0);
  EXPECT_FALSE(this->Window->findChild<VolumeRenderingLink*>()->IsBusy());
}

TEST_F(VolumeRenderingTest, TickDrawsTheVolumeAndUndoGivesTheFormerPicture)
{
  const int background = this->At(Vector3::Zero());
  this->SwitchByMouse();
  EXPECT_TRUE(this->Tick()->isChecked());
  ASSERT_EQ(this->Shown(), 1) << this->Messages();
  EXPECT_GT(this->At(Vector3::Zero()), background + 60);
  EXPECT_GT(this->At(Vector3(0.0, 0.0, 10.0)), background + 40);
  EXPECT_LT(std::abs(this->At(Vector3(24.0, 16.0, 0.0)) - background), 10);
  this->Space()->ShowAll();
  this->Draw();
  const QImage on = this->Picture();
  this->Study->Undo();
  this->Draw();
  EXPECT_EQ(this->Shown(), 0);
  EXPECT_FALSE(this->Tick()->isChecked());
  EXPECT_LT(this->At(Vector3::Zero()), background + 10);
  this->Study->Redo();
  WaitUntil([this] { return this->Shown() == 1; });
  this->Draw();
  EXPECT_EQ(this->Picture(), on);
}

TEST_F(VolumeRenderingTest, OffGivesTheFormerPicture)
{
  this->Space()->ShowAll();
  this->SwitchByMouse();
  this->Study->Undo();
  this->Space()->ShowAll();
  this->Draw();
  const QImage before = this->Picture();
  this->SwitchByMouse();
  EXPECT_NE(this->Picture(), before);
  this->SwitchByMouse();
  this->Space()->ShowAll();
  this->Draw();
  EXPECT_EQ(this->Picture(), before);
}

TEST_F(VolumeRenderingTest, SurfaceInFrontHidesIt)
{
  this->SwitchByMouse();
  const Vector3 front(-15.0, 0.0, 0.0); // of the sphere of label 1, which reaches out of it
  const QRgb bare = this->Picture().pixel(this->PlaceOf(front).toPoint());
  StudyState next = this->Study->State();
  next.Structures.front().IsVisible = true;
  next.Structures.front().Color = {{0.0, 0.1, 1.0}};
  this->Study->Change("Show", next);
  this->Settle();
  this->Space()->LookFrom(vtkSpaceView::RIGHT);
  this->Draw();
  const QRgb covered = this->Picture().pixel(this->PlaceOf(front).toPoint());
  EXPECT_LE(qBlue(bare), qRed(bare) + 20);
  EXPECT_GT(qBlue(covered), qRed(covered) + 60);
  this->Space()->LookFrom(vtkSpaceView::LEFT);
  this->Draw();
  const QRgb behind = this->Picture().pixel(this->PlaceOf(Vector3(-15.0, 0.0, 0.0)).toPoint());
  EXPECT_GT(qRed(behind), qBlue(behind) - 20) << "the volume hides it from the other side";
}

TEST_F(VolumeRenderingTest, KeysChooseAPresetAsAnUndoStep)
{
  this->SwitchByMouse();
  const QImage bone = this->Picture();
  Press(this->Preset(), Qt::Key_End);
  EXPECT_EQ(this->Study->State().Rendering.Preset, VolumePreset::MaximumIntensity);
  this->Draw();
  EXPECT_NE(this->Picture(), bone);
  this->Study->Undo();
  EXPECT_EQ(this->Preset()->currentIndex(), 0);
  this->Draw();
  EXPECT_EQ(this->Picture(), bone);
}

TEST_F(VolumeRenderingTest, OpacityFollowsWindowAndLevel)
{
  const int background = this->At(Vector3::Zero());
  this->SwitchByMouse();
  EXPECT_GT(this->At(Vector3::Zero()), background + 60);
  this->Window->Contents().Images()->SetWindowLevel(700.0, 1500.0);
  this->Draw();
  EXPECT_LT(this->At(Vector3::Zero()), background + 10);
}

TEST_F(VolumeRenderingTest, SessionKeepsIt)
{
  this->SwitchByMouse();
  Press(this->Preset(), Qt::Key_Down);
  const auto session = this->Phantom.Folder / "case.palpate.json";
  ASSERT_TRUE(this->Study->Save(session)) << this->Messages();
  this->Study->New();
  WaitUntil([this] { return this->Shown() == 0; });
  EXPECT_FALSE(this->Tick()->isChecked());
  this->Study->OpenSession(session);
  WaitUntil([this] { return this->Shown() == 1; });
  EXPECT_TRUE(this->Tick()->isChecked());
  EXPECT_EQ(this->Preset()->currentText(), "CT: soft tissue");
}

TEST_F(VolumeRenderingTest, FurtherVolumesHaveTheirOwnUnlessHidden)
{
  const auto file = this->Phantom.Folder / "second.nii.gz";
  test::LabelGrid grid;
  grid.Size = {{40, 40, 40}};
  std::mt19937_64 random(5);
  grid.Direction = test::RandomRotation(random);
  grid.Origin = {{60.0, 0.0, 0.0}};
  WriteImage(file, test::MakeLabelImage<short>(
                       grid, [](double, double, double) { return true; }, 100));
  this->Study->AddVolume(file);
  auto* list = this->Window->findChild<QListWidget*>("volumes");
  WaitUntil([this] { return this->Window->Contents().Images()->GetNumberOfOverlays() == 1; });
  list->setCurrentRow(1);
  this->SwitchByMouse();
  EXPECT_EQ(this->Shown(), 1);
  EXPECT_TRUE(this->Study->State().Volumes[0].Rendering.IsShown);
  EXPECT_FALSE(this->Study->State().Rendering.IsShown);
  list->setCurrentRow(0);
  EXPECT_FALSE(this->Tick()->isChecked());
  list->item(1)->setCheckState(Qt::Unchecked);
  EXPECT_EQ(this->Shown(), 0);
  list->setCurrentRow(1);
  EXPECT_FALSE(this->Tick()->isEnabled());
}

// A head of 8 million voxels: a probe measures how late events are while it is prepared and drawn.
TEST_F(VolumeRenderingTest, PreparingAndDrawingBlockNoEventForLong)
{
  const auto file = this->Phantom.Folder / "head.nii.gz";
  test::LabelGrid grid;
  grid.Size = {{200, 200, 200}};
  grid.CenterOnOrigin();
  WriteImage(file, test::MakeLabelImage<short>(
                       grid,
                       [](double x, double y, double z)
                       { return std::fmod(std::hypot(x, y, z), 12.0) < 9.0; },
                       900));
  this->Study->OpenVolume(file);
  this->Settle();
  this->Draw();
  QElapsedTimer clock;
  std::vector<qint64> lags;
  QTimer probe;
  QObject::connect(&probe, &QTimer::timeout,
                   [&]
                   {
                     lags.push_back(clock.elapsed());
                     clock.restart();
                   });
  clock.start();
  probe.start(1);
  this->SwitchByMouse();
  ASSERT_EQ(this->Shown(), 1);
  const qint64 longest = *std::max_element(lags.begin(), lags.end());
  RecordProperty("longest_ms", static_cast<int>(longest));
  // Some 100 ms; other programs may take the processors.
  EXPECT_LT(longest, 500);
}
} // namespace
} // namespace palpate::volume_rendering_test
