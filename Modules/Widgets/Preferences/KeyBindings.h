#pragma once

#include <QAction>
#include <QKeySequence>
#include <QString>
#include <QWidget>

#include <cstddef>
#include <vector>

namespace palpate
{
/// The keys of a window's actions, which the user may change. Kept by QSettings, under the actions'
/// names; an action whose key a user gave to another one has none.
class KeyBindings
{
public:
  struct Entry
  {
    QAction* Action;
    QString Name; ///< with its menu: "File: Open..."
    QKeySequence Default;
  };

  /// Takes the actions that the window's menus and toolbars have now, and gives them their kept
  /// keys.
  explicit KeyBindings(QWidget* window);

  /// In the order of the menus.
  const std::vector<Entry>& Entries() const { return this->All; }
  /// Gives an action another key, of one stroke, or none. Returns why not, or an empty text.
  QString Change(std::size_t entry, const QKeySequence& key);
  void RestoreDefaults();

private:
  void Add(QAction* action, const QString& menu);
  void AddMenu(const QList<QAction*>& actions, const QString& menu);
  void TakeKept();
  QString WhyReserved(const QKeySequence& key) const;
  QString WhyTaken(const QAction* action, const QKeySequence& key) const;

  QWidget* Window;
  std::vector<Entry> All;
};
} // namespace palpate
