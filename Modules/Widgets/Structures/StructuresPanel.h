#pragma once

#include "StructureEdits.h"
#include "StructureFilterModel.h"
#include "StructureMenu.h"
#include "StructureTable.h"
#include "StructureTableModel.h"
#include "StructureVerdicts.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLineEdit>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include <functional>
#include <vector>

namespace palpate
{
/// The table of structures with its search, what can be done with many of them at once, and the
/// opacity of labels over the slices.
class StructuresPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the address.
  explicit StructuresPanel(StudyController& study, QWidget* parent = nullptr);

  std::vector<int> SelectedIds() const { return this->Table->SelectedIds(); }
  /// Of the masks, which the table marks.
  StructureVerdicts& Verdicts() { return *this->Checked; }
  /// What adds structures, for the menu of a button.
  void AddAdding(const QList<QAction*>& actions);
  /// Selects the row of a structure, which is listed again if the search left it out. Tells
  /// SelectionChanged, but not Selected.
  void Select(int id);

Q_SIGNALS:
  void OpacityChosen(double opacity);
  /// The user selected a row, or asked to centre the views at it.
  void Selected(int id);
  /// The user chose the mark of a mask that is not plausible: show where (world, mm).
  void PlaceChosen(const Vector3& placeWorld);
  void CheckAsked();
  /// Other rows are selected, for whatever reason.
  void SelectionChanged();

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  void ConnectTable();
  QBoxLayout* MakeSearch();
  QBoxLayout* MakeTools();
  void MakeShowMenu(QToolButton* button);
  QWidget* MakeButton(const QString& text, const char* name, const QString& tip,
                      void (StructuresPanel::*act)());
  void ShowOpacity(double opacity);
  void KeepSelection();
  void TakeSelection(const QItemSelection& selected);
  void TakeCheck(int id, int column, bool isOn);
  void TakeOpacity(int id, int percent, bool isLast);
  void TakeText(const QString& text);
  void OpenCell(const QModelIndex& index);
  void ShowFinding(const QModelIndex& index);
  void OpenMenu(const QPoint& global);
  void Act(int entry);
  void ShowOnlySelected();
  void ShowDetails();
  void ShowGuide();
  void Remove();
  void ChooseColor();
  void ChooseOpacity();
  void ChooseColorOf(const QModelIndex& index);
  std::vector<int> WithSelected(int id) const;

  StudyController& Study;
  StructureEdits Edits;
  StructureVerdicts* Checked;
  StructureTableModel* Model;
  StructureFilterModel* Listed;
  StructureTable* Table;
  StructureMenu* Menu;
  QLineEdit* Search;
  QComboBox* Kept;
  QMenu* Add;
  QSlider* Opacity;
  std::vector<int> SelectedBefore; ///< while the list changes
  bool IsQuiet = false;            ///< while the selection is changed by the program
};
} // namespace palpate
