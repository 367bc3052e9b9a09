#include "ChoiceDelegate.h"

#include <QApplication>
#include <QComboBox>
#include <QTimer>

namespace palpate
{
namespace
{
constexpr int ArrowWidth = 14; // pixels

QStyle* StyleOf(const QStyleOptionViewItem& option)
{
  return option.widget != nullptr ? option.widget->style() : QApplication::style();
}
} // namespace

void ChoiceDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const
{
  QStyleOptionViewItem cell = option;
  this->initStyleOption(&cell, index);
  StyleOf(option)->drawPrimitive(QStyle::PE_PanelItemViewItem, &cell, painter, option.widget);
  QStyleOptionViewItem text = option;
  text.rect.setRight(option.rect.right() - ArrowWidth);
  QStyledItemDelegate::paint(painter, text, index);
  QStyleOption arrow = option;
  arrow.rect.setLeft(text.rect.right());
  // Styles draw arrows in a button's text colour.
  const bool isSelected = option.state & QStyle::State_Selected;
  arrow.palette.setColor(
      QPalette::ButtonText,
      option.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text));
  StyleOf(option)->drawPrimitive(QStyle::PE_IndicatorArrowDown, &arrow, painter, option.widget);
}

QWidget* ChoiceDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                                      const QModelIndex& /*index*/) const
{
  auto* box = new QComboBox(parent);
  box->addItems(this->Choices);
  connect(box, qOverload<int>(&QComboBox::activated), this, &ChoiceDelegate::Take);
  // The editor has no place and no choice yet.
  QTimer::singleShot(0, box, &QComboBox::showPopup);
  return box;
}

// A choice is taken at once, not when the editor loses the focus.
void ChoiceDelegate::Take()
{
  auto* box = qobject_cast<QWidget*>(this->sender());
  Q_EMIT commitData(box);
  Q_EMIT closeEditor(box);
}

void ChoiceDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const
{
  qobject_cast<QComboBox*>(editor)->setCurrentIndex(index.data(Qt::EditRole).toInt());
}

void ChoiceDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                  const QModelIndex& index) const
{
  const int choice = qobject_cast<QComboBox*>(editor)->currentIndex();
  if (this->TakeChoice)
  {
    this->TakeChoice(index, choice);
    return;
  }
  model->setData(index, choice, Qt::EditRole);
}
} // namespace palpate
