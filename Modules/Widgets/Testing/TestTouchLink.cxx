#include "PlotsPanel.h"
#include "ThresholdDialog.h"
#include "TouchPanel.h"
#include "TouchRecording.h"
#include "VirtualSpnav.h"
#include "WindowTest.h"

#include "vtkRenderWindow.h"

#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QKeyEvent>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QSlider>
#include <QTableWidget>
#include <QTextEdit>
#include <QWindow>

namespace palpate::touch_link_test
{
namespace
{
using test::Norm;

// The most (mm/s) by which the hand comes nearer to a ball of 9 mm over 20 ticks that begin between
// these distances (mm) from it.
double FastestApproach(const TouchRecording& recording, const Vector3& center, double from,
                       double to)
{
  const auto distance = [&](std::size_t tick)
  { return (Vector3(recording.Ticks[tick].ProbeWorld) - center).norm() - 9.0; };
  double fastest = 0.0;
  for (std::size_t tick = 0; tick + 20 < recording.Ticks.size(); ++tick)
  {
    const double begin = distance(tick);
    const auto passed = recording.Ticks[tick + 20].Sample.Time - recording.Ticks[tick].Sample.Time;
    if (begin > from && begin < to && passed > 0)
    {
      fastest =
          std::max(fastest, 1e9 * (begin - distance(tick + 20)) / static_cast<double>(passed));
    }
  }
  return fastest;
}

class TouchLinkTest : public test::WindowTest
{
protected:
  // Starts touching the sphere alone by mouse.
  void StartTouch()
  {
    this->OpenPhantom();
    StudyState next = this->Study->State();
    next.Structures.resize(1);
    this->Study->Change("Keep the ball", next);
    this->BeginTouch();
  }
  void PressByMouse() { this->Press(SphereCenter, 0.5); }

  // Like the window system: to the window, which passes it on to the widget with the focus.
  void SendKey(QEvent::Type type, Qt::Key key, const QString& text)
  {
    QKeyEvent event(type, key, Qt::NoModifier, text);
    QApplication::sendEvent(this->Window->windowHandle(), &event);
  }
  // Whether D is the drill's pedal while a widget has the focus.
  bool IsPedalWith(QWidget* focused)
  {
    focused->show();
    Activate(*this->Window);
    focused->setFocus();
    EXPECT_EQ(this->Window->focusWidget(), focused);
    this->SendKey(QEvent::KeyPress, Qt::Key_D, "d");
    const bool isDown = this->AfterSomeTicks().IsDrilling;
    this->SendKey(QEvent::KeyRelease, Qt::Key_D, "d");
    EXPECT_FALSE(this->AfterSomeTicks().IsDrilling);
    return isDown;
  }
  const TouchState& AfterSomeTicks()
  {
    const std::uint64_t now = this->Study->Reading().Newest.Tick.Number;
    this->FeelUntil([&] { return this->Study->Reading().Newest.Tick.Number > now + 50; });
    return this->Study->Reading().Newest;
  }

  const Vector3 SphereCenter{-15.0, 0.0, 0.0};
};

TEST_F(TouchLinkTest, MouseMovesHandShownInEveryView)
{
  this->StartTouch();
  this->PressByMouse();
  DrawAll(*this->Window->Views());
  vtkProbeRepresentation* probe = this->Window->Contents().Probe();
  EXPECT_TRUE(probe->GetVisibility());
  EXPECT_TRUE(probe->GetInContact());
  EXPECT_GT(this->Window->findChild<PlotsPanel*>()->Force().Largest(), 0.1);
  EXPECT_FALSE(this->Window->findChild<TouchPanel*>()->SafetyWords().isEmpty());
}

TEST_F(TouchLinkTest, ToolWithoutContactTellsItsDistance)
{
  this->StartTouch();
  Move(this->Window->Views()->Space()->Canvas(), this->PlaceOf(this->SphereCenter));
  vtkProbeRepresentation* probe = this->Window->Contents().Probe();
  this->FeelUntil([&] { return probe->GetHasNearestPoint() && !probe->GetInContact(); });
  const Vector3 nearest(probe->GetNearestPoint());
  const Vector3 tool = probe->ProxyWorld();
  // No farther than the sphere of 9 mm, within a voxel.
  EXPECT_LE((nearest - tool).norm(), std::abs((tool - this->SphereCenter).norm() - 9.0) + 1.0);
}

TEST_F(TouchLinkTest, SpaceMouseIsSlowNearTheSurfaceAndPushesIt)
{
  test::VirtualSpnav daemon((this->Phantom.Folder / "spnav").string());
  this->OpenPhantom();
  StudyState next = this->Study->State();
  next.Structures.resize(1);
  next.Device = "spacemouse:" + (this->Phantom.Folder / "spnav").string();
  this->Study->Change("Steer at the ball", next);
  this->BeginTouch();
  daemon.Accept();
  const auto file = this->Phantom.Folder / "steered.touch";
  ASSERT_TRUE(this->Study->Current().Touch().StartRecording(file).IsOk());
  // Steered when the window has told how far the ball is; later it tells it as often as it can.
  vtkProbeRepresentation* probe = this->Window->Contents().Probe();
  this->FeelUntil([&] { return probe->GetHasNearestPoint(); });
  daemon.Send({0, 0, 0, 250, 0, 0, 0, 16}); // away from the person
  this->FeelUntil([&] { return Norm(this->Study->Reading().Newest.ForceWorld) > 0.5; });
  EXPECT_EQ(this->Study->Reading().TouchedId, 1);
  daemon.Send({0, 0, 0, 0, 0, 0, 0, 16});
  this->FeelUntil([&] { return Norm(this->Study->Reading().Newest.ForceWorld) < 0.3; });
  ASSERT_TRUE(this->Study->Current().Touch().StopRecording().IsOk());
  TouchRecording recording;
  ASSERT_TRUE(ReadTouchRecording(file.string(), recording).IsOk());
  EXPECT_GT(FastestApproach(recording, this->SphereCenter, 15.0, 25.0),
            1.5 * FastestApproach(recording, this->SphereCenter, 2.0, 4.0));
}

TEST_F(TouchLinkTest, CapsuleTipsWhereItTouchesAndIsDrawnSo)
{
  this->OpenPhantom();
  StudyState next = this->Study->State();
  next.Structures.resize(1);
  this->Study->Change("Keep the ball", next);
  this->Window->findChild<QDoubleSpinBox*>("tool-length")->setValue(16.0);
  EXPECT_EQ(this->Study->State().Tool.Kind, TouchToolSettings::Shape::Capsule);
  this->BeginTouch();
  // Beside the middle of the ball, so that one end of the capsule is held.
  this->Press(this->SphereCenter + Vector3(2.0, 0.0, 3.0), 0.5);
  const TouchState& felt = this->Study->Reading().Newest;
  const Eigen::Map<const Eigen::Quaterniond> hand(felt.ProbeOrientation.data());
  const Eigen::Map<const Eigen::Quaterniond> tool(felt.ProxyOrientation.data());
  EXPECT_GT(tool.angularDistance(hand), 1e-3);
  const Matrix3 turned = tool.toRotationMatrix();
  vtkMatrix4x4* drawn = this->Window->Contents().Probe()->GetProxyMatrix();
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      EXPECT_NEAR(drawn->GetElement(row, column), turned(row, column), 1e-9);
    }
  }
  // The spot of the contact is on the ball, where a ball of the capsule's length is not.
  constexpr double BallRadius = 9.0; // mm
  constexpr double OfModel = 0.3;    // mm, of a coarse fit
  const Vector3 spot = this->Window->Contents().Probe()->ContactWorld();
  EXPECT_NEAR((spot - this->SphereCenter).norm(), BallRadius, OfModel);
  this->Window->findChild<QDoubleSpinBox*>("tool-shaft")->setValue(0.5);
  EXPECT_EQ(this->Study->State().Tool.Kind, TouchToolSettings::Shape::Drill);
  this->Window->findChild<QDoubleSpinBox*>("tool-length")->setValue(0.0);
  EXPECT_EQ(this->Study->State().Tool.Kind, TouchToolSettings::Shape::Sphere);
  this->Window->findChild<QDoubleSpinBox*>("tool-shaft")->setValue(0.5);
  EXPECT_EQ(this->Study->State().Tool.Kind, TouchToolSettings::Shape::Drill) << "of usual length";
}

TEST_F(TouchLinkTest, EscapeStopsForceUntilAllowedAgain)
{
  this->StartTouch();
  this->PressByMouse();
  QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
  QApplication::sendEvent(this->Window->findChild<QTableWidget*>("landmarks"), &escape);
  WaitUntil([this]
            { return this->Study->Reading().Newest.Safety.Fault == SafetyFault::SwitchedOff; });
  EXPECT_EQ(Norm(this->Study->Reading().Newest.ForceDevice), 0.0);
  QPushButton* force = this->Button("stop-force");
  WaitUntil([&] { return force->isEnabled() && force->text() == "Allow force again"; });
  force->click();
  this->FeelUntil([this]
                  { return this->Study->Reading().Newest.Safety.Fault == SafetyFault::None; });
  // The ball around the tool is silent until the tool has left it.
  QWidget* canvas = this->Window->Views()->Space()->Canvas();
  for (int notch = 0; notch < 40; ++notch)
  {
    Wheel(canvas, this->PlaceOf(this->SphereCenter), -1);
  }
  this->FeelUntil([this] { return !this->Study->Reading().Newest.IsBuried; });
  this->PressByMouse();
}

TEST_F(TouchLinkTest, KeyDIsPedalUnlessTyping)
{
  this->StartTouch();
  Activate(*this->Window);
  EXPECT_TRUE(this->IsPedalWith(this->Window->Views()->Space()->Canvas()));
  auto* line = new QLineEdit(this->Window.get());
  EXPECT_FALSE(this->IsPedalWith(line));
  EXPECT_EQ(line->text(), "d");
  EXPECT_FALSE(this->IsPedalWith(new QDoubleSpinBox(this->Window.get())));
  EXPECT_FALSE(this->IsPedalWith(new QTextEdit(this->Window.get())));
  EXPECT_FALSE(this->IsPedalWith(new QKeySequenceEdit(this->Window.get())));
  EXPECT_FALSE(this->IsPedalWith(new QPlainTextEdit(this->Window.get())));
  auto* choice = new QComboBox(this->Window.get());
  EXPECT_TRUE(this->IsPedalWith(choice));
  choice->setEditable(true);
  EXPECT_FALSE(this->IsPedalWith(choice));
}

TEST_F(TouchLinkTest, ModifierMovesCameraInsteadOfHand)
{
  this->StartTouch();
  SpacePane* space = this->Window->Views()->Space();
  const Matrix3 before = space->Axes();
  int moved = 0;
  QObject::connect(space, &SpacePane::HandMoved, [&moved](const Vector3&) { ++moved; });
  QWidget* canvas = space->Canvas();
  SendMouse(canvas, QEvent::MouseButtonPress, {100.0, 100.0}, Qt::LeftButton, Qt::LeftButton,
            Qt::ControlModifier);
  SendMouse(canvas, QEvent::MouseMove, {160.0, 110.0}, Qt::NoButton, Qt::LeftButton,
            Qt::ControlModifier);
  SendMouse(canvas, QEvent::MouseButtonRelease, {160.0, 110.0}, Qt::LeftButton, Qt::NoButton,
            Qt::ControlModifier);
  EXPECT_GT((space->Axes() - before).norm(), 0.1);
  EXPECT_EQ(moved, 0);
  // The device's axes followed.
  EXPECT_LT((this->Study->Current().Touch().Frame().Rotation - space->Axes()).norm(), 1e-12);
  Move(canvas, {120.0, 100.0});
  EXPECT_GE(moved, 1); // VTK 9.6 tells it twice, with Qt's event of hovering
}

// One movement and one press; releasing lifts.
TEST_F(TouchLinkTest, PressPushesWhatIsUnderThePointer)
{
  this->StartTouch();
  QWidget* canvas = this->Window->Views()->Space()->Canvas();
  const QPointF place = this->PlaceOf(this->SphereCenter);
  Move(canvas, place);
  EXPECT_EQ(Norm(this->AfterSomeTicks().ForceWorld), 0.0) << "the tool only rests";
  SendMouse(canvas, QEvent::MouseButtonPress, place, Qt::LeftButton, Qt::LeftButton);
  this->FeelUntil(
      [this]
      {
        return this->Study->Reading().TouchedId == 1 &&
               Norm(this->Study->Reading().Newest.ForceWorld) > 1.0;
      });
  SendMouse(canvas, QEvent::MouseButtonRelease, place, Qt::LeftButton, Qt::NoButton);
  this->FeelUntil([this] { return Norm(this->Study->Reading().Newest.ForceWorld) == 0.0; });
}

TEST_F(TouchLinkTest, StrokeStaysOnTheSurface)
{
  this->StartTouch();
  QWidget* canvas = this->Window->Views()->Space()->Canvas();
  QPointF place = this->PlaceOf(this->SphereCenter);
  Move(canvas, place);
  SendMouse(canvas, QEvent::MouseButtonPress, place, Qt::LeftButton, Qt::LeftButton);
  this->FeelUntil([this] { return Norm(this->Study->Reading().Newest.ForceWorld) > 1.0; });
  const double tool = this->Study->State().Tool.Radius;
  for (int step = 0; step < 20; ++step)
  {
    place += QPointF(1.0, 0.5);
    SendMouse(canvas, QEvent::MouseMove, place, Qt::NoButton, Qt::LeftButton);
    const TouchState& felt = this->AfterSomeTicks();
    EXPECT_GT(Norm(felt.ForceWorld), 0.3) << "step " << step;
    // A sphere of 9 mm, within a voxel.
    EXPECT_NEAR((Vector3(felt.ProxyWorld) - this->SphereCenter).norm(), 9.0 + tool, 1.0);
  }
}

TEST_F(TouchLinkTest, PressInASlicePushes)
{
  this->StartTouch();
  this->Window->Contents().Crosshair()->SetPositionWorld(
      this->SphereCenter.x(), this->SphereCenter.y(), this->SphereCenter.z());
  DrawAll(*this->Window->Views());
  SlicePane* slice = this->Window->Views()->Slice(SliceOrientation::Axial);
  const QPointF edge = PlaceIn(*slice, this->SphereCenter + Vector3(9.5, 0.0, 0.0));
  const QPointF inside = PlaceIn(*slice, this->SphereCenter + Vector3(4.0, 0.0, 0.0));
  Move(slice->Canvas(), QPointF(3.0, 3.0));
  EXPECT_EQ(slice->cursor().shape(), Qt::ArrowCursor);
  Move(slice->Canvas(), edge);
  EXPECT_EQ(slice->cursor().shape(), Qt::PointingHandCursor) << "a press pushes";
  SendMouse(slice->Canvas(), QEvent::MouseButtonPress, edge, Qt::LeftButton, Qt::LeftButton);
  this->AfterSomeTicks();
  SendMouse(slice->Canvas(), QEvent::MouseMove, inside, Qt::NoButton, Qt::LeftButton);
  this->FeelUntil([this] { return Norm(this->Study->Reading().Newest.ForceWorld) > 0.5; });
  EXPECT_GT(this->Study->Reading().Newest.ForceWorld.X, 0.4) << "pushed back the way it came";
  SendMouse(slice->Canvas(), QEvent::MouseButtonRelease, inside, Qt::LeftButton, Qt::NoButton);
  this->FeelUntil([this] { return Norm(this->Study->Reading().Newest.ForceWorld) == 0.0; });
}

TEST_F(TouchLinkTest, WheelStopsAtWorkspaceLimit)
{
  this->StartTouch();
  SpacePane* space = this->Window->Views()->Space();
  const QPointF place(10.0, 10.0); // beside everything
  Move(space->Canvas(), place);
  const double reach = this->Study->Current().Touch().Capabilities().Workspace.max().x();
  const WorkspaceFrame& frame = this->Study->Current().Touch().Frame();
  for (int notch = 0; notch < 1000; ++notch)
  {
    Wheel(space->Canvas(), place, 1);
  }
  const Vector3 farthest = space->HandWorld();
  EXPECT_NEAR(frame.ToDevice(farthest).z(), -reach, 1e-9); // some roundings
  // So it returns with the first notch.
  Wheel(space->Canvas(), place, -1);
  EXPECT_GT((space->HandWorld() - farthest).norm(), 0.1);
  EXPECT_LT((space->HandWorld() - this->Study->Current().Touch().HandWorld()).norm(), 1e-12);
}

TEST_F(TouchLinkTest, WorkspaceIsShownAndDraggedByMouse)
{
  vtkSurfaceDisplay* shown = this->Window->Contents().Workspace();
  EXPECT_FALSE(shown->GetVisibility());
  this->StartTouch();
  EXPECT_FALSE(shown->GetVisibility());
  const StudyTouch& touch = this->Study->Current().Touch();
  const Vector3 before = touch.Frame().CenterWorld;
  SpacePane* space = this->Window->Views()->Space();
  QWidget* canvas = space->Canvas();
  this->Action("Move workspace")->trigger();
  EXPECT_TRUE(shown->GetVisibility()) << "while it is moved";
  const Vector3 hand = touch.HandWorld();
  Move(canvas, {100.0, 100.0});
  EXPECT_EQ(touch.HandWorld(), hand) << "the mouse must not move the hand meanwhile";
  SendMouse(canvas, QEvent::MouseButtonPress, {100.0, 100.0}, Qt::LeftButton, Qt::LeftButton);
  SendMouse(canvas, QEvent::MouseMove, {120.0, 100.0}, Qt::NoButton, Qt::LeftButton);
  SendMouse(canvas, QEvent::MouseMove, {150.0, 100.0}, Qt::NoButton, Qt::LeftButton);
  SendMouse(canvas, QEvent::MouseButtonRelease, {150.0, 100.0}, Qt::LeftButton, Qt::NoButton);
  const Vector3 path = touch.Frame().CenterWorld - before;
  EXPECT_GT(path.norm(), 1.0);
  // To the right on the screen: a few roundings through its coordinates.
  EXPECT_NEAR(path.normalized().dot(space->Axes().col(0)), 1.0, 1e-6);
  Vector3 corner;
  shown->GetSurface()->GetPoint(0, corner.data());
  const Vector3 least = touch.Capabilities().Workspace.min();
  EXPECT_LT((corner - touch.Frame().ToWorld(least)).norm(), 1e-9);
  Wheel(canvas, {150.0, 100.0}, 1);
  EXPECT_GT((touch.Frame().CenterWorld - before - path).norm(), 0.1);
  this->Action("Undo")->trigger();
  EXPECT_LT((touch.Frame().CenterWorld - before - path).norm(), 1e-9);
  this->Action("Undo")->trigger();
  EXPECT_EQ(touch.Frame().CenterWorld, before);
  this->Action("Move workspace")->trigger();
  EXPECT_FALSE(shown->GetVisibility());
  this->Action("Show the workspace")->trigger();
  EXPECT_TRUE(shown->GetVisibility());
}

TEST_F(TouchLinkTest, SlicesFollowTheProbe)
{
  this->StartTouch();
  this->PressByMouse();
  const TouchState& felt = this->Study->Reading().Newest;
  const Vector3 cross(this->Window->Contents().Crosshair()->GetPositionWorld());
  const double tool = this->Study->State().Tool.Radius;
  constexpr double Still = 0.1; // mm that slices do not follow
  EXPECT_NEAR((cross - Vector3(felt.ProxyWorld)).norm(), tool, Still) << "the place of contact";
  EXPECT_NEAR((cross - this->SphereCenter).norm(), 9.0, 1.0) << "on the sphere, within a voxel";
}

// Record, drop the file on the window: the touch is shown again, and nothing is touched meanwhile.
TEST_F(TouchLinkTest, ReplaysRecording)
{
  this->StartTouch();
  const auto file = this->Phantom.Folder / "felt.touch";
  this->SavedTo = QString::fromStdString((this->Phantom.Folder / "felt").string());
  this->Button("record")->click();
  ASSERT_TRUE(this->Study->IsRecording()) << this->Messages();
  this->PressByMouse();
  auto* panel = this->Window->findChild<TouchPanel*>();
  EXPECT_TRUE(panel->RecordingWords().startsWith("Recording felt.touch: "))
      << panel->RecordingWords().toStdString();
  this->Action("Stop recording")->trigger();
  EXPECT_FALSE(this->Study->IsRecording());
  EXPECT_TRUE(panel->RecordingWords().startsWith("Recorded felt.touch: "));
  ASSERT_TRUE(std::filesystem::exists(file)) << this->Messages();
  QMimeData mime;
  mime.setUrls({QUrl::fromLocalFile(QString::fromStdString(file.string()))});
  QDragEnterEvent enter({300, 300}, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(this->Window.get(), &enter);
  QDropEvent drop({300.0, 300.0}, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(this->Window.get(), &drop);
  WaitUntil([this] { return this->Study->IsReplaying() || !this->Messages().empty(); });
  ASSERT_TRUE(this->Study->IsReplaying()) << this->Messages();
  EXPECT_FALSE(this->Study->IsTouching());
  auto* slider = this->Window->findChild<QSlider*>("replay-slider");
  QKeyEvent end(QEvent::KeyPress, Qt::Key_End, Qt::NoModifier);
  QApplication::sendEvent(slider, &end);
  WaitUntil([this] { return Norm(this->Study->Reading().Newest.ForceWorld) > 0.1; });
  EXPECT_EQ(this->Study->Reading().TouchedId, 1);
  EXPECT_TRUE(this->Window->Contents().Probe()->GetInContact());
  EXPECT_GT(this->Window->findChild<PlotsPanel*>()->Force().Largest(), 0.1);
}

TEST_F(TouchLinkTest, ClosingSwitchesForcesOff)
{
  this->StartTouch();
  this->PressByMouse();
  EXPECT_TRUE(this->Window->close());
  EXPECT_FALSE(this->Study->IsTouching());
}

TEST_F(TouchLinkTest, CancelledCloseKeepsForcesOff)
{
  this->StartTouch();
  this->PressByMouse();
  StudyState marked = this->Study->State();
  marked.Landmarks.push_back({"apex", Vector3::Zero()});
  this->Study->Change("Mark the apex", marked);
  this->Leaving = FileQuestions::Answer::Cancel;
  EXPECT_FALSE(this->Window->close());
  WaitUntil([this]
            { return this->Study->Reading().Newest.Safety.Fault == SafetyFault::SwitchedOff; });
  const std::uint64_t tick = this->Study->Reading().Newest.Tick.Number;
  WaitUntil([&] { return this->Study->Reading().Newest.Tick.Number > tick + 100; });
  EXPECT_EQ(Norm(this->Study->Reading().Newest.ForceDevice), 0.0);
}

TEST_F(TouchLinkTest, RejectsTouchOfNothing)
{
  EXPECT_FALSE(this->Button("start-touch")->isEnabled());
  this->Study->StartTouch();
  WaitUntil([this] { return !this->Messages().empty(); });
  EXPECT_EQ(this->Messages(), "There is nothing to touch yet: make a structure touchable and wait "
                              "until its model is made.");
}

// By keyboard: to a landmark, along a path, to a plane that has too few points, and none.
TEST_F(TouchLinkTest, LandmarksGuideTheTool)
{
  this->StartTouch();
  StudyState next = this->Study->State();
  next.Landmarks = {{"F-1", this->SphereCenter + Vector3(0.0, 0.0, 20.0)},
                    {"F-2", this->SphereCenter + Vector3(10.0, 0.0, 20.0)}};
  this->Study->Change("Place landmarks", next);
  auto* guide = this->Window->findChild<QComboBox*>("guide");
  auto* dock = guide->parentWidget();
  while (qobject_cast<QDockWidget*>(dock) == nullptr)
  {
    dock = dock->parentWidget();
  }
  dock->show();
  const auto chooseNext = [guide]
  {
    QKeyEvent down(QEvent::KeyPress, Qt::Key_Down, Qt::NoModifier);
    QCoreApplication::sendEvent(guide, &down);
  };
  chooseNext();
  ASSERT_EQ(this->Study->State().Guides.size(), 1U) << this->Messages();
  EXPECT_EQ(this->Study->State().Guides[0].Shape, GuideShape::Point);
  chooseNext();
  const GuideSettings path = this->Study->State().Guides.at(0);
  EXPECT_EQ(path.Shape, GuideShape::Path);
  EXPECT_EQ(path.PointsWorld.size(), 2U);
  EXPECT_EQ(path.PointsWorld.back(), next.Landmarks.back().PositionWorld);
  chooseNext();
  EXPECT_NE(this->Messages().find("a plane 3"), std::string::npos);
  EXPECT_EQ(this->Study->State().Guides.at(0), path);
  EXPECT_EQ(guide->currentIndex(), 2) << "shows what holds";
  this->Study->Undo();
  this->Study->Undo();
  EXPECT_TRUE(this->Study->State().Guides.empty());
  EXPECT_EQ(guide->currentIndex(), 0);
  EXPECT_TRUE(this->Study->IsTouching());
}

// Open, fit, touch by mouse, landmark, save, reopen: the same state.
TEST_F(TouchLinkTest, SessionReopensUnchanged)
{
  this->StartTouch();
  this->PressByMouse();
  this->Button("add-touched")->click();
  this->Button("add-landmarks")->setChecked(true);
  Click(this->Window->Views()->Slice(SliceOrientation::Coronal)->Canvas(), {70.0, 60.0});
  this->Button("add-landmarks")->setChecked(false);
  ASSERT_EQ(this->Study->State().Landmarks.size(), 2U);
  // Touched from outside: at least the sphere's radius from the centre, within a voxel.
  const Vector3 touched = this->Study->State().Landmarks.front().PositionWorld;
  EXPECT_GT((touched - this->SphereCenter).norm(), 9.0 - 1.0);
  this->Window->findChild<QTableWidget*>("landmarks")->selectAll();
  this->Button("add-distance")->click();
  ASSERT_EQ(this->Study->State().Measurements.size(), 1U) << this->Messages();
  const auto csv = this->Phantom.Folder / "marks.csv";
  this->SavedTo = QString::fromStdString(csv.string());
  this->Button("export-landmarks")->click();
  this->FinishWriting();
  EXPECT_TRUE(std::filesystem::exists(csv)) << this->Messages();
  this->Button("start-touch")->click();
  EXPECT_FALSE(this->Study->IsTouching());
  this->ExpectSameStudyAfterReopening();
  EXPECT_EQ(this->Window->Contents().Landmarks()->GetCurves().size(), 1U);
}

TEST_F(TouchLinkTest, EscapeEndsModesAndAllowsNoForce)
{
  this->StartTouch();
  QAction* marks = this->Action("Add landmarks by click");
  QAction* workspace = this->Action("Move workspace");
  marks->setChecked(true);
  workspace->setChecked(true);
  this->SendKey(QEvent::KeyPress, Qt::Key_Escape, {});
  EXPECT_FALSE(marks->isChecked());
  EXPECT_FALSE(workspace->isChecked());
  const auto fault = [this] { return this->AfterSomeTicks().Safety.Fault; };
  EXPECT_EQ(fault(), SafetyFault::SwitchedOff);
  marks->trigger();
  marks->trigger();
  EXPECT_EQ(fault(), SafetyFault::SwitchedOff) << "ending a mode allows no force";
}

TEST_F(TouchLinkTest, VolumeAloneOffersItsValues)
{
  QAction* start = this->Action("Start touching");
  EXPECT_FALSE(start->isEnabled()) << "as the button";
  this->Study->OpenVolume(this->VolumeFile());
  WaitUntil([this] { return this->Button("start-touch")->isEnabled(); });
  EXPECT_EQ(this->Button("start-touch")->text(), "Touch image values...");
  EXPECT_TRUE(start->isEnabled());
  this->Button("start-touch")->click();
  auto* dialog = this->Window->findChild<ThresholdDialog*>();
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->isVisible());
  EXPECT_EQ(this->Messages(), "");
  dialog->accept();
  WaitUntil([this] { return this->Study->IsTouching() || !this->Messages().empty(); });
  EXPECT_EQ(this->Messages(), "") << "touch begins when the structure is made";
}
} // namespace
} // namespace palpate::touch_link_test
