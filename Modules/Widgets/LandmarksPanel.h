#pragma once

#include "FileQuestions.h"
#include "StudyController.h"

#include <QAction>
#include <QComboBox>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <QWidget>

namespace palpate
{
/// Landmarks and distances in a table, placed by click or by touch, with export to other programs.
class LandmarksPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  LandmarksPanel(StudyController& study, const FileQuestions& questions, QWidget* parent = nullptr);

  /// Whether a click on a view places a landmark.
  bool IsAdding() const { return this->AddMode->isChecked(); }
  /// Switches that, for the toolbar.
  QAction* Tool() const { return this->AddMode; }
  /// World, mm.
  void Add(const Vector3& pointWorld);

Q_SIGNALS:
  /// The user chose a row: show this point (world, mm).
  void Chosen(const Vector3& pointWorld);

private:
  void MakeButtons();
  void MakeGuide(QVBoxLayout* column);
  void ChangeGuide(int shape);
  void ShowState();
  void TakeEdit(QTableWidgetItem* item);
  void AddAtProxy();
  void AddDistance();
  void Remove();
  void Export();
  std::vector<std::size_t> SelectedRows() const;

  StudyController& Study;
  const FileQuestions& Questions;
  QTableWidget* Table;
  QAction* AddMode;
  QComboBox* Guide;
};
} // namespace palpate
