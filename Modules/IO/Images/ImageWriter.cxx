#include "ImageWriter.h"

#include "AtomicFile.h"
#include "AvailableMemory.h"
#include "CNumericLocale.h"
#include "ImageFormat.h"
#include "ItkImageWriter.h"
#include "LabelMap.h"
#include "Refusal.h"
#include "SegmentationWriter.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

namespace palpate
{
namespace
{
// Converts 64-bit integers, which none of the formats supports, to 32-bit ones if these hold
// every value; else returns the voxels unchanged.
vtkSmartPointer<vtkDataArray> Narrowed(const std::filesystem::path& path, vtkDataArray* voxels)
{
  const int type = voxels == nullptr ? VTK_VOID : voxels->GetDataType();
  if (type != VTK_LONG && type != VTK_UNSIGNED_LONG && type != VTK_LONG_LONG &&
      type != VTK_UNSIGNED_LONG_LONG && type != VTK_ID_TYPE)
  {
    return voxels;
  }
  const double* range = voxels->GetRange(0);
  const bool fitsSigned = range[0] >= VTK_INT_MIN && range[1] <= VTK_INT_MAX;
  const bool fitsUnsigned = range[0] >= 0.0 && range[1] <= VTK_UNSIGNED_INT_MAX;
  if (!fitsSigned && !fitsUnsigned)
  {
    return voxels;
  }
  CheckMemory(path, static_cast<double>(voxels->GetNumberOfValues()) * sizeof(int));
  auto narrowed = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(fitsSigned ? VTK_INT : VTK_UNSIGNED_INT));
  narrowed->DeepCopy(voxels);
  return narrowed;
}

void CheckWritable(const std::filesystem::path& path, vtkDataArray* voxels)
{
  if (voxels == nullptr || voxels->GetNumberOfTuples() == 0)
  {
    Refuse(path, "cannot be written: the image has no voxels", "create the image first");
  }
  if (voxels->GetNumberOfComponents() != 1)
  {
    Refuse(path, "cannot be written: the image has more than one value per voxel",
           "write its components one by one");
  }
  if (!IsItkType(voxels->GetDataType()))
  {
    Refuse(path,
           "cannot be written: no format holds voxels of type \"" +
               std::string(voxels->GetDataTypeAsString()) + "\"",
           "convert them to another type");
  }
}

// Whether a newly written file holds exactly these voxels: their type and all their bits, not the
// geometry. Throws std::exception if it cannot be read.
bool HoldsVoxels(const std::filesystem::path& file, vtkDataArray* voxels)
{
  const std::unique_ptr<ImageFile> written = ImageFormatOf(file).Open(file);
  const int type = voxels->GetDataType();
  const auto size = static_cast<std::size_t>(voxels->GetNumberOfTuples()) *
                    static_cast<std::size_t>(voxels->GetDataTypeSize());
  if (written->ScalarType() != (type == VTK_CHAR ? VTK_SIGNED_CHAR : type) ||
      written->Grid().VoxelCount() != voxels->GetNumberOfTuples())
  {
    return false;
  }
  std::vector<char> back(size);
  written->ReadInto(back.data());
  return std::memcmp(back.data(), voxels->GetVoidPointer(0), size) == 0;
}
} // namespace

bool IsWritableImage(const std::filesystem::path& path)
{
  return ImageFormats().Writer(path) != nullptr;
}

void WriteImage(const std::filesystem::path& path, vtkImageData* image, const LabelTable& labels)
{
  if (IsSlicerSegmentation(path))
  {
    CheckWritable(path, image->GetPointData()->GetScalars());
    Volume volume;
    volume.Image = image;
    volume.Source = path;
    volume.Labels = labels;
    WriteSegmentation(path, LabelMapOf(volume));
    return;
  }
  const ImageFormat* const format = ImageFormats().Writer(path);
  if (format == nullptr)
  {
    Refuse(path, "does not have the ending of a writable image format",
           "use " + ListOfEndings(ImageFormats().WrittenEndings()));
  }
  const vtkSmartPointer<vtkDataArray> voxels = Narrowed(path, image->GetPointData()->GetScalars());
  CheckWritable(path, voxels);
  if (format->WritesThroughStreams)
  {
    CNumericLocale::RequireOfStreams(path);
  }
  AtomicFile file(path);
  bool complete = false;
  try
  {
    format->Write(file.TemporaryPath(), image, voxels);
    if (format->AddLabels &&
        std::any_of(labels.begin(), labels.end(),
                    [](const auto& label) { return !label.second.Name.empty(); }))
    {
      format->AddLabels(file.TemporaryPath(), voxels, labels);
    }
    // ITK's writers of NRRD and MetaImage do not notice a full disk, so the file is read again.
    complete = HoldsVoxels(file.TemporaryPath(), voxels);
  }
  catch (const std::exception&)
  {
    complete = false;
  }
  if (!complete)
  {
    Refuse(path, "cannot be written: writing stopped early",
           "free disk space or choose another output");
  }
  file.Commit();
}
} // namespace palpate
