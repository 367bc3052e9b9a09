#include "CorrectionTest.h"
#include "LabelImages.h"
#include "SegmentationFile.h"
#include "WholeFile.h"
#include "WindowLook.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <QMenu>
#include <QRegularExpression>

namespace palpate::correction_panel_test
{
namespace
{
using test::PullSizes;

class CorrectionPanelTest : public test::CorrectionTest
{
};

TEST_F(CorrectionPanelTest, DragInASlicePullsTheSurfaceAtUsualSizes)
{
  for (const QSize& size : PullSizes)
  {
    this->Open(size);
    ASSERT_EQ(this->Window->size(), size);
    EXPECT_LT(this->LargestRadius(), 10.0);
    this->DragInSlice(this->Top, this->Top + Vector3(0, 4, 0), false);
    EXPECT_NEAR(this->LargestRadius(), 13.0, 0.8) << "before the button is released";
    EXPECT_TRUE(this->Steps().empty());
    ASSERT_TRUE(this->HasRing());
    const auto& corner = this->Window->Contents().Landmarks()->GetCurves().back().Points.front();
    EXPECT_NEAR((Vector3(corner.data()) - this->Top - Vector3(0, 4, 0)).norm(), 3.0, 1.2)
        << "around it";
    this->DragInSlice(this->Top, this->Top + Vector3(0, 4, 0));
    ASSERT_EQ(this->Steps().size(), 1U) << "one drag, one step";
    const SurfacePull& pull = this->LastPull();
    ASSERT_TRUE(pull.TargetWorld);
    EXPECT_LT((*pull.TargetWorld - pull.PlaceWorld - Vector3(0, 4, 0)).norm(), 0.3) << "a pixel";
    EXPECT_NEAR(pull.Width, 3.0, 1e-9);
    this->WaitForSurface();
    EXPECT_TRUE(this->Line().startsWith("1 step: +0.")) << this->Line().toStdString();
    EXPECT_TRUE(this->Line().contains("at most 4.") || this->Line().contains("at most 3."))
        << this->Line().toStdString();
    this->Show(QString("correct-%1").arg(size.width()));
    this->Study->New();
    QTest::keyClick(this->Window.get(), Qt::Key_Escape);
  }
}

TEST_F(CorrectionPanelTest, EachPullIsUndoneAndRedone)
{
  this->Open();
  this->DragInSlice(this->Top, this->Top + Vector3(0, 3, 0));
  this->WaitForSurface();
  this->DragInSlice(this->Center - Vector3(9, 0, 0), this->Center - Vector3(6, 0, 0));
  this->WaitForSurface();
  ASSERT_EQ(this->Steps().size(), 2U);
  const double both = this->LargestRadius();
  for (int n = 0; n < 2; ++n)
  {
    QTest::keyClick(this->Window.get(), Qt::Key_Z, Qt::ControlModifier);
  }
  EXPECT_TRUE(this->Steps().empty());
  this->WaitForSurface();
  EXPECT_LT(this->LargestRadius(), 10.0);
  for (int n = 0; n < 2; ++n)
  {
    QTest::keyClick(this->Window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  }
  this->WaitForSurface();
  EXPECT_EQ(this->LargestRadius(), both);
  this->Button("correct-back")->click();
  EXPECT_EQ(this->Steps().size(), 1U);
}

TEST_F(CorrectionPanelTest, WheelOverTheSurfaceSetsTheWidthAndElsewhereTheSlice)
{
  this->Open();
  QWidget* canvas = this->Axial()->Canvas();
  const QPointF onSurface = PlaceIn(*this->Axial(), this->Top);
  Move(canvas, onSurface);
  EXPECT_TRUE(this->HasRing());
  const int slice = this->Axial()->View()->GetSliceNumber();
  test::WidgetTest::Wheel(canvas, onSurface, 2);
  EXPECT_NEAR(this->Width(), 3.0 * 1.21, 0.06);
  EXPECT_EQ(this->Axial()->View()->GetSliceNumber(), slice);
  const QPointF inside = PlaceIn(*this->Axial(), this->Center);
  Move(canvas, inside);
  EXPECT_FALSE(this->HasRing());
  test::WidgetTest::Wheel(canvas, inside, 2);
  EXPECT_NEAR(this->Width(), 3.0 * 1.21, 0.06);
  DrawAll(*this->Window->Views());
  EXPECT_NE(this->Axial()->View()->GetSliceNumber(), slice);
}

TEST_F(CorrectionPanelTest, RingEndsWithTheSurfaceUnderThePointer)
{
  this->Open();
  QWidget* canvas = this->Axial()->Canvas();
  const QPointF onSurface = PlaceIn(*this->Axial(), this->Top);
  Move(canvas, onSurface);
  ASSERT_TRUE(this->HasRing());
  QTest::keyClick(this->Window.get(), Qt::Key_Z, Qt::ControlModifier); // nothing is corrected now
  test::WidgetTest::Wheel(canvas, onSurface, 1);
  EXPECT_FALSE(this->HasRing());
}

TEST_F(CorrectionPanelTest, WheelDuringAPullWidensIt)
{
  this->Open();
  const Vector3 end = this->Top + Vector3(0, 4, 0);
  this->DragInSlice(this->Top, end, false);
  const auto moved = [this]
  {
    int count = 0;
    vtkDataArray* array =
        this->Shown()->GetSurface()->GetPointData()->GetArray(StudyCorrected::ChangeArray);
    for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n)
    {
      count += std::abs(array->GetTuple1(n)) > 0.5 ? 1 : 0;
    }
    return count;
  };
  const int narrow = moved();
  test::WidgetTest::Wheel(this->Axial()->Canvas(), PlaceIn(*this->Axial(), end), 5);
  EXPECT_GT(moved(), 1.5 * narrow);
  SendMouse(this->Axial()->Canvas(), QEvent::MouseButtonRelease, PlaceIn(*this->Axial(), end),
            Qt::LeftButton, Qt::NoButton);
  ASSERT_EQ(this->Steps().size(), 1U);
  EXPECT_NEAR(this->LastPull().Width, 3.0 * std::pow(1.1, 5), 0.05);
}

TEST_F(CorrectionPanelTest, ClickChangesNothingAndADragElsewhereIsTheCrosshairs)
{
  this->Open();
  this->DragInSlice(this->Top, this->Top);
  EXPECT_TRUE(this->Steps().empty());
  const Vector3 place = this->Center + Vector3(2, 1, 0);
  this->DragInSlice(this->Center, place);
  EXPECT_TRUE(this->Steps().empty());
  const Vector3 cross(this->Window->Contents().Crosshair()->GetPositionWorld());
  EXPECT_LT((cross - place).norm(), 0.5);
}

TEST_F(CorrectionPanelTest, DragInSpaceFollowsTheNormalAndElsewhereTurnsTheCamera)
{
  this->Open();
  // From the front: upwards in the view pulls what faces the viewer.
  const QPointF middle = this->PlaceOf(this->Center);
  Drag(this->Space(), middle, middle + QPointF(0, -25));
  ASSERT_EQ(this->Steps().size(), 1U);
  EXPECT_FALSE(this->LastPull().TargetWorld);
  EXPECT_GT(this->LastPull().Displacement, 1.0);
  this->WaitForSurface();
  Drag(this->Space(), middle, middle + QPointF(0, 25));
  ASSERT_EQ(this->Steps().size(), 2U);
  EXPECT_LT(this->LastPull().Displacement, -1.0);
  this->WaitForSurface();
  // At the silhouette the surface goes where the pointer does.
  const Matrix3 axes = this->Space()->Axes();
  const Vector3 side = this->Center + 8.6 * axes.col(0) + 1.5 * axes.col(2);
  const QPointF from = this->PlaceOf(side);
  const QPointF to = this->PlaceOf(side + 4.0 * axes.col(0));
  Drag(this->Space(), from, to);
  ASSERT_EQ(this->Steps().size(), 3U);
  EXPECT_NEAR(this->LastPull().Displacement, 4.0, 0.6);
  this->WaitForSurface();
  const Vector3 camera(this->Space()->Renderer()->GetActiveCamera()->GetPosition());
  Drag(this->Space(), QPointF(5, 5), QPointF(60, 40));
  EXPECT_EQ(this->Steps().size(), 3U);
  EXPECT_GT((Vector3(this->Space()->Renderer()->GetActiveCamera()->GetPosition()) - camera).norm(),
            1.0);
}

TEST_F(CorrectionPanelTest, EscapeGivesAPullUpAndEndsTheMode)
{
  this->Open();
  this->DragInSlice(this->Top, this->Top + Vector3(0, 4, 0), false);
  QTest::keyClick(this->Window.get(), Qt::Key_Escape);
  EXPECT_FALSE(this->Action("Push and pull")->isChecked());
  EXPECT_FALSE(this->Button("correct-mode")->isChecked());
  EXPECT_LT(this->LargestRadius(), 10.0);
  SendMouse(this->Axial()->Canvas(), QEvent::MouseButtonRelease, QPointF(80, 80), Qt::LeftButton,
            Qt::NoButton);
  EXPECT_TRUE(this->Steps().empty());
  this->DragInSlice(this->Top, this->Top + Vector3(0, 4, 0));
  EXPECT_TRUE(this->Steps().empty()) << "drags are the crosshair's again";
  EXPECT_FALSE(this->HasRing());
}

TEST_F(CorrectionPanelTest, ModesOfTheMouseExcludeEachOther)
{
  this->Open();
  this->Action("Draw by touch")->trigger();
  EXPECT_FALSE(this->Action("Push and pull")->isChecked());
  this->DragInSlice(this->Top, this->Top + Vector3(0, 4, 0));
  EXPECT_TRUE(this->Steps().empty());
  EXPECT_FALSE(this->Study->State().Drawing.Touches.empty());
  this->Action("Push and pull")->trigger();
  EXPECT_FALSE(this->Action("Draw by touch")->isChecked());
  const std::size_t touches = this->Study->State().Drawing.Touches.size();
  this->DragInSlice(this->Top, this->Top + Vector3(0, 4, 0));
  EXPECT_EQ(this->Steps().size(), 1U);
  EXPECT_EQ(this->Study->State().Drawing.Touches.size(), touches);
}

TEST_F(CorrectionPanelTest, KeptMaskIsAStructureAndTheSourceStays)
{
  this->Open();
  const std::string source = ReadWholeFile(this->MaskFile(), 1U << 20U);
  EXPECT_FALSE(this->Button("correct-keep")->isEnabled()) << "nothing is corrected";
  this->DragInSlice(this->Top, this->Top + Vector3(0, 4, 0));
  this->WaitForSurface();
  const long long added = this->Shape().Change()->AddedVoxels;
  this->Chosen = QString::fromStdString((this->Phantom.Folder / "kept" / "Better ball").string());
  const std::size_t before = this->Study->State().Structures.size();
  QTest::mouseClick(this->Button("correct-keep"), Qt::LeftButton);
  WaitUntil([&] { return this->Study->State().Structures.size() > before; });
  this->Settle();
  const SceneStructure& kept = this->Study->State().Structures.back();
  EXPECT_EQ(kept.Name, "Better ball");
  EXPECT_TRUE(this->Steps().empty());
  EXPECT_FALSE(this->Shown()->GetVisibility());
  EXPECT_EQ(this->Window->Contents().Surfaces().count(kept.Id), 1U);
  EXPECT_EQ(this->Window->Contents().Surfaces().count(1), 0U) << "its start is hidden";
  EXPECT_EQ(ReadWholeFile(this->MaskFile(), 1U << 20U), source);
  const Segmentation was = ReadSegmentation(this->MaskFile());
  const Segmentation is = ReadSegmentation(kept.File);
  long long changed = 0;
  for (vtkIdType n = 0; n < was.Layers[0]->GetNumberOfPoints(); ++n)
  {
    changed += was.Layers[0]->GetPointData()->GetScalars()->GetTuple1(n) !=
                       is.Layers[0]->GetPointData()->GetScalars()->GetTuple1(n)
                   ? 1
                   : 0;
  }
  EXPECT_EQ(changed, added);
  this->ExpectSameStudyAfterReopening();
}

TEST_F(CorrectionPanelTest, SessionKeepsTheSteps)
{
  this->Open();
  this->DragInSlice(this->Top, this->Top + Vector3(0, 4, 0));
  this->WaitForSurface();
  const double radius = this->LargestRadius();
  this->ExpectSameStudyAfterReopening();
  this->WaitForSurface();
  EXPECT_EQ(this->LargestRadius(), radius);
}

TEST_F(CorrectionPanelTest, NeighbourStopsAPullUnlessItIsChosen)
{
  this->Open();
  const Vector3 right = this->Center + Vector3(9, 0, 0);
  this->DragInSlice(right, right + Vector3(12, 0, 0)); // the other structure begins after 8
  this->WaitForSurface();
  const long long stopped = this->Shape().Change()->AddedVoxels;
  auto* neighbors = this->Window->findChild<QComboBox*>("correct-neighbors");
  neighbors->setFocus();
  QTest::keyClick(neighbors, Qt::Key_End);
  EXPECT_EQ(this->Study->State().Correction.Neighbors, NeighborPolicy::Overwrite);
  this->WaitForSurface();
  EXPECT_GT(this->Shape().Change()->AddedVoxels, stopped);
}

TEST_F(CorrectionPanelTest, ButtonsEditTheMask)
{
  this->Open();
  this->Button("correct-smooth")->click();
  this->WaitForSurface();
  EXPECT_TRUE(this->Line().startsWith("1 step")) << this->Line().toStdString();
  QAction* below = nullptr;
  for (QAction* action : this->Button("correct-cut")->menu()->actions())
  {
    below = action->text().startsWith("Below") ? action : below;
  }
  ASSERT_NE(below, nullptr);
  below->trigger();
  this->WaitForSurface();
  EXPECT_GT(this->Shown()->GetSurface()->GetBounds()[4], -1.5);
  this->Button("correct-fill")->click();
  this->Button("correct-islands")->click();
  this->WaitForSurface();
  EXPECT_EQ(this->Steps().size(), 4U);
  this->DragInSlice(this->Top, this->Top + Vector3(0, 4, 0));
  ASSERT_EQ(this->Steps().size(), 5U) << "what was edited can be pulled";
  this->Button("correct-discard")->click();
  EXPECT_EQ(this->Study->State().Correction.StructureId, 0);
  EXPECT_FALSE(this->Shown()->GetVisibility());
  this->Study->Undo();
  EXPECT_EQ(this->Steps().size(), 5U);
}

TEST_F(CorrectionPanelTest, SaysSoWhereNothingCanBeCorrected)
{
  Activate(*this->Window);
  this->Action("Push and pull")->trigger();
  QApplication::processEvents();
  EXPECT_FALSE(this->Action("Push and pull")->isChecked());
  EXPECT_NE(this->Messages().find("nothing to correct"), std::string::npos) << this->Messages();
}

TEST_F(CorrectionPanelTest, HandGripsWhereItTouchesAndLeadsTheSurface)
{
  this->Open();
  this->Action("Grip where touched")->trigger();
  EXPECT_NE(this->Messages().find("does not touch"), std::string::npos) << this->Messages();
  this->BeginTouch();
  this->TouchTheTop();
  this->Action("Grip where touched")->trigger();
  const Vector3 from(this->Study->Reading().Newest.ProbeWorld);
  const Vector3 out = (from - this->Center).normalized();
  this->FeelUntil(
      [&]
      {
        this->Study->Current().Touch().MoveHand(from + 5.0 * out);
        return (Vector3(this->Study->Reading().Newest.ProbeWorld) - from).dot(out) > 4.0;
      });
  WaitUntil([this] { return this->LargestRadius() > 12.5; });
  EXPECT_TRUE(this->Steps().empty()) << "it is still held";
  EXPECT_EQ(this->Study->Reading().TouchedId, 0) << "what is held does not push";
  this->Action("Grip where touched")->trigger();
  ASSERT_EQ(this->Steps().size(), 1U);
  const SurfacePull& pull = this->LastPull();
  ASSERT_TRUE(pull.TargetWorld);
  EXPECT_NEAR((pull.PlaceWorld - this->Center).norm(), 9.0, 0.7) << "on the surface";
  EXPECT_GT((*pull.TargetWorld - pull.PlaceWorld).dot(out), 3.9);
  EXPECT_EQ(this->Study->Reading().Newest.Safety.Fault, SafetyFault::None);
}

TEST_F(CorrectionPanelTest, EndOfTouchGivesUpWhatTheHandHolds)
{
  this->Open();
  this->BeginTouch();
  this->TouchTheTop();
  this->Action("Grip where touched")->trigger();
  this->Study->StopTouch();
  QApplication::processEvents();
  EXPECT_TRUE(this->Steps().empty());
  EXPECT_LT(this->LargestRadius(), 10.0);
  EXPECT_FALSE(this->Study->Current().Contacts().empty()) << "it is felt again";
}

TEST_F(CorrectionPanelTest, NothingIsClippedInLightAndDark)
{
  const auto expectUnclipped = [this]
  {
    auto* panel = this->Window->findChild<CorrectionPanel*>();
    for (auto* control : panel->findChildren<QWidget*>(QRegularExpression("^correct-")))
    {
      const QSize least = control->minimumSizeHint();
      EXPECT_TRUE(!control->isVisible() || control->width() >= least.width())
          << control->objectName().toStdString();
      EXPECT_TRUE(!control->isVisible() || control->height() >= least.height())
          << control->objectName().toStdString();
    }
  };
  for (const WindowLook look : {WindowLook::Light, WindowLook::Dark})
  {
    ChooseLook(look);
    for (const QSize& size : PullSizes)
    {
      this->Open(size);
      this->DragInSlice(this->Top, this->Top + Vector3(0, 4, 0));
      this->WaitForSurface();
      Move(this->Axial()->Canvas(), PlaceIn(*this->Axial(), this->Top + Vector3(0, 4, 0)));
      EXPECT_EQ(this->Window->size(), size) << "the window can be as small as that";
      expectUnclipped();
      this->Show(QString("correct-%1-%2")
                     .arg(look == WindowLook::Dark ? "dark" : "light")
                     .arg(size.width()));
      QTest::keyClick(this->Window.get(), Qt::Key_B); // the controls of the brush
      DrawAll(*this->Window->Views());
      expectUnclipped();
      QTest::keyClick(this->Window.get(), Qt::Key_B);
      this->Study->New();
      QTest::keyClick(this->Window.get(), Qt::Key_Escape);
    }
  }
  ChooseLook(WindowLook::System);
}
} // namespace
} // namespace palpate::correction_panel_test
