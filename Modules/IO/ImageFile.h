#pragma once

#include "FileKind.h"
#include "ImageGrid.h"
#include "ItkImageHeader.h"
#include "PalpateIOModule.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
class ItkImageReader;
class NiftiVoxels;

/// One image file: NIfTI-1 read here, the others with ITK. The constructor reads the header only;
/// the voxels then go straight from the reader into the VTK array, in the type that the file has
/// (after its rescale slope). Every failure is an InputError; nothing is printed.
class PALPATEIO_EXPORT ImageFile
{
public:
  /// Throws InputError where the header cannot be read or its geometry is no volume's. The kind is
  /// any but DICOM.
  ImageFile(const std::filesystem::path& file, FileKind kind);
  ImageFile(const ImageFile&) = delete;
  ImageFile& operator=(const ImageFile&) = delete;
  ~ImageFile();

  /// Patient LPS, mm; as in the file, so perhaps left-handed.
  const ImageGrid& Grid() const { return this->FileGrid; }
  int Components() const { return this->Header.Components; }
  /// VTK_SHORT, ...
  int ScalarType() const { return this->Header.VtkType; }
  /// Text entries of the header (NRRD's key/value pairs).
  const std::map<std::string, std::string>& Entries() const { return this->Header.Entries; }
  /// Sentences on what was made of the header.
  const std::vector<std::string>& Notes() const { return this->HeaderNotes; }

  /// An array of the file's type, components and voxel count, not yet filled. Throws InputError
  /// where it does not fit into memory.
  vtkSmartPointer<vtkDataArray> NewArray() const;
  /// Reads all voxels to `buffer`, which has room for them. Throws InputError for a file that is
  /// truncated or damaged.
  void ReadInto(void* buffer);

private:
  void OpenNifti();
  void OpenNrrd();
  void OpenMetaImage();
  void OpenReader();
  void CheckHeader() const;
  void TakeGrid();
  // Of all voxels. A double, since a header may promise anything.
  double DataBytes() const;

  std::filesystem::path File;
  FileKind Kind;
  std::unique_ptr<NiftiVoxels> Nifti; ///< for NIfTI, else Reader
  std::unique_ptr<ItkImageReader> Reader;
  ItkImageHeader Header;
  ImageGrid FileGrid;
  std::vector<std::string> HeaderNotes;
};
} // namespace palpate
