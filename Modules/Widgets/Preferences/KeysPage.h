#pragma once

#include "KeyBindings.h"

#include <QKeySequenceEdit>
#include <QLabel>
#include <QTableWidget>
#include <QWidget>

namespace palpate
{
/// The page of the preferences that lists every action with its key, and changes the key of the
/// selected one.
class KeysPage : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the address.
  KeysPage(KeyBindings& keys, QWidget* parent);

  void RestoreDefaults();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QKeySequence SelectedKey() const;
  void ShowKeys();
  void ShowSelected();
  void Take(const QKeySequence& key);

  KeyBindings& Keys;
  QTableWidget* Table;
  QKeySequenceEdit* Edit;
  QLabel* Message;
};
} // namespace palpate
