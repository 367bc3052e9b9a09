#pragma once

#include <QStyledItemDelegate>

namespace palpate
{
/// A cell that holds a percentage: a number over a bar, edited by a spin box.
class OpacityDelegate : public QStyledItemDelegate
{
  Q_OBJECT

public:
  using QStyledItemDelegate::QStyledItemDelegate;

  /// What the bar of a cell would be at a horizontal position, 0 to 100.
  static int PercentAt(const QRect& cell, int x);

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
};
} // namespace palpate
