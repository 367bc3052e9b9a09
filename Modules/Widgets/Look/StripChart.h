#pragma once

#include <QColor>
#include <QString>
#include <QWidget>

#include <cstddef>
#include <vector>

namespace palpate
{
/// A curve over the last seconds, with its limit. Each pixel column shows the minimum and maximum
/// of its time, so that no peak is lost.
class StripChart : public QWidget
{
  Q_OBJECT

public:
  StripChart(const QString& title, const QString& unit, const QColor& color, QWidget* parent);

  /// A dashed line; 0 for none.
  void SetLimit(double limit);
  /// The value at a time, s; times increase. NaN interrupts the curve.
  void Add(double time, double value);
  void Clear();
  /// Number of stored values, and the largest of them.
  std::size_t Count() const { return this->Values.size(); }
  double Largest() const;

  QSize sizeHint() const override { return {220, 80}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  struct Sample
  {
    double Time;
    double Value;
  };
  void DrawCurve(QPainter& painter, const QRectF& frame, double top) const;

  QString Title;
  QString Unit;
  QColor Color;
  double Limit = 0.0;
  std::vector<Sample> Values; ///< of the visible time, and at most as much again
};
} // namespace palpate
