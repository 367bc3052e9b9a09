#pragma once

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

namespace palpate
{
/// Dots over two axes, one per case; a click on one chooses it.
class ScatterChart : public QWidget
{
  Q_OBJECT

public:
  explicit ScatterChart(QWidget* parent = nullptr);

  /// One number of each axis per case; cases with one that is not finite have no dot.
  void SetPoints(const QString& xName, const QString& yName, std::vector<double> x,
                 std::vector<double> y);
  /// -1 for none.
  void Choose(int index);
  int Chosen() const { return this->ChosenIndex; }
  /// In the widget's pixels; nothing for a case without a dot.
  std::optional<QPointF> PlaceOf(int index) const;
  QSize sizeHint() const override { return {320, 220}; }

Q_SIGNALS:
  void Clicked(int index);

protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

private:
  struct Range
  {
    double Low = 0.0;
    double High = 1.0;
  };
  static Range RangeOf(const std::vector<double>& values);
  QRectF Frame() const;

  QString XName;
  QString YName;
  std::vector<double> X;
  std::vector<double> Y;
  Range XRange;
  Range YRange;
  int ChosenIndex = -1;
};
} // namespace palpate
