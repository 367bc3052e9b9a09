#pragma once

#include "KeysPage.h"
#include "Preferences.h"

#include <QComboBox>
#include <QDialog>
#include <QFormLayout>
#include <QSpinBox>
#include <QTabWidget>

namespace palpate
{
/// The user's preferences; each change is kept and told at once.
class PreferencesDialog : public QDialog
{
  Q_OBJECT

public:
  /// Keeps the address.
  PreferencesDialog(KeyBindings& keys, QWidget* window);

Q_SIGNALS:
  void Changed(const Preferences& preferences);

private:
  QWidget* MakeGeneral();
  QComboBox* AddChoice(QFormLayout* form, const QString& label, const char* name,
                       const QStringList& texts);
  void ShowGeneral(const Preferences& preferences);
  void TakeGeneral();
  void RestoreDefaults();

  QTabWidget* Pages;
  KeysPage* Keys;
  QComboBox* Look = nullptr;
  QComboBox* LeftDrag = nullptr;
  QComboBox* Convention = nullptr;
  QComboBox* Unit;
  QSpinBox* Degree = nullptr;
  QComboBox* ErrorScale = nullptr;
};
} // namespace palpate
