#pragma once

#include "StudyController.h"

#include <QPushButton>
#include <QTimer>

namespace palpate
{
/// Stops all force, and allows it again. It never moves nor changes its size.
///
/// A press right after force ended, whatever ended it, does nothing: it was meant as a stop. While
/// a fault ends by itself the button still stops.
class ForceButton : public QPushButton
{
  Q_OBJECT

public:
  /// Keeps the address.
  ForceButton(StudyController& study, QWidget* parent);
  /// Whether there is no force until somebody allows it: not while a fault ends by itself.
  static bool IsOff(const SafetyReport& safety);

private:
  void Press();
  void Show();

  StudyController& Study;
  QTimer Pause; // after force ended
  bool WasOff = false;
};
} // namespace palpate
