#pragma once

#include "StructureTableModel.h"

#include <QSlider>
#include <QTableView>
#include <QWidget>

namespace palpate
{
/// The table of structures, their details, and the opacity of labels over the slices.
class StructuresPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the address.
  explicit StructuresPanel(StudyController& study, QWidget* parent = nullptr);

Q_SIGNALS:
  void OpacityChosen(double opacity);

private:
  void ShowOpacity(double opacity);
  void ChooseColor(const QModelIndex& index);
  int SelectedId() const;
  void ShowDetails();
  void Remove();

  StudyController& Study;
  StructureTableModel* Model;
  QTableView* Table;
  QSlider* Opacity;
};
} // namespace palpate
