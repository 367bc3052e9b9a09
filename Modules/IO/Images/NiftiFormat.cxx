#include "NiftiFormat.h"

#include "ItkImageWriter.h"
#include "NiftiVoxels.h"

namespace palpate
{
namespace
{
class NiftiFile : public ImageFile
{
public:
  explicit NiftiFile(const std::filesystem::path& file)
      : ImageFile(file), FileHeader(ReadNiftiHeader(file)), Voxels(file, this->FileHeader)
  {
    this->Header.Components = 1;
    this->Header.VtkType = this->Voxels.ScalarType();
    this->FileGrid.Size = this->FileHeader.Size;
    this->FileGrid.Spacing = this->FileHeader.Spacing;
    PlaceGrid(file, this->FileHeader.Orientation, this->FileGrid);
    this->HeaderNotes = OrientationNotes(this->FileHeader.Orientation, this->FileGrid);
  }

  void ReadInto(void* buffer) override { this->Voxels.ReadInto(buffer); }

private:
  NiftiHeader FileHeader;
  NiftiVoxels Voxels;
};

void Write(const std::filesystem::path& file, vtkImageData* image, vtkDataArray* voxels)
{
  WriteWithItk(ItkFormat::Nifti, file, image, voxels, !EndingOf(file, {".gz"}).empty());
}
} // namespace

ImageFormat NiftiFormat()
{
  return {{"NIfTI", {".nii", ".nii.gz"}, {".nii", ".nii.gz"}},
          [](const std::filesystem::path& file) { return std::make_unique<NiftiFile>(file); },
          &Write};
}
} // namespace palpate
