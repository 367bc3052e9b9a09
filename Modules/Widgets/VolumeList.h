#pragma once

#include "StudyController.h"

#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QWidget>

namespace palpate
{
/// The volumes of a study where there are several: which are shown over the first one, and where.
/// The one that is selected is the one whose settings a panel shows.
class VolumeList : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the address.
  VolumeList(StudyController& study, QWidget* parent);

  /// The id of the selected volume; 0 for the first one.
  int Chosen() const { return this->Id; }
  /// Changes the settings of a volume over the first one; see StudyController::Change.
  void Change(const QString& message, const StudyVolume& changed, const QString& gesture = {});

Q_SIGNALS:
  void Changed(); ///< another volume is selected

private:
  void Show();
  void ShowMixing();
  void TakeCheck(QListWidgetItem* item);
  void TakeRow(int row);
  void Remove();
  void TakeMixing();

  StudyController& Study;
  QListWidget* Volumes;
  QPushButton* RemoveButton;
  QComboBox* Mixing;
  QSlider* Curtain;
  int Id = 0;
};
} // namespace palpate
