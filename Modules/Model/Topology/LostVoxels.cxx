#include "LostVoxels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// Points sorted into cubic cells of at least a given size.
class PointCells
{
public:
  PointCells(const std::vector<Vector3>& points, double size) : Points(&points)
  {
    Vector3 high = points.front();
    this->Low = points.front();
    for (const Vector3& point : points)
    {
      this->Low = this->Low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    // As many cells as points at most.
    const Vector3 box = high - this->Low;
    const double padded = (box.array() + size).prod();
    this->CellSize = std::max(size, std::cbrt(padded / static_cast<double>(points.size())));
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Size[static_cast<std::size_t>(axis)] = static_cast<int>(box[axis] / this->CellSize) + 1;
    }
    this->Sort();
  }

  // Whether a point is within a radius, not above the cells' size, of any of the points.
  bool HasWithin(const Vector3& point, double radius) const
  {
    const std::array<int, 3> at = this->CellOf(point);
    for (int k = std::max(at[2] - 1, 0); k <= std::min(at[2] + 1, this->Size[2] - 1); ++k)
    {
      for (int j = std::max(at[1] - 1, 0); j <= std::min(at[1] + 1, this->Size[1] - 1); ++j)
      {
        for (int i = std::max(at[0] - 1, 0); i <= std::min(at[0] + 1, this->Size[0] - 1); ++i)
        {
          if (this->CellHasWithin({i, j, k}, point, radius))
          {
            return true;
          }
        }
      }
    }
    return false;
  }

private:
  // May be outside of the cells.
  std::array<int, 3> CellOf(const Vector3& point) const
  {
    std::array<int, 3> cell{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      const double at = std::floor((point[axis] - this->Low[axis]) / this->CellSize);
      cell[a] = static_cast<int>(std::clamp(at, -2.0, this->Size[a] + 1.0));
    }
    return cell;
  }

  std::size_t Offset(const std::array<int, 3>& cell) const
  {
    return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(this->Size[1]) +
            static_cast<std::size_t>(cell[1])) *
               static_cast<std::size_t>(this->Size[0]) +
           static_cast<std::size_t>(cell[0]);
  }

  void Sort()
  {
    this->Starts.assign(this->Offset({0, 0, this->Size[2]}) + 1, 0);
    for (const Vector3& point : *this->Points)
    {
      ++this->Starts[this->Offset(this->CellOf(point)) + 1];
    }
    for (std::size_t cell = 1; cell < this->Starts.size(); ++cell)
    {
      this->Starts[cell] += this->Starts[cell - 1];
    }
    std::vector<std::size_t> next = this->Starts;
    this->Order.resize(this->Points->size());
    for (std::size_t n = 0; n < this->Points->size(); ++n)
    {
      this->Order[next[this->Offset(this->CellOf((*this->Points)[n]))]++] = n;
    }
  }

  bool CellHasWithin(const std::array<int, 3>& cell, const Vector3& point, double radius) const
  {
    const std::size_t offset = this->Offset(cell);
    for (std::size_t n = this->Starts[offset]; n < this->Starts[offset + 1]; ++n)
    {
      if (((*this->Points)[this->Order[n]] - point).squaredNorm() <= radius * radius)
      {
        return true;
      }
    }
    return false;
  }

  const std::vector<Vector3>* Points;
  Vector3 Low{Vector3::Zero()};
  double CellSize = 0.0;
  std::array<int, 3> Size{};
  std::vector<std::size_t> Starts; // of each cell's points in Order
  std::vector<std::size_t> Order;
};

std::array<int, 3> IndexOf(const VoxelMask& mask, std::size_t voxel)
{
  const auto i = static_cast<std::size_t>(mask.Size[0]);
  const auto j = static_cast<std::size_t>(mask.Size[1]);
  return {static_cast<int>(voxel % i), static_cast<int>(voxel / i % j),
          static_cast<int>(voxel / (i * j))};
}

Vector3 CentreOf(const VoxelMask& mask, std::size_t voxel)
{
  const std::array<int, 3> at = IndexOf(mask, voxel);
  return {at[0] * mask.Spacing[0], at[1] * mask.Spacing[1], at[2] * mask.Spacing[2]};
}

std::vector<std::size_t> LostOffsets(const VoxelMask& mask, const ShapeField& field,
                                     const PointCells& surface, double tolerance)
{
  std::vector<std::size_t> lost;
  for (std::size_t voxel = 0; voxel < mask.Inside.size(); ++voxel)
  {
    if (mask.Inside[voxel] != 0)
    {
      const Vector3 centre = CentreOf(mask, voxel);
      if (!(field.Sample(centre) > 0.0) && !surface.HasWithin(centre, tolerance))
      {
        lost.push_back(voxel);
      }
    }
  }
  return lost;
}

// Calls visit(offset) for the 26 neighbours of a voxel that are in the mask's box.
template <typename Visitor>
void VisitNeighbors(const VoxelMask& mask, std::size_t voxel, const Visitor& visit)
{
  const std::array<int, 3> at = IndexOf(mask, voxel);
  for (int k = std::max(at[2] - 1, 0); k <= std::min(at[2] + 1, mask.Size[2] - 1); ++k)
  {
    for (int j = std::max(at[1] - 1, 0); j <= std::min(at[1] + 1, mask.Size[1] - 1); ++j)
    {
      for (int i = std::max(at[0] - 1, 0); i <= std::min(at[0] + 1, mask.Size[0] - 1); ++i)
      {
        visit(mask.Offset(i, j, k));
      }
    }
  }
}

std::vector<LostPlace> GroupByPlace(const VoxelMask& mask, const std::vector<std::size_t>& lost)
{
  std::vector<unsigned char> isLost(lost.empty() ? 0 : mask.Inside.size(), 0);
  for (const std::size_t voxel : lost)
  {
    isLost[voxel] = 1;
  }
  std::vector<LostPlace> places;
  for (const std::size_t first : lost)
  {
    if (isLost[first] == 0)
    {
      continue;
    }
    isLost[first] = 0;
    std::vector<std::size_t> voxels{first};
    for (std::size_t n = 0; n < voxels.size(); ++n)
    {
      VisitNeighbors(mask, voxels[n],
                     [&](std::size_t neighbor)
                     {
                       if (isLost[neighbor] != 0)
                       {
                         isLost[neighbor] = 0;
                         voxels.push_back(neighbor);
                       }
                     });
    }
    places.push_back({std::move(voxels), 0.0, Vector3::Zero(), false});
  }
  return places;
}

// Distances change from voxel to voxel by no more than the step between them, so that most of a
// large place need not be measured.
void FindFarthest(const VoxelMask& mask, const IndexedMesh& mesh, LostPlace& place)
{
  Vector3 measured = Vector3::Zero();
  double distance = std::numeric_limits<double>::infinity();
  for (const std::size_t voxel : place.Voxels)
  {
    const Vector3 centre = CentreOf(mask, voxel);
    if (distance + (centre - measured).norm() <= place.Distance)
    {
      continue;
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector3& point : mesh.Points)
    {
      nearest = std::min(nearest, (point - centre).squaredNorm());
    }
    measured = centre;
    distance = std::sqrt(nearest);
    if (distance > place.Distance)
    {
      place.Distance = distance;
      place.Farthest = centre;
    }
  }
}
// Voxels of the mask around lost places: connected ones with their centres outside of the field,
// and those inside of it next to them.
struct LostRegion
{
  std::vector<std::size_t> Voxels;
  bool ReachesObject = false;
};

class LostRegions
{
public:
  LostRegions(const VoxelMask& mask, const std::vector<LostPlace>& places, const ShapeField& field)
      : Mask(&mask), Field(&field), Numbers(places.empty() ? 0 : mask.Inside.size(), 0)
  {
    for (const LostPlace& place : places)
    {
      if (this->Numbers[place.Voxels.front()] == 0)
      {
        this->Regions.push_back({});
        this->Add(place.Voxels.front());
        this->Fill(this->Regions.back());
      }
    }
  }

  const std::vector<LostRegion>& All() const { return this->Regions; }
  const LostRegion& Of(const LostPlace& place) const
  {
    return this->Regions[static_cast<std::size_t>(this->Numbers[place.Voxels.front()]) - 1];
  }

private:
  void Add(std::size_t voxel)
  {
    this->Numbers[voxel] = static_cast<int>(this->Regions.size());
    this->Regions.back().Voxels.push_back(voxel);
  }

  void Fill(LostRegion& region)
  {
    for (std::size_t n = 0; n < region.Voxels.size(); ++n)
    {
      const std::size_t voxel = region.Voxels[n];
      if (this->Field->Sample(CentreOf(*this->Mask, voxel)) > 0.0)
      {
        // Other regions may reach it too.
        region.ReachesObject = true;
        this->Numbers[voxel] = 0;
        continue;
      }
      VisitNeighbors(*this->Mask, voxel,
                     [this](std::size_t neighbor)
                     {
                       if (this->Mask->Inside[neighbor] != 0 && this->Numbers[neighbor] == 0)
                       {
                         this->Add(neighbor);
                       }
                     });
    }
  }

  const VoxelMask* Mask;
  const ShapeField* Field;
  std::vector<int> Numbers; // of each voxel's region, from 1
  std::vector<LostRegion> Regions;
};

// Nodes of one axis within half a voxel, and at least half a step, of a coordinate; never a border
// node.
std::array<int, 2> NodesNear(const ShapeGrid& grid, std::size_t axis, double at, double voxel)
{
  const double centre = (at - grid.Origin[static_cast<int>(axis)]) / grid.Spacing;
  const double reach = std::max(0.5, 0.5 * voxel / grid.Spacing);
  const double last = grid.Size[axis] - 2.0;
  return {static_cast<int>(std::clamp(std::ceil(centre - reach), 1.0, last)),
          static_cast<int>(std::clamp(std::floor(centre + reach), 1.0, last))};
}

// Sets nodes around a voxel to at least `depth`; returns how many were outside.
std::size_t RaiseNodes(const VoxelMask& mask, std::size_t voxel, float depth, ShapeField& field)
{
  const ShapeGrid& grid = field.Grid;
  const Vector3 centre = CentreOf(mask, voxel);
  std::array<std::array<int, 2>, 3> range{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    range[axis] = NodesNear(grid, axis, centre[static_cast<int>(axis)], mask.Spacing[axis]);
  }
  std::size_t raised = 0;
  for (int k = range[2][0]; k <= range[2][1]; ++k)
  {
    for (int j = range[1][0]; j <= range[1][1]; ++j)
    {
      for (int i = range[0][0]; i <= range[0][1]; ++i)
      {
        float& value = field.Values[grid.Offset(i, j, k)];
        raised += value > 0.0f ? 0 : 1;
        value = std::max(value, depth);
      }
    }
  }
  return raised;
}
} // namespace

double LostVoxelTolerance(const VoxelMask& mask, const ShapeGrid& grid)
{
  std::array<double, 3> spacing = mask.Spacing;
  std::sort(spacing.begin(), spacing.end());
  return 1.5 * std::max(std::hypot(spacing[0], spacing[1]), grid.Spacing);
}

std::vector<LostPlace> FindLostVoxels(const VoxelMask& mask, const ShapeField& field,
                                      const IndexedMesh& mesh, double tolerance)
{
  if (mesh.Points.empty())
  {
    return {};
  }
  const PointCells surface(mesh.Points, tolerance);
  std::vector<LostPlace> places = GroupByPlace(mask, LostOffsets(mask, field, surface, tolerance));
  const LostRegions regions(mask, places, field);
  for (LostPlace& place : places)
  {
    FindFarthest(mask, mesh, place);
    place.IsSeparate = !regions.Of(place).ReachesObject;
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const LostPlace& a, const LostPlace& b) { return a.Distance > b.Distance; });
  return places;
}

std::size_t RestoreVoxels(const VoxelMask& mask, const std::vector<LostPlace>& places,
                          const ShapeField& repaired, ShapeField& field)
{
  const auto depth = static_cast<float>(0.15 * field.Grid.Spacing);
  const LostRegions regions(mask, places, repaired);
  std::size_t raised = 0;
  for (const LostRegion& region : regions.All())
  {
    for (std::size_t n = 0; region.ReachesObject && n < region.Voxels.size(); ++n)
    {
      raised += RaiseNodes(mask, region.Voxels[n], depth, field);
    }
  }
  return raised;
}
} // namespace palpate
