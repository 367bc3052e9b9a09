#pragma once

#include "PalpateIOModule.h"
#include "SegmentCodes.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// One structure of a segmentation: the voxels of a layer that have one value.
struct Segment
{
  int Label = 0;    ///< number for the user; unique in the segmentation
  int Value = 0;    ///< voxel value in its layer; equals Label if that is unique
  int Layer = 0;    ///< index into Segmentation::Layers
  std::string Name; ///< empty if the file has none
  std::array<double, 3> Color{{0.9, 0.6, 0.4}}; ///< red, green, blue in 0..1
  SegmentCodes Codes = {};                      ///< empty if the file has none
};

/// A mask of a folder that its segmentation lacks.
struct RefusedMask
{
  std::filesystem::path File;
  std::string Message; ///< why, a sentence that begins with the file
};

/// A label map, or several if structures overlap. Layers are one-component images of type unsigned
/// char, unsigned short or int, with origin, spacing (mm) and a right-handed direction matrix in
/// patient LPS; 0 is background.
struct Segmentation
{
  std::vector<vtkSmartPointer<vtkImageData>> Layers;
  std::vector<Segment> Segments; ///< those with at least one voxel, by ascending Label
  std::filesystem::path Source;
  std::vector<std::string> Notes;   ///< changes made to the file's data
  std::vector<RefusedMask> Refused; ///< of a folder of masks
  bool IsOriented = true;           ///< false: the file does not state its axes in the patient

  /// Finds a segment by label number or name. Throws InputError with the list of segments.
  PALPATEIO_EXPORT const Segment& Find(const std::string& labelOrName) const;
  /// The notes, and why masks were refused.
  PALPATEIO_EXPORT std::vector<std::string> Remarks() const;
};
} // namespace palpate
