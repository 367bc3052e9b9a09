#pragma once

#include "StudyController.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

namespace palpate
{
/// Under the views while a recorded touch is looked at: its moment as a slider, play and pause,
/// speed, time. Hidden otherwise.
class ReplayBar : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the address.
  explicit ReplayBar(StudyController& study, QWidget* parent = nullptr);

private:
  void ShowReplay();
  void ShowMoment();
  void MakeSpeeds();

  StudyController& Study;
  QLabel* Name;
  QPushButton* Play;
  QSlider* Slider;
  QLabel* Moment;
  QComboBox* Speed;
};
} // namespace palpate
