#pragma once

#include <QStringList>
#include <QStyledItemDelegate>

namespace palpate
{
/// Edits a cell that holds the number of one of a few choices.
class ChoiceDelegate : public QStyledItemDelegate
{
  Q_OBJECT

public:
  ChoiceDelegate(const QStringList& choices, QObject* parent)
      : QStyledItemDelegate(parent), Choices(choices)
  {
  }

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model,
                    const QModelIndex& index) const override;

private:
  QStringList Choices;
};
} // namespace palpate
