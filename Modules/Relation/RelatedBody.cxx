#include "RelatedBody.h"

#include "MeshVoxels.h"

#include <utility>

namespace palpate
{
namespace
{
// Around the body, of which organs fill about half.
constexpr double CubesAroundBody = 20000.0;

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
} // namespace

Status RelatedBody::Make(ComparedBody body, RelatedBody& made)
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
  related.Points = PointSpread::OfInside(kept.Enclosure());
  Status status = GapSurface::Make(kept.Surface(), related.Surface);
  if (status.IsOk())
  {
    status = FindCenters(kept, related.Centers);
  }
  made = std::move(related);
  return status;
}
} // namespace palpate
