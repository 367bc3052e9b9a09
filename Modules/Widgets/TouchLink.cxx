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
  connect(views.Space(), &SpacePane::HandMoved, &study, &StudyController::MoveHand);
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
}

Vector3 TouchLink::FirstHand() const
{
  StudyTouch& touch = this->Study.Current().Touch();
  const WorkspaceFrame& frame = touch.Frame();
  const double reach = 0.5 * touch.Capabilities().Workspace.sizes().minCoeff();
  const Vector3 towardsViewer = this->Views.Space()->Axes().col(2);
  return frame.CenterWorld + frame.Scale * reach * towardsViewer;
}

void TouchLink::Begin()
{
  const bool isTouching = this->Study.IsTouching();
  Vector3 hand = Vector3::Zero();
  bool isSimulated = false;
  if (isTouching)
  {
    hand = this->FirstHand();
    isSimulated = this->Study.Current().Touch().MoveHand(hand);
  }
  this->Views.Space()->SetHand(isSimulated, hand);
  this->Contents.ShowTouch(this->Study.Reading(), isTouching);
}

void TouchLink::ShowReading()
{
  const StudyTouchReading& reading = this->Study.Reading();
  this->Contents.ShowTouch(reading, true);
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
