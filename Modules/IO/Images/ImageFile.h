#pragma once

#include "ImageGrid.h"
#include "ItkImageHeader.h"
#include "LabelTable.h"
#include "PalpateIOModule.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace palpate
{
/// An image file whose header has been read; the reader then writes the voxels directly into the
/// VTK array, in the file's type (after its rescale slope). Every failure is an InputError; nothing
/// is printed.
class PALPATEIO_EXPORT ImageFile
{
public:
  ImageFile(const ImageFile&) = delete;
  ImageFile& operator=(const ImageFile&) = delete;
  virtual ~ImageFile() = default;

  /// Throws InputError if the grid is not valid for a volume (see CheckGrid).
  void CheckVolume(ShearedAxes sheared)
  {
    CheckGrid(this->File, this->FileGrid, this->HeaderNotes, sheared);
  }
  /// Patient LPS, mm; as in the file, so possibly left-handed.
  const ImageGrid& Grid() const { return this->FileGrid; }
  int Components() const { return this->Header.Components; }
  /// VTK_SHORT, ...
  int ScalarType() const { return this->Header.VtkType; }
  /// Text entries of the header (NRRD's key/value pairs).
  const std::map<std::string, std::string>& Entries() const { return this->Header.Entries; }
  /// Names and colours of the values as labels; empty if the header has none.
  const LabelTable& Labels() const { return this->HeaderLabels; }
  /// Notes on the interpretation of the header, as sentences.
  const std::vector<std::string>& Notes() const { return this->HeaderNotes; }

  /// Volumes of a four-dimensional file; 1 for all others.
  virtual std::int64_t VolumeCount() const { return 1; }
  /// Chooses the volume that ReadInto reads by its number in the file, from 1. With one volume the
  /// text is ignored. Throws InputError for a number that the file lacks, and for an empty text.
  void ChooseVolume(const std::string& number);

  /// An uninitialized array of the file's type, components and voxel count. Throws InputError if it
  /// does not fit into memory or exceeds the file.
  vtkSmartPointer<vtkDataArray> NewArray() const;
  /// Reads all voxels to `buffer`, which must be large enough. Throws InputError for a truncated or
  /// damaged file.
  virtual void ReadInto(void* buffer) = 0;

protected:
  explicit ImageFile(const std::filesystem::path& file) : File(file) {}
  /// Throws InputError if the file is too short for its voxels.
  virtual void CheckLength() const {}
  /// Of all voxels. A double, since a header may declare any size.
  double DataBytes() const;

  std::filesystem::path File;
  ItkImageHeader Header;
  ImageGrid FileGrid;
  std::vector<std::string> HeaderNotes;
  LabelTable HeaderLabels;
  std::int64_t ChosenVolume = 0; ///< from 0
};
} // namespace palpate
