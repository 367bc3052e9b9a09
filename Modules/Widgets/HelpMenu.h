#pragma once

#include <QMenu>

namespace palpate
{
/// Shortcuts, mouse actions, and information about the program.
class HelpMenu : public QMenu
{
  Q_OBJECT

public:
  /// Lists the current shortcuts of the window's menus.
  explicit HelpMenu(QWidget* window);

  /// Shortcuts of all menus, and mouse actions.
  QString ShortcutText() const;

private:
  QWidget* Window;
};
} // namespace palpate
