#pragma once

#include <QPersistentModelIndex>
#include <QPoint>
#include <QTableView>

#include <vector>

namespace palpate
{
/// The view of a StructureFilterModel. Check boxes and opacities are changed without changing the
/// selection, which may hold several rows; names are edited by F2 or a double click only, so that
/// typed text can search.
class StructureTable : public QTableView
{
  Q_OBJECT

public:
  explicit StructureTable(QWidget* parent);

  void setModel(QAbstractItemModel* model) override;
  /// Ids of the selected rows, in their order.
  std::vector<int> SelectedIds() const;
  /// The structure of the row with the cursor if that is selected, else of the first selected row;
  /// 0 if none is.
  int CurrentId() const;
  void SelectIds(const std::vector<int>& ids);
  /// Edits the name in the row of the cursor.
  void Rename();
  /// Whether the status is next to the name, before drill roles.
  void PutStatusFirst(bool isFirst);
  /// Sideways only if the cell cannot be seen: names stay where they are read.
  void scrollTo(const QModelIndex& cell, ScrollHint hint = EnsureVisible) override;

Q_SIGNALS:
  /// A check box of this structure was clicked, or switched by the space bar.
  void CheckChosen(int id, int column, bool isOn);
  /// An opacity is being dragged; `isLast` at the end.
  void OpacityDragged(int id, int percent, bool isLast);
  void MenuAsked(const QPoint& global);
  /// Printable text was typed that nothing is edited by.
  void Typed(const QString& text);

protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  int WidthOf(int column) const;
  int WidthOfNames() const;
  int WidthBesideNames() const;
  void KeepWidth(int column, int before, int width);
  void SetWidths();
  void FitName();
  bool Press(const QMouseEvent& event);
  void TellCheck(const QModelIndex& cell);
  void TellOpacity(int x, bool isLast);

  QPersistentModelIndex Pressed; ///< the cell that the mouse went down on, unless it only selects
  QPoint PressedAt;
  bool IsDragging = false;
  bool IsFitting = false; ///< widths are changed by the program
};
} // namespace palpate
