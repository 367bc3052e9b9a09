#include "BrushLink.h"
#include "CorrectionTest.h"
#include "LabelImages.h"
#include "MaskEdits.h"
#include "SegmentationFile.h"

#include "vtkCamera.h"
#include "vtkPointData.h"

#include <QMenu>

namespace palpate::brush_link_test
{
namespace
{
class BrushLinkTest : public test::CorrectionTest
{
protected:
  void OpenBrush(const QSize& size = QSize(1280, 800))
  {
    this->Open(size);
    const Vector3 inSlice = this->Center + Vector3(0.0, 0.0, 0.5);
    this->Window->Contents().Crosshair()->SetPositionWorld(inSlice.data());
    DrawAll(*this->Window->Views());
    QTest::keyClick(this->Axial()->Canvas(), Qt::Key_B);
    this->Width()->setValue(2.0);
  }
  QDoubleSpinBox* Width() const
  {
    return this->Window->findChild<QDoubleSpinBox*>("correct-width");
  }
  void Stroke(const Vector3& from, const Vector3& to,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier, bool isReleased = true)
  {
    this->Lead(this->Axial(), PlaceIn(*this->Axial(), from), PlaceIn(*this->Axial(), to), modifiers,
               isReleased);
  }
  static void Lead(ViewPane* pane, const QPointF& from, const QPointF& to,
                   Qt::KeyboardModifiers modifiers, bool isReleased = true)
  {
    Move(pane->Canvas(), from, modifiers);
    SendMouse(pane->Canvas(), QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton,
              modifiers);
    for (int n = 1; n <= 5; ++n)
    {
      SendMouse(pane->Canvas(), QEvent::MouseMove, from + (to - from) * n / 5, Qt::NoButton,
                Qt::LeftButton, modifiers);
    }
    if (isReleased)
    {
      SendMouse(pane->Canvas(), QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton,
                modifiers);
    }
  }
  const BrushStroke& LastStroke() const { return std::get<BrushStroke>(this->Steps().back()); }
  vtkSurfaceDisplay* Painted() const { return this->Window->Contents().Correction().Stroke(); }
  // Of the mask as it is now.
  bool Has(const Vector3& place)
  {
    CorrectedMask mask = *this->Shape().Voxels();
    const IndexToWorld& grid = mask.Grid();
    const Vector3 index = grid.Axes.inverse() * (place - grid.Origin);
    return HasVoxel(mask.Mask(), {static_cast<int>(std::lround(index.x())),
                                  static_cast<int>(std::lround(index.y())),
                                  static_cast<int>(std::lround(index.z()))});
  }
  long long Count()
  {
    CorrectedMask mask = *this->Shape().Voxels();
    return mask.Mask().Count();
  }

  // Outside of the sphere, in the volume's ball; and beyond that.
  const Vector3 Beside{-5.5, 10.5, 0.5};
  const Vector3 Far{-13.5, 15.5, 0.5};
};

TEST_F(BrushLinkTest, StrokeInASlicePaintsAtOnceAtUsualSizes)
{
  for (const QSize& size : test::PullSizes)
  {
    this->OpenBrush(size);
    ASSERT_EQ(this->Window->size(), size);
    ASSERT_FALSE(this->Has(this->Beside));
    this->Stroke(this->Beside, this->Beside + Vector3(6, 0, 0), Qt::NoModifier, false);
    ASSERT_TRUE(this->Painted()->GetVisibility()) << "before the button is released";
    const double* bounds = this->Painted()->GetSurface()->GetBounds();
    EXPECT_NEAR(bounds[1] - bounds[0], 10.0, 1.5);
    EXPECT_NEAR(bounds[3] - bounds[2], 4.0, 1.5);
    EXPECT_NEAR(bounds[5] - bounds[4], 1.0, 1e-6) << "one slice";
    EXPECT_TRUE(this->HasRing());
    EXPECT_TRUE(this->Steps().empty());
    this->Show(QString("brush-%1").arg(size.width()));
    SendMouse(this->Axial()->Canvas(), QEvent::MouseButtonRelease, QPointF(80, 80), Qt::LeftButton,
              Qt::NoButton);
    ASSERT_EQ(this->Steps().size(), 1U) << "one drag, one step";
    EXPECT_EQ(this->LastStroke().Radius, 2.0);
    EXPECT_TRUE(this->LastStroke().SliceNormal);
    EXPECT_NE(static_cast<bool>(this->Painted()->GetVisibility()), this->Shape().IsReady())
        << "until the mask has it";
    this->WaitForSurface();
    EXPECT_FALSE(this->Painted()->GetVisibility());
    EXPECT_TRUE(this->Has(this->Beside));
    EXPECT_TRUE(this->Has(this->Beside + Vector3(6, 0, 0)));
    EXPECT_FALSE(this->Has(this->Beside + Vector3(0, 0, 1)));
    EXPECT_TRUE(this->Line().startsWith("1 step: +0.0")) << this->Line().toStdString();
    this->Study->New();
    QTest::keyClick(this->Window.get(), Qt::Key_Escape);
    QTest::keyClick(this->Window.get(), Qt::Key_B); // and pulls again
    QTest::keyClick(this->Window.get(), Qt::Key_Escape);
  }
}

TEST_F(BrushLinkTest, HandWithABrushToEdgesFeelsThemUntilItPulls)
{
  this->OpenBrush();
  const auto areFelt = [this]
  {
    const auto all = this->Study->Current().Contacts();
    return all.front().Effects != nullptr &&
           all.front().Effects->Made.count("guiding gradient") > 0;
  };
  auto* edges = this->Window->findChild<QCheckBox*>("correct-edges");
  const auto click = [edges]
  { QTest::mouseClick(edges, Qt::LeftButton, Qt::NoModifier, QPoint(8, edges->height() / 2)); };
  click();
  ASSERT_TRUE(edges->isChecked());
  EXPECT_FALSE(areFelt()) << "nobody touches";
  this->BeginTouch();
  WaitUntil(areFelt);
  this->TouchTheTop();
  EXPECT_EQ(this->Study->Reading().Newest.Safety.Fault, SafetyFault::None);
  QTest::keyClick(this->Axial()->Canvas(), Qt::Key_B);
  EXPECT_FALSE(areFelt()) << "a pull keeps to no edges";
  QTest::keyClick(this->Axial()->Canvas(), Qt::Key_B);
  WaitUntil(areFelt);
  click();
  EXPECT_FALSE(areFelt());
}

TEST_F(BrushLinkTest, ControlErasesAndEachStrokeIsUndone)
{
  this->OpenBrush();
  const long long before = this->Count();
  this->Stroke(this->Beside, this->Beside);
  const long long painted = 13; // a disc of 2 mm around a voxel, about
  this->Stroke(this->Center, this->Center + Vector3(3, 0, 0), Qt::ControlModifier);
  this->WaitForSurface();
  ASSERT_EQ(this->Steps().size(), 2U) << "the second began before the mask had the first";
  EXPECT_TRUE(this->LastStroke().Erases);
  EXPECT_TRUE(this->Has(this->Beside));
  EXPECT_FALSE(this->Has(this->Center + Vector3(0.5, 0.5, 0.5)));
  EXPECT_LT(this->Count(), before + painted);
  QTest::keyClick(this->Window.get(), Qt::Key_Z, Qt::ControlModifier);
  this->WaitForSurface();
  EXPECT_NEAR(static_cast<double>(this->Count() - before), static_cast<double>(painted), 3.0);
  QTest::keyClick(this->Window.get(), Qt::Key_Z, Qt::ControlModifier);
  this->WaitForSurface();
  EXPECT_EQ(this->Count(), before);
  EXPECT_TRUE(this->Steps().empty());
}

TEST_F(BrushLinkTest, WheelSetsTheRadiusAndWithShiftTheSlice)
{
  this->OpenBrush();
  QWidget* canvas = this->Axial()->Canvas();
  const QPointF place = PlaceIn(*this->Axial(), this->Center);
  Move(canvas, place);
  const int slice = this->Axial()->View()->GetSliceNumber();
  Wheel(canvas, place, 2);
  EXPECT_NEAR(this->Width()->value(), 2.0 * 1.21, 0.06);
  EXPECT_EQ(this->Axial()->View()->GetSliceNumber(), slice);
  const auto& ring = this->Window->Contents().Landmarks()->GetCurves().back();
  EXPECT_NEAR((Vector3(ring.Points.front().data()) - this->Axial()->PointAt(place.x(), 0)).x(),
              2.0 * 1.21, 0.5);
  Wheel(canvas, place, 1, Qt::ShiftModifier);
  DrawAll(*this->Window->Views());
  EXPECT_NE(this->Axial()->View()->GetSliceNumber(), slice);
  EXPECT_NEAR(this->Width()->value(), 2.0 * 1.21, 0.06);
  QTest::keyClick(canvas, Qt::Key_B);
  EXPECT_NEAR(this->Width()->value(), 3.0, 1e-9) << "of a pull";
}

TEST_F(BrushLinkTest, BallAtTheSurfaceInSpace)
{
  this->OpenBrush();
  const Matrix3 axes = this->Space()->Axes();
  const Vector3 front = this->Center + 9.0 * axes.col(2);
  Lead(this->Space(), this->PlaceOf(front), this->PlaceOf(front + 2.0 * axes.col(0)),
       Qt::NoModifier, false);
  EXPECT_TRUE(this->Painted()->GetVisibility());
  SendMouse(this->Space()->Canvas(), QEvent::MouseButtonRelease, QPointF(9, 9), Qt::LeftButton,
            Qt::NoButton);
  ASSERT_EQ(this->Steps().size(), 1U);
  EXPECT_FALSE(this->LastStroke().SliceNormal);
  const Vector3 from = this->LastStroke().PointsWorld->front();
  EXPECT_NEAR((from - this->Center).norm(), 9.0, 1.0) << "at the surface";
  this->WaitForSurface();
  EXPECT_TRUE(this->Has(from + 1.5 * axes.col(2)));
  Lead(this->Space(), this->PlaceOf(this->Center), this->PlaceOf(this->Center),
       Qt::ControlModifier);
  ASSERT_EQ(this->Steps().size(), 2U);
  EXPECT_TRUE(this->LastStroke().Erases);
  this->WaitForSurface();
  EXPECT_FALSE(this->Has(this->LastStroke().PointsWorld->front() - 0.5 * axes.col(2)));
  const Vector3 camera(this->Space()->Renderer()->GetActiveCamera()->GetPosition());
  Lead(this->Space(), QPointF(5, 5), QPointF(60, 40), Qt::NoModifier);
  EXPECT_EQ(this->Steps().size(), 2U);
  EXPECT_GT((Vector3(this->Space()->Renderer()->GetActiveCamera()->GetPosition()) - camera).norm(),
            1.0);
}

TEST_F(BrushLinkTest, KeepsToEdgesOfTheVolume)
{
  this->OpenBrush();
  auto* edges = this->Window->findChild<QCheckBox*>("correct-edges");
  ASSERT_TRUE(edges->isVisible());
  QTest::mouseClick(edges, Qt::LeftButton, Qt::NoModifier, QPoint(8, edges->height() / 2));
  ASSERT_TRUE(edges->isChecked());
  this->Stroke(this->Beside, this->Far);
  this->WaitForSurface();
  ASSERT_EQ(this->Steps().size(), 1U);
  const auto& edit = std::get<VoxelEdit>(this->Steps().back());
  EXPECT_GT(edit.Runs->size(), 3U);
  const IndexToWorld& grid = this->Shape().Voxels()->Grid();
  for (const IndexRun& run : *edit.Runs)
  {
    for (int n = 0; n < run.Count; ++n)
    {
      EXPECT_LT(grid(Vector3(run.First[0] + n, run.First[1], run.First[2])).norm(), 16.0);
    }
  }
  EXPECT_TRUE(this->Has(this->Beside));
  EXPECT_FALSE(this->Has(this->Far));
  edges->setChecked(false);
  this->Stroke(this->Beside, this->Far);
  this->WaitForSurface();
  EXPECT_TRUE(this->Has(this->Far));
  this->ExpectSameStudyAfterReopening();
}

TEST_F(BrushLinkTest, SlicesAreCopiedAndFilledBetween)
{
  this->OpenBrush();
  const Vector3 high(-5.5, 10.5, 0.5);
  this->Window->Contents().Crosshair()->SetPositionWorld(high.data());
  DrawAll(*this->Window->Views());
  this->Stroke(this->Beside, this->Beside);
  QTest::keyClick(this->Axial()->Canvas(), Qt::Key_Up, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_EQ(this->Steps().size(), 2U);
  const SliceCopy copy = std::get<SliceCopy>(this->Steps().back());
  EXPECT_EQ(copy.Axis, 2);
  this->WaitForSurface();
  EXPECT_TRUE(this->Has(this->Beside + Vector3(0, 0, 1))) << "towards the head";
  EXPECT_NEAR(this->Window->Contents().Crosshair()->GetPositionWorld()[2], 1.5, 1e-6);
  QTest::keyClick(this->Axial()->Canvas(), Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_NE(this->Messages().find("nothing to fill"), std::string::npos) << this->Messages();
  const Vector3 low(-5.5, 10.5, -3.5);
  this->Window->Contents().Crosshair()->SetPositionWorld(low.data());
  DrawAll(*this->Window->Views());
  const Vector3 beside = this->Beside - Vector3(0, 0, 4);
  this->Stroke(beside, beside);
  QTest::keyClick(this->Axial()->Canvas(), Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
  this->WaitForSurface();
  ASSERT_TRUE(std::holds_alternative<SliceFilling>(this->Steps().back()));
  EXPECT_EQ(std::get<SliceFilling>(this->Steps().back()).Last, copy.To);
  EXPECT_TRUE(this->Has(this->Beside - Vector3(0, 0, 2)));
  QAction* previous = this->Button("correct-slices")->menu()->actions().at(1);
  previous->trigger();
  EXPECT_EQ(std::get<SliceCopy>(this->Steps().back()).To, copy.From - 5);
}

TEST_F(BrushLinkTest, NeighbourStopsAStrokeUnlessItIsChosen)
{
  this->OpenBrush();
  const Vector3 other(14.0 + 0.5, 9.5, 0.5); // of the bow
  this->Stroke(this->Beside, other);
  this->WaitForSurface();
  EXPECT_FALSE(this->Has(other));
  EXPECT_TRUE(this->Has(this->Beside));
  auto* neighbors = this->Window->findChild<QComboBox*>("correct-neighbors");
  neighbors->setFocus();
  QTest::keyClick(neighbors, Qt::Key_End);
  this->WaitForSurface();
  EXPECT_TRUE(this->Has(other));
}

TEST_F(BrushLinkTest, EscapeGivesAStrokeUp)
{
  this->OpenBrush();
  this->Stroke(this->Beside, this->Far, Qt::NoModifier, false);
  QTest::keyClick(this->Window.get(), Qt::Key_Escape);
  EXPECT_FALSE(this->Painted()->GetVisibility());
  EXPECT_FALSE(this->HasRing());
  SendMouse(this->Axial()->Canvas(), QEvent::MouseButtonRelease, QPointF(80, 80), Qt::LeftButton,
            Qt::NoButton);
  EXPECT_TRUE(this->Steps().empty());
  this->Stroke(this->Beside, this->Far);
  EXPECT_TRUE(this->Steps().empty()) << "drags are the crosshair's again";
}

TEST_F(BrushLinkTest, KeptMaskHasTheStrokes)
{
  this->OpenBrush();
  this->Stroke(this->Beside, this->Far);
  this->WaitForSurface();
  const long long count = this->Count();
  this->Chosen = QString::fromStdString((this->Phantom.Folder / "kept" / "Painted").string());
  const std::size_t before = this->Study->State().Structures.size();
  QTest::mouseClick(this->Button("correct-keep"), Qt::LeftButton);
  WaitUntil([&] { return this->Study->State().Structures.size() > before; });
  this->Settle();
  const Segmentation kept = ReadSegmentation(this->Study->State().Structures.back().File);
  long long voxels = 0;
  for (vtkIdType n = 0; n < kept.Layers[0]->GetNumberOfPoints(); ++n)
  {
    voxels += kept.Layers[0]->GetPointData()->GetScalars()->GetTuple1(n) == 1.0 ? 1 : 0;
  }
  EXPECT_EQ(voxels, count);
}

TEST_F(BrushLinkTest, HandPaintsWhereItTouches)
{
  this->OpenBrush();
  this->Action("Grip where touched")->trigger();
  EXPECT_NE(this->Messages().find("touch the structure to paint"), std::string::npos)
      << this->Messages();
  this->BeginTouch();
  this->TouchTheTop();
  this->Action("Grip where touched")->trigger();
  EXPECT_TRUE(this->Painted()->GetVisibility());
  EXPECT_TRUE(this->Steps().empty()) << "it is still led";
  EXPECT_EQ(this->Study->Reading().TouchedId, 1) << "what is painted at is felt";
  this->Action("Grip where touched")->trigger();
  ASSERT_EQ(this->Steps().size(), 1U);
  EXPECT_FALSE(this->LastStroke().SliceNormal);
  EXPECT_NEAR((this->LastStroke().PointsWorld->front() - this->Center).norm(), 9.0, 0.8);
  this->WaitForSurface();
  EXPECT_GT(this->Shape().Change()->AddedVoxels, 5);
}
} // namespace
} // namespace palpate::brush_link_test
