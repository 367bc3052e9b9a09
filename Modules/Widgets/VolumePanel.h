#pragma once

#include "StudyController.h"
#include "ViewContents.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QWidget>

namespace palpate
{
/// The open files, and window and level of the volume as numbers and presets.
class VolumePanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  VolumePanel(StudyController& study, const ViewContents& contents, QWidget* parent);

private:
  QDoubleSpinBox* AddNumber(const char* name);
  void ShowFiles();
  void ShowWindow();
  void TakeNumbers();
  void TakePreset(int preset);

  StudyController& Study;
  vtkImageDisplay* Images;
  QLabel* VolumeText;
  QLabel* LabelsText;
  QDoubleSpinBox* Width;
  QDoubleSpinBox* Level;
  QComboBox* Preset;
};
} // namespace palpate
