#include "HistogramView.h"

#include "PointerPlace.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
const QColor RangeColor(255, 140, 0, 110); // as the slices show it
} // namespace

HistogramView::HistogramView(const ValueHistogram& histogram, QWidget* parent)
    : QWidget(parent), Histogram(histogram)
{
  this->setObjectName("histogram");
  this->setToolTip("How often each value occurs, on a logarithmic scale. Click to choose the lower "
                   "value.");
  this->setCursor(Qt::CrossCursor);
}

void HistogramView::ShowRange(double lower, double upper)
{
  this->Lower = lower;
  this->Upper = upper;
  this->update();
}

double HistogramView::PlaceOf(double value) const
{
  const double share =
      (value - this->Histogram.First) / (this->Histogram.Last - this->Histogram.First);
  return std::clamp(share, 0.0, 1.0) * this->width();
}

void HistogramView::paintEvent(QPaintEvent* /*event*/)
{
  QPainter painter(this);
  painter.fillRect(this->rect(), this->palette().base());
  const auto& counts = this->Histogram.Counts;
  const auto most = static_cast<double>(*std::max_element(counts.begin(), counts.end()));
  const double scale = most > 0.0 ? (this->height() - 2.0) / std::log1p(most) : 0.0;
  const double step = this->width() / static_cast<double>(counts.size());
  for (std::size_t bin = 0; bin < counts.size(); ++bin)
  {
    const double height = scale * std::log1p(static_cast<double>(counts[bin]));
    const QRectF bar(step * static_cast<double>(bin), this->height() - height, step, height);
    painter.fillRect(bar, this->palette().color(QPalette::Mid));
  }
  const double from = this->PlaceOf(this->Lower);
  painter.fillRect(QRectF(from, 0.0, this->PlaceOf(this->Upper) - from, this->height()),
                   RangeColor);
  painter.setPen(this->palette().color(QPalette::Text));
  painter.drawLine(QPointF(from, 0.0), QPointF(from, this->height()));
}

void HistogramView::AskFor(const QPointF& place)
{
  const double share = std::clamp(place.x() / std::max(1, this->width()), 0.0, 1.0);
  Q_EMIT ValueAsked(this->Histogram.First + share * (this->Histogram.Last - this->Histogram.First));
}

void HistogramView::mousePressEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton)
  {
    this->AskFor(PointerPlace(*event));
  }
}

void HistogramView::mouseMoveEvent(QMouseEvent* event)
{
  if ((event->buttons() & Qt::LeftButton) != 0)
  {
    this->AskFor(PointerPlace(*event));
  }
}
} // namespace palpate
