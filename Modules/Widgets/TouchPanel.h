#pragma once

#include "StudyController.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

class QFormLayout;

namespace palpate
{
/// The device, the tool, start and stop, what the safety chain does, and the button that stops all
/// force.
class TouchPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the address.
  explicit TouchPanel(StudyController& study, QWidget* parent = nullptr);

  /// What the safety chain does, in words.
  QString SafetyWords() const { return this->Safety->text(); }

private:
  void MakeButtons();
  void MakeSettings(QFormLayout* form);
  void ShowState();
  void ShowTouch();
  void ShowReading();
  void ChangeScale(double scale);
  QString Warnings() const;

  StudyController& Study;
  QComboBox* Device;
  QDoubleSpinBox* Radius;
  QDoubleSpinBox* Scale;
  QCheckBox* FollowCamera;
  QPushButton* Start;
  QPushButton* StopForce;
  QPushButton* AllowForce;
  QLabel* Safety;
  QLabel* Felt;
  QLabel* Advice;
};
} // namespace palpate
