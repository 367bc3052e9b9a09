#include "LabelImages.h"
#include "ViewGrid.h"
#include "WidgetTest.h"
#include "WindowLook.h"

#include "vtkCamera.h"
#include "vtkGenericOpenGLRenderWindow.h"

#include <QImage>

#include <cmath>
#include <set>

namespace palpate::view_grid_test
{
namespace
{
// A sphere of 12 mm in a volume of 60 x 50 x 40 mm around the origin.
vtkSmartPointer<vtkImageData> SphereImage()
{
  test::LabelGrid grid;
  grid.Size = {{60, 50, 40}};
  grid.CenterOnOrigin();
  return test::MakeLabelImage<short>(
      grid, [](double x, double y, double z) { return std::hypot(x, y, z) < 12.0; }, 700);
}

class ViewGridTest : public test::WidgetTest
{
protected:
  void SetUp() override
  {
    WidgetTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    this->Contents.Images()->SetImage(SphereImage());
    this->Contents.Crosshair()->SetPositionWorld(0.0, 0.0, 0.0);
    this->Views = std::make_unique<ViewGrid>(this->Contents);
    this->Views->resize(640, 480);
    this->Views->show();
    DrawAll(*this->Views);
  }
  QWidget* CanvasOf(SliceOrientation orientation) const
  {
    return this->Views->Slice(orientation)->Canvas();
  }
  std::array<int, 4> Counts() const
  {
    std::array<int, 4> counts{};
    for (std::size_t p = 0; p < counts.size(); ++p)
    {
      counts[p] = this->Views->Panes()[p]->RenderCount();
    }
    return counts;
  }
  std::set<ViewPane*> Visible() const
  {
    std::set<ViewPane*> visible;
    for (ViewPane* pane : this->Views->Panes())
    {
      if (pane->isVisible())
      {
        visible.insert(pane);
      }
    }
    return visible;
  }

  ViewContents Contents;
  std::unique_ptr<ViewGrid> Views;
};

TEST_F(ViewGridTest, ShowsVolumeInEverySlice)
{
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    const QImage image = this->CanvasOf(orientation)->grab().toImage();
    // Off the crosshair's lines, within the sphere: 12 mm are at least 40 pixels.
    const QColor middle = image.pixelColor(image.width() / 2 + 12, image.height() / 2 + 12);
    EXPECT_GT(middle.lightness(), 150) << NameOf(orientation);
  }
}

TEST_F(ViewGridTest, ClickMovesCrosshairOfAllViews)
{
  QWidget* axial = this->CanvasOf(SliceOrientation::Axial);
  const double pixel = this->Views->Slice(SliceOrientation::Axial)->View()->GetPixelMillimeters();
  const QPointF middle(0.5 * axial->width(), 0.5 * axial->height());
  Click(axial, middle + QPointF(20.0, 10.0));
  // Radiological convention, from the feet: right on the screen is the patient's left, down is
  // posterior. Points are pixel centres; the view's centre lies between two.
  const double* place = this->Contents.Crosshair()->GetPositionWorld();
  EXPECT_NEAR(place[0], 20.0 * pixel, 1.5 * pixel);
  EXPECT_NEAR(place[1], 10.0 * pixel, 1.5 * pixel);
  EXPECT_NEAR(place[2], 0.0, 0.5); // the slice's centre
}

TEST_F(ViewGridTest, DrawsEachViewOncePerTurn)
{
  const auto before = this->Counts();
  for (int step = 1; step <= 20; ++step)
  {
    this->Contents.Crosshair()->SetPositionWorld(0.1 * step, 0.0, 0.0);
  }
  EXPECT_EQ(this->Counts(), before);
  WaitUntil([&] { return this->Counts() != before; });
  QApplication::processEvents();
  for (std::size_t p = 0; p < before.size(); ++p)
  {
    EXPECT_EQ(this->Counts()[p], before[p] + 1);
  }
}

TEST_F(ViewGridTest, DrawsOnlyChangedView)
{
  const auto before = this->Counts();
  QWidget* axial = this->CanvasOf(SliceOrientation::Axial);
  Wheel(axial, {50.0, 50.0}, 1, Qt::ControlModifier); // its own zoom
  WaitUntil([&] { return this->Counts() != before; });
  QApplication::processEvents();
  const auto after = this->Counts();
  EXPECT_EQ(after[0], before[0] + 1);
  EXPECT_EQ(after[1], before[1]);
  EXPECT_EQ(after[2], before[2]);
  EXPECT_EQ(after[3], before[3]);
}

TEST_F(ViewGridTest, WheelAndSliderScroll)
{
  SlicePane* axial = this->Views->Slice(SliceOrientation::Axial);
  const int number = axial->View()->GetSliceNumber();
  Wheel(axial->Canvas(), {50.0, 50.0}, 1);
  EXPECT_EQ(axial->View()->GetSliceNumber(), number + 1);
  auto* slider = axial->findChild<QSlider*>("slice");
  slider->setValue(7);
  EXPECT_EQ(axial->View()->GetSliceNumber(), 7);
  DrawAll(*this->Views);
  EXPECT_EQ(slider->value(), 7);
  EXPECT_EQ(slider->maximum(), 40);
}

TEST_F(ViewGridTest, DoubleClickTogglesSingleView)
{
  SlicePane* coronal = this->Views->Slice(SliceOrientation::Coronal);
  DoubleClick(coronal->Canvas(), {30.0, 30.0});
  EXPECT_EQ(this->Visible(), std::set<ViewPane*>{coronal});
  DoubleClick(coronal->Canvas(), {30.0, 30.0});
  EXPECT_EQ(this->Visible().size(), 4U);
}

TEST_F(ViewGridTest, LayoutsShowTheirViews)
{
  this->Views->SetLayout(ViewLayout::Space);
  QApplication::processEvents();
  EXPECT_EQ(this->Visible().size(), 4U);
  EXPECT_GT(this->Views->Space()->width(),
            this->Views->Slice(SliceOrientation::Axial)->width() * 3 / 2);
  this->Views->SetLayout(ViewLayout::One);
  EXPECT_EQ(this->Visible().size(), 1U);
  this->Views->SetLayout(ViewLayout::Four);
  EXPECT_EQ(this->Visible().size(), 4U);
  EXPECT_EQ(LayoutOf("no layout"), ViewLayout::Four);
  for (const ViewLayout layout : AllViewLayouts)
  {
    EXPECT_EQ(LayoutOf(WordOf(layout)), layout);
  }
}

TEST_F(ViewGridTest, NoticeIsShownOnce)
{
  const auto banners = [this]
  {
    std::set<QString> shown;
    for (ViewPane* pane : this->Views->Panes())
    {
      const auto* banner = pane->findChild<ViewBanner*>();
      if (!banner->isHidden() && pane->isVisible())
      {
        shown.insert(pane->Name());
        EXPECT_LT(5 * banner->height(), pane->height() + 5 * 30) << "short where it is small";
        EXPECT_TRUE(banner->text().startsWith("No force")) << banner->text().toStdString();
      }
    }
    return shown;
  };
  this->Views->resize(400, 250);
  this->Views->ShowNotice({TouchNotice::Kind::NoForce,
                           "No force. The device was switched off by the user, who may allow "
                           "force again by the button in the toolbar."});
  EXPECT_EQ(banners(), std::set<QString>{"3-D"});
  EXPECT_EQ(this->Views->Space()->findChild<ViewBanner*>()->text(), "No force");
  this->Views->resize(1600, 1200);
  QApplication::processEvents();
  EXPECT_TRUE(this->Views->Space()->findChild<ViewBanner*>()->text().endsWith("toolbar."));
  this->Views->ToggleMaximized(this->Views->Slice(SliceOrientation::Coronal));
  EXPECT_EQ(banners(), std::set<QString>{"Coronal"});
  this->Views->ShowNotice({});
  EXPECT_TRUE(banners().empty());
}

TEST_F(ViewGridTest, SlicesInSpaceNeverSurroundTheCamera)
{
  SpacePane* space = this->Views->Space();
  vtkCamera* camera = space->Renderer()->GetActiveCamera();
  camera->SetPosition(2.0, -5.0, 3.0); // within the volume
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  space->ShowSlices(true);
  EXPECT_GT(Vector3(camera->GetPosition()).norm(), 40.0);
  const Vector3 outside(camera->GetPosition());
  space->ShowSlices(false);
  space->ShowSlices(true);
  EXPECT_EQ(Vector3(camera->GetPosition()), outside) << "it stays where it sees them";
}

TEST_F(ViewGridTest, EffectsReturnWithinAMomentOfRest)
{
  SpacePane* space = this->Views->Space();
  space->SmoothEdges(true);
  EXPECT_TRUE(space->View()->GetMoving());
  const int before = space->RenderCount();
  WaitUntil([&] { return space->RenderCount() == before + 1; });
  EXPECT_TRUE(space->View()->GetMoving());
  WaitUntil([&] { return space->RenderCount() == before + 2; });
  EXPECT_FALSE(space->View()->GetMoving());
  EXPECT_LE(SpacePane::RestTime, 300);
  space->WaitForRest(false);
  space->RequestRender();
  EXPECT_FALSE(space->View()->GetMoving());
}

TEST_F(ViewGridTest, GroundFollowsTheTheme)
{
  SpacePane* space = this->Views->Space();
  const auto grey = [space] { return space->Renderer()->GetBackground2()[0]; };
  for (const WindowLook look : {WindowLook::Dark, WindowLook::Light})
  {
    space->setPalette(PaletteOf(look));
    EXPECT_EQ(grey() < 0.5, look == WindowLook::Dark);
  }
  space->SetGround(ViewGround::White);
  EXPECT_EQ(space->Renderer()->GetBackground()[0], 1.0);
  EXPECT_FALSE(space->Renderer()->GetGradientBackground());
}

TEST_F(ViewGridTest, DoesNotDrawHiddenViews)
{
  this->Views->SetLayout(ViewLayout::One);
  QApplication::processEvents();
  const auto before = this->Counts();
  this->Contents.Crosshair()->SetPositionWorld(3.0, 0.0, 0.0);
  WaitUntil([&] { return this->Counts() != before; });
  QApplication::processEvents();
  EXPECT_EQ(this->Counts()[0], before[0]);
  EXPECT_EQ(this->Counts()[3], before[3] + 1);
}
} // namespace
} // namespace palpate::view_grid_test
