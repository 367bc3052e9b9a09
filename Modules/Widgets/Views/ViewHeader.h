#pragma once

#include <QColor>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

namespace palpate
{
/// The thin bar over a view: its name in its colour, the slice's number and their count, a slider,
/// and a button that maximises. Its actions are its context menu.
class ViewHeader : public QWidget
{
  Q_OBJECT

public:
  ViewHeader(const QString& name, const QColor& color, QWidget* parent);

  /// From 1; no slider if there are no slices.
  void ShowSlice(int number, int count);

Q_SIGNALS:
  void SliceChosen(int number);
  void MaximizeAsked();

private:
  QLabel* Number;
  QSlider* Slider;
};
} // namespace palpate
