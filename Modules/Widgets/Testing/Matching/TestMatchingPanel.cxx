#include "MatchingPanel.h"
#include "TransformFile.h"
#include "TransformedImage.h"
#include "WindowTest.h"

#include <QComboBox>
#include <QLabel>
#include <QTest>

#include <array>
#include <cmath>
#include <cstdlib>

namespace palpate::matching_panel_test
{
namespace
{
using Phase = HeldOrgan::Phase;

// The last is 1600 x 1000 at scale 2.
const std::array<QSize, 3> Sizes{QSize(1280, 800), QSize(1024, 700), QSize(800, 500)};

// Where the second scan's patient lies, from the first one: 10 mm and 11 degrees.
Eigen::Affine3d Off()
{
  return Eigen::Translation3d(6.0, -7.0, 4.0) *
         Eigen::Affine3d(Eigen::AngleAxisd(0.2, Vector3(1.0, 2.0, -1.0).normalized()));
}

// Two scans of one organ, an ellipsoid, each with a segmentation.
class MatchingPanelTest : public test::WindowTest
{
protected:
  void SetUp() override
  {
    WindowTest::SetUp();
    test::LabelGrid grid;
    grid.Size = {{44, 36, 32}};
    grid.CenterOnOrigin();
    const auto isInside = [](double x, double y, double z)
    { return std::hypot(x / 15.0, y / 11.0, z / 8.5) < 1.0; };
    const auto volume = test::MakeLabelImage<short>(grid, isInside, 400);
    const auto mask = test::MakeLabelImage(grid, isInside, 1);
    WriteImage(this->File("first.nii.gz"), volume);
    WriteImage(this->File("first-organ.nii.gz"), mask);
    WriteImage(this->File("second.nii.gz"), MoveRigidly("second", volume, Off()));
    WriteImage(this->File("second-organ.nii.gz"), MoveRigidly("second", mask, Off()));
  }
  std::filesystem::path File(const std::string& name) const { return this->Phantom.Folder / name; }
  void Open(const QSize& size = QSize(1280, 800))
  {
    this->Window->resize(size);
    this->Study->OpenVolume(this->File("first.nii.gz"));
    this->Study->OpenSegmentation(this->File("first-organ.nii.gz"));
    this->Settle();
    this->Study->AddVolume(this->File("second.nii.gz"));
    this->Study->AddSegmentation(this->File("second-organ.nii.gz"));
    WaitUntil([this] { return this->Study->State().Structures.size() == 2; });
    this->Settle();
    WaitUntil([this] { return this->Window->Contents().Surfaces().size() == 2; });
    Activate(*this->Window);
    QTest::keyClick(this->Axial()->Canvas(), Qt::Key_H);
    ASSERT_TRUE(this->Action("Hold and match")->isChecked());
    DrawAll(*this->Window->Views());
  }
  SlicePane* Axial() const { return this->Window->Views()->Slice(SliceOrientation::Axial); }
  const HeldOrgan& Organ() const { return this->Window->findChild<MatchingLink*>()->Organ(); }
  // Presses at one place of the axial slice, moves to another, without letting go.
  void BeginDrag(const Vector3& from, const Vector3& to,
                 Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    QWidget* canvas = this->Axial()->Canvas();
    const auto at = [&](double part) { return PlaceIn(*this->Axial(), from + part * (to - from)); };
    SendMouse(canvas, QEvent::MouseButtonPress, at(0.0), Qt::LeftButton, Qt::LeftButton, modifiers);
    for (int n = 1; n <= 10; ++n)
    {
      SendMouse(canvas, QEvent::MouseMove, at(0.1 * n), Qt::NoButton, Qt::LeftButton, modifiers);
    }
    this->LastPlace = at(1.0);
  }
  void LetGo()
  {
    SendMouse(this->Axial()->Canvas(), QEvent::MouseButtonRelease, this->LastPlace, Qt::LeftButton,
              Qt::NoButton);
    WaitUntil([this] { return this->Organ().Is() == Phase::Lying; });
  }
  // From where the organ would be if it lay as the other one does.
  double Error() const { return (this->Organ().Pose() * Off()).translation().norm(); }
  QString Line() const { return this->Window->findChild<QLabel*>("match-line")->text(); }
  vtkSurfaceDisplay* Held() const { return this->Window->Contents().Held(); }
  Vector3 CenterOf(int id) const
  {
    double bounds[6];
    this->Window->Contents().Surfaces().at(id)->GetSurface()->GetBounds(bounds);
    return 0.5 * Vector3(bounds[0] + bounds[1], bounds[2] + bounds[3], bounds[4] + bounds[5]);
  }
  int MovingId() const { return this->Study->State().Structures.back().Id; }
  // Written where PALPATE_PICTURES says, for people to look at.
  void Show(const QString& name)
  {
    DrawAll(*this->Window->Views());
    if (const char* folder = std::getenv("PALPATE_PICTURES"))
    {
      EXPECT_TRUE(this->Window->grab().save(QString(folder) + "/" + name + ".png"));
    }
  }

  QPointF LastPlace;
};

TEST_F(MatchingPanelTest, DraggedOrganIsMatchedWhenItIsLetGoAtUsualSizes)
{
  for (const QSize& size : Sizes)
  {
    this->Open(size);
    ASSERT_EQ(this->Window->size(), size);
    EXPECT_TRUE(this->Held()->GetVisibility());
    const Vector3 before = this->Organ().Middle();
    this->BeginDrag(before, before + Vector3(-4.0, 5.0, 0.0));
    EXPECT_EQ(this->Organ().Is(), Phase::Pointed);
    EXPECT_TRUE(this->Line().startsWith("Held: it pulls with ")) << this->Line().toStdString();
    EXPECT_GT((this->Organ().Middle() - before).norm(), 2.0);
    this->Show(QString("match-held-%1").arg(size.width()));
    this->LetGo();
    EXPECT_TRUE(this->Line().startsWith("Matched: surfaces ")) << this->Line().toStdString();
    EXPECT_LT(this->Error(), 0.3); // of voxels of 1 mm
    this->Show(QString("match-%1").arg(size.width()));
    QTest::keyClick(this->Window.get(), Qt::Key_Escape);
    EXPECT_FALSE(this->Action("Hold and match")->isChecked());
    this->Study->New();
    WaitUntil([this] { return this->Organ().Is() == Phase::Absent; });
    EXPECT_FALSE(this->Held()->GetVisibility());
  }
}

TEST_F(MatchingPanelTest, ControlTurnsTheOrganAboutItsMiddle)
{
  this->Open();
  const Vector3 middle = this->Organ().Middle();
  this->BeginDrag(middle + Vector3(12.0, 0.0, 0.0), middle + Vector3(12.0, 6.0, 0.0),
                  Qt::ControlModifier);
  const Eigen::AngleAxisd made(Eigen::Matrix3d(this->Organ().Pose().linear()));
  EXPECT_NEAR(made.angle(), std::atan2(6.0, 12.0), 0.02); // a pixel
  EXPECT_GT(made.axis().z(), 0.99);
  this->LetGo();
}

TEST_F(MatchingPanelTest, KeptMatchMovesOrganAndVolumeAndIsUndone)
{
  this->Open();
  const Vector3 before = this->CenterOf(this->MovingId());
  const Vector3 middle = this->Organ().Middle();
  EXPECT_FALSE(this->Button("match-keep")->isEnabled()) << "nothing is matched";
  this->BeginDrag(middle, middle + Vector3(-4.0, 5.0, 0.0));
  this->LetGo();
  this->SavedTo = QString::fromStdString(this->File("match.lta").string());
  QTest::mouseClick(this->Button("match-keep"), Qt::LeftButton);
  ASSERT_EQ(this->Messages(), "");
  const StudyState& state = this->Study->State();
  EXPECT_EQ(state.Volumes.at(0).Transform, this->File("match.lta"));
  EXPECT_EQ(state.Structures.back().Move.File, this->File("match.lta"));
  EXPECT_FALSE(state.Structures.front().Move.IsSet());
  const Eigen::Affine3d written = ReadTransform(this->File("match.lta"));
  EXPECT_LT((written * Off()).translation().norm(), 0.3);
  const auto isMoved = [&] { return (this->CenterOf(this->MovingId()) - before).norm() > 3.0; };
  WaitUntil(isMoved);
  EXPECT_LT((this->CenterOf(this->MovingId()) - this->CenterOf(state.Structures.front().Id)).norm(),
            0.5);
  WaitUntil([this] { return !this->Organ().Match(); });
  EXPECT_EQ(this->Organ().Pose().matrix(), Eigen::Matrix4d::Identity()) << "taken where it is now";
  this->ExpectSameStudyAfterReopening();
}

TEST_F(MatchingPanelTest, UndoBringsBackOrganAndVolume)
{
  this->Open();
  const Vector3 middle = this->Organ().Middle();
  this->BeginDrag(middle, middle + Vector3(-4.0, 5.0, 0.0));
  this->LetGo();
  this->SavedTo = QString::fromStdString(this->File("match.tfm").string());
  this->Button("match-keep")->click();
  this->Settle();
  QTest::keyClick(this->Window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(this->Study->State().Volumes.at(0).Transform.empty());
  this->Settle();
  EXPECT_LT((this->CenterOf(this->MovingId()) - Off().translation()).norm(), 0.5);
}

TEST_F(MatchingPanelTest, DragInSpaceMovesTheOrganInTheViewsPlane)
{
  this->Open();
  SpacePane* space = this->Window->Views()->Space();
  const Vector3 before = this->Organ().Middle();
  const QPointF from = this->PlaceOf(before);
  SendMouse(space->Canvas(), QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
  for (int n = 1; n <= 5; ++n)
  {
    SendMouse(space->Canvas(), QEvent::MouseMove, from + QPointF(4.0 * n, 0.0), Qt::NoButton,
              Qt::LeftButton);
  }
  EXPECT_EQ(this->Organ().Is(), Phase::Pointed);
  const Vector3 motion = this->Organ().Middle() - before;
  EXPECT_GT(motion.norm(), 0.3);
  EXPECT_LT(std::abs(motion.normalized().dot(space->Axes().col(2))), 0.3);
  SendMouse(space->Canvas(), QEvent::MouseButtonRelease, from + QPointF(20.0, 0.0), Qt::LeftButton,
            Qt::NoButton);
  WaitUntil([this] { return this->Organ().Is() == Phase::Lying; });
  EXPECT_TRUE(this->Organ().Match());
}

TEST_F(MatchingPanelTest, ToolHoldsTheOrganAndFeelsIt)
{
  this->Open();
  EXPECT_FALSE(this->Button("match-tool")->isEnabled());
  this->BeginTouch();
  EXPECT_TRUE(this->Button("match-tool")->isEnabled());
  // Until the hand is where it begins.
  this->FeelUntil([this] { return this->Study->Reading().Newest.Tick.Number > 1500; });
  QTest::keyClick(this->Axial()->Canvas(), Qt::Key_H, Qt::ShiftModifier);
  ASSERT_EQ(this->Organ().Is(), Phase::Carried) << this->Messages();
  const Vector3 before = this->Organ().Middle();
  const Vector3 tool(this->Study->Reading().Newest.ProbeWorld);
  this->Study->Current().Touch().MoveHand(tool + Vector3(-3.0, 4.0, -2.0));
  this->FeelUntil([&] { return (this->Organ().Middle() - before).norm() > 4.0; });
  this->FeelUntil(
      [this]
      {
        const double force = test::Norm(this->Study->Reading().Newest.ForceWorld);
        return force > 0.2 && std::abs(force - this->Organ().Felt().Force.norm()) < 1e-6;
      });
  EXPECT_EQ(this->Study->Reading().TouchedId, 0) << "the tool touches nothing else";
  QTest::keyClick(this->Axial()->Canvas(), Qt::Key_H, Qt::ShiftModifier);
  EXPECT_NE(this->Organ().Is(), Phase::Carried);
  this->FeelUntil([this] { return this->Organ().Is() == Phase::Lying; });
  ASSERT_TRUE(this->Organ().Match());
  EXPECT_LT(this->Error(), 0.3);
}

TEST_F(MatchingPanelTest, ModesOfTheMouseExcludeEachOther)
{
  this->Open();
  this->Action("Draw by touch")->trigger();
  EXPECT_FALSE(this->Action("Hold and match")->isChecked());
  const Vector3 middle = this->Organ().Middle();
  this->BeginDrag(middle, middle + Vector3(-4.0, 5.0, 0.0));
  EXPECT_EQ(this->Organ().Is(), Phase::Lying);
  SendMouse(this->Axial()->Canvas(), QEvent::MouseButtonRelease, this->LastPlace, Qt::LeftButton,
            Qt::NoButton);
  EXPECT_FALSE(this->Study->State().Drawing.Touches.empty());
  this->Button("match-mode")->click();
  EXPECT_FALSE(this->Action("Draw by touch")->isChecked());
  const std::size_t touches = this->Study->State().Drawing.Touches.size();
  this->BeginDrag(middle, middle + Vector3(-4.0, 5.0, 0.0));
  EXPECT_EQ(this->Organ().Is(), Phase::Pointed);
  this->LetGo();
  EXPECT_EQ(this->Study->State().Drawing.Touches.size(), touches);
}

TEST_F(MatchingPanelTest, PutBackReturnsItAndAnotherChoiceDoesToo)
{
  this->Open();
  const Vector3 middle = this->Organ().Middle();
  this->BeginDrag(middle, middle + Vector3(-4.0, 5.0, 0.0));
  this->LetGo();
  this->Button("match-back")->click();
  EXPECT_EQ(this->Organ().Middle(), middle);
  EXPECT_FALSE(this->Button("match-keep")->isEnabled());
  auto* fixed = this->Window->findChild<QComboBox*>("match-fixed");
  fixed->setCurrentIndex(0);
  Q_EMIT fixed->activated(0);
  EXPECT_EQ(this->Organ().Is(), Phase::Absent);
  EXPECT_TRUE(this->Line().startsWith("Choose two organs")) << this->Line().toStdString();
  EXPECT_TRUE(this->Window->Contents().Surfaces().at(this->MovingId())->GetVisibility());
}
} // namespace
} // namespace palpate::matching_panel_test
