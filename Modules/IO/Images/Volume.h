#pragma once

#include "LabelTable.h"
#include "LeftHandedAxes.h"
#include "ShearedAxes.h"
#include "ValueChoice.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// An MR or CT volume. The image carries origin, spacing (mm) and a right-handed direction matrix
/// in patient LPS; its one-component scalars keep the file's type.
struct Volume
{
  vtkSmartPointer<vtkImageData> Image;
  std::filesystem::path Source;
  /// Changes made to the file's data (an axis reversed, ...), as sentences.
  std::vector<std::string> Notes;
  bool IsOriented = true; ///< false: the file does not state its axes in the patient
  LabelTable Labels = {}; ///< names and colours of its values in the file itself, if it has any
};

struct VolumeChoice
{
  /// DICOM: series instance UID, or its number in the error message's list (from 1). A file of
  /// several volumes: the number of one, from 1. Empty if there is only one.
  std::string Series;
  LeftHandedAxes LeftHanded = LeftHandedAxes::Reverse;
  ShearedAxes Sheared = ShearedAxes::Refuse;
  ValueChoice Values = {}; ///< of images; a segmentation that states its structures refuses one
};
} // namespace palpate
