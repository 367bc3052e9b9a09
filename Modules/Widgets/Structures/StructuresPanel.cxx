#include "StructuresPanel.h"

#include "ChoiceDelegate.h"
#include "DrillRole.h"
#include "GuideDialog.h"
#include "OpacityDelegate.h"
#include "StructureDialog.h"

#include <QColorDialog>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double SliderSteps = 100.0;
}

StructuresPanel::StructuresPanel(StudyController& study, QWidget* parent)
    : QWidget(parent), Study(study), Edits(study), Checked(new StructureVerdicts(study, this)),
      Model(new StructureTableModel(study, *this->Checked, this)),
      Listed(new StructureFilterModel(this)), Table(new StructureTable(this)),
      Menu(new StructureMenu(this)), Search(new QLineEdit(this)), Kept(new QComboBox(this)),
      Add(new QMenu(this)), Opacity(new QSlider(Qt::Horizontal, this))
{
  this->Listed->setSourceModel(this->Model);
  this->Table->setModel(this->Listed);
  this->Table->setObjectName("structures");
  this->Table->setItemDelegateForColumn(StructureTableModel::OpacityColumn,
                                        new OpacityDelegate(this));
  this->Table->setItemDelegateForColumn(
      StructureTableModel::DrillColumn,
      new ChoiceDelegate(DrillRole::Names(), this,
                         [this](const QModelIndex& cell, int role)
                         {
                           const int id = cell.data(StructureTableModel::IdRole).toInt();
                           this->Edits.SetDrillRole(this->WithSelected(id), role);
                         }));
  this->Table->setItemDelegateForColumn(
      StructureTableModel::AppearanceColumn,
      new ChoiceDelegate(StructureTableModel::AppearanceNames(), this));
  this->Table->setItemDelegateForColumn(
      StructureTableModel::RepresentationColumn,
      new ChoiceDelegate(StructureTableModel::RepresentationNames(), this));
  // No column at first: the study's order.
  this->Table->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
  this->Table->setSortingEnabled(true);
  this->ConnectTable();
  this->Opacity->setObjectName("opacity");
  this->Opacity->setRange(0, static_cast<int>(SliderSteps));
  this->ShowOpacity(study.State().View.OverlayOpacity);
  connect(&study, &StudyController::StateChanged, this,
          [this, &study] { this->ShowOpacity(study.State().View.OverlayOpacity); });
  connect(this->Opacity, &QSlider::valueChanged, this,
          [this](int value) { Q_EMIT OpacityChosen(value / SliderSteps); });
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 2, 4, 2);
  column->addLayout(this->MakeSearch());
  column->addWidget(this->Table, 1);
  column->addLayout(this->MakeTools());
}

void StructuresPanel::ConnectTable()
{
  connect(this->Table, &StructureTable::CheckChosen, this, &StructuresPanel::TakeCheck);
  connect(this->Table, &StructureTable::OpacityDragged, this, &StructuresPanel::TakeOpacity);
  connect(this->Table, &StructureTable::Typed, this, &StructuresPanel::TakeText);
  connect(this->Table, &StructureTable::MenuAsked, this, &StructuresPanel::OpenMenu);
  connect(this->Table, &QTableView::clicked, this, &StructuresPanel::OpenCell);
  connect(this->Table, &QTableView::activated, this, &StructuresPanel::ShowFinding);
  connect(this->Checked, &StructureVerdicts::Changed, this,
          [this] { this->Table->PutStatusFirst(!this->Checked->IsEmpty()); });
  connect(this->Table, &QTableView::doubleClicked, this, &StructuresPanel::ChooseColorOf);
  connect(this->Menu, &StructureMenu::Chosen, this, &StructuresPanel::Act);
  connect(this->Table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &StructuresPanel::TakeSelection);
  connect(this->Listed, &QAbstractItemModel::modelAboutToBeReset, this,
          [this] { this->SelectedBefore = this->Table->SelectedIds(); });
  connect(this->Listed, &QAbstractItemModel::modelReset, this, &StructuresPanel::KeepSelection);
}

QBoxLayout* StructuresPanel::MakeSearch()
{
  this->Search->setObjectName("structure-search");
  this->Search->setPlaceholderText("Search");
  this->Search->setToolTip("List only structures whose names contain these words");
  this->Search->setClearButtonEnabled(true);
  this->Search->setMinimumWidth(this->fontMetrics().horizontalAdvance("Search 00"));
  this->Search->installEventFilter(this);
  connect(this->Search, &QLineEdit::textChanged, this->Listed, &StructureFilterModel::Search);
  this->Kept->setObjectName("structure-filter");
  this->Kept->addItems({"All", "Visible", "Touchable", "Drilled"}); // in the order of Kept
  this->Kept->setToolTip("Which structures are listed");
  connect(this->Kept, qOverload<int>(&QComboBox::currentIndexChanged), this,
          [this](int kept) { this->Listed->Keep(static_cast<StructureFilterModel::Kept>(kept)); });
  auto* add = new QToolButton(this);
  add->setObjectName("structure-add-menu");
  add->setText("Add");
  add->setPopupMode(QToolButton::InstantPopup);
  add->setMenu(this->Add);
  auto* show = new QToolButton(this);
  this->MakeShowMenu(show);
  auto* row = new QHBoxLayout;
  row->addWidget(this->Search, 1);
  row->addWidget(this->Kept);
  row->addWidget(show);
  row->addWidget(add);
  return row;
}

void StructuresPanel::AddAdding(const QList<QAction*>& actions)
{
  this->Add->addActions(actions);
  this->Add->addSeparator();
  this->Add->addAction("&Guide of the tool by the selected structure...", this,
                       &StructuresPanel::ShowGuide);
}

QBoxLayout* StructuresPanel::MakeTools()
{
  this->Opacity->setMinimumWidth(this->fontMetrics().horizontalAdvance("00000000"));
  auto* label = new QLabel("Labels", this);
  label->setToolTip("Opacity of all labels over the slices");
  auto* row = new QHBoxLayout;
  row->addWidget(this->MakeButton("Details...", "structure-details",
                                  "All touch settings of the selected structure",
                                  &StructuresPanel::ShowDetails));
  row->addWidget(this->MakeButton("Remove", "structure-remove",
                                  "Remove the selected structures from the study",
                                  &StructuresPanel::Remove));
  row->addWidget(label);
  row->addWidget(this->Opacity, 1);
  return row;
}

QWidget* StructuresPanel::MakeButton(const QString& text, const char* name, const QString& tip,
                                     void (StructuresPanel::*act)())
{
  auto* button = new QPushButton(text, this);
  button->setObjectName(name);
  button->setToolTip(tip);
  connect(button, &QPushButton::clicked, this, act);
  return button;
}

void StructuresPanel::MakeShowMenu(QToolButton* button)
{
  button->setObjectName("structure-show-menu");
  button->setText("Show");
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button);
  const auto add = [this, menu](const QString& text, const char* name, const auto& act)
  { menu->addAction(text, this, act)->setObjectName(name); };
  add("Show &all listed", "structures-show-all",
      [this] { this->Edits.SetVisible(this->Listed->Ids(), true); });
  add("Show &none of the listed", "structures-show-none",
      [this] { this->Edits.SetVisible(this->Listed->Ids(), false); });
  add("Show &only the selected", "structures-show-only", [this] { this->ShowOnlySelected(); });
  menu->addSeparator();
  add("&Sort as in the study", "structures-unsort",
      [this] { this->Table->sortByColumn(-1, Qt::AscendingOrder); });
  button->setMenu(menu);
}

void StructuresPanel::ShowOpacity(double opacity)
{
  const QSignalBlocker quiet(this->Opacity);
  this->Opacity->setValue(static_cast<int>(std::lround(SliderSteps * opacity)));
}

void StructuresPanel::Select(int id)
{
  if (FindStructure(this->Study.State(), id) == nullptr)
  {
    return;
  }
  if (this->Listed->RowOf(id) < 0)
  {
    this->Search->clear();
    this->Kept->setCurrentIndex(0);
  }
  const QScopedValueRollback<bool> quiet(this->IsQuiet, true);
  this->Table->SelectIds({id});
}

// The views forget their selection when structures come or go.
void StructuresPanel::KeepSelection()
{
  const QScopedValueRollback<bool> quiet(this->IsQuiet, true);
  this->Table->SelectIds(this->SelectedBefore);
  Q_EMIT SelectionChanged();
}

void StructuresPanel::TakeSelection(const QItemSelection& selected)
{
  Q_EMIT SelectionChanged();
  // By the keyboard, rows are selected before the cursor moves there. Several rows that leave the
  // cursor where it is, as if all are selected, have no centre.
  const QModelIndex current = this->Table->currentIndex();
  const bool isOne = selected.size() == 1 && selected.front().height() == 1;
  const QModelIndex cell = selected.contains(current) ? current
                           : isOne                    ? QModelIndex(selected.front().topLeft())
                                                      : QModelIndex();
  if (!this->IsQuiet && cell.isValid())
  {
    Q_EMIT Selected(cell.data(StructureTableModel::IdRole).toInt());
  }
}

// A change of a selected row is one of all selected rows.
std::vector<int> StructuresPanel::WithSelected(int id) const
{
  std::vector<int> ids = this->SelectedIds();
  const bool isSelected = std::find(ids.begin(), ids.end(), id) != ids.end();
  return isSelected ? ids : std::vector<int>{id};
}

void StructuresPanel::TakeCheck(int id, int column, bool isOn)
{
  if (column == StructureTableModel::VisibleColumn)
  {
    this->Edits.SetVisible(this->WithSelected(id), isOn);
  }
  else
  {
    this->Edits.SetTouchable(this->WithSelected(id), isOn);
  }
}

void StructuresPanel::TakeOpacity(int id, int percent, bool isLast)
{
  this->Edits.SetOpacity(this->WithSelected(id), percent, "structure-opacity");
  if (isLast)
  {
    this->Study.EndGesture();
  }
}

void StructuresPanel::TakeText(const QString& text)
{
  // While touching, D is the drill's pedal.
  if (!(this->Study.IsTouching() && text.compare("d", Qt::CaseInsensitive) == 0))
  {
    this->Search->setFocus();
    this->Search->insert(text);
  }
}

// From the search back to the table; the down arrow enters the list.
bool StructuresPanel::eventFilter(QObject* object, QEvent* event)
{
  if (object != this->Search || event->type() != QEvent::KeyPress)
  {
    return QWidget::eventFilter(object, event);
  }
  const int key = static_cast<QKeyEvent*>(event)->key();
  const bool leaves =
      key == Qt::Key_Escape || key == Qt::Key_Down || key == Qt::Key_Return || key == Qt::Key_Enter;
  if (!leaves)
  {
    return false;
  }
  if (key == Qt::Key_Escape)
  {
    this->Search->clear();
  }
  this->Table->setFocus();
  if (key != Qt::Key_Escape && this->Listed->rowCount() > 0)
  {
    this->Table->selectRow(0);
  }
  return true;
}

void StructuresPanel::OpenCell(const QModelIndex& index)
{
  const int column = index.column();
  const bool isChoice = column == StructureTableModel::DrillColumn ||
                        column == StructureTableModel::AppearanceColumn ||
                        column == StructureTableModel::RepresentationColumn;
  if (QGuiApplication::keyboardModifiers() != Qt::NoModifier)
  {
    return;
  }
  if (isChoice)
  {
    this->Table->edit(index);
  }
  this->ShowFinding(index);
}

// By a click on the mark, or the key that activates it.
void StructuresPanel::ShowFinding(const QModelIndex& index)
{
  const SceneStructure* structure =
      FindStructure(this->Study.State(), index.data(StructureTableModel::IdRole).toInt());
  const StructureVerdict* verdict =
      index.column() == StructureTableModel::StatusColumn && structure != nullptr
          ? this->Checked->Of(*structure)
          : nullptr;
  if (verdict != nullptr && verdict->Is != OrganJudgement::Verdict::Plausible)
  {
    const Vector3 place = verdict->PlaceWorld;
    if (!structure->IsVisible)
    {
      this->Edits.SetVisible({structure->Id}, true);
    }
    Q_EMIT PlaceChosen(place);
  }
}

void StructuresPanel::OpenMenu(const QPoint& global)
{
  std::vector<SceneStructure> selected;
  for (const int id : this->SelectedIds())
  {
    selected.push_back(*FindStructure(this->Study.State(), id));
  }
  this->Menu->Offer(selected);
  this->Menu->popup(global);
}

void StructuresPanel::Act(int entry)
{
  switch (entry)
  {
  case StructureMenu::OnlyThis:
    return this->ShowOnlySelected();
  case StructureMenu::Show:
    return this->Edits.SetVisible(this->SelectedIds(), this->Menu->Shows());
  case StructureMenu::Touch:
    return this->Edits.SetTouchable(this->SelectedIds(), this->Menu->Touches());
  case StructureMenu::Color:
    return this->ChooseColor();
  case StructureMenu::Opacity:
    return this->ChooseOpacity();
  case StructureMenu::Details:
    return this->ShowDetails();
  case StructureMenu::Guide:
    return this->ShowGuide();
  case StructureMenu::Rename:
    return this->Table->Rename();
  case StructureMenu::Centre:
    Q_EMIT Selected(this->Table->CurrentId());
    return;
  case StructureMenu::Check:
    Q_EMIT CheckAsked();
    return;
  case StructureMenu::Remove:
    return this->Remove();
  default:
    return;
  }
}

void StructuresPanel::ShowOnlySelected()
{
  const std::vector<int> ids = this->SelectedIds();
  if (!ids.empty())
  {
    this->Edits.ShowOnly(ids);
  }
}

void StructuresPanel::ShowDetails()
{
  if (const int id = this->Table->CurrentId())
  {
    StructureDialog(this->Study, id, this).exec();
  }
}

void StructuresPanel::ShowGuide()
{
  if (const int id = this->Table->CurrentId())
  {
    GuideDialog(this->Study, id, this).exec();
  }
}

void StructuresPanel::Remove()
{
  const std::vector<int> ids = this->SelectedIds();
  if (!ids.empty())
  {
    this->Edits.Remove(ids);
  }
}

void StructuresPanel::ChooseColorOf(const QModelIndex& index)
{
  if (index.column() == StructureTableModel::ColorColumn)
  {
    this->ChooseColor();
  }
}

void StructuresPanel::ChooseColor()
{
  const SceneStructure* structure = FindStructure(this->Study.State(), this->Table->CurrentId());
  if (structure == nullptr)
  {
    return;
  }
  const std::vector<int> ids = this->SelectedIds();
  const QColor now =
      QColor::fromRgbF(structure->Color[0], structure->Color[1], structure->Color[2]);
  const QColor color = QColorDialog::getColor(now, this, "Colour");
  if (color.isValid())
  {
    this->Edits.SetColor(ids, color);
  }
}

void StructuresPanel::ChooseOpacity()
{
  const int row = this->Listed->RowOf(this->Table->CurrentId());
  if (row < 0)
  {
    return;
  }
  const std::vector<int> ids = this->SelectedIds();
  const QModelIndex cell = this->Listed->index(row, StructureTableModel::OpacityColumn);
  bool isChosen = false;
  const int percent = QInputDialog::getInt(this, "Opacity", "In 3-D and over the slices, %:",
                                           cell.data(Qt::EditRole).toInt(), 0, 100, 5, &isChosen);
  if (isChosen)
  {
    this->Edits.SetOpacity(ids, percent);
  }
}
} // namespace palpate
