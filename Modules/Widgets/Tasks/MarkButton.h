#pragma once

#include "TaskWatch.h"

#include <QPushButton>

namespace palpate
{
/// Marks the place where the tool touches; also by the space bar and the device's first button.
class MarkButton : public QPushButton
{
  Q_OBJECT

public:
  explicit MarkButton(QWidget* parent);

  /// The tool as it is now.
  void Take(const TouchState& newest, const TaskWatch& watch);

Q_SIGNALS:
  void Marked(const Vector3& tipWorld);

private:
  Vector3 Tip = Vector3::Zero(); // world, mm
  bool HasTip = false;
  bool IsHeld = true; // the device's button, which may be from before
};
} // namespace palpate
