#pragma once

#include "StudyController.h"
#include "ViewContents.h"
#include "VolumeList.h"
#include "VolumeRenderingRow.h"
#include "VolumeTransformRow.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QWidget>

namespace palpate
{
/// The open files, and how the selected volume is shown: window and level as numbers and presets,
/// and for a volume over the first one colours and opacity.
class VolumePanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  VolumePanel(StudyController& study, const ViewContents& contents, const FileQuestions& questions,
              QWidget* parent);

Q_SIGNALS:
  /// Make a structure of the values of this further volume.
  void ValuesAsked(int volumeId);

private:
  QDoubleSpinBox* AddNumber(const char* name);
  void ShowFiles();
  void ShowWindow();
  void ShowOverlay();
  void SetWindow(double width, double level);
  void TakeNumbers();
  void TakePreset(int preset);
  void TakeOverlay();
  void ChangeOverlay(const StudyVolume& changed, const QString& what);
  const StudyVolume* Overlay() const;
  vtkImageData* Image() const;

  StudyController& Study;
  const ViewContents& Contents;
  vtkImageDisplay* Images;
  QLabel* VolumeText;
  QLabel* LabelsText;
  VolumeList* Volumes;
  QDoubleSpinBox* Width;
  QDoubleSpinBox* Level;
  QComboBox* Preset;
  QComboBox* Colors;
  QSlider* Opacity;
  QCheckBox* HidesBelow;
  QWidget* OfOverlay; // its colours and opacity
  VolumeTransformRow* Moving;
  VolumeRenderingRow* InSpace;
};
} // namespace palpate
