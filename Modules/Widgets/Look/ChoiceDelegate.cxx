#include "ChoiceDelegate.h"

#include <QComboBox>

namespace palpate
{
QWidget* ChoiceDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                                      const QModelIndex& /*index*/) const
{
  auto* box = new QComboBox(parent);
  box->addItems(this->Choices);
  return box;
}

void ChoiceDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const
{
  qobject_cast<QComboBox*>(editor)->setCurrentIndex(index.data(Qt::EditRole).toInt());
}

void ChoiceDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                  const QModelIndex& index) const
{
  model->setData(index, qobject_cast<QComboBox*>(editor)->currentIndex(), Qt::EditRole);
}
} // namespace palpate
