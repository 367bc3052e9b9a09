#include "TrialPad.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double UsualReach = 40.0; // mm, of a workspace that is not known
constexpr double BarWidth = 26.0;   // pixels
constexpr double BarGap = 22.0;
constexpr std::size_t MostTrace = 2000;
const QColor Vermilion(213, 94, 0);
const QColor Sky(86, 180, 233);
} // namespace

TrialPad::TrialPad(QWidget* parent) : QWidget(parent)
{
  this->setObjectName("trial-pad");
  this->setMouseTracking(true);
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  this->SetWorkspace({});
}

void TrialPad::SetWorkspace(const Eigen::AlignedBox3d& workspace)
{
  this->Box = workspace.isEmpty() ? Eigen::AlignedBox3d(Vector3::Constant(-UsualReach),
                                                        Vector3::Constant(UsualReach))
                                  : workspace;
  this->Target = this->Box.center();
  this->Clear();
}

void TrialPad::SetWall(std::optional<double> wall)
{
  this->Wall = wall;
  this->Trace.clear();
  this->update();
}

void TrialPad::Clear()
{
  this->Pointer.reset();
  this->Trace.clear();
  this->Force = 0.0;
  this->update();
}

void TrialPad::ShowPointer(const Vector3& place, double force, double mostForce)
{
  this->Pointer = place;
  this->Force = force;
  this->MostForce = std::max(mostForce, 1e-3);
  if (this->Trace.empty() || (this->Trace.back() - place).norm() > 0.5)
  {
    this->Trace.push_back(place);
  }
  if (this->Trace.size() > MostTrace)
  {
    this->Trace.erase(this->Trace.begin());
  }
  this->update();
}

QRectF TrialPad::DepthBar() const
{
  const double title = this->fontMetrics().height();
  return {this->width() - BarWidth - 2.0, title, BarWidth, this->height() - title - 2.0};
}

QRectF TrialPad::Front() const
{
  const QRectF bar = this->DepthBar();
  return {2.0, bar.top(), bar.left() - BarGap - 2.0, bar.height()};
}

double TrialPad::PixelsPerMillimeter() const
{
  const Vector3 size = this->Box.sizes();
  return std::min(this->Front().width() / size.x(), this->Front().height() / size.y());
}

QPointF TrialPad::PixelOf(const Vector3& place) const
{
  const Vector3 offset = this->PixelsPerMillimeter() * (place - this->Box.center());
  return this->Front().center() + QPointF(offset.x(), -offset.y());
}

double TrialPad::PixelOfDepth(double z) const
{
  const double part = (this->Box.max().z() - z) / this->Box.sizes().z();
  return this->DepthBar().top() + std::clamp(part, 0.0, 1.0) * this->DepthBar().height();
}

void TrialPad::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  this->PaintField(painter);
  if (this->Pointer)
  {
    this->PaintPointer(painter);
  }
}

// The reach from the front, and the wall in the bar.
void TrialPad::PaintField(QPainter& painter) const
{
  const QRectF front = this->Front();
  const QRectF bar = this->DepthBar();
  painter.setPen(this->palette().color(QPalette::WindowText));
  painter.drawText(QRectF(0, 0, front.width(), front.top()), Qt::AlignLeft | Qt::AlignVCenter,
                   "From the front");
  painter.drawText(QRectF(bar.left() - 60.0, 0, 60.0 + bar.width(), bar.top()),
                   Qt::AlignRight | Qt::AlignVCenter, "Depth");
  painter.setPen(this->palette().color(QPalette::Mid));
  painter.setBrush(this->palette().color(QPalette::Base));
  const Vector3 size = this->PixelsPerMillimeter() * this->Box.sizes();
  QRectF reach(0.0, 0.0, size.x() - 1.0, size.y() - 1.0);
  reach.moveCenter(front.center());
  painter.drawRect(reach);
  painter.drawRect(bar);
  if (this->Wall)
  {
    const double top = this->PixelOfDepth(*this->Wall);
    painter.fillRect(QRectF(bar.left(), top, bar.width(), bar.bottom() - top),
                     QBrush(Vermilion, Qt::BDiagPattern));
  }
}

void TrialPad::PaintPointer(QPainter& painter) const
{
  const QRectF bar = this->DepthBar();
  painter.setPen(Qt::NoPen);
  painter.setClipRect(this->Front());
  painter.setBrush(QColor(Sky.red(), Sky.green(), Sky.blue(), 70));
  for (const Vector3& place : this->Trace)
  {
    painter.drawEllipse(this->PixelOf(place), 2.0, 2.0);
  }
  const double pushed = std::min(1.0, this->Force / this->MostForce);
  painter.setBrush(pushed > 0.02 ? Vermilion : Sky);
  painter.drawEllipse(this->PixelOf(*this->Pointer), 7.0 + 6.0 * pushed, 7.0 + 6.0 * pushed);
  painter.setClipping(false);
  painter.drawRect(QRectF(bar.left() - 3.0, this->PixelOfDepth(this->Pointer->z()) - 2.0,
                          bar.width() + 6.0, 4.0));
}

void TrialPad::Lead()
{
  constexpr double Deep = 8.0; // mm beyond the wall: a hand pushes with 0.5 N/mm
  Vector3 pushed = this->Target;
  if (this->IsPressed && this->Wall)
  {
    pushed.z() = std::max(*this->Wall - Deep, this->Box.min().z());
  }
  Q_EMIT Led(pushed);
}

void TrialPad::mouseMoveEvent(QMouseEvent* event)
{
  const QPointF offset =
      (QPointF(event->pos()) - this->Front().center()) / this->PixelsPerMillimeter();
  this->Target.x() =
      std::clamp(this->Box.center().x() + offset.x(), this->Box.min().x(), this->Box.max().x());
  this->Target.y() =
      std::clamp(this->Box.center().y() - offset.y(), this->Box.min().y(), this->Box.max().y());
  this->Lead();
}

// A press pushes into the wall wherever the wheel has led the hand.
void TrialPad::mousePressEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton)
  {
    this->IsPressed = true;
    this->Lead();
  }
}

void TrialPad::mouseReleaseEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton)
  {
    this->IsPressed = false;
    this->Lead();
  }
}

void TrialPad::wheelEvent(QWheelEvent* event)
{
  constexpr double PerNotch = 2.0; // mm
  constexpr double Notch = 120.0;
  const double notches = event->angleDelta().y() / Notch;
  this->Target.z() =
      std::clamp(this->Target.z() - PerNotch * notches, this->Box.min().z(), this->Box.max().z());
  this->Lead();
  event->accept();
}

bool TrialPad::event(QEvent* event)
{
  if (event->type() == QEvent::Leave && this->IsPressed)
  {
    this->IsPressed = false;
    this->Lead();
  }
  return QWidget::event(event);
}
} // namespace palpate
