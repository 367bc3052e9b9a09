#pragma once

#include <QObject>

namespace palpate
{
/// How number boxes, choices and sliders of all windows take the wheel and keys. Without the focus
/// the wheel scrolls what they lie in instead of changing them, and shortcuts of the program work
/// while a number box has the focus. A digit that is not taken is answered with the numbers that
/// are.
class FormManners : public QObject
{
  Q_OBJECT

public:
  /// From now on, until it ends.
  explicit FormManners(QObject* parent);

protected:
  bool eventFilter(QObject* object, QEvent* event) override;
};
} // namespace palpate
