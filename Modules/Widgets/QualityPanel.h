#pragma once

#include "StudyController.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace palpate
{
/// Scene-wide quality presets, from faster to more accurate, with their cost and accuracy: expected
/// where they were measured, and the servo's own ticks while something is touched. A button
/// measures the presets and another applies what is recommended for each structure.
class QualityPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the address.
  explicit QualityPanel(StudyController& study, QWidget* parent = nullptr);

  QString NumbersText() const { return this->Numbers->text(); }
  /// What each preset would cost at each structure; the tool tip.
  QString DetailsText() const { return this->Numbers->toolTip(); }

private:
  void Choose(int preset);
  void Measure();
  void Show();
  void ShowNumbers();
  void MeasureTicks();

  StudyController& Study;
  QComboBox* Preset;
  QPushButton* Measuring;
  QPushButton* Recommended;
  QLabel* Numbers;
  std::vector<QualityLine> Lines;
  PeriodStatistics Last;     // up to the last look
  double Microseconds = 0.0; // mean of a tick between the last two looks; 0 without
};
} // namespace palpate
