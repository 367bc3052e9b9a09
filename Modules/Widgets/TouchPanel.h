#pragma once

#include "StudyController.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

class QFormLayout;
class QHBoxLayout;

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

  /// Buttons for what a menu does.
  void AddTools(const QList<QAction*>& actions);

  /// What the safety chain does, in words.
  QString SafetyWords() const { return this->Safety->text(); }
  /// What is recorded or replayed, in words.
  QString RecordingWords() const { return this->Recording->text(); }

Q_SIGNALS:
  /// The user wants a recording to begin, or to end.
  void RecordAsked();

private:
  void MakeButtons();
  void MakeSettings(QFormLayout* form);
  void ShowState();
  void ShowTouch();
  void ShowReading();
  void ChangeScale(double scale);
  void ShowRecording();
  QString Warnings() const;

  StudyController& Study;
  QHBoxLayout* Tools;
  QComboBox* Device;
  QDoubleSpinBox* Radius;
  QDoubleSpinBox* Scale;
  QCheckBox* FollowCamera;
  QPushButton* Start;
  QPushButton* StopForce;
  QPushButton* AllowForce;
  QPushButton* Record;
  QLabel* Recording;
  QLabel* Safety;
  QLabel* Felt;
  QLabel* Advice;
};
} // namespace palpate
