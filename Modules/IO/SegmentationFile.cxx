#include "SegmentationFile.h"

#include "AvailableMemory.h"
#include "DicomSegmentation.h"
#include "DicomStructureSet.h"
#include "FileKind.h"
#include "ForeignDicom.h"
#include "ImageFormat.h"
#include "LabelMap.h"
#include "LabelValues.h"
#include "MaskFolder.h"
#include "OrthogonalResampling.h"
#include "Refusal.h"
#include "RightHandedAxes.h"
#include "SegmentCompletion.h"
#include "SlicerSegments.h"
#include "VolumeFile.h"

#include "vtkPointData.h"

namespace palpate
{
namespace
{
// Component `layer` of voxels with one value per layer.
vtkSmartPointer<vtkDataArray> ExtractLayer(const std::filesystem::path& file, vtkDataArray* voxels,
                                           int layer)
{
  if (voxels->GetNumberOfComponents() == 1)
  {
    return voxels;
  }
  auto single =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(voxels->GetDataType()));
  CheckMemory(file, static_cast<double>(voxels->GetNumberOfTuples()) * voxels->GetDataTypeSize());
  single->SetNumberOfTuples(voxels->GetNumberOfTuples());
  single->CopyComponent(0, voxels, layer);
  return single;
}

Segmentation ReadSlicerSegmentation(const std::filesystem::path& path, ImageFile& file,
                                    const std::vector<Segment>& described,
                                    LeftHandedAxes leftHanded)
{
  constexpr int MostLayers = 1024; // each is a separate image
  if (file.Components() > MostLayers)
  {
    Refuse(path, "has " + std::to_string(file.Components()) + " layers of segments",
           "export fewer segments at a time");
  }
  Segmentation segmentation;
  segmentation.Source = path;
  segmentation.Segments = described;
  segmentation.Notes = file.Notes();
  const vtkSmartPointer<vtkDataArray> voxels = file.NewArray();
  file.ReadInto(voxels->GetVoidPointer(0));
  ImageGrid grid = file.Grid();
  MakeRightHanded(path, leftHanded, grid, voxels, segmentation.Notes);
  segmentation.IsOriented = grid.IsOriented;
  for (int layer = 0; layer < file.Components(); ++layer)
  {
    segmentation.Layers.push_back(
        MakeImage(grid, ToLabels(path, ExtractLayer(path, voxels, layer), segmentation.Notes)));
  }
  if (IsSheared(grid))
  {
    for (vtkSmartPointer<vtkImageData>& layer : segmentation.Layers)
    {
      layer = ResampleSheared(path, layer, ResamplingKind::Nearest);
    }
    segmentation.Notes.emplace_back(ResamplingNote);
  }
  CompleteSegments(segmentation);
  return segmentation;
}

std::filesystem::path FindDicomSegmentation(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> found;
  for (const std::filesystem::path& file : DicomFilesIn(folder))
  {
    if (IsDicomSegmentation(file) || IsDicomStructureSet(file))
    {
      found.push_back(file);
    }
  }
  if (found.empty())
  {
    RefuseForeignDicomIn(folder);
  }
  if (found.size() != 1)
  {
    Refuse(folder,
           "is a folder that holds " + std::to_string(found.size()) +
               " DICOM segmentation objects or structure sets",
           "specify one segmentation file");
  }
  return found.front();
}

void RefuseValueChoice(const std::filesystem::path& path, const VolumeChoice& choice)
{
  if (choice.Values.Threshold || !choice.Values.Background.empty())
  {
    Refuse(path, "is a segmentation, whose voxels are labels already",
           "leave out --threshold and --background");
  }
}

Segmentation ReadDicomLabels(const std::filesystem::path& file, const VolumeChoice& choice)
{
  RefuseValueChoice(file, choice);
  return IsDicomStructureSet(file) ? ReadDicomStructureSet(file) : ReadDicomSegmentation(file);
}

Segmentation StructuresOf(const MaskFolder& folder, const std::filesystem::path& path)
{
  if (folder.Is() == MaskFolder::Kind::Structures)
  {
    Segmentation all = folder.Structures();
    all.Refused = folder.LeftOut();
    return all;
  }
  Refuse(path, "holds " + folder.Why() + ", so they are not the structures of one patient",
         "read them one by one, or join them by palpate convert");
}
} // namespace

Segmentation ReadSegmentation(const std::filesystem::path& path, LeftHandedAxes leftHanded)
{
  VolumeChoice choice;
  choice.LeftHanded = leftHanded;
  return ReadSegmentation(path, choice);
}

Segmentation ReadSegmentation(const std::filesystem::path& path, const VolumeChoice& choice)
{
  std::error_code failure;
  if (IsMaskFolder(path))
  {
    return StructuresOf(MaskFolder(path, choice, true), path);
  }
  if (std::filesystem::is_directory(path, failure))
  {
    return ReadDicomLabels(FindDicomSegmentation(path), choice);
  }
  if (IsDicomFile(path))
  {
    if (!IsDicomSegmentation(path) && !IsDicomStructureSet(path))
    {
      RefuseForeignDicom(path);
      Refuse(path, "is a DICOM file but not a segmentation",
             "specify a DICOM segmentation object, a structure set or a label map");
    }
    return ReadDicomLabels(path, choice);
  }
  const std::unique_ptr<ImageFile> file = OpenImage(path, choice.Sheared);
  if (const std::vector<Segment> described = SlicerSegments(file->Entries()); !described.empty())
  {
    RefuseValueChoice(path, choice);
    return ReadSlicerSegmentation(path, *file, described, choice.LeftHanded);
  }
  return LabelMapOf(ReadVolume(path, choice));
}
} // namespace palpate
