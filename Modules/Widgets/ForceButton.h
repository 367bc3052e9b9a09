#pragma once

#include "StudyController.h"

#include <QPushButton>
#include <QTimer>

namespace palpate
{
/// Stops all force, and allows it again. It never moves nor changes its size. A second press right
/// after a stop does nothing: who presses twice wants no force.
class ForceButton : public QPushButton
{
  Q_OBJECT

public:
  /// Keeps the address.
  ForceButton(StudyController& study, QWidget* parent);

private:
  void Press();
  void Show();

  StudyController& Study;
  QTimer Pause; // after a stop
};
} // namespace palpate
