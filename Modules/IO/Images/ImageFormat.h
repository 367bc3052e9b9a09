#pragma once

#include "FileFormat.h"
#include "ImageFile.h"
#include "PalpateIOModule.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <filesystem>
#include <functional>
#include <memory>

namespace palpate
{
/// A format of images; a file holds one volume or several of the same grid.
struct ImageFormat : FileFormat
{
  /// Reads the header. Throws InputError if it is damaged.
  std::function<std::unique_ptr<ImageFile>(const std::filesystem::path& file)> Open;
  /// Writes the image's grid with `voxels`; throws a std::exception if it cannot.
  std::function<void(const std::filesystem::path& file, vtkImageData* image, vtkDataArray* voxels)>
      Write;
  /// Writes numbers through C++ streams (see CNumericLocale::RequireOfStreams).
  bool WritesThroughStreams = false;
  /// Adds names and colours of labels to a file that Write has just written, whose voxels are
  /// these; throws a std::exception if it cannot. Null if the format has no place for them.
  std::function<void(const std::filesystem::path& file, vtkDataArray* voxels,
                     const LabelTable& labels)>
      AddLabels = nullptr;
};

/// NIfTI, Analyze, NRRD, MetaImage, FreeSurfer, GIPL and added formats.
PALPATEIO_EXPORT FormatList<ImageFormat>& ImageFormats();

/// The format of a file that is not DICOM, by its ending. Throws InputError if there is none.
PALPATEIO_EXPORT const ImageFormat& ImageFormatOf(const std::filesystem::path& file);

/// Reads the header of such a file. Throws InputError if it is damaged or not that of a volume.
PALPATEIO_EXPORT std::unique_ptr<ImageFile> OpenImage(const std::filesystem::path& file,
                                                      ShearedAxes sheared = ShearedAxes::Refuse);

/// Endings of all readable images and segmentations, including DICOM.
PALPATEIO_EXPORT std::vector<std::string> ReadableImageEndings();

/// A file's name without its folder and such an ending.
PALPATEIO_EXPORT std::string ImageNameOf(const std::filesystem::path& file);
} // namespace palpate
