#include "VolumeFile.h"

#include "ChosenValues.h"
#include "DicomSegmentation.h"
#include "DicomStructureSet.h"
#include "DicomVolume.h"
#include "FileKind.h"
#include "ForeignDicom.h"
#include "ImageFormat.h"
#include "LabelMap.h"
#include "OrthogonalResampling.h"
#include "Refusal.h"
#include "RightHandedAxes.h"

#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace palpate
{
namespace
{
Volume ReadImageFile(const std::filesystem::path& path, const VolumeChoice& choice)
{
  const std::unique_ptr<ImageFile> file = OpenImage(path, choice.Sheared);
  file->ChooseVolume(choice.Series);
  if (file->Components() != 1)
  {
    Refuse(path, "has " + std::to_string(file->Components()) + " values per voxel",
           "use one grey value per voxel, or read it as a segmentation if its values are layers");
  }
  const vtkSmartPointer<vtkDataArray> voxels = file->NewArray();
  file->ReadInto(voxels->GetVoidPointer(0));
  ImageGrid grid = file->Grid();
  Volume volume;
  volume.Source = path;
  volume.Notes = file->Notes();
  MakeRightHanded(path, choice.LeftHanded, grid, voxels, volume.Notes);
  volume.Image = MakeImage(grid, voxels);
  volume.IsOriented = grid.IsOriented;
  volume.Labels = choice.Values.Threshold ? LabelTable() : file->Labels();
  return volume;
}

Volume ReadDicom(const std::filesystem::path& path, const VolumeChoice& choice)
{
  std::error_code isNoFolder;
  if (std::filesystem::is_directory(path, isNoFolder))
  {
    const std::vector<DicomSeries> all = FindDicomSeries(path);
    return ReadDicomVolume(ChooseSeries(path, all, choice), path, choice.Sheared);
  }
  if (IsDicomSegmentation(path))
  {
    Refuse(path, "is a DICOM segmentation",
           "read it as a segmentation, or specify an image series");
  }
  if (IsDicomStructureSet(path))
  {
    Refuse(path, "is a DICOM structure set (contours)",
           "read it as a segmentation, or specify an image series");
  }
  RefuseForeignDicom(path);
  const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  const std::vector<DicomSeries> all = FindDicomSeries(folder);
  return ReadDicomVolume(SeriesOfFile(path, all), path, choice.Sheared);
}

template <typename T>
vtkIdType CountNotFinite(const T* values, vtkIdType count)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    return std::count_if(values, values + count, [](T value) { return !std::isfinite(value); });
  }
  return 0;
}

void CheckFinite(const std::filesystem::path& file, vtkDataArray* voxels)
{
  vtkIdType found = 0;
  switch (voxels->GetDataType())
  {
    vtkTemplateMacro(found = CountNotFinite(static_cast<const VTK_TT*>(voxels->GetVoidPointer(0)),
                                            voxels->GetNumberOfValues()));
  }
  if (found > 0)
  {
    Refuse(file, "holds " + std::to_string(found) + " voxels that are NaN or infinite",
           "take them as background (--background nan of palpate convert, fit, mesh, compare and "
           "soften), or "
           "replace them");
  }
}
} // namespace

Volume ReadVolume(const std::filesystem::path& path, const VolumeChoice& choice)
{
  std::error_code failure;
  const bool isFolder = std::filesystem::is_directory(path, failure);
  Volume volume =
      isFolder || IsDicomFile(path) ? ReadDicom(path, choice) : ReadImageFile(path, choice);
  ChooseValues(choice.Values, volume);
  CheckFinite(path, volume.Image->GetPointData()->GetScalars());
  if (IsSheared(GridOf(volume.Image)))
  {
    const bool isLabelMap = WhyNoLabelMap(volume).empty();
    volume.Image = ResampleSheared(path, volume.Image,
                                   isLabelMap ? ResamplingKind::Nearest : ResamplingKind::Linear);
    volume.Notes.emplace_back(ResamplingNote);
  }
  return volume;
}
} // namespace palpate
