#include "IgtlConversion.h"

#include "IgtlMessages.h"
#include "ImageGrid.h"
#include "ImageWriter.h"
#include "TriangleMesh.h"
#include "vtkDataArray.h"
#include "vtkTypeTraits.h"

#include <cstring>
#include <string>
#include <type_traits>
#include <utility>

namespace palpate
{
namespace
{
int VtkTypeOf(ScalarType type)
{
  return VisitScalars(nullptr, type,
                      [](const auto* samples)
                      { return vtkTypeTraits<std::decay_t<decltype(*samples)>>::VTKTypeID(); });
}
} // namespace

vtkSmartPointer<vtkImageData> ImageOf(const IgtlImage& received)
{
  ImageGrid grid;
  grid.Size = received.Size;
  grid.Spacing = received.Spacing;
  grid.OriginWorld = received.OriginWorld;
  grid.Direction = received.Direction;
  std::vector<std::string> notes; // what is sent has no place for them
  CheckGrid("The image that was sent", grid, notes);
  const auto voxels =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VtkTypeOf(received.Type)));
  voxels->SetNumberOfTuples(grid.VoxelCount());
  std::memcpy(voxels->GetVoidPointer(0), received.Voxels.data(), received.Voxels.size());
  return MakeImage(grid, voxels);
}

std::filesystem::path KeepImage(const IgtlImage& received, const std::filesystem::path& folder)
{
  const vtkSmartPointer<vtkImageData> image = ImageOf(received);
  std::filesystem::create_directories(folder);
  std::filesystem::path file;
  for (int number = 1; file.empty() || std::filesystem::exists(file); ++number)
  {
    file = folder / ("image-" + std::to_string(number) + ".nrrd");
  }
  WriteImage(file, image);
  return file;
}

std::vector<std::vector<std::uint8_t>>
SurfaceMessagesOf(const std::vector<vtkSmartPointer<vtkPolyData>>& surfaces)
{
  std::vector<std::vector<std::uint8_t>> messages;
  for (vtkPolyData* surface : surfaces)
  {
    const std::string name = "Palpate model " + std::to_string(messages.size() + 1);
    TriangleMesh triangles = TrianglesOf(surface, name);
    messages.push_back(IgtlSurfaceMessage(
        name, {std::move(triangles.PointsWorld), std::move(triangles.Triangles)}));
  }
  return messages;
}
} // namespace palpate
