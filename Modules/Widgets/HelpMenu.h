#pragma once

#include <QMenu>

namespace palpate
{
/// What keys and mouse do, and what this program is.
class HelpMenu : public QMenu
{
  Q_OBJECT

public:
  /// Lists the shortcuts of the window's menus, as they are when asked for.
  explicit HelpMenu(QWidget* window);

  /// Of all menus, and the mouse's.
  QString ShortcutText() const;

private:
  QWidget* Window;
};
} // namespace palpate
