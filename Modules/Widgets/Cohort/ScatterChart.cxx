#include "ScatterChart.h"

#include "DecimalText.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr double DotRadius = 3.5; // pixels
constexpr double ClickRadius = 9.0;
constexpr double EmptyShare = 0.05; // of the range, beside the outermost dots

QString AxisNumber(double value)
{
  return QString::fromStdString(SignificantText(value, 3));
}
} // namespace

ScatterChart::ScatterChart(QWidget* parent) : QWidget(parent)
{
  this->setMinimumSize(200, 90);
  this->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  this->setAccessibleName("Scatter of two columns");
}

void ScatterChart::SetPoints(const QString& xName, const QString& yName, std::vector<double> x,
                             std::vector<double> y)
{
  this->XName = xName;
  this->YName = yName;
  this->X = std::move(x);
  this->Y = std::move(y);
  this->XRange = RangeOf(this->X);
  this->YRange = RangeOf(this->Y);
  this->update();
}

void ScatterChart::Choose(int index)
{
  this->ChosenIndex = index;
  this->update();
}

ScatterChart::Range ScatterChart::RangeOf(const std::vector<double>& values)
{
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double value : values)
  {
    if (std::isfinite(value))
    {
      range = {std::min(range.Low, value), std::max(range.High, value)};
    }
  }
  if (!(range.Low <= range.High))
  {
    return {};
  }
  const double margin = range.High > range.Low ? EmptyShare * (range.High - range.Low) : 1.0;
  return {range.Low - margin, range.High + margin};
}

QRectF ScatterChart::Frame() const
{
  const int line = this->fontMetrics().height();
  return QRectF(this->rect()).adjusted(4.0 * line, 0.5 * line, -0.5 * line, -2.5 * line);
}

std::optional<QPointF> ScatterChart::PlaceOf(int index) const
{
  const auto i = static_cast<std::size_t>(index);
  if (index < 0 || i >= std::min(this->X.size(), this->Y.size()) || !std::isfinite(this->X[i]) ||
      !std::isfinite(this->Y[i]))
  {
    return std::nullopt;
  }
  const QRectF frame = this->Frame();
  const double x = (this->X[i] - this->XRange.Low) / (this->XRange.High - this->XRange.Low);
  const double y = (this->Y[i] - this->YRange.Low) / (this->YRange.High - this->YRange.Low);
  return QPointF(frame.left() + x * frame.width(), frame.bottom() - y * frame.height());
}

void ScatterChart::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF frame = this->Frame();
  const int line = this->fontMetrics().height();
  painter.setPen(this->palette().color(QPalette::Mid));
  painter.drawRect(frame);
  painter.setPen(this->palette().color(QPalette::WindowText));
  const QRectF below(frame.left(), frame.bottom() + 2.0, frame.width(), line);
  painter.drawText(below, Qt::AlignLeft, AxisNumber(this->XRange.Low));
  painter.drawText(below, Qt::AlignRight, AxisNumber(this->XRange.High));
  painter.drawText(below.translated(0.0, line), Qt::AlignCenter, this->XName);
  const QRectF beside(0.0, frame.top(), frame.left() - 4.0, frame.height());
  painter.drawText(beside, Qt::AlignRight | Qt::AlignTop, AxisNumber(this->YRange.High));
  painter.drawText(beside, Qt::AlignRight | Qt::AlignBottom, AxisNumber(this->YRange.Low));
  painter.save();
  painter.translate(0.0, frame.center().y());
  painter.rotate(-90.0);
  painter.drawText(QRectF(-0.5 * frame.height(), 0.0, frame.height(), line), Qt::AlignCenter,
                   this->YName);
  painter.restore();
  const QColor dot = this->palette().color(QPalette::Highlight);
  for (int i = 0; i < static_cast<int>(this->X.size()); ++i)
  {
    if (const auto place = this->PlaceOf(i); place && i != this->ChosenIndex)
    {
      painter.setPen(Qt::NoPen);
      painter.setBrush(QColor(dot.red(), dot.green(), dot.blue(), 150));
      painter.drawEllipse(*place, DotRadius, DotRadius);
    }
  }
  if (const auto place = this->PlaceOf(this->ChosenIndex))
  {
    painter.setPen(QPen(this->palette().color(QPalette::WindowText), 1.5));
    painter.setBrush(QColor("#D55E00"));
    painter.drawEllipse(*place, 1.5 * DotRadius, 1.5 * DotRadius);
  }
}

void ScatterChart::mousePressEvent(QMouseEvent* event)
{
  int nearest = -1;
  double least = ClickRadius;
  for (int i = 0; i < static_cast<int>(this->X.size()); ++i)
  {
    if (const auto place = this->PlaceOf(i))
    {
      const QPointF offset = *place - event->pos();
      const double distance = std::hypot(offset.x(), offset.y());
      nearest = distance < least ? i : nearest;
      least = std::min(least, distance);
    }
  }
  if (nearest >= 0)
  {
    Q_EMIT this->Clicked(nearest);
  }
}
} // namespace palpate
