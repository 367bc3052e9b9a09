#pragma once

#include "FileQuestions.h"
#include "MarkPlacer.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

namespace palpate
{
/// Landmarks and measurements in a table, placed by click or by touch, exchanged with other
/// programs.
class LandmarksPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  LandmarksPanel(StudyController& study, ViewContents& contents, const FileQuestions& questions,
                 QWidget* parent = nullptr);

  /// Whether a click on a view places a point.
  bool IsAdding() const { return this->AddMode->isChecked(); }
  /// Switches that, for the toolbar.
  QAction* Tool() const { return this->AddMode; }
  /// Places a point where the tool touches.
  QAction* TouchTool() const { return this->AddTouched; }
  /// Ends a curve.
  QAction* EndTool() const { return this->EndCurve; }
  void SetLengthUnit(LengthUnit unit);
  MarkPlacer* Placer() const { return this->Points; }

Q_SIGNALS:
  /// The user chose a row: show this point (world, mm).
  void Chosen(const Vector3& pointWorld);

private:
  void MakeActions();
  void MakeChoice();
  QWidget* MakeButtons();
  QPushButton* MakeButton(const QString& text, const char* name);
  void MakeGuide();
  void ChangeGuide(int shape);
  void ShowState();
  void TakeEdit(QTableWidgetItem* item);
  void ShowPreview(const QString& text);
  void ShowPlaceOf(std::size_t row);
  void AddDistance();
  void Remove();
  void Import();
  void Export();
  std::vector<std::size_t> SelectedRows() const;

  StudyController& Study;
  LengthUnit Unit = LengthUnit::Millimeter;
  int MarkCount = 0; ///< landmarks that are listed
  const FileQuestions& Questions;
  QTableWidget* Table;
  MarkPlacer* Points;
  QAction* AddMode;
  QAction* AddTouched;
  QAction* EndCurve;
  QComboBox* Next;
  QComboBox* Guide;
  QLabel* Value; ///< of what is being placed
};
} // namespace palpate
