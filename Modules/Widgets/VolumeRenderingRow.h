#pragma once

#include "StudyController.h"
#include "VolumeList.h"

#include <QCheckBox>
#include <QComboBox>
#include <QWidget>

namespace palpate
{
/// Whether and how the selected volume is drawn in the 3-D view.
class VolumeRenderingRow : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  VolumeRenderingRow(StudyController& study, const VolumeList& volumes, QWidget* parent);

  /// Shows the volume that is selected now.
  void ShowVolume();

private:
  StudyRendering Current() const;
  void Change(const StudyRendering& changed, const QString& message);
  void TakeTick();
  void TakePreset(int preset);

  StudyController& Study;
  const VolumeList& Volumes;
  QCheckBox* IsShown;
  QComboBox* Preset;
};
} // namespace palpate
