#pragma once

#include "ValueHistogram.h"

#include <QWidget>

namespace palpate
{
/// A histogram with a chosen range of values. Heights are logarithmic, since most voxels of a
/// volume are air. A click or drag asks for a value.
class HistogramView : public QWidget
{
  Q_OBJECT

public:
  HistogramView(const ValueHistogram& histogram, QWidget* parent);

  void ShowRange(double lower, double upper);

  QSize sizeHint() const override { return {360, 120}; }
  QSize minimumSizeHint() const override { return {160, 60}; }

Q_SIGNALS:
  void ValueAsked(double value);

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

private:
  double PlaceOf(double value) const;
  void AskFor(const QPointF& place);

  ValueHistogram Histogram;
  double Lower = 0.0;
  double Upper = 0.0;
};
} // namespace palpate
