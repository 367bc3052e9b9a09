#include "NiftiFormat.h"

#include "ItkImageWriter.h"
#include "NiftiHeader.h"
#include "StoredImageFile.h"

namespace palpate
{
namespace
{
class NiftiFile : public StoredImageFile
{
public:
  NiftiFile(const std::filesystem::path& file, const NiftiHeader& header)
      : StoredImageFile(file, header.Voxels)
  {
    this->FileGrid.Size = header.Size;
    this->FileGrid.Spacing = header.Spacing;
    PlaceGrid(file, header.Orientation, this->FileGrid);
    this->HeaderNotes = OrientationNotes(header.Orientation, this->FileGrid);
    if (header.IsAnalyze)
    {
      this->FileGrid.IsOriented = false;
      this->HeaderNotes = {"Analyze files state no reliable orientation; the index axes were taken "
                           "as L, P, S, as ITK does: check left and right."};
    }
    this->HeaderNotes.insert(this->HeaderNotes.end(), header.Notes.begin(), header.Notes.end());
  }
};

template <bool IsPair>
std::unique_ptr<ImageFile> OpenNifti(const std::filesystem::path& file)
{
  return std::make_unique<NiftiFile>(file, ReadNiftiHeader(file, IsPair));
}

void WriteNifti(const std::filesystem::path& file, vtkImageData* image, vtkDataArray* voxels)
{
  WriteWithItk(ItkFormat::Nifti, file, image, voxels, !EndingOf(file, {".gz"}).empty());
}
} // namespace

ImageFormat NiftiFormat()
{
  return {{"NIfTI", {".nii", ".nii.gz"}, {".nii", ".nii.gz"}}, &OpenNifti<false>, &WriteNifti};
}

ImageFormat NiftiPairFormat()
{
  return {{"NIfTI or Analyze pair", {".hdr", ".hdr.gz"}, {}}, &OpenNifti<true>, nullptr};
}
} // namespace palpate
