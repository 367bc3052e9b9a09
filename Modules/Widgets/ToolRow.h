#pragma once

#include "StudyController.h"

#include <QToolBar>

namespace palpate
{
/// What is used most, in a thin row, with the button that stops all force always at its right end.
class ToolRow : public QToolBar
{
  Q_OBJECT

public:
  /// Keeps the address of the study.
  ToolRow(StudyController& study, QWidget* window);

  /// Adds buttons for actions of the menus, and a line before them. An action with a menu opens it.
  void Add(const QList<QAction*>& actions);

private:
  QToolBar* Buttons;
};
} // namespace palpate
