#pragma once

#include "StudyController.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

namespace palpate
{
/// Below the views during a replay: time slider, play and pause, speed, time. Hidden otherwise.
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
