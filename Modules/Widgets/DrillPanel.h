#pragma once

#include "FileQuestions.h"
#include "StudyController.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include <functional>
#include <string>
#include <vector>

namespace palpate
{
/// Drilling: the burr and its pedal, alarms, undo and redo. Roles and removed volumes are columns
/// of the structures' table.
class DrillPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  DrillPanel(StudyController& study, const FileQuestions& questions, QWidget* parent = nullptr);

  /// The panel's text on forbidden structures near the drill, and on why it does not cut.
  QString AlarmWords() const { return this->Alarm->text(); }
  /// The structure that is exported, if it is drilled; else the first one that is.
  void Choose(int id) { this->Chosen = id; }

private:
  void MakeBurr(QWidget* row);
  void MakeButtons(QWidget* row);
  QPushButton* AddButton(QWidget* row, const QString& text, const QString& name,
                         const std::function<void()>& act);
  void ShowState();
  void ShowReading();
  void ShowAlarm(const StudyDrillReading& reading, const std::vector<StudyForbidden>& forbidden);
  std::string HoldText(const StudyDrillReading& reading,
                       std::vector<StudyForbidden> forbidden) const;
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
  QLabel* Alarm;
  int Chosen = 0;
};
} // namespace palpate
