#include "StripChart.h"

#include "RoundNumber.h"
#include "TextContrast.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Seconds = 5.0;
constexpr double Headroom = 1.1;
} // namespace

StripChart::StripChart(const QString& title, const QString& unit, const QColor& color,
                       QWidget* parent)
    : QWidget(parent), Title(title), Unit(unit), Color(color)
{
  this->setMinimumSize(120, 60);
}

void StripChart::SetLimit(double limit)
{
  this->Limit = limit;
  this->update();
}

void StripChart::Add(double time, double value)
{
  // Time starts again, such as in another touch.
  if (!this->Values.empty() && time < this->Values.back().Time)
  {
    this->Values.clear();
  }
  this->Values.push_back(
      {time, std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN()});
  const auto isOld = [time](const Sample& sample) { return sample.Time < time - Seconds; };
  // Removes values in large blocks, so that adding one is cheap.
  if (isOld(this->Values[this->Values.size() / 2]))
  {
    this->Values.erase(this->Values.begin(),
                       std::find_if_not(this->Values.begin(), this->Values.end(), isOld));
  }
  this->update();
}

void StripChart::Clear()
{
  this->Values.clear();
  this->update();
}

double StripChart::Largest() const
{
  double largest = 0.0;
  for (const Sample& sample : this->Values)
  {
    const bool isShown = sample.Time >= this->Values.back().Time - Seconds;
    largest = isShown && sample.Value > largest ? sample.Value : largest;
  }
  return largest;
}

void StripChart::DrawCurve(QPainter& painter, const QRectF& frame, double top) const
{
  const double start = this->Values.back().Time - Seconds;
  const auto columns = static_cast<std::size_t>(std::max(1.0, frame.width()));
  std::vector<QLineF> lines;
  auto sample = this->Values.begin();
  double last = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t c = 0; c < columns; ++c)
  {
    const double end = start + Seconds * static_cast<double>(c + 1) / static_cast<double>(columns);
    double low = last;
    double high = last;
    for (; sample != this->Values.end() && sample->Time <= end; ++sample)
    {
      low = std::fmin(low, sample->Value);
      high = std::fmax(high, sample->Value);
      last = sample->Value;
    }
    if (std::isfinite(low) && std::isfinite(high))
    {
      const double x = frame.left() + static_cast<double>(c) + 0.5;
      const double scale = frame.height() / top;
      lines.emplace_back(x, frame.bottom() - scale * low, x, frame.bottom() - scale * high - 1.0);
    }
  }
  painter.setPen(ReadableOn(this->palette().color(QPalette::Base), this->Color));
  painter.drawLines(lines.data(), static_cast<int>(lines.size()));
}

void StripChart::paintEvent(QPaintEvent* /*event*/)
{
  QPainter painter(this);
  const int line = this->fontMetrics().height();
  const QRectF frame = QRectF(this->rect()).adjusted(2.0, line + 2.0, -2.0, -2.0);
  const double top =
      RoundNumberAbove(std::max(Headroom * std::max(this->Largest(), this->Limit), 1e-9));
  painter.fillRect(frame, this->palette().base());
  const QString now =
      this->Values.empty()
          ? QString()
          : QString(": %1 %2").arg(this->Values.back().Value, 0, 'g', 3).arg(this->Unit);
  painter.drawText(2, this->fontMetrics().ascent(), this->Title + now);
  const QString scale = QString("%1 %2").arg(top).arg(this->Unit);
  painter.drawText(this->width() - 2 - this->fontMetrics().horizontalAdvance(scale),
                   this->fontMetrics().ascent(), scale);
  if (!this->Values.empty())
  {
    this->DrawCurve(painter, frame, top);
  }
  if (this->Limit > 0.0)
  {
    const double y = frame.bottom() - frame.height() * this->Limit / top;
    painter.setPen(QPen(this->palette().text().color(), 1.0, Qt::DashLine));
    painter.drawLine(QPointF(frame.left(), y), QPointF(frame.right(), y));
  }
}
} // namespace palpate
