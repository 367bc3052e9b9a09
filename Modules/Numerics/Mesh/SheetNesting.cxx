#include "SheetNesting.h"

#include "WindingNumbers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace palpate
{
namespace
{
constexpr double LeastVolume = 0.01; // of the largest sheet's
constexpr std::size_t MostSheets = 32;
constexpr int VoxelsOfSide = 48;

double SizeOf(double volume)
{
  return std::isfinite(volume) ? std::abs(volume) : 0.0;
}

// By falling volume.
std::vector<int> LargeSheets(const std::vector<double>& volumes)
{
  std::vector<int> order(volumes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&volumes](int one, int other)
                   { return SizeOf(volumes[one]) > SizeOf(volumes[other]); });
  const double least = LeastVolume * SizeOf(volumes[order.front()]);
  const auto end =
      std::find_if(order.begin(), order.end(),
                   [&volumes, least](int sheet) { return SizeOf(volumes[sheet]) < least; });
  order.erase(end, order.end());
  order.resize(std::min(order.size(), MostSheets));
  return order;
}

std::vector<char> ClosedSheets(const EdgeRings& rings, const MeshSheets& sheets)
{
  std::vector<char> isClosed(static_cast<std::size_t>(sheets.SheetCount), 1);
  const int count = static_cast<int>(sheets.SheetOf.size());
  for (int h = 0; h < 3 * count; ++h)
  {
    if (sheets.SheetOf[h / 3] >= 0 && !rings.IsPair(h))
    {
      isClosed[sheets.SheetOf[h / 3]] = 0;
    }
  }
  return isClosed;
}

/// The voxels inside one sheet.
class SheetVoxels
{
public:
  SheetVoxels(const MeshSheets& sheets, const IndexedMesh& mesh) : Sheets(&sheets), Whole(&mesh)
  {
    this->Part.Points = mesh.Points;
  }

  void Fill(int sheet)
  {
    this->Part.Triangles.clear();
    Eigen::AlignedBox3d box;
    for (std::size_t t = 0; t < this->Whole->Triangles.size(); ++t)
    {
      if (this->Sheets->SheetOf[t] == sheet)
      {
        auto [a, b, c] = this->Whole->Triangles[t];
        for (const int corner : {a, b, c})
        {
          box.extend(this->Whole->Points[corner]);
        }
        this->Part.Triangles.push_back(this->Sheets->IsTurned[t] != 0 ? std::array<int, 3>{a, c, b}
                                                                      : this->Whole->Triangles[t]);
      }
    }
    // A flat box gets voxels too.
    const Vector3 sizes = box.sizes().cwiseMax(1e-6 * box.sizes().maxCoeff());
    this->Sides = sizes / VoxelsOfSide;
    this->Corner = box.center() - 0.5 * sizes;
    const VoxelCenters centers{this->Corner + 0.5 * this->Sides,
                               Matrix3(this->Sides.asDiagonal()),
                               {VoxelsOfSide, VoxelsOfSide, VoxelsOfSide}};
    if (!FindWindingNumbers(this->Part, centers, this->Numbers).IsOk())
    {
      this->Numbers.assign(std::size_t{VoxelsOfSide} * VoxelsOfSide * VoxelsOfSide, 0);
    }
  }

  bool Encloses(const Vector3& point) const
  {
    const Vector3 place = (point - this->Corner).cwiseQuotient(this->Sides);
    if (!(place.minCoeff() >= 0.0 && place.maxCoeff() < VoxelsOfSide))
    {
      return false;
    }
    const Eigen::Vector3i index = place.cast<int>();
    return this->Numbers[static_cast<std::size_t>(
               (index.z() * VoxelsOfSide + index.y()) * VoxelsOfSide + index.x())] != 0;
  }

private:
  const MeshSheets* Sheets;
  const IndexedMesh* Whole;
  IndexedMesh Part;
  Vector3 Corner = Vector3::Zero();
  Vector3 Sides = Vector3::Ones();
  std::vector<std::int16_t> Numbers;
};

// Adds 1 for each of their triangles that the voxels enclose, else subtracts 1.
std::vector<int> Balance(const IndexedMesh& mesh, const MeshSheets& sheets,
                         const SheetVoxels& voxels)
{
  std::vector<int> balance(static_cast<std::size_t>(sheets.SheetCount), 0);
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    if (sheets.SheetOf[t] >= 0)
    {
      const auto [a, b, c] = mesh.Triangles[t];
      const Vector3 center = (mesh.Points[a] + mesh.Points[b] + mesh.Points[c]) / 3.0;
      balance[sheets.SheetOf[t]] += voxels.Encloses(center) ? 1 : -1;
    }
  }
  return balance;
}
} // namespace

std::vector<int> OutermostSheets(const IndexedMesh& mesh, const EdgeRings& rings,
                                 const MeshSheets& sheets, const std::vector<double>& volumes)
{
  if (volumes.size() < 2)
  {
    return std::vector<int>(volumes.size(), 0);
  }
  const std::vector<int> large = LargeSheets(volumes);
  std::vector<int> outermost(volumes.size(), -1);
  if (large.size() > 1)
  {
    const std::vector<char> isClosed = ClosedSheets(rings, sheets);
    SheetVoxels voxels(sheets, mesh);
    for (const int outer : large)
    {
      if (outermost[outer] >= 0)
      {
        continue; // lies in a larger one
      }
      outermost[outer] = isClosed[outer] != 0 ? outer : large.front();
      voxels.Fill(outer);
      const std::vector<int> balance = Balance(mesh, sheets, voxels);
      for (std::size_t sheet = 0; sheet < balance.size(); ++sheet)
      {
        outermost[sheet] =
            outermost[sheet] < 0 && balance[sheet] > 0 ? outermost[outer] : outermost[sheet];
      }
    }
  }
  std::replace(outermost.begin(), outermost.end(), -1, large.front());
  return outermost;
}
} // namespace palpate
