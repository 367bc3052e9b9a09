#pragma once

#include "FileQuestions.h"
#include "StudyController.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

#include <functional>
#include <string>
#include <vector>

namespace palpate
{
/// Drilling: each structure's drill role, the burr and its pedal, removed volumes, distances to
/// forbidden structures, and undo and redo.
class DrillPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  DrillPanel(StudyController& study, const FileQuestions& questions, QWidget* parent = nullptr);

  /// The panel's text on forbidden structures near the drill, and on why it does not cut.
  QString AlarmWords() const { return this->Alarm->text(); }

private:
  void MakeBurr(QWidget* row);
  void MakeButtons(QWidget* row);
  void MakeTable();
  QPushButton* AddButton(QWidget* row, const QString& text, const QString& name,
                         const std::function<void()>& act);
  void ShowState();
  void MakeRow(int row, const SceneStructure& structure);
  void ShowRow(int row, const SceneStructure& structure);
  bool HasRowsOf(const StudyState& state) const;
  void ShowReading();
  void ShowAlarm(const StudyDrillReading& reading, const std::vector<StudyForbidden>& forbidden);
  std::string HoldText(const StudyDrillReading& reading,
                       std::vector<StudyForbidden> forbidden) const;
  void ChangeStructure(int label, const QString& message,
                       const std::function<void(SceneStructure&)>& change);
  void Press(bool isDown);
  void Save();
  void Open();
  void Export();

  StudyController& Study;
  const FileQuestions& Questions;
  QPushButton* Pedal = nullptr;
  QPushButton* Undo = nullptr;
  QPushButton* Redo = nullptr;
  QDoubleSpinBox* Radius = nullptr; // mm
  QDoubleSpinBox* Turns = nullptr;  // per second
  QTableWidget* Table;
  QLabel* Alarm;
};
} // namespace palpate
