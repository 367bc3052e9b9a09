#include "KeyBindings.h"

#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QToolBar>

#include <algorithm>
#include <array>
#include <set>

namespace palpate
{
namespace
{
constexpr const char* Group = "keys"; // of the settings

struct ReservedKey
{
  int Key;
  const char* Use;
};

// Of the views, tables and fields.
constexpr std::array<ReservedKey, 16> Reserved{
    {{Qt::Key_Escape, "stops all force"},
     {Qt::Key_D, "drills"},
     {Qt::Key_R, "fits a slice"},
     {Qt::Key_F2, "renames a structure"},
     {Qt::Key_Up, "scrolls and selects"},
     {Qt::Key_Down, "scrolls and selects"},
     {Qt::Key_Left, "scrolls and selects"},
     {Qt::Key_Right, "scrolls and selects"},
     {Qt::Key_PageUp, "scrolls"},
     {Qt::Key_PageDown, "scrolls"},
     {Qt::Key_Tab, "goes to the next field"},
     {static_cast<int>(Qt::SHIFT) | Qt::Key_Backtab, "goes to the previous field"},
     {Qt::Key_Return, "ends an input"},
     {Qt::Key_Enter, "ends an input"},
     {Qt::Key_Space, "presses a button"},
     {Qt::Key_Backspace, "deletes a letter"}}};

QString SettingOf(const KeyBindings::Entry& entry)
{
  QString name = entry.Name;
  return QString("%1/%2").arg(Group, name.replace('/', '-'));
}

// Without the letter that is underlined, and the step that would be undone.
QString PlainText(const QAction* action)
{
  return action->text().remove('&').section(": ", 0, 0);
}
} // namespace

KeyBindings::KeyBindings(QWidget* window) : Window(window)
{
  for (const auto* bar : window->findChildren<QMenuBar*>())
  {
    this->AddMenu(bar->actions(), {});
  }
  for (const auto* bar : window->findChildren<QToolBar*>())
  {
    this->AddMenu(bar->actions(), {});
  }
  this->TakeKept();
}

void KeyBindings::AddMenu(const QList<QAction*>& actions, const QString& menu)
{
  for (QAction* action : actions)
  {
    if (action->menu() != nullptr)
    {
      this->AddMenu(action->menu()->actions(), PlainText(action));
    }
    else
    {
      this->Add(action, menu);
    }
  }
}

void KeyBindings::Add(QAction* action, const QString& menu)
{
  const bool isThere = std::any_of(this->All.begin(), this->All.end(),
                                   [action](const Entry& one) { return one.Action == action; });
  const QString text = PlainText(action);
  if (!isThere && !action->isSeparator() && !text.isEmpty())
  {
    this->All.push_back({action, menu.isEmpty() ? text : menu + ": " + text, action->shortcut()});
  }
}

// The user's keys come first: a later version of the program may have another use for one.
void KeyBindings::TakeKept()
{
  const QSettings settings;
  std::set<QKeySequence> used;
  std::vector<QAction*> others;
  for (const Entry& entry : this->All)
  {
    const QVariant kept = settings.value(SettingOf(entry));
    const auto key = QKeySequence::fromString(kept.toString(), QKeySequence::PortableText);
    const bool isMeant = kept.isValid() && (key.isEmpty() ? kept.toString().isEmpty()
                                                          : this->WhyReserved(key).isEmpty() &&
                                                                used.insert(key).second);
    if (isMeant)
    {
      entry.Action->setShortcut(key);
    }
    else
    {
      others.push_back(entry.Action);
    }
  }
  for (QAction* other : others)
  {
    if (used.count(other->shortcut()) > 0)
    {
      other->setShortcut(QKeySequence());
    }
  }
}

QString KeyBindings::WhyReserved(const QKeySequence& key) const
{
  const QString name = key.toString(QKeySequence::NativeText);
  if (key.count() != 1 || name.isEmpty())
  {
    return "Choose one key, alone or with Ctrl, Alt or Shift.";
  }
  const auto* reserved = std::find_if(Reserved.begin(), Reserved.end(),
                                      [&key](const ReservedKey& one) { return one.Key == key[0]; });
  if (reserved != Reserved.end())
  {
    return name + " " + reserved->Use + ": choose another key.";
  }
  for (const auto* bar : this->Window->findChildren<QMenuBar*>())
  {
    for (const QAction* menu : bar->actions())
    {
      if (QKeySequence::mnemonic(menu->text()) == key)
      {
        return name + " opens the menu " + PlainText(menu) + ": choose another key.";
      }
    }
  }
  return {};
}

QString KeyBindings::WhyTaken(const QAction* action, const QKeySequence& key) const
{
  for (const QAction* other : this->Window->findChildren<QAction*>())
  {
    if (other != action && other->shortcut() == key)
    {
      return key.toString(QKeySequence::NativeText) + " is the key of \"" + PlainText(other) +
             "\": choose another key, or give that action another one first.";
    }
  }
  return {};
}

QString KeyBindings::Change(std::size_t entry, const QKeySequence& key)
{
  const Entry& changed = this->All.at(entry);
  if (!key.isEmpty())
  {
    const QString reserved = this->WhyReserved(key);
    QString taken = reserved.isEmpty() ? this->WhyTaken(changed.Action, key) : reserved;
    if (!taken.isEmpty())
    {
      return taken;
    }
  }
  changed.Action->setShortcut(key);
  QSettings settings;
  key == changed.Default
      ? settings.remove(SettingOf(changed))
      : settings.setValue(SettingOf(changed), key.toString(QKeySequence::PortableText));
  return {};
}

void KeyBindings::RestoreDefaults()
{
  for (const Entry& entry : this->All)
  {
    entry.Action->setShortcut(entry.Default);
  }
  QSettings().remove(Group);
}
} // namespace palpate
