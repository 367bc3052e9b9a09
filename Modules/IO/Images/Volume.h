#pragma once

#include "LeftHandedAxes.h"
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
  /// Sentences about what was done to the file's data on the way in (an axis reversed, ...).
  std::vector<std::string> Notes;
};

/// What the user may have to choose before a path can be read.
struct VolumeChoice
{
  /// Series instance UID, or its number in the list that the error message gives (from 1); empty
  /// where there is only one.
  std::string DicomSeries;
  LeftHandedAxes LeftHanded = LeftHandedAxes::Reverse;
};
} // namespace palpate
