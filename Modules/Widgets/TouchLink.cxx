#include "TouchLink.h"

#include "ScreenString.h"
#include "TouchNotice.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>

#include <algorithm>
#include <limits>
#include <optional>

namespace palpate
{
namespace
{
constexpr double StrongestPush = 4.0; // N, of a hand that points

// Whether the widget takes keys as text.
bool TakesText(const QWidget* widget)
{
  const auto* choice = qobject_cast<const QComboBox*>(widget);
  return (choice != nullptr && choice->isEditable()) ||
         qobject_cast<const QLineEdit*>(widget) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
         qobject_cast<const QKeySequenceEdit*>(widget) != nullptr ||
         qobject_cast<const QTextEdit*>(widget) != nullptr ||
         qobject_cast<const QPlainTextEdit*>(widget) != nullptr;
}
} // namespace

TouchLink::TouchLink(StudyController& study, ViewContents& contents, ViewGrid& views,
                     QObject* parent)
    : QObject(parent), Study(study), Contents(contents), Views(views)
{
  connect(&study, &StudyController::TouchChanged, this, &TouchLink::Begin);
  connect(&study, &StudyController::ReplayChanged, this, &TouchLink::ShowProbe);
  connect(&study, &StudyController::Touched, this, &TouchLink::ShowReading);
  connect(&study, &StudyController::DrilledChanged, this, &TouchLink::ShowDrilled);
  connect(views.Space(), &SpacePane::HandMoved, this,
          [this](const Vector3& targetWorld)
          {
            this->IsLedInSlice = false;
            this->MoveHand(targetWorld);
          });
  connect(views.Space(), &SpacePane::Aimed, this, &TouchLink::FindRest);
  connect(views.Space(), &SpacePane::Pressed, this,
          [this] { this->Study.Current().Touch().PressHand(); });
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    this->LeadIn(views.Slice(orientation));
  }
  connect(views.Space(), &SpacePane::Dragged, this,
          [this](const Vector3& world) { this->Study.MoveWorkspace(world, "workspace"); });
  connect(views.Space(), &SpacePane::DragEnded, &study, &StudyController::EndGesture);
  connect(views.Space(), &SpacePane::CameraTurned, this, &TouchLink::TellAxes);
  // Before a touch begins the device's axes are those of the camera as it is; later a camera that
  // is still turning would move the scene under the hand.
  connect(views.Space(), &ViewPane::Rendered, this,
          [this]
          {
            if (!this->Study.IsTouching())
            {
              this->TellAxes();
            }
          });
  QApplication::instance()->installEventFilter(this);
}

void TouchLink::TakeHand()
{
  const bool isHand = this->IsPointing && !this->AreClicksForMarks;
  this->Views.Space()->SetHand(this->IsPointing, this->Study.Current().Touch().HandWorld());
  this->Views.Space()->SetButtonPushes(!this->AreClicksForMarks);
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    this->Views.Slice(orientation)->SetHand(isHand);
  }
}

void TouchLink::LeaveClicks(bool areForMarks)
{
  this->Lift();
  this->AreClicksForMarks = areForMarks;
  this->TakeHand();
}

void TouchLink::ShowHandOnly(bool isOn)
{
  this->IsHandOnly = isOn;
  this->Contents.ShowHandOnly(isOn);
}

void TouchLink::TellAxes()
{
  this->Study.Current().TurnAxes(this->Views.Space()->Axes());
  this->ShowHand();
}

void TouchLink::Begin()
{
  const bool isTouching = this->Study.IsTouching();
  const bool isSimulated =
      isTouching && this->Study.Current().Touch().PlaceHand(this->Views.Space()->Axes().col(2));
  if (isSimulated)
  {
    // To its first place without contacts.
    this->Study.Current().Touch().LiftHand();
    this->Study.Current().Touch().PressHand();
  }
  this->IsPointing = isSimulated;
  this->TakeHand();
  this->IsLedInSlice = false;
  this->AimedAt = -1;
  this->ShowProbe();
  this->ShowNotice();
  this->ShowPlace();
}

// Shows the workspace's position, which a drag starts from.
void TouchLink::ShowPlace()
{
  const StudyTouch& touch = this->Study.Current().Touch();
  const bool isTouching = this->Study.IsTouching();
  this->Contents.ShowWorkspace(touch.Frame(),
                               isTouching ? touch.Capabilities().Workspace : Eigen::AlignedBox3d(),
                               isTouching && (this->IsWorkspaceShown || this->IsWorkspaceMoved));
  this->Views.Space()->SetDragging(isTouching && this->IsWorkspaceMoved, touch.Frame().CenterWorld);
}

void TouchLink::ShowWorkspace(bool isShown)
{
  this->IsWorkspaceShown = isShown;
  this->ShowPlace();
}

void TouchLink::MoveWorkspace(bool isMoved)
{
  this->IsWorkspaceMoved = isMoved;
  this->ShowPlace();
}

void TouchLink::ShowProbe()
{
  this->Contents.ShowTouch(this->Study.Reading(),
                           this->Study.IsTouching() || this->Study.IsReplaying());
  if (this->Study.IsTouching())
  {
    this->Study.Current().Touch().TellDistance(this->ToolDistance());
  }
}

// mm from the tool, as it is shown, to the nearest surface.
double TouchLink::ToolDistance() const
{
  const auto& probe = this->Contents.Probe();
  if (probe->GetInContact())
  {
    return 0.0;
  }
  return probe->GetHasNearestPoint()
             ? (Vector3(probe->GetNearestPoint()) - probe->ProxyWorld()).norm()
             : std::numeric_limits<double>::infinity();
}

void TouchLink::ShowNotice()
{
  const bool isLost = this->Study.Current().IsAwaitingDevice();
  TouchNotice notice;
  if (isLost)
  {
    notice = {TouchNotice::Kind::NoForce,
              "No force. " + ScreenString(this->Study.Current().DeviceNotice())};
  }
  else if (this->Study.IsTouching() && !this->IsHandOnly)
  {
    notice = TouchNotice::Of(this->Study.Reading());
  }
  this->Views.ShowNotice(notice);
  const bool isAlarm = notice.Is == TouchNotice::Kind::Alarm;
  if (isAlarm && !this->IsAlarmed && this->AreAlarmsHeard)
  {
    QApplication::beep();
  }
  this->IsAlarmed = isAlarm;
}

void TouchLink::FindRest(const Vector3& from, const Vector3& to)
{
  StudyTouch& touch = this->Study.Current().Touch();
  const std::optional<TouchRay::Rest> rest = touch.RestBetween(from, to);
  if (!rest)
  {
    return;
  }
  this->AimAt(rest->Structure);
  this->Views.Space()->Rest(rest->ToolWorld, rest->NormalWorld, this->MostPush);
  if (!this->Views.Space()->IsPressed())
  {
    touch.LiftHand(); // so that it hovers over everything
  }
}

// In a slice a press leads the tool to the pointer: what it is pulled into holds it back.
void TouchLink::LeadIn(SlicePane* slice)
{
  connect(slice, &SlicePane::PointedAt, this,
          [this, slice](const Vector3& point)
          {
            const bool isHand = this->IsPointing && !this->AreClicksForMarks;
            this->TakePlane(*slice);
            slice->ShowHand(isHand &&
                            this->Study.Current().Touch().HasRestAround(
                                point, this->SliceRight, this->SliceUp, this->SliceReach));
          });
  connect(slice, &SlicePane::Aimed, this,
          [this, slice](const Vector3& point)
          {
            this->TakePlane(*slice);
            if (this->FindRestInSlice(point))
            {
              this->IsLedInSlice = true;
              this->Study.Current().Touch().LiftHand();
              this->MoveHand(this->SliceRest);
              slice->AcceptPress();
            }
          });
  connect(slice, &SlicePane::Pressed, this, [this] { this->Study.Current().Touch().PressHand(); });
  connect(slice, &SlicePane::HandMoved, this,
          [this](const Vector3& point)
          {
            this->FindRestInSlice(point);
            const Vector3 pull = point - this->SliceRest;
            const double part = std::min(1.0, this->MostPush / std::max(pull.norm(), 1e-9));
            this->MoveHand(this->SliceRest + part * pull);
          });
  connect(slice, &SlicePane::Lifted, this, [this] { this->MoveHand(this->SliceRest); });
}

void TouchLink::TakePlane(const SlicePane& slice)
{
  constexpr double NearPixels = 12.0;
  const Vector3 right = slice.PixelRight();
  this->SliceRight = right.normalized();
  this->SliceUp = slice.PixelUp().normalized();
  this->SliceReach = NearPixels * right.norm();
}

bool TouchLink::FindRestInSlice(const Vector3& point)
{
  StudyTouch& touch = this->Study.Current().Touch();
  const std::optional<TouchRay::Rest> rest =
      touch.RestInPlane(point, this->SliceRight, this->SliceUp, this->SliceReach);
  if (rest)
  {
    this->AimAt(rest->Structure);
  }
  this->SliceRest = rest ? rest->ToolWorld : point;
  return rest.has_value();
}

void TouchLink::AimAt(int structure)
{
  if (structure != this->AimedAt)
  {
    this->AimedAt = structure;
    this->MostPush = this->Study.Current().Touch().PushFor(StrongestPush, structure);
  }
}

void TouchLink::MoveHand(const Vector3& targetWorld)
{
  this->Study.Current().Touch().MoveHand(targetWorld);
  this->ShowHand();
}

// Beyond the device's reach, or if the workspace moves, the hand differs from the pointer's target.
void TouchLink::ShowHand()
{
  this->Views.Space()->PlaceHand(this->Study.Current().Touch().HandWorld());
}

void TouchLink::ShowDrilled()
{
  if (this->Contents.ShowDrilled(this->Study.Reading().Drill))
  {
    this->Views.TakeContents();
  }
}

void TouchLink::ShowReading()
{
  const StudyTouchReading& reading = this->Study.Reading();
  this->ShowDrilled();
  this->ShowProbe();
  this->ShowNotice();
  this->ShowHand();
  this->ShowPlace();
  if (reading.Newest.HasSample && this->Study.State().View.SlicesFollowProbe)
  {
    this->FollowProbe();
  }
}

// A mouse leaves the crosshair to the user until it leads the tool or the tool touches something,
// and while the tool rests; a slice that is pressed stays.
void TouchLink::FollowProbe()
{
  constexpr double Still = 0.1; // mm
  const TouchState& newest = this->Study.Reading().Newest;
  const Vector3 force(newest.ForceWorld);
  Vector3 place(this->IsHandOnly ? newest.ProbeWorld : newest.ProxyWorld);
  if (this->Study.Reading().TouchedId != 0 && force.norm() > 0.0)
  {
    // The place of contact: slices through the centre of a large tool may miss the structure.
    place = this->Contents.Probe()->ContactWorld();
  }
  const bool isUnled = this->AimedAt < 0 && this->Study.Reading().TouchedId == 0;
  const bool isStill = isUnled || (place - this->Followed).norm() < Still;
  if (this->IsPointing && isStill)
  {
    return;
  }
  this->Followed = place;
  if (this->IsLedInSlice)
  {
    const Vector3 normal = this->SliceRight.cross(this->SliceUp);
    const Vector3 slice(this->Contents.Crosshair()->GetPositionWorld());
    place -= (place - slice).dot(normal) * normal;
  }
  this->Contents.Crosshair()->SetPositionWorld(place.data());
}

bool TouchLink::eventFilter(QObject* object, QEvent* event)
{
  switch (event->type())
  {
  case QEvent::KeyPress:
    this->PressKey(static_cast<const QKeyEvent&>(*event), object);
    break;
  case QEvent::KeyRelease:
    this->ReleaseKey(static_cast<const QKeyEvent&>(*event));
    break;
  case QEvent::WindowDeactivate:
    // A release of the key outside the window would not be received.
    this->Study.Current().Touch().RunDrill(false);
    this->Lift();
    break;
  default:
    break;
  }
  return false;
}

// A window passes a key on to the widget with the focus, so it arrives here twice.
void TouchLink::PressKey(const QKeyEvent& key, const QObject* receiver)
{
  if (key.key() == Qt::Key_Escape)
  {
    this->Study.Current().Touch().SwitchForcesOff();
    this->Lift();
    Q_EMIT Escaped();
  }
  if (key.key() == Qt::Key_D && key.modifiers() == Qt::NoModifier && !key.isAutoRepeat() &&
      !receiver->isWindowType() && !TakesText(QApplication::focusWidget()))
  {
    this->Study.Current().Touch().RunDrill(true);
  }
}

void TouchLink::Lift()
{
  this->Views.Space()->Lift();
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    this->Views.Slice(orientation)->Lift();
  }
}

// Whatever other keys are pressed, and wherever the cursor is.
void TouchLink::ReleaseKey(const QKeyEvent& key)
{
  if (key.key() == Qt::Key_D && !key.isAutoRepeat())
  {
    this->Study.Current().Touch().RunDrill(false);
  }
}
} // namespace palpate
