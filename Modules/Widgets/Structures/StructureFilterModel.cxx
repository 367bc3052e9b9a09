#include "StructureFilterModel.h"

#include "StructureTableModel.h"

#include <algorithm>

namespace palpate
{
StructureFilterModel::StructureFilterModel(QObject* parent) : QSortFilterProxyModel(parent)
{
  this->Order.setNumericMode(true);
  this->Order.setCaseSensitivity(Qt::CaseInsensitive);
  this->setSortRole(StructureTableModel::SortRole);
}

void StructureFilterModel::Search(const QString& text)
{
  const QStringList words = text.split(' ', Qt::SkipEmptyParts);
  if (words != this->Words)
  {
    this->Words = words;
    this->invalidateFilter();
  }
}

void StructureFilterModel::Keep(Kept kept)
{
  if (kept != this->Kind)
  {
    this->Kind = kept;
    this->invalidateFilter();
  }
}

std::vector<int> StructureFilterModel::Ids() const
{
  std::vector<int> ids;
  for (int row = 0; row < this->rowCount(); ++row)
  {
    ids.push_back(this->index(row, 0).data(StructureTableModel::IdRole).toInt());
  }
  return ids;
}

int StructureFilterModel::RowOf(int id) const
{
  const std::vector<int> ids = this->Ids();
  const auto found = std::find(ids.begin(), ids.end(), id);
  return found != ids.end() ? static_cast<int>(found - ids.begin()) : -1;
}

bool StructureFilterModel::filterAcceptsRow(int row, const QModelIndex& parent) const
{
  const auto cell = [&](int column) { return this->sourceModel()->index(row, column, parent); };
  const auto isOn = [&](int column)
  { return cell(column).data(Qt::CheckStateRole).toInt() == Qt::Checked; };
  if ((this->Kind == Kept::Visible && !isOn(StructureTableModel::VisibleColumn)) ||
      (this->Kind == Kept::Touchable && !isOn(StructureTableModel::TouchableColumn)))
  {
    return false;
  }
  if (this->Kind == Kept::Drilled &&
      cell(StructureTableModel::DrillColumn).data(Qt::EditRole).toInt() == 0)
  {
    return false;
  }
  const QString name = cell(StructureTableModel::NameColumn).data().toString();
  return std::all_of(this->Words.begin(), this->Words.end(),
                     [&name](const QString& word)
                     { return name.contains(word, Qt::CaseInsensitive); });
}

bool StructureFilterModel::lessThan(const QModelIndex& left, const QModelIndex& right) const
{
  const QVariant a = left.data(this->sortRole());
  const QVariant b = right.data(this->sortRole());
  return a.userType() == QMetaType::QString ? this->Order.compare(a.toString(), b.toString()) < 0
                                            : a.toDouble() < b.toDouble();
}
} // namespace palpate
