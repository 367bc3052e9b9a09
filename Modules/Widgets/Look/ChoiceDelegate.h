#pragma once

#include <QStringList>
#include <QStyledItemDelegate>

#include <functional>
#include <utility>

namespace palpate
{
/// A cell that holds the number of one of a few choices. It looks like a combo box, and its list
/// opens as soon as it is edited.
class ChoiceDelegate : public QStyledItemDelegate
{
  Q_OBJECT

public:
  using Taking = std::function<void(const QModelIndex& cell, int choice)>;

  /// A choice is set in the model, or passed to `take`.
  ChoiceDelegate(const QStringList& choices, QObject* parent, Taking take = {})
      : QStyledItemDelegate(parent), Choices(choices), TakeChoice(std::move(take))
  {
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model,
                    const QModelIndex& index) const override;

private:
  void Take();

  QStringList Choices;
  Taking TakeChoice;
};
} // namespace palpate
