#include "DrawingLink.h"

#include "ToolIcon.h"

#include <QApplication>

#include <utility>

namespace palpate
{
namespace
{
constexpr double StrokeSpacing = 2.0;  // mm
constexpr qint64 LastingContact = 200; // ms

double LengthOf(const std::vector<Vector3>& line)
{
  double length = 0.0;
  for (std::size_t n = 1; n < line.size(); ++n)
  {
    length += (line[n] - line[n - 1]).norm();
  }
  return length;
}
} // namespace

DrawingLink::DrawingLink(StudyController& study, ViewContents& contents, ViewGrid& views,
                         std::function<Vector3()> contact, QObject* parent)
    : QObject(parent), Study(study), Contents(contents), Views(views), Contact(std::move(contact)),
      Drawing(new QAction("Draw by touch", this)), Touched(new QAction("Draw where touched", this))
{
  this->Drawing->setCheckable(true);
  this->Drawing->setShortcut(QString("T"));
  this->Drawing->setIcon(ToolIcon(ToolSign::Draw));
  this->Touched->setShortcut(QString("Shift+T"));
  connect(this->Drawing, &QAction::toggled, this, &DrawingLink::ShowMode);
  connect(this->Touched, &QAction::triggered, this, &DrawingLink::TouchWhereTouched);
  connect(&study, &StudyController::StateChanged, this, &DrawingLink::ShowDrawing);
  connect(&study, &StudyController::Touched, this, &DrawingLink::FollowTouch);
  for (const SliceOrientation orientation : AllSliceOrientations)
  {
    this->FollowSlice(views.Slice(orientation));
  }
  connect(views.Space(), &ViewPane::Tapped, this, &DrawingLink::TakeSpace);
}

void DrawingLink::FollowSlice(SlicePane* slice)
{
  connect(slice, &SlicePane::StrokeBegun, this,
          [this, slice](double x, double y)
          {
            if (this->Drawing->isChecked())
            {
              slice->Accept();
              this->StrokePixel = slice->PixelRight().norm();
              this->Stroke = {slice->PointAt(x, y)};
            }
          });
  connect(slice, &SlicePane::StrokeMoved, this,
          [this, slice](double x, double y)
          {
            if (!this->Stroke.empty())
            {
              this->Stroke.push_back(slice->PointAt(x, y));
              StudyMeasurement line;
              line.Kind = MeasurementKind::Curve;
              line.PointsWorld = this->Stroke;
              this->Contents.ShowPreview(line);
            }
          });
  connect(slice, &SlicePane::StrokeEnded, this, &DrawingLink::TakeStroke);
}

void DrawingLink::Choose(Next next)
{
  if (this->Meant != next)
  {
    this->Meant = next;
    Q_EMIT ChoiceChanged();
  }
}

void DrawingLink::ShowMode()
{
  this->Stroke.clear();
  this->Contents.ShowPreview(std::nullopt);
  this->IsContactTaken = true; // one that was there before
  this->ShowDrawing();
}

void DrawingLink::ShowDrawing()
{
  const DrawnOrgan& organ = this->Study.Current().Drawn().Organ();
  const bool isOn = this->Drawing->isChecked();
  this->Contents.ShowDrawing(organ, isOn ? this->Study.State().Drawing : StudyDrawing(), isOn);
}

void DrawingLink::TakeStroke(bool isOutside)
{
  const std::vector<Vector3> line = std::exchange(this->Stroke, {});
  this->Contents.ShowPreview(std::nullopt);
  if (line.empty())
  {
    return; // it was given up
  }
  const Next meant = isOutside ? Next::Outside : this->Meant;
  const bool isClick = LengthOf(line) < QApplication::startDragDistance() * this->StrokePixel;
  if (isClick || meant != Next::Surface)
  {
    this->TakePoint(meant, line.front());
    return;
  }
  this->Add("Draw a stroke",
            TouchesOfStroke(line, StrokeSpacing, this->Study.State().Drawing.Sigma));
}

void DrawingLink::TakePoint(Next meant, const Vector3& pointWorld)
{
  if (meant == Next::Center)
  {
    StudyState next = this->Study.State();
    next.Drawing.CenterWorld = pointWorld;
    this->Study.Change("Mark the organ's middle", next);
    this->Choose(Next::Surface);
    return;
  }
  SurfaceTouch touch{pointWorld, this->Study.State().Drawing.Sigma};
  touch.IsOutside = meant == Next::Outside;
  this->Add(touch.IsOutside ? "Mark a point outside the organ" : "Touch the organ", {touch});
}

void DrawingLink::TakeSpace(double x, double y)
{
  Vector3 point;
  if (this->Drawing->isChecked() && this->Views.Space()->View()->Pick(x, y, point.data()))
  {
    const bool isOutside = QApplication::keyboardModifiers() & Qt::ControlModifier;
    this->TakePoint(isOutside ? Next::Outside : this->Meant, point);
  }
}

void DrawingLink::TouchWhereTouched()
{
  if (!this->Study.IsTouching())
  {
    this->Study.Report("Touch is off: start touching to draw at the tool's contact.");
    return;
  }
  const StudyTouchReading& reading = this->Study.Reading();
  if (reading.TouchedId == 0)
  {
    this->Study.Report("The tool touches nothing: draw where it touches the organ.");
    return;
  }
  if (reading.TouchedId == StudyDrawn::StructureId)
  {
    this->Study.Report("The tool touches what was drawn, which is no touch of the organ: switch "
                       "off \"Can be felt\" to reach what is below.");
    return;
  }
  // Contacts without friction push along the surface's normal, those with little nearly.
  constexpr double LeastDepth = 0.05; // mm
  const Vector3 out = Vector3(reading.Newest.ProxyWorld) - Vector3(reading.Newest.ProbeWorld);
  SurfaceTouch touch{this->Contact(), this->Study.State().Drawing.Sigma};
  if (out.norm() > LeastDepth)
  {
    touch.Normal = out.normalized();
  }
  this->IsContactTaken = true;
  this->Add("Touch the organ", {touch});
}

void DrawingLink::FollowTouch()
{
  const int touched = this->Study.Reading().TouchedId;
  if (touched == 0 || touched == StudyDrawn::StructureId)
  {
    this->IsContactTaken = false;
    this->SinceContact.invalidate();
    return;
  }
  if (!this->SinceContact.isValid())
  {
    this->SinceContact.start();
  }
  const bool isDue = this->Drawing->isChecked() && this->AreContactsTaken &&
                     !this->IsContactTaken && this->SinceContact.elapsed() >= LastingContact;
  if (isDue)
  {
    this->TouchWhereTouched();
  }
}

void DrawingLink::Add(const QString& message, std::vector<SurfaceTouch> touches)
{
  StudyState next = this->Study.State();
  const Status status = AddTouches(next.Drawing, std::move(touches));
  if (status.IsOk())
  {
    this->Study.Change(message, next);
  }
  else
  {
    this->Study.Report(status.Message());
  }
}
} // namespace palpate
