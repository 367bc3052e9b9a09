// A pen pushes by its pressure; and a push is felt together with a guide.
#include "WindowTest.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <QTabletEvent>
#include <QtGlobal>
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
#include <QPointingDevice>
#endif

namespace palpate::pen_touch_test
{
namespace
{
using test::Norm;

class PenTouchTest : public test::WindowTest
{
protected:
  // Starts touching the sphere alone.
  void Start()
  {
    this->OpenPhantom();
    StudyState next = this->Study->State();
    next.Structures.resize(1);
    this->Study->Change("Keep the ball", next);
    this->BeginTouch();
  }
  QWidget* Canvas() const { return this->Window->Views()->Space()->Canvas(); }
  QPointF Place() const { return this->PlaceOf(this->SphereCenter); }

  // As a window system does: the pen's event, and then that of a mouse if nobody has accepted it.
  void Pen(QEvent::Type type, double pressure)
  {
    const QPointF place = this->Place();
    const QPointF global = this->Canvas()->mapToGlobal(place.toPoint());
    const bool isPress = type == QEvent::TabletPress;
    const bool isRelease = type == QEvent::TabletRelease;
    const auto button = isPress || isRelease ? Qt::LeftButton : Qt::NoButton;
    const Qt::MouseButtons buttons = pressure > 0.0 ? Qt::LeftButton : Qt::NoButton;
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
    QTabletEvent event(type, QPointingDevice::primaryPointingDevice(), place, global, pressure,
                       0.0F, 0.0F, 0.0F, 0.0, 0.0F, Qt::NoModifier, button, buttons);
#else
    QTabletEvent event(type, place, global, QTabletEvent::Stylus, QTabletEvent::Pen, pressure, 0, 0,
                       0.0, 0.0, 0, Qt::NoModifier, 1, button, buttons);
#endif
    QApplication::sendEvent(this->Canvas(), &event);
    EXPECT_FALSE(event.isAccepted());
    SendMouse(this->Canvas(),
              isPress     ? QEvent::MouseButtonPress
              : isRelease ? QEvent::MouseButtonRelease
                          : QEvent::MouseMove,
              place, button, buttons);
  }
  double Force() const
  {
    return Norm(this->Study->Reading().Newest.ForceWorld);
  }
  // N, once it changes no more.
  double SteadyForce()
  {
    constexpr double Steady = 0.01; // N, in a fifth of a second
    double before = -1.0;
    std::uint64_t since = 0;
    this->FeelUntil(
        [&]
        {
          const std::uint64_t tick = this->Study->Reading().Newest.Tick.Number;
          const bool isSteady = std::abs(this->Force() - before) < Steady;
          before = isSteady ? before : this->Force();
          since = isSteady ? since : tick;
          return tick > since + 200;
        });
    return this->Force();
  }

  const Vector3 SphereCenter{-15.0, 0.0, 0.0};
};

TEST_F(PenTouchTest, PressureIsTheForce)
{
  this->Start();
  this->Pen(QEvent::TabletMove, 0.0);
  EXPECT_EQ(this->SteadyForce(), 0.0) << "it hovers";
  this->Pen(QEvent::TabletPress, 0.3);
  this->FeelUntil([this] { return this->Force() > 0.1; });
  const double light = this->SteadyForce();
  this->Pen(QEvent::TabletMove, 0.9);
  const double firm = this->SteadyForce();
  EXPECT_GT(firm, 1.5 * light);
  this->Pen(QEvent::TabletMove, 0.3);
  EXPECT_LT(this->SteadyForce(), 0.5 * (light + firm));
  this->Pen(QEvent::TabletRelease, 0.0);
  this->FeelUntil([this] { return this->Force() == 0.0; });
}

TEST_F(PenTouchTest, PenPlacesMarksWithoutPushing)
{
  this->Start();
  this->Pen(QEvent::TabletMove, 0.0);
  this->SteadyForce(); // the hand has arrived
  this->Button("add-landmarks")->setChecked(true);
  this->Pen(QEvent::TabletPress, 0.9);
  EXPECT_EQ(this->SteadyForce(), 0.0);
  this->Pen(QEvent::TabletRelease, 0.0);
  EXPECT_EQ(this->Study->State().Landmarks.size(), 1U) << this->Messages();
}

// A point above the place that is pressed draws the tool upwards.
TEST_F(PenTouchTest, GuideIsFeltWhileThePenPushes)
{
  this->Start();
  this->Pen(QEvent::TabletMove, 0.0);
  vtkCamera* camera = this->Window->Views()->Space()->Renderer()->GetActiveCamera();
  const Vector3 up = Vector3(camera->GetViewUp());
  this->Pen(QEvent::TabletPress, 0.5);
  this->FeelUntil([this] { return this->Force() > 0.1; });
  this->SteadyForce();
  const TouchState& newest = this->Study->Reading().Newest;
  const double without = Vector3(newest.ForceWorld).dot(up);
  GuideSettings guide;
  guide.PointsWorld = {Vector3(newest.ProxyWorld) + 15.0 * up};
  guide.Range = 40.0;
  guide.LargestForce = 1.0;
  StudyState next = this->Study->State();
  next.Guides = {guide};
  this->Study->Change("guide", next);
  const auto isGuided = [&] { return Vector3(newest.ForceWorld).dot(up) > without + 0.3; };
  this->FeelUntil([&] { return isGuided() && this->Study->Reading().TouchedId == 1; });
  this->Pen(QEvent::TabletRelease, 0.0);
  this->FeelUntil([&] { return isGuided() && this->Study->Reading().TouchedId == 0; });
}
} // namespace
} // namespace palpate::pen_touch_test
