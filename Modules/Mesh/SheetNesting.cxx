#include "SheetNesting.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace palpate
{
namespace
{
constexpr double LeastVolume = 0.01; // of the largest sheet's
constexpr std::size_t MostSheets = 16;

double SizeOf(double volume)
{
  return std::isfinite(volume) ? std::abs(volume) : 0.0;
}

struct Sheet
{
  std::vector<int> Triangles; // of large sheets only
  Eigen::AlignedBox3d Box;
  bool IsClosed = true;
};

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

std::vector<Sheet> DescribeSheets(const IndexedMesh& mesh, const EdgeRings& rings,
                                  const MeshSheets& sheets, const std::vector<int>& large)
{
  std::vector<Sheet> described(static_cast<std::size_t>(sheets.SheetCount));
  std::vector<char> isLarge(described.size(), 0);
  for (const int sheet : large)
  {
    isLarge[sheet] = 1;
  }
  const int count = static_cast<int>(mesh.Triangles.size());
  for (int t = 0; t < count; ++t)
  {
    const int number = sheets.SheetOf[t];
    if (number < 0)
    {
      continue;
    }
    Sheet& sheet = described[number];
    for (int k = 0; k < 3; ++k)
    {
      sheet.Box.extend(mesh.Points[mesh.Triangles[t][k]]);
      sheet.IsClosed = sheet.IsClosed && rings.IsPair(3 * t + k);
    }
    if (isLarge[number] != 0)
    {
      sheet.Triangles.push_back(t);
    }
  }
  return described;
}

Vector3 CenterOf(const IndexedMesh& mesh, int triangle)
{
  const auto [a, b, c] = mesh.Triangles[triangle];
  return (mesh.Points[a] + mesh.Points[b] + mesh.Points[c]) / 3.0;
}

// Whether a sheet fills more than half of the sphere of directions (van Oosterom and Strackee, IEEE
// Trans. Biomed. Eng. 30 (1983)).
bool Surrounds(const IndexedMesh& mesh, const MeshSheets& sheets, const Sheet& sheet,
               const Vector3& point)
{
  double angle = 0.0;
  for (const int t : sheet.Triangles)
  {
    const auto [i, j, k] = mesh.Triangles[t];
    const Vector3 a = mesh.Points[i] - point;
    const Vector3 b = mesh.Points[j] - point;
    const Vector3 c = mesh.Points[k] - point;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    const double part =
        std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    angle += sheets.IsTurned[t] != 0 ? -part : part; // half the solid angle
  }
  return std::abs(angle) > M_PI;
}

// Most of a lumen that sticks out of its wall a little lies in the wall's box.
bool IsAbout(const Eigen::AlignedBox3d& outer, const Eigen::AlignedBox3d& inner)
{
  constexpr double Beyond = 0.05; // of the box's size
  const Vector3 beyond = Beyond * outer.sizes();
  return Eigen::AlignedBox3d(outer.min() - beyond, outer.max() + beyond).contains(inner);
}

// By the centres of five triangles, or of fewer if three agree.
bool Encloses(const IndexedMesh& mesh, const MeshSheets& sheets, const Sheet& outer,
              const Sheet& inner)
{
  constexpr std::size_t Majority = 3;
  constexpr double GoldenRatio = 0.6180339887498949; // spreads over any regular order
  if (!IsAbout(outer.Box, inner.Box))
  {
    return false;
  }
  std::array<std::size_t, 2> votes{};
  for (double part = 0.5; votes[0] < Majority && votes[1] < Majority;
       part = std::fmod(part + GoldenRatio, 1.0))
  {
    const auto number =
        static_cast<std::size_t>(part * static_cast<double>(inner.Triangles.size()));
    const int triangle = inner.Triangles[std::min(number, inner.Triangles.size() - 1)];
    ++votes[Surrounds(mesh, sheets, outer, CenterOf(mesh, triangle)) ? 1 : 0];
  }
  return votes[1] == Majority;
}
} // namespace

std::vector<int> OutermostSheets(const IndexedMesh& mesh, const EdgeRings& rings,
                                 const MeshSheets& sheets, const std::vector<double>& volumes)
{
  const std::vector<int> large = LargeSheets(volumes);
  if (large.size() < 2)
  {
    return std::vector<int>(volumes.size(), large.front());
  }
  std::vector<int> outermost(volumes.size(), -1);
  const std::vector<Sheet> described = DescribeSheets(mesh, rings, sheets, large);
  std::vector<int> roots;
  for (const int sheet : large)
  {
    const auto around = std::find_if(
        roots.begin(), roots.end(),
        [&](int root) { return Encloses(mesh, sheets, described[root], described[sheet]); });
    if (around != roots.end())
    {
      outermost[sheet] = outermost[*around];
      continue;
    }
    outermost[sheet] = described[sheet].IsClosed ? sheet : large.front();
    roots.push_back(sheet);
  }
  for (std::size_t sheet = 0; sheet < outermost.size(); ++sheet)
  {
    if (outermost[sheet] < 0)
    {
      // The smallest with a box around it.
      const auto around = std::find_if(
          roots.rbegin(), roots.rend(),
          [&](int root) { return described[root].Box.contains(described[sheet].Box); });
      outermost[sheet] = around != roots.rend() ? outermost[*around] : large.front();
    }
  }
  return outermost;
}
} // namespace palpate
