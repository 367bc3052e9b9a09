#include "StructureTable.h"

#include "OpacityDelegate.h"
#include "StructureTableModel.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QSettings>
#include <QStyle>
#include <QStyledItemDelegate>

#include <algorithm>

namespace palpate
{
namespace
{
bool IsCheck(const QModelIndex& cell)
{
  return cell.column() == StructureTableModel::VisibleColumn ||
         cell.column() == StructureTableModel::TouchableColumn;
}

// Whether a key is text for the search.
bool IsText(const QKeyEvent& key)
{
  const auto commands = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
  return !(key.modifiers() & commands) && !key.text().isEmpty() && key.text()[0].isPrint() &&
         key.key() != Qt::Key_Space;
}

// The widest text of a column; the header may be wider.
QString WidestTextOf(int column)
{
  switch (column)
  {
  case StructureTableModel::OpacityColumn:
    return "100 %";
  case StructureTableModel::NameColumn:
    return "Frontal_Sup_Medial_R";
  case StructureTableModel::DrillColumn:
    return "Forbidden0";
  case StructureTableModel::StatusColumn:
    return "10.0 mm away, least 10.0 mm";
  case StructureTableModel::AppearanceColumn:
    return "sub-voxel volume000";
  case StructureTableModel::RepresentationColumn:
    return "model or field: sub-voxel000";
  default:
    return "0.000";
  }
}

// A name that does not fit keeps its end, by which left and right differ.
class NameDelegate : public QStyledItemDelegate
{
public:
  using QStyledItemDelegate::QStyledItemDelegate;

protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
  {
    this->QStyledItemDelegate::initStyleOption(option, index);
    option->textElideMode = Qt::ElideLeft;
  }
};

// Of a width that the user chose.
QString WidthKey(int column)
{
  return QString("structure-columns/%1").arg(column);
}
} // namespace

StructureTable::StructureTable(QWidget* parent) : QTableView(parent)
{
  this->setSelectionBehavior(SelectRows);
  this->setSelectionMode(ExtendedSelection);
  this->setEditTriggers(DoubleClicked);
  this->setTabKeyNavigation(false);
  this->setHorizontalScrollMode(ScrollPerPixel);
  this->setWordWrap(false);
  this->verticalHeader()->hide();
  this->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  this->verticalHeader()->setDefaultSectionSize(this->fontMetrics().height() + 6);
  this->horizontalHeader()->setSectionsClickable(true);
  this->horizontalHeader()->setHighlightSections(false);
  this->setItemDelegateForColumn(StructureTableModel::NameColumn, new NameDelegate(this));
  connect(this->horizontalHeader(), &QHeaderView::sectionResized, this, &StructureTable::KeepWidth);
}

void StructureTable::setModel(QAbstractItemModel* model)
{
  QTableView::setModel(model);
  connect(model, &QAbstractItemModel::modelReset, this, &StructureTable::FitName);
  this->SetWidths();
}

// Only those that the user drags: the others follow the contents.
void StructureTable::KeepWidth(int column, int /*before*/, int width)
{
  if (!this->IsFitting)
  {
    QSettings().setValue(WidthKey(column), width);
  }
}

void StructureTable::scrollTo(const QModelIndex& cell, ScrollHint hint)
{
  const int left = this->columnViewportPosition(cell.column());
  const bool isSeen =
      left < this->viewport()->width() && left + this->columnWidth(cell.column()) > 0;
  const int before = this->horizontalScrollBar()->value();
  QTableView::scrollTo(cell, hint);
  if (isSeen)
  {
    this->horizontalScrollBar()->setValue(before);
  }
}

// From samples: widths that follow the contents would measure every row at every change. The
// columns before the name are narrow, so that it is read without scrolling.
int StructureTable::WidthOf(int column) const
{
  const QVariant kept = QSettings().value(WidthKey(column));
  if (kept.isValid())
  {
    return kept.toInt();
  }
  const QFontMetrics font = this->fontMetrics();
  if (column < StructureTableModel::OpacityColumn)
  {
    return font.height() + 8;
  }
  const int margin = 2 * (this->style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 2);
  const int text = font.horizontalAdvance(WidestTextOf(column)) + margin;
  return column <= StructureTableModel::DrillColumn
             ? text
             : std::max(text, this->horizontalHeader()->sectionSizeHint(column));
}

void StructureTable::SetWidths()
{
  const QScopedValueRollback<bool> fitting(this->IsFitting, true);
  for (int column = 0; column < this->horizontalHeader()->count(); ++column)
  {
    this->horizontalHeader()->resizeSection(column, this->WidthOf(column));
  }
  this->FitName();
}

int StructureTable::WidthOfNames() const
{
  int widest = 0;
  for (int row = 0; row < this->model()->rowCount(); ++row)
  {
    const QModelIndex name = this->model()->index(row, StructureTableModel::NameColumn);
    widest = std::max(widest, this->fontMetrics().horizontalAdvance(name.data().toString()));
  }
  return widest + 2 * (this->style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 2);
}

// Drill roles, or the verdict that a status begins with, are seen next to the names without
// scrolling; this is their width.
int StructureTable::WidthBesideNames() const
{
  const QHeaderView* header = this->horizontalHeader();
  const int next = header->logicalIndex(header->visualIndex(StructureTableModel::NameColumn) + 1);
  return next == StructureTableModel::StatusColumn
             ? this->fontMetrics().horizontalAdvance("\u2716 implausible") +
                   2 * (this->style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 2)
             : header->sectionSize(next);
}

void StructureTable::PutStatusFirst(bool isFirst)
{
  QHeaderView* header = this->horizontalHeader();
  header->moveSection(header->visualIndex(StructureTableModel::StatusColumn),
                      isFirst ? StructureTableModel::DrillColumn
                              : StructureTableModel::StatusColumn);
  this->FitName();
}

// As wide as the names are, if what is next to them is still seen without scrolling; in a wide
// table what the other columns leave.
void StructureTable::FitName()
{
  constexpr int Name = StructureTableModel::NameColumn;
  QHeaderView* header = this->horizontalHeader();
  if (header->count() <= Name || QSettings().contains(WidthKey(Name)))
  {
    return;
  }
  const int left = header->sectionPosition(Name);
  const int beside = this->viewport()->width() - left - this->WidthBesideNames();
  const int free = this->viewport()->width() - header->length() + header->sectionSize(Name);
  const QScopedValueRollback<bool> fitting(this->IsFitting, true);
  const int names = std::max(std::min(this->WidthOfNames(), beside), free);
  // Names keep their ends; a verdict needs its beginning.
  const bool isVerdictNext =
      header->visualIndex(StructureTableModel::StatusColumn) == header->visualIndex(Name) + 1;
  header->resizeSection(Name, std::max(this->WidthOf(Name) / (isVerdictNext ? 2 : 1), names));
}

void StructureTable::resizeEvent(QResizeEvent* event)
{
  QTableView::resizeEvent(event);
  this->FitName();
}

std::vector<int> StructureTable::SelectedIds() const
{
  QModelIndexList rows = this->selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end());
  std::vector<int> ids;
  for (const QModelIndex& row : rows)
  {
    ids.push_back(row.data(StructureTableModel::IdRole).toInt());
  }
  return ids;
}

int StructureTable::CurrentId() const
{
  const QModelIndex current = this->currentIndex();
  if (current.isValid() && this->selectionModel()->isRowSelected(current.row(), {}))
  {
    return current.data(StructureTableModel::IdRole).toInt();
  }
  const std::vector<int> ids = this->SelectedIds();
  return ids.empty() ? 0 : ids.front();
}

void StructureTable::SelectIds(const std::vector<int>& ids)
{
  QItemSelection rows;
  QModelIndex first;
  for (int row = 0; row < this->model()->rowCount(); ++row)
  {
    const QModelIndex cell = this->model()->index(row, StructureTableModel::NameColumn);
    if (std::find(ids.begin(), ids.end(), cell.data(StructureTableModel::IdRole).toInt()) !=
        ids.end())
    {
      first = first.isValid() ? first : cell;
      rows.select(cell, cell);
    }
  }
  this->selectionModel()->setCurrentIndex(first, QItemSelectionModel::NoUpdate);
  this->selectionModel()->select(rows,
                                 QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  if (first.isValid())
  {
    this->scrollTo(first);
  }
}

void StructureTable::Rename()
{
  const QModelIndex name = this->currentIndex().siblingAtColumn(StructureTableModel::NameColumn);
  if (name.isValid())
  {
    this->setCurrentIndex(name);
    this->edit(name);
  }
}

// Otherwise the window's shortcuts of single letters would take text.
bool StructureTable::event(QEvent* event)
{
  if (event->type() == QEvent::ShortcutOverride && IsText(static_cast<const QKeyEvent&>(*event)))
  {
    event->accept();
    return true;
  }
  return QTableView::event(event);
}

void StructureTable::keyPressEvent(QKeyEvent* event)
{
  const QModelIndex current = this->currentIndex();
  if (this->state() == EditingState)
  {
    QTableView::keyPressEvent(event);
  }
  else if (event->key() == Qt::Key_F2)
  {
    this->Rename();
  }
  else if (event->key() == Qt::Key_Space && event->modifiers() == Qt::NoModifier)
  {
    this->TellCheck(IsCheck(current) ? current
                                     : current.siblingAtColumn(StructureTableModel::VisibleColumn));
  }
  else if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) &&
           (current.flags() & Qt::ItemIsEditable))
  {
    this->edit(current);
  }
  else if (IsText(*event))
  {
    Q_EMIT Typed(event->text());
  }
  else
  {
    QTableView::keyPressEvent(event);
  }
}

void StructureTable::TellCheck(const QModelIndex& cell)
{
  if (cell.isValid())
  {
    Q_EMIT CheckChosen(cell.data(StructureTableModel::IdRole).toInt(), cell.column(),
                       cell.data(Qt::CheckStateRole).toInt() != Qt::Checked);
  }
}

// Whether the press begins a change that leaves the selection.
bool StructureTable::Press(const QMouseEvent& event)
{
  const QModelIndex cell = this->indexAt(event.pos());
  const bool isOpacity =
      cell.column() == StructureTableModel::OpacityColumn && event.modifiers() == Qt::NoModifier;
  const bool isTaken = event.button() == Qt::LeftButton && (IsCheck(cell) || isOpacity);
  this->Pressed = isTaken ? cell : QModelIndex();
  this->PressedAt = event.pos();
  this->IsDragging = false;
  return isTaken;
}

void StructureTable::mousePressEvent(QMouseEvent* event)
{
  if (!this->Press(*event))
  {
    QTableView::mousePressEvent(event);
  }
}

void StructureTable::mouseDoubleClickEvent(QMouseEvent* event)
{
  const QModelIndex cell = this->indexAt(event->pos());
  if (IsCheck(cell))
  {
    this->Press(*event); // two quick clicks
  }
  else if (cell.column() == StructureTableModel::OpacityColumn && event->button() == Qt::LeftButton)
  {
    this->edit(cell); // Qt did not see the first click
  }
  else
  {
    QTableView::mouseDoubleClickEvent(event);
  }
}

void StructureTable::mouseMoveEvent(QMouseEvent* event)
{
  if (!this->Pressed.isValid())
  {
    QTableView::mouseMoveEvent(event);
  }
  else if (this->Pressed.column() == StructureTableModel::OpacityColumn)
  {
    // A click with an unsteady hand selects.
    const int moved = (event->pos() - this->PressedAt).manhattanLength();
    this->IsDragging = this->IsDragging || moved >= QApplication::startDragDistance();
    if (this->IsDragging)
    {
      this->TellOpacity(event->pos().x(), false);
    }
  }
}

void StructureTable::mouseReleaseEvent(QMouseEvent* event)
{
  const QPersistentModelIndex cell = this->Pressed;
  if (!cell.isValid() || event->button() != Qt::LeftButton)
  {
    QTableView::mouseReleaseEvent(event);
    return;
  }
  if (this->IsDragging)
  {
    this->TellOpacity(event->pos().x(), true);
  }
  else if (this->indexAt(event->pos()) == cell)
  {
    IsCheck(cell) ? this->TellCheck(cell) : this->setCurrentIndex(cell);
  }
  this->Pressed = QModelIndex();
  this->IsDragging = false;
}

void StructureTable::TellOpacity(int x, bool isLast)
{
  const int percent = OpacityDelegate::PercentAt(this->visualRect(this->Pressed), x);
  Q_EMIT OpacityDragged(this->Pressed.data(StructureTableModel::IdRole).toInt(), percent, isLast);
}

void StructureTable::contextMenuEvent(QContextMenuEvent* event)
{
  Q_EMIT MenuAsked(event->globalPos());
}
} // namespace palpate
