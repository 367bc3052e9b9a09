#include "StructuresPanel.h"

#include "DrillRole.h"
#include "QualityPanel.h"
#include "WidgetTest.h"

#include <QAbstractItemView>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QScrollBar>
#include <QSettings>
#include <QSpinBox>
#include <QTest>

#include <chrono>

namespace palpate::structures_panel_test
{
namespace
{
constexpr int Count = 116; // as many as AAL has

using Column = StructureTableModel::Column;

// The panel alone, with structures whose file is missing, so that nothing is computed.
class StructuresPanelTest : public test::WidgetTest
{
protected:
  void SetUp() override
  {
    WidgetTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    this->Study = std::make_unique<StudyController>(this->Time);
    StudyState state;
    for (int id = 1; id <= Count; ++id)
    {
      SceneStructure structure;
      structure.Id = id;
      structure.Labels = {std::to_string(id)};
      structure.File = StudyPath("missing.nii.gz");
      structure.Name = (id == 77   ? "Thalamus_L"
                        : id == 78 ? "Thalamus_R"
                                   : "Region_" + std::to_string(Count + 1 - id) + "_L");
      structure.IsVisible = structure.IsTouchable = false;
      state.Structures.push_back(structure);
    }
    this->Study->Change("Open", state);
    this->Panel = std::make_unique<StructuresPanel>(*this->Study);
    this->Panel->resize(900, 500);
    this->Panel->show();
    QApplication::setActiveWindow(this->Panel.get()); // there may be no window manager
    this->Table = this->Panel->findChild<StructureTable*>("structures");
    this->Search = this->Panel->findChild<QLineEdit*>("structure-search");
    QObject::connect(this->Panel.get(), &StructuresPanel::Selected,
                     [this](int id) { this->Told.push_back(id); });
    QApplication::processEvents();
  }
  void TearDown() override
  {
    if (this->Study != nullptr)
    {
      this->Study->Close();
    }
    this->Panel.reset();
  }

  QPointF PlaceOf(int row, int column) const
  {
    return this->Table->visualRect(this->Table->model()->index(row, column)).center();
  }
  void ClickCell(int row, int column, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    // Through the window: Qt 6's tables look at the keyboard's state too.
    QTest::mouseClick(this->Table->viewport(), Qt::LeftButton, modifiers,
                      this->PlaceOf(row, column).toPoint());
  }
  // To the widget with the focus.
  static void Key(int key, const QString& text = {},
                  Qt::KeyboardModifiers modifiers = Qt::NoModifier)
  {
    QWidget* receiver = QApplication::focusWidget();
    ASSERT_NE(receiver, nullptr);
    QKeyEvent press(QEvent::KeyPress, key, modifiers, text);
    QApplication::sendEvent(receiver, &press);
    QKeyEvent release(QEvent::KeyRelease, key, modifiers, text);
    QApplication::sendEvent(QApplication::focusWidget(), &release);
  }
  void Choose(const char* name) const { this->Panel->findChild<QAction*>(name)->trigger(); }
  const SceneStructure& StructureOf(int id) const
  {
    return *FindStructure(this->Study->State(), id);
  }
  std::vector<int> IdsWhere(bool SceneStructure::*flag) const
  {
    std::vector<int> ids;
    for (const SceneStructure& structure : this->Study->State().Structures)
    {
      if (structure.*flag)
      {
        ids.push_back(structure.Id);
      }
    }
    return ids;
  }
  std::vector<int> Visible() const { return this->IdsWhere(&SceneStructure::IsVisible); }
  QString NameAt(int row) const
  {
    return this->Table->model()->index(row, Column::NameColumn).data().toString();
  }
  std::string UndoText() const { return this->Study->Current().History().UndoText(); }

  SteadyClock Time;
  std::unique_ptr<StudyController> Study;
  std::unique_ptr<StructuresPanel> Panel;
  StructureTable* Table = nullptr;
  QLineEdit* Search = nullptr;
  std::vector<int> Told; ///< by Selected
};

using Ids = std::vector<int>;

TEST_F(StructuresPanelTest, ListsNamesThatContainEveryWord)
{
  EXPECT_EQ(this->Table->model()->rowCount(), Count);
  this->Search->setText("thal");
  EXPECT_EQ(this->Table->model()->rowCount(), 2);
  this->Search->setText("_R  thal");
  ASSERT_EQ(this->Table->model()->rowCount(), 1);
  EXPECT_EQ(this->NameAt(0), "Thalamus_R");
  this->Search->clear();
  EXPECT_EQ(this->Table->model()->rowCount(), Count);
}

TEST_F(StructuresPanelTest, TypingInTheTableSearchesAndRenamesNothing)
{
  const StudyState before = this->Study->State();
  this->ClickCell(0, Column::NameColumn);
  this->Table->setFocus();
  for (const char letter : {'T', 'h', 'a', 'l'})
  {
    Key(letter, QString(letter));
  }
  EXPECT_EQ(this->Search->text(), "Thal");
  EXPECT_TRUE(this->Search->hasFocus());
  EXPECT_EQ(this->Table->model()->rowCount(), 2);
  EXPECT_EQ(this->Study->State(), before);
}

TEST_F(StructuresPanelTest, LettersInTheTableAreNoShortcuts)
{
  QKeyEvent letter(QEvent::ShortcutOverride, Qt::Key_A, Qt::NoModifier, "a");
  letter.ignore();
  QApplication::sendEvent(this->Table, &letter);
  EXPECT_TRUE(letter.isAccepted());
  QKeyEvent command(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier, "\x1A");
  command.ignore();
  QApplication::sendEvent(this->Table, &command);
  EXPECT_FALSE(command.isAccepted());
}

TEST_F(StructuresPanelTest, EscapeEndsTheSearchAndDownEntersTheList)
{
  this->Search->setFocus();
  Key(Qt::Key_T, "thal");
  Key(Qt::Key_Down);
  EXPECT_TRUE(this->Table->hasFocus());
  EXPECT_EQ(this->Panel->SelectedIds(), Ids{77});
  this->Search->setFocus();
  Key(Qt::Key_Escape);
  EXPECT_EQ(this->Search->text(), "");
  EXPECT_TRUE(this->Table->hasFocus());
  EXPECT_EQ(this->Panel->SelectedIds(), Ids{77}) << "it is still listed";
}

TEST_F(StructuresPanelTest, F2RenamesAndRefusesAnEmptyName)
{
  this->Table->setFocus();
  const auto rename = [this](const QString& name)
  {
    Key(Qt::Key_F2);
    auto* editor = this->Table->viewport()->findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    EXPECT_EQ(editor->text(), "Thalamus_L");
    editor->setText(name);
    Key(Qt::Key_Return);
    QApplication::processEvents();
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  };
  this->Table->scrollTo(this->Table->model()->index(76, Column::NameColumn));
  this->Table->setCurrentIndex(this->Table->model()->index(76, Column::DegreeColumn));
  rename("  ");
  EXPECT_EQ(this->StructureOf(77).Name, "Thalamus_L");
  EXPECT_EQ(this->UndoText(), "Open");
  rename("Thalamus");
  EXPECT_EQ(this->StructureOf(77).Name, "Thalamus");
  EXPECT_EQ(this->UndoText(), "Change Thalamus_L: name Thalamus");
}

TEST_F(StructuresPanelTest, EditorThatIsLeftUnchangedNamesNothing)
{
  StudyState unnamed = this->Study->State();
  unnamed.Structures.front().Name.clear();
  this->Study->Change("Clear the name", unnamed);
  QAbstractItemModel* model = this->Table->model();
  const QModelIndex name = model->index(0, Column::NameColumn);
  ASSERT_EQ(name.data().toString(), "label 1");
  EXPECT_FALSE(model->setData(name, "label 1"));
  EXPECT_EQ(this->StructureOf(1).Name, "");
}

TEST_F(StructuresPanelTest, CheckOfASelectedRowIsThatOfAllInOneStep)
{
  this->ClickCell(1, Column::NameColumn);
  this->ClickCell(3, Column::NameColumn, Qt::ShiftModifier);
  ASSERT_EQ(this->Panel->SelectedIds(), (Ids{2, 3, 4}));
  this->ClickCell(2, Column::VisibleColumn);
  EXPECT_EQ(this->Visible(), (Ids{2, 3, 4}));
  EXPECT_EQ(this->Panel->SelectedIds(), (Ids{2, 3, 4}));
  EXPECT_EQ(this->UndoText(), "Show 3 structures");
  this->ClickCell(3, Column::TouchableColumn);
  EXPECT_EQ(this->IdsWhere(&SceneStructure::IsTouchable), (Ids{2, 3, 4}));
  this->Study->Undo();
  this->Study->Undo();
  EXPECT_TRUE(this->Visible().empty());
  EXPECT_EQ(this->UndoText(), "Open");
}

TEST_F(StructuresPanelTest, CheckOfAnotherRowIsItsOwnAndKeepsTheSelection)
{
  this->ClickCell(1, Column::NameColumn);
  this->ClickCell(2, Column::NameColumn, Qt::ControlModifier);
  this->Told.clear();
  this->ClickCell(5, Column::VisibleColumn);
  EXPECT_EQ(this->Visible(), Ids{6});
  EXPECT_EQ(this->Panel->SelectedIds(), (Ids{2, 3}));
  EXPECT_TRUE(this->Told.empty()) << "the views stay";
}

TEST_F(StructuresPanelTest, SpaceSwitchesAllSelectedRows)
{
  this->ClickCell(1, Column::NameColumn);
  this->ClickCell(2, Column::NameColumn, Qt::ControlModifier);
  this->Table->setFocus();
  Key(Qt::Key_Space, " ");
  EXPECT_EQ(this->Visible(), (Ids{2, 3}));
  EXPECT_EQ(this->NameAt(1), "Region_115_L");
}

TEST_F(StructuresPanelTest, ShowsAllNoneAndOnlyTheSelectedInOneStepEach)
{
  this->Choose("structures-show-all");
  EXPECT_EQ(this->Visible().size(), static_cast<std::size_t>(Count));
  EXPECT_EQ(this->UndoText(), "Show 116 structures");
  this->ClickCell(4, Column::NameColumn);
  this->Choose("structures-show-only");
  EXPECT_EQ(this->Visible(), Ids{5});
  this->Study->Undo();
  EXPECT_EQ(this->Visible().size(), static_cast<std::size_t>(Count));
  this->Choose("structures-show-none");
  EXPECT_TRUE(this->Visible().empty());
  this->Study->Undo();
  this->Study->Undo();
  EXPECT_EQ(this->UndoText(), "Open");
}

TEST_F(StructuresPanelTest, ShowsAllThatAreListed)
{
  this->Search->setText("thal");
  this->Choose("structures-show-all");
  EXPECT_EQ(this->Visible(), (Ids{77, 78}));
}

TEST_F(StructuresPanelTest, ListsOnlyVisibleOrTouchableStructures)
{
  StudyState next = this->Study->State();
  next.Structures[3].IsVisible = true;
  next.Structures[5].IsTouchable = true;
  this->Study->Change("Choose", next);
  auto* kept = this->Panel->findChild<QComboBox*>("structure-filter");
  kept->setCurrentIndex(1);
  ASSERT_EQ(this->Table->model()->rowCount(), 1);
  EXPECT_EQ(this->NameAt(0), QString::fromStdString(next.Structures[3].Name));
  kept->setCurrentIndex(2);
  ASSERT_EQ(this->Table->model()->rowCount(), 1);
  EXPECT_EQ(this->NameAt(0), QString::fromStdString(next.Structures[5].Name));
  kept->setCurrentIndex(0);
  EXPECT_EQ(this->Table->model()->rowCount(), Count);
}

TEST_F(StructuresPanelTest, HeaderSortsByNumbersInNamesAndTheMenuReturnsToTheStudysOrder)
{
  EXPECT_EQ(this->NameAt(0), "Region_116_L");
  QHeaderView* header = this->Table->horizontalHeader();
  const QPointF place(header->sectionViewportPosition(Column::NameColumn) + 20.0,
                      0.5 * header->height());
  Move(header->viewport(), place);
  Click(header->viewport(), place);
  EXPECT_EQ(this->NameAt(0), "Region_1_L");
  EXPECT_EQ(this->NameAt(1), "Region_2_L") << "and not 10";
  this->Choose("structures-unsort");
  EXPECT_EQ(this->NameAt(0), "Region_116_L");
}

TEST_F(StructuresPanelTest, MenuOffersWhatAppliesToTheSelection)
{
  this->ClickCell(1, Column::NameColumn);
  this->ClickCell(2, Column::NameColumn, Qt::ControlModifier);
  auto* menu = this->Panel->findChild<StructureMenu*>();
  const auto open = [&]
  {
    QContextMenuEvent event(QContextMenuEvent::Mouse,
                            this->PlaceOf(1, Column::NameColumn).toPoint(),
                            this->Table->mapToGlobal(QPoint(30, 30)));
    QApplication::sendEvent(this->Table->viewport(), &event);
    EXPECT_TRUE(menu->isVisible());
    menu->hide();
  };
  open();
  EXPECT_EQ(menu->ActionOf(StructureMenu::Show)->text(), "&Show");
  EXPECT_FALSE(menu->ActionOf(StructureMenu::Rename)->isEnabled()) << "of two";
  this->Choose("structure-show");
  EXPECT_EQ(this->Visible(), (Ids{2, 3}));
  open();
  EXPECT_EQ(menu->ActionOf(StructureMenu::Show)->text(), "&Hide");
  this->Choose("structure-touch");
  EXPECT_EQ(this->IdsWhere(&SceneStructure::IsTouchable), (Ids{2, 3}));
  this->Choose("structure-menu-remove");
  EXPECT_EQ(this->Study->State().Structures.size(), Count - 2U);
  EXPECT_EQ(this->UndoText(), "Remove 2 structures");
}

TEST_F(StructuresPanelTest, DraggedOpacityIsOneStepOfAllSelectedRows)
{
  this->ClickCell(1, Column::NameColumn);
  this->ClickCell(2, Column::NameColumn, Qt::ControlModifier);
  QWidget* port = this->Table->viewport();
  const QRect cell = this->Table->visualRect(this->Table->model()->index(2, Column::OpacityColumn));
  SendMouse(port, QEvent::MouseButtonPress, cell.center(), Qt::LeftButton, Qt::LeftButton);
  for (const int x : {cell.center().x() + 15, cell.left() + cell.width() / 4, cell.left() - 50})
  {
    SendMouse(port, QEvent::MouseMove, QPointF(x, cell.center().y()), Qt::NoButton, Qt::LeftButton);
  }
  EXPECT_EQ(this->StructureOf(2).Opacity, 0.0);
  const QPointF end(cell.left() + 0.5 * cell.width(), cell.center().y());
  SendMouse(port, QEvent::MouseButtonRelease, end, Qt::LeftButton, Qt::NoButton);
  EXPECT_NEAR(this->StructureOf(2).Opacity, 0.5, 0.03);
  EXPECT_EQ(this->StructureOf(2).Opacity, this->StructureOf(3).Opacity);
  EXPECT_EQ(this->StructureOf(4).Opacity, 1.0);
  EXPECT_EQ(this->Panel->SelectedIds(), (Ids{2, 3}));
  this->Study->Undo();
  EXPECT_EQ(this->StructureOf(2).Opacity, 1.0);
  EXPECT_EQ(this->UndoText(), "Open");
}

TEST_F(StructuresPanelTest, ClickOnAnOpacityOnlySelects)
{
  this->ClickCell(3, Column::OpacityColumn);
  EXPECT_EQ(this->StructureOf(4).Opacity, 1.0);
  EXPECT_EQ(this->Panel->SelectedIds(), Ids{4});
}

TEST_F(StructuresPanelTest, DoubleClickTypesAnOpacity)
{
  DoubleClick(this->Table->viewport(), this->PlaceOf(3, Column::OpacityColumn));
  auto* box = this->Table->viewport()->findChild<QSpinBox*>();
  ASSERT_NE(box, nullptr);
  EXPECT_EQ(box->value(), 100);
  box->setValue(30);
  this->Table->setFocus();
  EXPECT_EQ(this->StructureOf(4).Opacity, 0.3);
}

TEST_F(StructuresPanelTest, ChoiceOpensItsListAtOneClick)
{
  this->ClickCell(0, Column::AppearanceColumn);
  auto* box = this->Table->viewport()->findChild<QComboBox*>();
  ASSERT_NE(box, nullptr);
  WaitUntil([box] { return box->view()->isVisible(); });
  QKeyEvent down(QEvent::KeyPress, Qt::Key_Down, Qt::NoModifier);
  QApplication::sendEvent(box->view(), &down);
  QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
  QApplication::sendEvent(box->view(), &enter);
  EXPECT_EQ(this->StructureOf(1).Appearance, SceneAppearance::Model);
}

TEST_F(StructuresPanelTest, TellsOfRowsThatTheUserSelects)
{
  this->ClickCell(0, Column::NameColumn);
  EXPECT_EQ(this->Told, Ids{1});
  this->Table->setFocus();
  Key(Qt::Key_Down);
  EXPECT_EQ(this->Told, (Ids{1, 2}));
  this->Panel->Select(60);
  EXPECT_EQ(this->Panel->SelectedIds(), Ids{60});
  EXPECT_EQ(this->Told, (Ids{1, 2})) << "the program selected it";
  this->Choose("structure-centre");
  EXPECT_EQ(this->Told, (Ids{1, 2, 60}));
}

TEST_F(StructuresPanelTest, SelectListsTheStructureAgain)
{
  this->Search->setText("thal");
  this->Panel->Select(5);
  EXPECT_EQ(this->Search->text(), "");
  EXPECT_EQ(this->Panel->SelectedIds(), Ids{5});
  this->Panel->Select(4711);
  EXPECT_EQ(this->Panel->SelectedIds(), Ids{5}) << "there is no such structure";
}

TEST_F(StructuresPanelTest, SelectionSurvivesTheRemovalOfOthers)
{
  this->ClickCell(3, Column::NameColumn);
  this->ClickCell(5, Column::NameColumn, Qt::ControlModifier);
  this->Told.clear();
  StudyState next = this->Study->State();
  next.Structures.erase(next.Structures.begin());
  this->Study->Change("Remove the first", next);
  EXPECT_EQ(this->Panel->SelectedIds(), (Ids{4, 6}));
  EXPECT_TRUE(this->Told.empty());
}

// Counts do not depend on the machine; the time is generous.
TEST_F(StructuresPanelTest, AllAreSearchedAndSwitchedAtOnce)
{
  int cells = 0;
  QObject::connect(this->Panel->findChild<StructureTableModel*>(), &QAbstractItemModel::dataChanged,
                   [&cells] { ++cells; });
  const auto start = std::chrono::steady_clock::now();
  this->Table->selectAll();
  this->ClickCell(0, Column::VisibleColumn);
  EXPECT_EQ(this->Visible().size(), static_cast<std::size_t>(Count));
  EXPECT_EQ(this->UndoText(), "Show 116 structures");
  EXPECT_EQ(cells, 1);
  this->Search->setText("thal");
  this->Search->clear();
  EXPECT_EQ(cells, 1) << "the search changes no cell";
  QApplication::processEvents();
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  EXPECT_LT(time.count(), 1.0) << "0.1 s are wanted";
}

TEST_F(StructuresPanelTest, UnchangedStudyTellsNoCells)
{
  int cells = 0;
  QObject::connect(this->Panel->findChild<StructureTableModel*>(), &QAbstractItemModel::dataChanged,
                   [&cells] { ++cells; });
  Q_EMIT this->Study->ProductsChanged();
  EXPECT_EQ(cells, 0) << "an editor would lose what is typed";
}

TEST_F(StructuresPanelTest, NamesAreReadableInANarrowPanel)
{
  QHeaderView* header = this->Table->horizontalHeader();
  const int text = this->Table->fontMetrics().horizontalAdvance("Frontal_Sup_Medial_R");
  for (const int width : {320, 1600})
  {
    this->Panel->resize(width, 300);
    QApplication::processEvents();
    EXPECT_GE(header->sectionSize(Column::NameColumn), text) << width;
    EXPECT_LT(header->sectionViewportPosition(Column::NameColumn) + text,
              this->Table->viewport()->width())
        << "without scrolling";
  }
  EXPECT_EQ(header->length(), this->Table->viewport()->width()) << "all of a wide panel is used";
}

TEST_F(StructuresPanelTest, ToolsNeedNoWiderColumn)
{
  const QualityPanel quality(*this->Study); // another part of the column
  EXPECT_LE(this->Panel->minimumSizeHint().width(), quality.minimumSizeHint().width() + 48);
  this->Panel->resize(this->Panel->minimumSizeHint().width(), 300);
  QApplication::processEvents();
  for (const char* name : {"structure-search", "structure-filter", "structure-show-menu",
                           "structure-details", "structure-remove", "opacity"})
  {
    const auto* widget = this->Panel->findChild<QWidget*>(name);
    EXPECT_GE(widget->width(), widget->minimumSizeHint().width()) << name;
    EXPECT_LE(widget->geometry().right(), this->Panel->width()) << name;
  }
}

TEST_F(StructuresPanelTest, RoleIsGivenToAllSelectedRows)
{
  this->ClickCell(0, Column::NameColumn);
  this->ClickCell(2, Column::NameColumn, Qt::ControlModifier);
  const QModelIndex role = this->Table->model()->index(2, Column::DrillColumn);
  QComboBox box;
  box.addItems(DrillRole::Names());
  box.setCurrentIndex(3);
  this->Table->itemDelegateForColumn(Column::DrillColumn)
      ->setModelData(&box, this->Table->model(), role);
  for (const int id : {1, 3})
  {
    EXPECT_TRUE(this->StructureOf(id).IsForbidden) << id;
  }
  EXPECT_FALSE(this->StructureOf(2).IsForbidden);
  EXPECT_EQ(this->UndoText(), "Change 2 structures: drill role Forbidden");
  this->Panel->findChild<QComboBox*>("structure-filter")->setCurrentIndex(3);
  EXPECT_EQ(this->Table->model()->rowCount(), 2) << "only those with a role";
}

TEST_F(StructuresPanelTest, RolesAreSeenBesideNamesAndDoNotScroll)
{
  this->Panel->resize(370, 500); // as in the window
  QApplication::processEvents();
  const QRect role = this->Table->visualRect(this->Table->model()->index(0, Column::DrillColumn));
  EXPECT_LE(role.left() + 0.6 * role.width(), this->Table->viewport()->width());
  const QModelIndex status = this->Table->model()->index(60, Column::StatusColumn);
  QScrollBar* bar = this->Table->horizontalScrollBar();
  bar->setValue(bar->maximum() / 4);
  const int before = bar->value();
  this->Table->scrollTo(status.siblingAtColumn(Column::DrillColumn));
  EXPECT_EQ(bar->value(), before);
}

TEST_F(StructuresPanelTest, ColumnsKeepWidthsThatWereDragged)
{
  QHeaderView* header = this->Table->horizontalHeader();
  const int dragged = header->sectionSize(Column::NameColumn) + 30;
  header->resizeSection(Column::NameColumn, dragged); // as a drag does
  StructuresPanel next(*this->Study);
  next.resize(500, 300);
  next.show();
  QApplication::processEvents();
  EXPECT_EQ(next.findChild<StructureTable*>("structures")
                ->horizontalHeader()
                ->sectionSize(Column::NameColumn),
            dragged);
  QSettings().clear();
}
} // namespace
} // namespace palpate::structures_panel_test
