#include "TouchLink.h"

#include "TouchNotice.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>

namespace palpate
{
namespace
{
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
  connect(views.Space(), &SpacePane::HandMoved, this, &TouchLink::MoveHand);
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
  this->Views.Space()->SetHand(isSimulated, this->Study.Current().Touch().HandWorld());
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
                               isTouching && this->IsWorkspaceShown);
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
}

void TouchLink::ShowNotice()
{
  const TouchNotice notice =
      this->Study.IsTouching() ? TouchNotice::Of(this->Study.Reading()) : TouchNotice();
  this->Views.ShowNotice(notice);
  const bool isAlarm = notice.Is == TouchNotice::Kind::Alarm;
  if (isAlarm && !this->IsAlarmed && this->AreAlarmsHeard)
  {
    QApplication::beep();
  }
  this->IsAlarmed = isAlarm;
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
    const PlainVector3& proxy = reading.Newest.ProxyWorld;
    this->Contents.Crosshair()->SetPositionWorld(proxy.X, proxy.Y, proxy.Z);
  }
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
  }
  if (key.key() == Qt::Key_D && key.modifiers() == Qt::NoModifier && !key.isAutoRepeat() &&
      !receiver->isWindowType() && !TakesText(QApplication::focusWidget()))
  {
    this->Study.Current().Touch().RunDrill(true);
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
