#pragma once

#include "StudyController.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace palpate
{
/// Scene-wide quality presets, from faster to more accurate, with their cost and accuracy: expected
/// values once measured, and the servo's own ticks while touching. One button measures the presets,
/// another applies the recommendation for each structure.
class QualityPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the address.
  explicit QualityPanel(StudyController& study, QWidget* parent = nullptr);

  QString NumbersText() const { return this->Numbers->text(); }
  /// Cost of each preset for each structure; the tool tip.
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
  PeriodStatistics Last;     // up to the last poll
  double Microseconds = 0.0; // mean tick between the last two polls; 0 if unknown
};
} // namespace palpate
