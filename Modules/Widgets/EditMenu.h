#pragma once

#include "StudyController.h"

#include <QMenu>

namespace palpate
{
/// Undo and redo, with the names of the steps.
class EditMenu : public QMenu
{
  Q_OBJECT

public:
  /// Keeps the address.
  EditMenu(StudyController& study, QWidget* window);

private:
  void Show();

  StudyController& Study;
  QAction* Undo;
  QAction* Redo;
};
} // namespace palpate
