#include "TouchLink.h"

#include <QApplication>
#include <QKeyEvent>

namespace palpate
{
TouchLink::TouchLink(StudyController& study, ViewContents& contents, ViewGrid& views,
                     QObject* parent)
    : QObject(parent), Study(study), Contents(contents), Views(views)
{
  connect(&study, &StudyController::TouchChanged, this, &TouchLink::Begin);
  connect(&study, &StudyController::Touched, this, &TouchLink::ShowReading);
  connect(views.Space(), &SpacePane::HandMoved, this, &TouchLink::MoveHand);
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
  this->Study.TurnAxes(this->Views.Space()->Axes());
  this->ShowHand();
}

void TouchLink::Begin()
{
  const bool isTouching = this->Study.IsTouching();
  const bool isSimulated =
      isTouching && this->Study.Current().Touch().PlaceHand(this->Views.Space()->Axes().col(2));
  this->Views.Space()->SetHand(isSimulated, this->Study.Current().Touch().HandWorld());
  this->Contents.ShowTouch(this->Study.Reading(), isTouching);
}

void TouchLink::MoveHand(const Vector3& targetWorld)
{
  this->Study.MoveHand(targetWorld);
  this->ShowHand();
}

// Beyond the device's reach, and with a workspace that moves, the hand is elsewhere than the
// pointer led it.
void TouchLink::ShowHand()
{
  this->Views.Space()->PlaceHand(this->Study.Current().Touch().HandWorld());
}

void TouchLink::ShowReading()
{
  const StudyTouchReading& reading = this->Study.Reading();
  this->Contents.ShowTouch(reading, true);
  this->ShowHand();
  if (reading.Newest.HasSample && this->Study.State().View.SlicesFollowProbe)
  {
    const PlainVector3& proxy = reading.Newest.ProxyWorld;
    this->Contents.Crosshair()->SetPositionWorld(proxy.X, proxy.Y, proxy.Z);
  }
}

bool TouchLink::eventFilter(QObject* /*object*/, QEvent* event)
{
  if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
  {
    this->Study.SwitchForcesOff();
  }
  return false;
}
} // namespace palpate
