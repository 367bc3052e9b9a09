#include "KeyBindings.h"

#include "KeysPage.h"
#include "PreferencesDialog.h"
#include "WindowTest.h"

#include <QDialogButtonBox>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QScrollBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QTextBrowser>

namespace palpate::key_bindings_test
{
namespace
{
class KeyBindingsTest : public test::WindowTest
{
protected:
  void OpenKeys()
  {
    this->Action("Preferences")->trigger();
    this->Dialog = this->Window->findChild<PreferencesDialog*>();
    auto* tabs = this->Dialog->findChild<QTabWidget*>();
    tabs->setCurrentWidget(tabs->findChild<KeysPage*>());
    QApplication::processEvents();
  }
  QTableWidget* Table() const { return this->Dialog->findChild<QTableWidget*>("keys"); }
  int RowOf(const QString& name) const
  {
    const QList<QTableWidgetItem*> found = this->Table()->findItems(name, Qt::MatchStartsWith);
    EXPECT_EQ(found.size(), 1) << name.toStdString();
    return found.isEmpty() ? 0 : found.front()->row();
  }
  QString KeyOf(const QString& name) const
  {
    return this->Table()->item(this->RowOf(name), 1)->text();
  }
  void Select(const QString& name) { this->Table()->selectRow(this->RowOf(name)); }
  void Type(Qt::Key key, Qt::KeyboardModifiers modifiers)
  {
    auto* edit = this->Dialog->findChild<QKeySequenceEdit*>();
    for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease})
    {
      QKeyEvent event(type, key, modifiers);
      QApplication::sendEvent(edit, &event);
    }
    // The modifier is released last.
    QKeyEvent event(QEvent::KeyRelease, Qt::Key_Control, Qt::NoModifier);
    QApplication::sendEvent(edit, &event);
  }
  QString Message() const { return this->Dialog->findChild<QLabel*>("key-message")->text(); }

  PreferencesDialog* Dialog = nullptr;
};

TEST_F(KeyBindingsTest, ListsEveryActionOfTheMenus)
{
  this->OpenKeys();
  EXPECT_EQ(this->KeyOf("File: Save picture"), "Ctrl+P");
  EXPECT_EQ(this->KeyOf("View: Slices follow the probe"), "Ctrl+F");
  EXPECT_EQ(this->KeyOf("Look from: Posterior"), "Alt+P");
  EXPECT_EQ(this->KeyOf("Touch: Fit workspace"), "");
  EXPECT_EQ(this->KeyOf("Edit: Undo"), "Ctrl+Z");
  this->RowOf("Add landmarks by click");
  for (const QAction* action : this->Window->findChildren<QAction*>())
  {
    if (!action->shortcut().isEmpty())
    {
      const QString name = action->text().remove('&').section(": ", 0, 0);
      EXPECT_FALSE(this->Table()->findItems(name, Qt::MatchEndsWith).isEmpty())
          << name.toStdString();
    }
  }
}

TEST_F(KeyBindingsTest, ChangedKeyActsAtOnceAndAtTheNextStart)
{
  this->OpenKeys();
  this->Select("View: Fit all views");
  this->Type(Qt::Key_K, Qt::ControlModifier);
  EXPECT_EQ(this->Message(), "");
  EXPECT_EQ(this->KeyOf("View: Fit all views"), "Ctrl+K");
  EXPECT_EQ(this->Action("Fit all views")->shortcut(), QKeySequence("Ctrl+K"));
  this->Dialog->close();
  this->Action("Shortcuts and mouse")->trigger();
  const QString help = this->Window->findChild<QTextBrowser*>()->toPlainText();
  EXPECT_TRUE(help.contains("Ctrl+K"));
  EXPECT_FALSE(help.contains("Ctrl+R"));
  const MainWindow next(*this->Study);
  const QList<QAction*> actions = next.findChild<ViewMenu*>()->actions();
  EXPECT_TRUE(std::any_of(actions.begin(), actions.end(),
                          [](const QAction* action)
                          { return action->shortcut() == QKeySequence("Ctrl+K"); }));
}

TEST_F(KeyBindingsTest, KeyOfAnotherActionIsRefused)
{
  this->OpenKeys();
  this->Select("View: Fit all views");
  this->Type(Qt::Key_S, Qt::ControlModifier);
  EXPECT_TRUE(this->Message().startsWith("Ctrl+S is the key of \"Save\""))
      << this->Message().toStdString();
  EXPECT_EQ(this->KeyOf("View: Fit all views"), "Ctrl+R");
  EXPECT_EQ(this->Dialog->findChild<QKeySequenceEdit*>()->keySequence(), QKeySequence("Ctrl+R"));
  EXPECT_EQ(this->Action("Fit all views")->shortcut(), QKeySequence("Ctrl+R"));
}

TEST_F(KeyBindingsTest, KeysOfViewsAndMenusAreRefused)
{
  this->OpenKeys();
  this->Select("View: Fit all views");
  const std::vector<std::tuple<Qt::Key, Qt::KeyboardModifiers, QString>> refused{
      {Qt::Key_Escape, Qt::NoModifier, "stops all force"},
      {Qt::Key_D, Qt::NoModifier, "drills"},
      {Qt::Key_Up, Qt::NoModifier, "scrolls"},
      {Qt::Key_F2, Qt::NoModifier, "renames"},
      {Qt::Key_F, Qt::AltModifier, "opens the menu File"}};
  for (const auto& [key, modifiers, use] : refused)
  {
    this->Type(key, modifiers);
    EXPECT_TRUE(this->Message().contains(use)) << this->Message().toStdString();
    EXPECT_EQ(this->KeyOf("View: Fit all views"), "Ctrl+R");
  }
}

TEST_F(KeyBindingsTest, ActionMayHaveNoKeyAndTheKeyIsThenFree)
{
  this->OpenKeys();
  this->Select("File: Save picture");
  QPushButton* none = this->Dialog->findChild<QPushButton*>("no-key");
  Click(none, none->rect().center());
  EXPECT_TRUE(this->Action("Save picture")->shortcut().isEmpty());
  this->Select("View: Fit all views");
  this->Type(Qt::Key_P, Qt::ControlModifier);
  EXPECT_EQ(this->Action("Fit all views")->shortcut(), QKeySequence("Ctrl+P"));
  MainWindow next(*this->Study);
  const KeyBindings keys(&next);
  for (const KeyBindings::Entry& entry : keys.Entries())
  {
    const QString expected = entry.Name.startsWith("File: Save picture") ? ""
                             : entry.Name == "View: Fit all views"
                                 ? "Ctrl+P"
                                 : entry.Action->shortcut().toString();
    EXPECT_EQ(entry.Action->shortcut().toString(), expected) << entry.Name.toStdString();
  }
}

TEST_F(KeyBindingsTest, DefaultsAreRestored)
{
  this->OpenKeys();
  this->Select("View: Fit all views");
  this->Type(Qt::Key_K, Qt::ControlModifier);
  QPushButton* restore =
      this->Dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults);
  Click(restore, restore->rect().center());
  EXPECT_EQ(this->KeyOf("View: Fit all views"), "Ctrl+R");
  EXPECT_EQ(this->Action("Fit all views")->shortcut(), QKeySequence("Ctrl+R"));
  EXPECT_TRUE(QSettings().allKeys().filter("keys/").isEmpty());
}

// A later version may have another use for a key, and files can be edited.
TEST_F(KeyBindingsTest, KeptKeysNeverBecomeAmbiguous)
{
  QSettings().setValue("keys/View: Fit all views", "Ctrl+S");
  QSettings().setValue("keys/View: Reset window and level", "Ctrl+S");
  QSettings().setValue("keys/File: New study", "Esc");
  QSettings().setValue("keys/File: Quit", "no key at all");
  const MainWindow next(*this->Study);
  std::map<QString, QString> keys;
  for (const QAction* action : next.findChildren<QAction*>())
  {
    const QString key = action->shortcut().toString();
    if (!key.isEmpty())
    {
      EXPECT_EQ(keys.count(key), 0U) << key.toStdString();
      keys[key] = action->text().remove('&');
    }
  }
  EXPECT_EQ(keys["Ctrl+S"], "Reset window and level") << "the first one of the menu";
  EXPECT_EQ(keys["Ctrl+R"], "Fit all views");
  EXPECT_EQ(keys["Ctrl+N"], "New study");
  EXPECT_EQ(keys["Ctrl+Q"], "Quit");
}

TEST_F(KeyBindingsTest, PageFitsASmallScreen)
{
  this->OpenKeys();
  EXPECT_LE(this->Dialog->width(), 900);
  EXPECT_LE(this->Dialog->height(), 640);
  EXPECT_EQ(this->Table()->horizontalScrollBar()->maximum(), 0);
}
} // namespace
} // namespace palpate::key_bindings_test
