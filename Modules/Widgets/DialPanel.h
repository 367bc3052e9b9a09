#pragma once

#include "StudyController.h"
#include "StudyDialReport.h"

#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QWidget>

namespace palpate
{
/// One dial for the whole scene, from faster to truer, with what that costs and brings beside it:
/// expected where it was measured, and the servo's own ticks while something is touched.
class DialPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the address.
  explicit DialPanel(StudyController& study, QWidget* parent = nullptr);

  QString NumbersWords() const { return this->Numbers->text(); }
  /// What was chosen for each structure, and what the other rungs would be: a tool tip, since the
  /// table of structures shows the first too.
  QString SettingsWords() const { return this->Numbers->toolTip(); }

private:
  void MakeMode();
  void MakeSlider();
  void Turn(StudyDial dial, const QString& gesture);
  void Show();
  void ShowNumbers();
  void MeasureTicks();

  StudyController& Study;
  QComboBox* Mode;
  QSlider* Rung;
  QLabel* Numbers;
  std::vector<StudyDialLine> Lines;
  PeriodStatistics Last;     // up to the last look
  double Microseconds = 0.0; // mean of a tick between the last two looks; 0 without
};
} // namespace palpate
