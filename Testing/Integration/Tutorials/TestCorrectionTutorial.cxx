#include "SegmentationFile.h"
#include "TrueMask.h"
#include "TutorialWindow.h"

#include <QCheckBox>
#include <QLabel>

namespace palpate::correction_tutorial_test
{
namespace
{
// Documentation/Tutorial/CorrectAMask.md.
class CorrectionTutorial : public test::TutorialWindow
{
protected:
  StudyCorrected& Shape() { return this->Study->Current().Corrected(); }
  void WaitForSurface()
  {
    WaitUntil([this] { return this->Shape().IsReady() && !this->Shape().IsWorking(); });
    DrawAll(*this->Window->Views());
  }
  void OpenMask()
  {
    this->DropFiles({"patient/volume.nii.gz", "wrong/mask.nii.gz"});
    WaitUntil([this] { return !this->Study->State().Structures.empty(); });
    this->Settle();
    this->Action("Push and pull")->trigger();
    this->WaitForSurface();
    EXPECT_EQ(this->Messages(), "");
  }
  // In the axial slice through both: from the mask's edge to where the organ's is.
  void Drag(const Vector3& from, const Vector3& to, bool isReleased)
  {
    this->Window->Contents().Crosshair()->SetPositionWorld(from.data());
    DrawAll(*this->Window->Views());
    const SlicePane* axial = this->Window->Views()->Slice(SliceOrientation::Axial);
    QWidget* canvas = axial->Canvas();
    const QPointF begin = PlaceIn(*axial, from);
    const QPointF end = PlaceIn(*axial, to);
    SendMouse(canvas, QEvent::MouseMove, begin, Qt::NoButton, Qt::NoButton);
    SendMouse(canvas, QEvent::MouseButtonPress, begin, Qt::LeftButton, Qt::LeftButton);
    SendMouse(canvas, QEvent::MouseMove, end, Qt::NoButton, Qt::LeftButton);
    if (!isReleased)
    {
      return;
    }
    SendMouse(canvas, QEvent::MouseButtonRelease, end, Qt::LeftButton, Qt::NoButton);
    this->WaitForSurface();
  }
  // In another slice, from the inside beyond where the edge is.
  void PaintToTheEdge()
  {
    this->Action("Paint or pull")->trigger();
    this->Window->findChild<QCheckBox*>("correct-edges")->setChecked(true);
    const Vector3 middle = this->Middle + Vector3(0, 0, 9);
    const Vector3 edge = this->Seen.EdgeFrom(middle, middle - Vector3(40, 20, 0));
    const Vector3 out = (edge - middle).normalized();
    const Vector3 along(-out.y(), out.x(), 0.0);
    this->Drag(edge - 7.0 * out - 5.0 * along, edge - 2.0 * out + 8.0 * along, false);
    this->ExpectBaseline("tutorial-correct-brush.png");
    const SlicePane* axial = this->Window->Views()->Slice(SliceOrientation::Axial);
    SendMouse(axial->Canvas(), QEvent::MouseButtonRelease, PlaceIn(*axial, edge), Qt::LeftButton,
              Qt::NoButton);
    this->WaitForSurface();
    ASSERT_EQ(this->Study->State().Correction.Steps.size(), 3U);
    EXPECT_TRUE(std::holds_alternative<VoxelEdit>(this->Study->State().Correction.Steps.back()));
  }
  // Of the mask as it is, on the line from the middle.
  Vector3 SurfaceTowards(const Vector3& place)
  {
    const SurfaceCorrection& pulls = *this->Shape().Pulls();
    const Vector3 out = (place - this->Middle).normalized();
    Vector3 nearest = this->Middle;
    double least = 1e9;
    for (double r = 0.0; r < 60.0; r += 0.1)
    {
      const Vector3 at = this->Middle + r * out;
      const double distance = (pulls.PointNow(pulls.NearestNow(at)) - at).norm();
      nearest = distance < least ? at : nearest;
      least = std::min(least, distance);
    }
    return nearest;
  }

  const Vector3 Middle = Vector3(0.0, 0.0, -4.0);
  test::TrueMask Seen;
};

TEST_F(CorrectionTutorial, SixStepsLeadToTheTrueMask)
{
  ASSERT_NO_FATAL_FAILURE(this->Run({"phantom", "--seed", "9", "--output", "patient"}));
  ASSERT_NO_FATAL_FAILURE(
      this->Run({"correct", "patient/mask.nii.gz", "--label", "1", "--pull=23,0,-4:6:7",
                 "--pull=-24,0,-4:-5:7", "--output", "wrong"}));
  this->Seen.Truth = ReadSegmentation(this->File("patient/mask.nii.gz"));
  const Segmentation wrong = ReadSegmentation(this->File("wrong/mask.nii.gz"));
  EXPECT_LT(this->Seen.DiceOf(wrong.Layers[0]), 0.975);
  ASSERT_NO_FATAL_FAILURE(this->OpenMask());
  const Vector3 left = this->Middle + Vector3(40, 0, 0);
  const Vector3 right = this->Middle - Vector3(40, 0, 0);
  const Vector3 edge = this->Seen.EdgeFrom(this->Middle, left);
  this->Drag(this->SurfaceTowards(left), edge, false);
  this->ExpectBaseline("tutorial-correct-pull.png");
  const SlicePane* axial = this->Window->Views()->Slice(SliceOrientation::Axial);
  SendMouse(axial->Canvas(), QEvent::MouseButtonRelease, PlaceIn(*axial, edge), Qt::LeftButton,
            Qt::NoButton);
  this->WaitForSurface();
  this->Drag(this->SurfaceTowards(right), this->Seen.EdgeFrom(this->Middle, right), true);
  ASSERT_EQ(this->Study->State().Correction.Steps.size(), 2U);
  this->ExpectBaseline("tutorial-correct-change.png");
  ASSERT_NO_FATAL_FAILURE(this->PaintToTheEdge());
  this->Chosen = QString::fromStdString(this->File("gland").string());
  this->Button("correct-keep")->click();
  WaitUntil([this] { return this->Study->State().Structures.size() > 1; });
  const Segmentation kept = ReadSegmentation(this->File("gland/mask.nii.gz"));
  EXPECT_GT(this->Seen.DiceOf(kept.Layers[0]), 0.985) << "two pulls and a stroke";
}
} // namespace
} // namespace palpate::correction_tutorial_test
