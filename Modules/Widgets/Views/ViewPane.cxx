#include "ViewPane.h"

#include "ViewContents.h"

#include "vtkCommand.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkInteractorStyle.h"
#include "vtkLinkedView.h"
#include "vtkRenderWindowInteractor.h"

#include <QApplication>
#include <QTimer>
#include <QVBoxLayout>

namespace palpate
{
ViewCanvas::ViewCanvas(QWidget* parent) : QVTKOpenGLNativeWidget(parent)
{
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1); // depth peeling needs them
  this->setRenderWindow(window);
  this->interactor()->EnableRenderOff();
  this->setMouseTracking(true);
  this->setFocusPolicy(Qt::StrongFocus);
}

// VTK's widget expects the interactor to draw the first frame, and that of a new size, here;
// otherwise later ones are never shown.
void ViewCanvas::paintGL()
{
  this->interactor()->EnableRenderOn();
  QVTKOpenGLNativeWidget::paintGL();
  this->interactor()->EnableRenderOff();
}

ViewPane::ViewPane(const QString& name, const QColor& color, QWidget* parent)
    : QWidget(parent), Title(name), Bar(new ViewHeader(name, color, this)),
      RasterImage(new ViewCanvas(this)), Banner(new ViewBanner(RasterImage))
{
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(this->Bar);
  column->addWidget(this->RasterImage, 1);
  this->RasterImage->renderWindow()->AddRenderer(this->Scene);
  this->RasterImage->installEventFilter(this);
  // Requests to the interactor, such as a style's at each mouse move, are drawn in the next turn.
  this->Links->Connect(this->RasterImage->interactor(), vtkCommand::RenderEvent, this,
                       SLOT(RequestRender()));
  connect(this->Bar, &ViewHeader::MaximizeAsked, this, &ViewPane::MaximizeAsked);
}

void ViewPane::SetStyle(vtkInteractorStyle* style)
{
  this->RasterImage->interactor()->SetInteractorStyle(style);
}

void ViewPane::Show(vtkLinkedView* view, const ViewContents& contents)
{
  this->Shown = view;
  view->SetImageDisplay(contents.Images());
  view->SetCrosshair(contents.Crosshair());
  view->SetLandmarks(contents.Landmarks());
  view->SetProbe(contents.Probe());
  view->SetRenderer(this->Scene);
  this->Follow(contents.Images());
  this->Follow(contents.Crosshair());
  this->Follow(contents.Landmarks());
  this->Follow(contents.Probe());
  this->AddSurface(contents.Workspace());
  this->AddSurface(contents.Held());
  this->AddSurface(contents.Drawing().Display());
  this->AddSurface(contents.Correction().Display());
  this->AddSurface(contents.Correction().Stroke());
}

void ViewPane::AddSurface(vtkSurfaceDisplay* surface)
{
  this->Shown->AddSurface(surface);
  this->Follow(surface);
}

void ViewPane::RemoveSurface(vtkSurfaceDisplay* surface)
{
  this->Shown->RemoveSurface(surface);
  this->Unfollow(surface);
}

void ViewPane::SetAlongImage(bool isAlongImage)
{
  this->Shown->SetAlongImage(isAlongImage);
  this->RequestRender();
}

void ViewPane::SetLengthUnit(LengthUnit unit)
{
  this->Shown->SetCentimeters(unit == LengthUnit::Centimeter);
  this->RequestRender();
}

void ViewPane::Follow(vtkObject* shared)
{
  this->Links->Connect(shared, vtkCommand::ModifiedEvent, this, SLOT(RequestRender()));
  this->RequestRender();
}

void ViewPane::Unfollow(vtkObject* shared)
{
  this->Links->Disconnect(shared, vtkCommand::ModifiedEvent, this);
  this->RequestRender();
}

void ViewPane::RequestRender()
{
  this->Stir();
  this->RequestFrame();
}

void ViewPane::RequestFrame()
{
  if (!this->IsDue)
  {
    this->IsDue = true;
    QTimer::singleShot(0, this, &ViewPane::RenderNow);
  }
}

void ViewPane::RenderNow()
{
  // A hidden view is drawn when it is shown.
  const bool draws = this->IsDue && this->RasterImage->isVisible() && this->RasterImage->isValid();
  this->IsDue = false;
  if (draws)
  {
    this->RasterImage->renderWindow()->Render();
    ++this->Drawn;
    Q_EMIT Rendered();
  }
}

void ViewPane::SetStrokes(bool areOn)
{
  this->AreStrokesOn = areOn;
  this->IsStroke = false;
}

// Returns whether nobody else gets the event.
bool ViewPane::TakeStroke(QEvent* event)
{
  const QEvent::Type type = event->type();
  if (type == QEvent::Wheel)
  {
    return this->TakeWheel(static_cast<const QWheelEvent&>(*event));
  }
  const bool isMove = type == QEvent::MouseMove;
  const bool isPress = type == QEvent::MouseButtonPress || type == QEvent::MouseButtonDblClick;
  if (!isMove && !isPress && type != QEvent::MouseButtonRelease)
  {
    return false;
  }
  const auto& mouse = static_cast<const QMouseEvent&>(*event);
  const QPointF place = this->PlaceOf(mouse);
  if (isMove)
  {
    if (this->IsStroke)
    {
      Q_EMIT PointerMoved(place.x(), place.y());
      Q_EMIT StrokeMoved(place.x(), place.y());
    }
    return this->IsStroke;
  }
  if (mouse.button() != Qt::LeftButton)
  {
    return false;
  }
  const bool wasStroke = this->IsStroke;
  this->IsStroke = false;
  if (isPress)
  {
    this->HadControl = mouse.modifiers() & Qt::ControlModifier;
    this->IsAccepted = false;
    Q_EMIT StrokeBegun(place.x(), place.y(), this->HadControl);
    this->IsStroke = this->IsAccepted;
    return this->IsStroke;
  }
  if (wasStroke)
  {
    Q_EMIT StrokeEnded(this->HadControl);
  }
  return wasStroke;
}

bool ViewPane::TakeWheel(const QWheelEvent& wheel)
{
  constexpr double Notch = 120.0; // of Qt: eighths of a degree
  if (wheel.modifiers() & (Qt::ShiftModifier | Qt::ControlModifier))
  {
    return false;
  }
  const QPointF place = this->OnCanvas(wheel.position());
  this->IsAccepted = false;
  Q_EMIT WheelTurned(place.x(), place.y(), wheel.angleDelta().y() / Notch);
  return this->IsAccepted;
}

QPointF ViewPane::OnCanvas(const QPointF& place) const
{
  const double ratio = this->RasterImage->devicePixelRatioF();
  return {ratio * place.x(), ratio * (this->RasterImage->height() - 1 - place.y())};
}

bool ViewPane::TakeMouse(QEvent* event)
{
  auto* mouse = static_cast<QMouseEvent*>(event);
  const QPointF place = this->PlaceOf(*mouse);
  const double x = place.x();
  const double y = place.y();
  if (event->type() == QEvent::MouseMove)
  {
    Q_EMIT PointerMoved(x, y);
    return false;
  }
  if (mouse->button() != Qt::LeftButton)
  {
    return false;
  }
  const bool wasPressed = this->IsPressed;
  this->IsPressed = event->type() == QEvent::MouseButtonPress;
  switch (event->type())
  {
  case QEvent::MouseButtonDblClick:
    Q_EMIT MaximizeAsked();
    return true;
  case QEvent::MouseButtonPress:
    this->Pressed = mouse->pos();
    Q_EMIT Clicked(x, y);
    return false;
  default:
    if (wasPressed &&
        (mouse->pos() - this->Pressed).manhattanLength() < QApplication::startDragDistance())
    {
      Q_EMIT Tapped(x, y);
    }
    return false;
  }
}

bool ViewPane::eventFilter(QObject* object, QEvent* event)
{
  if (this->AreStrokesOn && this->TakeStroke(event))
  {
    return true;
  }
  switch (event->type())
  {
  case QEvent::MouseMove:
  case QEvent::MouseButtonPress:
  case QEvent::MouseButtonRelease:
  case QEvent::MouseButtonDblClick:
    return this->TakeMouse(event);
  case QEvent::Leave:
    Q_EMIT PointerLeft();
    break;
  case QEvent::Show:
  case QEvent::Resize:
    this->RequestRender();
    break;
  default:
    break;
  }
  return QWidget::eventFilter(object, event);
}
} // namespace palpate
