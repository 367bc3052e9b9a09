#include "MeshMending.h"

#include "EdgeRings.h"
#include "MeshSheets.h"
#include "SheetNesting.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t MostElements = 700'000'000;

using Bits = std::array<std::uint64_t, 3>;

// Adding 0 turns -0 into +0, so that equal positions have equal bits.
Bits BitsOf(const Vector3& point)
{
  const Vector3 normalised = point + Vector3::Zero();
  Bits bits;
  std::memcpy(bits.data(), normalised.data(), sizeof(bits));
  return bits;
}

std::uint64_t HashOf(const Vector3& point)
{
  std::uint64_t hash = 0;
  for (const std::uint64_t word : BitsOf(point))
  {
    hash = (hash ^ word) * 0x9E3779B97F4A7C15U;
    hash ^= hash >> 32U;
  }
  return hash;
}

// The points' indices by hash: those of bucket b are from Starts[b] to Starts[b + 1].
struct Buckets
{
  std::vector<int> Starts;
  std::vector<int> Numbers;

  explicit Buckets(const std::vector<Vector3>& points) : Numbers(points.size())
  {
    unsigned bits = 1;
    while ((std::size_t{1} << bits) < points.size())
    {
      ++bits;
    }
    this->Starts.assign((std::size_t{1} << bits) + 2, 0);
    const auto bucketOf = [bits](const Vector3& p) { return HashOf(p) >> (64U - bits); };
    for (const Vector3& point : points)
    {
      ++this->Starts[bucketOf(point) + 2];
    }
    for (std::size_t b = 2; b < this->Starts.size(); ++b)
    {
      this->Starts[b] += this->Starts[b - 1];
    }
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->Numbers[this->Starts[bucketOf(points[i]) + 1]++] = static_cast<int>(i);
    }
  }
};

// For each point the first one at the same position. Sorting within a bucket bounds the time.
std::vector<int> FirstAtPosition(const std::vector<Vector3>& points)
{
  Buckets buckets(points);
  std::vector<int> first(points.size());
  const auto begin = buckets.Numbers.begin();
  for (std::size_t b = 0; b + 2 < buckets.Starts.size(); ++b)
  {
    const auto from = begin + buckets.Starts[b];
    const auto to = begin + buckets.Starts[b + 1];
    std::sort(
        from, to,
        [&points](int one, int other)
        { return std::pair(BitsOf(points[one]), one) < std::pair(BitsOf(points[other]), other); });
    for (auto i = from; i != to; ++i)
    {
      const bool isSame = i != from && BitsOf(points[*i]) == BitsOf(points[*(i - 1)]);
      first[*i] = isSame ? first[*(i - 1)] : *i;
    }
  }
  return first;
}

// Keeps the points for which kept[i] == i and renumbers the triangles; others need kept[i] < i.
int KeepPoints(IndexedMesh& mesh, std::vector<int> kept)
{
  int count = 0;
  const int before = static_cast<int>(mesh.Points.size());
  for (int i = 0; i < before; ++i)
  {
    if (kept[i] == i)
    {
      mesh.Points[count] = mesh.Points[i];
      kept[i] = count++;
    }
    else if (kept[i] >= 0)
    {
      kept[i] = kept[kept[i]];
    }
  }
  mesh.Points.resize(count);
  for (std::array<int, 3>& triangle : mesh.Triangles)
  {
    for (int& corner : triangle)
    {
      corner = kept[corner];
    }
  }
  return before - count;
}

// Enclosed by each sheet once its triangles agree.
std::vector<double> SheetVolumes(const IndexedMesh& mesh, const MeshSheets& sheets)
{
  std::vector<double> volumes(sheets.SheetCount, 0.0);
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    if (sheets.SheetOf[t] >= 0)
    {
      const Vector3 corner = mesh.Points[mesh.Triangles[t][0]] - mesh.Points.front();
      const double part = corner.dot(AreaVector(mesh, mesh.Triangles[t])) / 3.0;
      volumes[sheets.SheetOf[t]] += sheets.IsTurned[t] != 0 ? -part : part;
    }
  }
  return volumes;
}

Status CheckPointsAndTriangles(const IndexedMesh& mesh)
{
  if (std::max(mesh.Points.size(), mesh.Triangles.size()) > MostElements)
  {
    return Status::Failure("The mesh has more than 700 million triangles or points.");
  }
  if (!std::all_of(mesh.Points.begin(), mesh.Points.end(),
                   [](const Vector3& p) { return p.allFinite(); }))
  {
    return Status::Failure("The mesh has points that are not finite.");
  }
  const int count = static_cast<int>(mesh.Points.size());
  const auto isValid = [count](const std::array<int, 3>& t)
  {
    return *std::min_element(t.begin(), t.end()) >= 0 &&
           *std::max_element(t.begin(), t.end()) < count;
  };
  return std::all_of(mesh.Triangles.begin(), mesh.Triangles.end(), isValid)
             ? Status::Success()
             : Status::Failure("The mesh has triangles with invalid point indices.");
}

// Keeps the triangles for whose numbers `isKept`; returns the number of the others.
template <typename Predicate>
int KeepTriangles(IndexedMesh& mesh, const Predicate& isKept)
{
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    if (isKept(t))
    {
      mesh.Triangles[count++] = mesh.Triangles[t];
    }
  }
  const std::size_t dropped = mesh.Triangles.size() - count;
  mesh.Triangles.resize(count);
  return static_cast<int>(dropped);
}
} // namespace

int WeldPoints(IndexedMesh& mesh)
{
  return KeepPoints(mesh, FirstAtPosition(mesh.Points));
}

int DropDegenerateTriangles(IndexedMesh& mesh)
{
  const auto end = std::remove_if(mesh.Triangles.begin(), mesh.Triangles.end(),
                                  [&mesh](const std::array<int, 3>& t)
                                  { return !HasThreePoints(t, mesh.Points.size()); });
  const auto count = mesh.Triangles.end() - end;
  mesh.Triangles.erase(end, mesh.Triangles.end());
  return static_cast<int>(count);
}

int DropDuplicateTriangles(IndexedMesh& mesh)
{
  struct Corners
  {
    std::array<int, 3> Sorted;
    int Number;
    bool operator<(const Corners& other) const
    {
      return std::tie(this->Sorted, this->Number) < std::tie(other.Sorted, other.Number);
    }
  };
  std::vector<Corners> all;
  all.reserve(mesh.Triangles.size());
  for (std::array<int, 3> triangle : mesh.Triangles)
  {
    std::sort(triangle.begin(), triangle.end());
    all.push_back({triangle, static_cast<int>(all.size())});
  }
  std::sort(all.begin(), all.end());
  std::vector<unsigned char> isKept(all.size(), 1);
  for (std::size_t i = 1; i < all.size(); ++i)
  {
    isKept[static_cast<std::size_t>(all[i].Number)] = all[i].Sorted != all[i - 1].Sorted ? 1 : 0;
  }
  return KeepTriangles(mesh, [&isKept](std::size_t t) { return isKept[t] != 0; });
}

int DropUnusedPoints(IndexedMesh& mesh)
{
  std::vector<int> kept(mesh.Points.size(), -1);
  for (const std::array<int, 3>& triangle : mesh.Triangles)
  {
    for (const int corner : triangle)
    {
      kept[corner] = corner;
    }
  }
  return KeepPoints(mesh, std::move(kept));
}

int KeepPart(IndexedMesh& mesh, int number)
{
  const MeshSheets sheets(mesh, EdgeRings(mesh));
  if (sheets.PartCount < std::max(2, number))
  {
    return 0;
  }
  std::vector<double> areas(sheets.PartCount, 0.0);
  const auto partOf = [&sheets](std::size_t t)
  { return sheets.SheetOf[t] < 0 ? -1 : sheets.PartOf[sheets.SheetOf[t]]; };
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    if (partOf(t) >= 0)
    {
      areas[partOf(t)] += AreaVector(mesh, mesh.Triangles[t]).norm();
    }
  }
  std::vector<int> order(areas.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&areas](int a, int b) { return areas[a] > areas[b]; });
  const int kept = order[number - 1];
  KeepTriangles(mesh, [&](std::size_t t) { return partOf(t) == kept; });
  return sheets.PartCount - 1;
}

int OrientOutwards(IndexedMesh& mesh)
{
  const EdgeRings rings(mesh);
  const MeshSheets sheets(mesh, rings);
  if (!sheets.IsOrientable || sheets.SheetCount == 0)
  {
    return 0;
  }
  const std::vector<double> volumes = SheetVolumes(mesh, sheets);
  const std::vector<int> outermost = OutermostSheets(mesh, rings, sheets, volumes);
  int count = 0;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const int sheet = sheets.SheetOf[t];
    if (sheet >= 0 && (sheets.IsTurned[t] != 0) != (volumes[outermost[sheet]] < 0.0))
    {
      std::swap(mesh.Triangles[t][1], mesh.Triangles[t][2]);
      ++count;
    }
  }
  return count;
}

Status MendMesh(IndexedMesh& mesh, int part, MeshMends& mends)
{
  mends = {};
  if (Status status = CheckPointsAndTriangles(mesh); !status.IsOk())
  {
    return status;
  }
  mends.WeldedPoints = WeldPoints(mesh);
  mends.DroppedTriangles = DropDegenerateTriangles(mesh);
  mends.Duplicates = DropDuplicateTriangles(mesh);
  mends.DroppedParts = part > 0 ? KeepPart(mesh, part) : 0;
  if (part > 1 && mends.DroppedParts == 0)
  {
    return Status::Failure("has no part number " + std::to_string(part));
  }
  mends.DroppedPoints = DropUnusedPoints(mesh);
  mends.ReversedTriangles = OrientOutwards(mesh);
  return Status::Success();
}
} // namespace palpate
