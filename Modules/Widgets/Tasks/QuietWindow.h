#pragma once

#include <QList>
#include <QMainWindow>
#include <QPointer>

namespace palpate
{
/// A window while a task runs in it: without what would give an answer away or change a condition,
/// which are its menus and their keys, its panels, tools and status, and files that are dropped.
class QuietWindow
{
public:
  explicit QuietWindow(QMainWindow& window) : Window(window) {}

  /// Off: as it was before.
  void Set(bool isQuiet);
  bool IsQuiet() const { return this->IsOn; }

private:
  QMainWindow& Window;
  bool IsOn = false;
  QList<QPointer<QWidget>> Hidden;
};
} // namespace palpate
