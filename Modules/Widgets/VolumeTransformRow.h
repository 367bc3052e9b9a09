#pragma once

#include "FileQuestions.h"
#include "StudyController.h"
#include "VolumeList.h"

#include <QPushButton>
#include <QWidget>

namespace palpate
{
/// The transform that moves the selected volume onto the first one, and structures of its values.
class VolumeTransformRow : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  VolumeTransformRow(StudyController& study, const VolumeList& volumes,
                     const FileQuestions& questions, QWidget* parent);

  /// Shows the volume that is selected now, which is a further one.
  void ShowVolume();

Q_SIGNALS:
  /// Make a structure of the values of this volume.
  void ValuesAsked(int volumeId);

private:
  void Choose();
  void Take(const QString& transform); // empty: none

  StudyController& Study;
  const VolumeList& Volumes;
  const FileQuestions& Questions;
  QPushButton* Choosing;
  QPushButton* Clearing;
  QPushButton* Adding;
};
} // namespace palpate
