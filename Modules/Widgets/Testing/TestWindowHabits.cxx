#include "StructureTableModel.h"
#include "WindowTest.h"

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMenuBar>
#include <QScreen>
#include <QScrollBar>
#include <QTableView>
#include <QTextBrowser>
#include <QToolTip>

#include <set>

namespace palpate::window_habits_test
{
namespace
{
class WindowHabitsTest : public test::WindowTest
{
protected:
  QDoubleSpinBox* Degree()
  {
    for (Section* section : this->Window->findChild<WorkColumn*>()->Sections())
    {
      section->Open(true);
    }
    QApplication::processEvents();
    return this->Window->findChild<QDoubleSpinBox*>("Degree of all");
  }
  // Whether a widget keeps a key from the program's shortcuts.
  static bool Keeps(QWidget* widget, Qt::Key key, Qt::KeyboardModifiers modifiers)
  {
    QKeyEvent event(QEvent::ShortcutOverride, key, modifiers);
    event.ignore();
    QApplication::sendEvent(widget, &event);
    return event.isAccepted();
  }
};

TEST_F(WindowHabitsTest, WheelOverANumberWithoutFocusScrolls)
{
  this->OpenPhantom();
  QDoubleSpinBox* degree = this->Degree();
  QScrollBar* bar = this->Window->findChild<WorkColumn*>()->verticalScrollBar();
  ASSERT_GT(bar->maximum(), 0);
  bar->setValue(0);
  const double before = degree->value();
  Wheel(degree, {5.0, 5.0}, -1);
  Wheel(degree->findChild<QLineEdit*>(), {5.0, 5.0}, -1);
  EXPECT_EQ(degree->value(), before);
  EXPECT_GT(bar->value(), 0);
  Activate(*this->Window);
  degree->setFocus();
  Wheel(degree, {5.0, 5.0}, -1);
  EXPECT_EQ(degree->value(), before - 1.0);
}

TEST_F(WindowHabitsTest, WheelOverTheTableForbidsNothing)
{
  this->OpenPhantom();
  const StudyState before = this->Study->State();
  auto* table = this->Window->findChild<QTableView*>("structures");
  for (int row = 0; row < table->model()->rowCount(); ++row)
  {
    const QModelIndex role = table->model()->index(row, StructureTableModel::DrillColumn);
    Wheel(table->viewport(), table->visualRect(role).center(), -3);
  }
  EXPECT_EQ(this->Study->State(), before);
}

TEST_F(WindowHabitsTest, ShortcutsWorkInANumberBox)
{
  auto* text = this->Degree()->findChild<QLineEdit*>();
  EXPECT_FALSE(Keeps(text, Qt::Key_Z, Qt::ControlModifier));
  EXPECT_FALSE(Keeps(text, Qt::Key_E, Qt::ControlModifier));
  EXPECT_FALSE(Keeps(text, Qt::Key_S, Qt::ControlModifier));
  EXPECT_TRUE(Keeps(text, Qt::Key_C, Qt::ControlModifier));
  EXPECT_TRUE(Keeps(text, Qt::Key_V, Qt::ControlModifier));
  QLineEdit line;
  EXPECT_TRUE(Keeps(&line, Qt::Key_Z, Qt::ControlModifier)) << "a text's own undo";
}

TEST_F(WindowHabitsTest, DigitThatIsNotTakenIsAnsweredWithTheRange)
{
  QDoubleSpinBox* degree = this->Degree();
  const auto type = [degree](Qt::Key key, const QString& text)
  {
    QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier, text);
    QApplication::sendEvent(degree, &event);
    QApplication::processEvents();
  };
  Activate(*this->Window);
  degree->setFocus();
  degree->selectAll();
  type(Qt::Key_9, "9");
  EXPECT_FALSE(QToolTip::isVisible());
  type(Qt::Key_9, "9");
  EXPECT_EQ(QToolTip::text(), "Out of range: from 0 to 64");
  EXPECT_EQ(degree->cleanText(), "9");
  QToolTip::hideText();
}

TEST_F(WindowHabitsTest, NumberThatIsBeingTypedCountsWhenTheWindowCloses)
{
  this->OpenPhantom();
  QDoubleSpinBox* degree = this->Degree();
  Activate(*this->Window);
  degree->setFocus();
  degree->selectAll();
  QKeyEvent seven(QEvent::KeyPress, Qt::Key_7, Qt::NoModifier, "7");
  QApplication::sendEvent(degree, &seven);
  EXPECT_EQ(this->Study->State().Fit.Degree, 12);
  this->Leaving = FileQuestions::Answer::Cancel;
  EXPECT_FALSE(this->Window->close());
  EXPECT_EQ(this->Study->State().Fit.Degree, 7);
  EXPECT_TRUE(this->Window->isWindowModified());
}

TEST_F(WindowHabitsTest, MouseIsNamedAsTheDevice)
{
  auto* device = this->Window->findChild<QComboBox*>("device");
  EXPECT_EQ(device->currentText(), "Mouse (no device)");
  device->setCurrentText("Novint Falcon");
  EXPECT_EQ(this->Study->State().Device, "falcon");
  device->setCurrentText("falcon:2");
  EXPECT_EQ(this->Study->State().Device, "falcon:2");
  device->setCurrentText("Mouse (no device)");
  EXPECT_EQ(this->Study->State().Device, "simulated");
}

TEST_F(WindowHabitsTest, MenusAndShortcutsHaveDifferentKeys)
{
  std::set<QString> menus;
  for (const QAction* action : this->Window->menuBar()->actions())
  {
    menus.insert(QKeySequence::mnemonic(action->text()).toString());
  }
  EXPECT_EQ(menus.size(), static_cast<std::size_t>(this->Window->menuBar()->actions().size()));
  for (const QAction* action : this->Window->findChildren<QAction*>())
  {
    EXPECT_EQ(menus.count(action->shortcut().toString()), 0U) << action->text().toStdString();
  }
}

TEST_F(WindowHabitsTest, ListOfShortcutsFitsTheScreen)
{
  this->OpenPhantom();
  this->Degree()->setValue(7.0); // a step that can be undone
  this->Action("Shortcuts and mouse")->trigger();
  const auto* dialog = this->Window->findChild<QDialog*>();
  ASSERT_NE(dialog, nullptr);
  const QString text = dialog->findChild<QTextBrowser*>()->toPlainText();
  EXPECT_TRUE(text.contains("Add landmarks by click"));
  EXPECT_TRUE(text.contains("drills"));
  EXPECT_FALSE(text.contains("Change the degree"));
  EXPECT_LE(dialog->height(), 0.8 * this->Window->screen()->availableSize().height());
}

TEST_F(WindowHabitsTest, AboutNamesVersionAndLicence)
{
  this->Action("About")->trigger();
  const QString text =
      this->Window->findChild<QDialog*>()->findChild<QTextBrowser*>()->toPlainText();
  for (const char* word : {"Palpate 0.", "BSD", "VTK 9", "Qt " QT_STRINGIFY(QT_VERSION_MAJOR),
                           EIGEN_VERSION_AT_LEAST(3, 4, 90) ? "Eigen 5" : "Eigen 3"})
  {
    EXPECT_TRUE(text.contains(word)) << word;
  }
}

TEST_F(WindowHabitsTest, ProbeFollowsTheWheelAndLeavesWithThePointer)
{
  this->OpenPhantom();
  SlicePane* axial = this->Window->Views()->Slice(SliceOrientation::Axial);
  const QPointF middle(0.5 * axial->Canvas()->width(), 0.5 * axial->Canvas()->height());
  Move(axial->Canvas(), middle);
  const QString before = this->Window->PointText();
  EXPECT_TRUE(before.contains("volume.nii.gz")) << before.toStdString();
  Wheel(axial->Canvas(), middle, 3);
  WaitUntil([&] { return this->Window->PointText() != before; });
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(axial->Canvas(), &leave);
  EXPECT_TRUE(this->Window->PointText().isEmpty());
}

TEST_F(WindowHabitsTest, PlaceHasSidesInsteadOfSigns)
{
  StatusLine line(*this->Study, nullptr);
  line.ShowPoint({-10.3, 4.0, -0.01}, "");
  EXPECT_EQ(line.PointText(), "R 10.3  P 4.0  S 0.0 mm");
  line.ShowPoint({10.3, -4.0, -7.26}, "a");
  EXPECT_EQ(line.PointText(), "L 10.3  A 4.0  I 7.3 mm   a");
}
} // namespace
} // namespace palpate::window_habits_test
