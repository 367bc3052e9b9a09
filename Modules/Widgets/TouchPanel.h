#pragma once

#include "DevicePanel.h"
#include "StudyController.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

class QFormLayout;
class QHBoxLayout;

namespace palpate
{
/// The device, the tool, start and stop, recording, and the status of the safety chain.
class TouchPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the address.
  explicit TouchPanel(StudyController& study, QWidget* parent = nullptr);

  /// Adds buttons for menu actions.
  void AddTools(const QList<QAction*>& actions);

  DevicePanel* Devices() const { return this->Device; }
  /// Text on the safety chain.
  QString SafetyWords() const { return this->Safety->text(); }
  /// Text on the recording or replay.
  QString RecordingWords() const { return this->Recording->text(); }

Q_SIGNALS:
  /// The user asks to start or stop touching.
  void StartAsked();
  /// The user asks to begin or end a recording.
  void RecordAsked();

private:
  void MakeButtons();
  void MakeSettings(QFormLayout* form);
  void ShowState();
  void ShowTouch();
  void ShowReading();
  void ChangeShape(double length, double shaft);
  void ChangeScale(double scale);
  void ShowRecording();
  QString Warnings() const;

  StudyController& Study;
  QHBoxLayout* Tools;
  DevicePanel* Device;
  QDoubleSpinBox* Radius;
  QDoubleSpinBox* Length;
  QDoubleSpinBox* Shaft;
  QDoubleSpinBox* Scale;
  QCheckBox* FollowCamera;
  QPushButton* Start;
  QPushButton* Record;
  QLabel* Recording;
  QLabel* Safety;
  QLabel* Felt;
  QLabel* Advice;
};
} // namespace palpate
