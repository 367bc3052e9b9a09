#pragma once

#include <QCollator>
#include <QSortFilterProxyModel>
#include <QStringList>

#include <vector>

namespace palpate
{
/// The rows of a StructureTableModel that are searched for, in the study's order or sorted by a
/// column. Names are sorted by the value of their numbers, whatever their case.
class StructureFilterModel : public QSortFilterProxyModel
{
  Q_OBJECT

public:
  enum class Kept
  {
    All,
    Visible,
    Touchable,
    Drilled ///< or forbidden
  };

  explicit StructureFilterModel(QObject* parent);

  /// Keeps names that contain every word of the text.
  void Search(const QString& text);
  void Keep(Kept kept);
  /// Ids of the rows, in their order.
  std::vector<int> Ids() const;
  /// -1 if the structure is not listed.
  int RowOf(int id) const;

protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
  QStringList Words;
  Kept Kind = Kept::All;
  QCollator Order{QLocale(QLocale::English)};
};
} // namespace palpate
