#pragma once

#include "HistogramView.h"
#include "StudyController.h"

#include "vtkImageDisplay.h"
#include "vtkSmartPointer.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>

#include <memory>
#include <utility>
#include <vector>

namespace palpate
{
/// Makes a structure of a range of a volume's values, in the whole volume or inside a label. The
/// slices show the range while it is chosen, unless the volume is a further one. Accepting it is
/// one undo step of the study; it closes if the study gets another volume.
class ThresholdDialog : public QDialog
{
  Q_OBJECT

public:
  /// Keeps the address of the study, whose volume of this id (0: the first one) must have been
  /// read. `images` shows the first one.
  ThresholdDialog(StudyController& study, vtkImageDisplay* images, QWidget* parent,
                  int volumeId = 0);

  void accept() override;
  void done(int result) override;

private:
  void AddValues();
  QWidget* AddValue(const char* name, QDoubleSpinBox*& box);
  void AddPresets();
  void AddMasks();
  void ListMasks();
  void FollowStudy();
  void ShowOnSlices();
  double Upper() const;
  std::shared_ptr<const Segmentation> SegmentationOf(const SceneStructure& structure) const;

  StudyController& Study;
  vtkSmartPointer<vtkImageDisplay> Images;
  int VolumeId;
  std::shared_ptr<const Volume> Shown;
  ValueHistogram Histogram;
  QFormLayout* Form;
  HistogramView* Chart;
  QDoubleSpinBox* LowerBox = nullptr;
  QDoubleSpinBox* UpperBox = nullptr;
  QCheckBox* HasUpper;
  QComboBox* Masks;
  std::vector<std::pair<int, QString>> Offered; ///< id and title of each mask
  QLineEdit* Name;
  QPushButton* Add = nullptr;
};
} // namespace palpate
