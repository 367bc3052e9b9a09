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
/// Drilling: what each structure is to the drill, the burr, its pedal, what is gone, how near it is
/// to what is forbidden, and steps back and forth.
class DrillPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  DrillPanel(StudyController& study, const FileQuestions& questions, QWidget* parent = nullptr);

  /// What the drill is near to, and why it cuts nothing, as the panel says it.
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
  void ChangeStructure(int label, const QString& sentence,
                       const std::function<void(SceneStructure&)>& change);
  void Press(bool isDown);
  void Save();
  void Open();
  void Export();
  void Try(const std::function<void()>& act);

  StudyController& Study;
  const FileQuestions& Questions;
  QPushButton* Pedal = nullptr;
  QPushButton* Undo = nullptr;
  QPushButton* Redo = nullptr;
  QDoubleSpinBox* Radius = nullptr; // mm
  QDoubleSpinBox* Turns = nullptr;  // a second
  QTableWidget* Table;
  QLabel* Alarm;
};
} // namespace palpate
