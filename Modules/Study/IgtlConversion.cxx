#include "IgtlConversion.h"

#include "IgtlMessages.h"
#include "ImageGrid.h"
#include "TriangleMesh.h"
#include "vtkDataArray.h"

#include <cstring>

namespace palpate
{
namespace
{
int VtkTypeOf(IgtlImage::Scalar type)
{
  switch (type)
  {
  case IgtlImage::Scalar::Int8:
    return VTK_SIGNED_CHAR;
  case IgtlImage::Scalar::UInt8:
    return VTK_UNSIGNED_CHAR;
  case IgtlImage::Scalar::Int16:
    return VTK_SHORT;
  case IgtlImage::Scalar::UInt16:
    return VTK_UNSIGNED_SHORT;
  case IgtlImage::Scalar::Int32:
    return VTK_INT;
  case IgtlImage::Scalar::UInt32:
    return VTK_UNSIGNED_INT;
  case IgtlImage::Scalar::Float32:
    return VTK_FLOAT;
  case IgtlImage::Scalar::Float64:
    break;
  }
  return VTK_DOUBLE;
}
} // namespace

vtkSmartPointer<vtkImageData> ImageOf(const IgtlImage& received)
{
  ImageGrid grid;
  grid.Size = received.Size;
  grid.Spacing = received.Spacing;
  grid.OriginWorld = received.OriginWorld;
  grid.Direction = received.Direction;
  CheckGrid("The image that was sent", grid);
  const auto voxels =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VtkTypeOf(received.Type)));
  voxels->SetNumberOfTuples(grid.VoxelCount());
  std::memcpy(voxels->GetVoidPointer(0), received.Voxels.data(), received.Voxels.size());
  return MakeImage(grid, voxels);
}

std::vector<std::uint8_t> SurfaceMessageOf(const std::string& name, vtkPolyData* surface)
{
  TriangleMesh triangles = TrianglesOf(surface, name);
  return IgtlSurfaceMessage(name,
                            {std::move(triangles.PointsWorld), std::move(triangles.Triangles)});
}
} // namespace palpate
