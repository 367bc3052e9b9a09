#include "OpacityDelegate.h"

#include <QPainter>
#include <QSpinBox>

#include <algorithm>

namespace palpate
{
namespace
{
constexpr int BarHeight = 4; // pixels, below the number

QRect BarOf(const QRect& cell)
{
  return {cell.left() + 3, cell.bottom() - BarHeight, std::max(1, cell.width() - 7), BarHeight};
}
} // namespace

int OpacityDelegate::PercentAt(const QRect& cell, int x)
{
  const QRect bar = BarOf(cell);
  return std::clamp((200 * (x - bar.left()) / bar.width() + 1) / 2, 0, 100);
}

void OpacityDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const
{
  QStyledItemDelegate::paint(painter, option, index);
  const bool isSelected = option.state & QStyle::State_Selected;
  QColor color = option.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Highlight);
  const QRect bar = BarOf(option.rect);
  const int filled = bar.width() * index.data(Qt::EditRole).toInt() / 100;
  painter->fillRect(QRect(bar.topLeft(), QSize(filled, bar.height())), color);
  color.setAlphaF(0.3);
  painter->fillRect(bar.adjusted(filled, 0, 0, 0), color);
}

QWidget* OpacityDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                                       const QModelIndex& /*index*/) const
{
  auto* box = new QSpinBox(parent);
  box->setRange(0, 100);
  box->setSuffix(" %");
  box->setFrame(false);
  return box;
}
} // namespace palpate
