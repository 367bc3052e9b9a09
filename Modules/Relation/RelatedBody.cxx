#include "RelatedBody.h"

#include "MeshVoxels.h"
#include "ScanBorder.h"

#include <array>
#include <utility>

namespace palpate
{
namespace
{
// Around the body, of which organs fill about half.
constexpr double CubesAroundBody = 10000.0;

// Without points that no triangle has.
IndexedMesh Compact(const IndexedMesh& mesh)
{
  IndexedMesh compact;
  std::vector<int> places(mesh.Points.size(), -1);
  for (std::array<int, 3> triangle : mesh.Triangles)
  {
    for (int& corner : triangle)
    {
      if (places[corner] < 0)
      {
        places[corner] = static_cast<int>(compact.Points.size());
        compact.Points.push_back(mesh.Points[corner]);
      }
      corner = places[corner];
    }
    compact.Triangles.push_back(triangle);
  }
  return compact;
}

Status FindCenters(const ComparedBody& body, std::vector<Vector3>& centers)
{
  const VoxelCenters cubes = CubesAround(body.Enclosure(), CubesAroundBody);
  std::vector<std::uint8_t> inside;
  if (Status status = FindInside(body.Enclosure(), cubes, body.IsConsistent(), inside);
      !status.IsOk())
  {
    return status;
  }
  std::size_t cube = 0;
  for (int k = 0; k < cubes.Size[2]; ++k)
  {
    for (int j = 0; j < cubes.Size[1]; ++j)
    {
      for (int i = 0; i < cubes.Size[0]; ++i, ++cube)
      {
        if (inside[cube] != 0)
        {
          centers.emplace_back(cubes.Origin + cubes.Axes * Vector3(i, j, k));
        }
      }
    }
  }
  return Status::Success();
}

std::vector<Vector3> VoxelCentersOf(const PlacedMask& mask)
{
  std::vector<Vector3> centers;
  const auto& size = mask.Voxels.Size;
  const auto& start = mask.Voxels.StartIndex;
  std::size_t voxel = 0;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i, ++voxel)
      {
        if (mask.Voxels.Inside[voxel] != 0)
        {
          centers.push_back(mask.ToWorld(Vector3(i + start[0], j + start[1], k + start[2])));
        }
      }
    }
  }
  return centers;
}
} // namespace

Status RelatedBody::Make(ComparedBody body, SpreadOf spread, RelatedBody& made,
                         const std::array<int, 3>* imageSize)
{
  if (!body.IsClosed())
  {
    return Status::Failure("is open, so that it has no inside");
  }
  if (!(body.Volume() > 0.0))
  {
    return Status::Failure("encloses no volume");
  }
  RelatedBody related;
  related.Compared = std::make_shared<const ComparedBody>(std::move(body));
  const ComparedBody& kept = *related.Compared;
  for (const Vector3& point : kept.Surface().Points)
  {
    related.Bounds.extend(point);
  }
  related.Sampled = kept.IsModel() ? Compact(kept.CoarseSurface()) : kept.Surface();
  if (imageSize != nullptr && kept.Mask() != nullptr)
  {
    related.Uncut =
        std::make_shared<const IndexedMesh>(WithoutCut(related.Sampled, *kept.Mask(), *imageSize));
  }
  related.Points = spread == SpreadOf::VoxelCenters && kept.Mask() != nullptr
                       ? PointSpread::OfPoints(VoxelCentersOf(*kept.Mask()))
                       : PointSpread::OfInside(kept.Enclosure());
  Status status = GapSurface::Make(kept.Surface(), related.Surface);
  if (status.IsOk())
  {
    status = FindCenters(kept, related.Centers);
  }
  made = std::move(related);
  return status;
}
} // namespace palpate
