#include "DicomVolume.h"

#include "AvailableMemory.h"
#include "DicomFrameDecoder.h"
#include "DicomPixels.h"
#include "RepeatedSlices.h"

#include <cstddef>

namespace palpate
{
namespace
{
// A type that holds every slice; slices with different rescale slopes (PET) have different types.
int CommonScalarType(const std::vector<DicomPixelFormat>& formats)
{
  int type = formats.front().ScalarType();
  for (const DicomPixelFormat& format : formats)
  {
    type = format.ScalarType() == type ? type : VTK_FLOAT;
  }
  return type;
}
} // namespace

Volume ReadDicomVolume(const DicomSeries& found, const std::filesystem::path& source,
                       ShearedAxes sheared)
{
  Volume volume;
  const DicomSeries series = WithoutRepeatedSlices(found, volume.Notes);
  SliceStack stack = StackSlices(source, series.Planes, {});
  volume.Notes.insert(volume.Notes.end(), stack.Notes.begin(), stack.Notes.end());
  CheckGrid(source, stack.Grid, volume.Notes, sheared);
  auto voxels = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(CommonScalarType(series.Formats)));
  CheckMemory(source, static_cast<double>(stack.Grid.VoxelCount()) * voxels->GetDataTypeSize());
  voxels->SetNumberOfTuples(stack.Grid.VoxelCount());
  const vtkIdType sliceVoxels = static_cast<vtkIdType>(stack.Grid.Size[0]) * stack.Grid.Size[1];
  DicomFrameDecoder decoder;
  for (std::size_t i = 0; i < series.Files.size(); ++i)
  {
    ReadSlicePixels(series.Files[i], series.Formats[i], sliceVoxels, voxels,
                    stack.SliceOfPlane[i] * sliceVoxels, decoder);
  }
  volume.Image = MakeImage(stack.Grid, voxels);
  volume.Source = source;
  return volume;
}
} // namespace palpate
