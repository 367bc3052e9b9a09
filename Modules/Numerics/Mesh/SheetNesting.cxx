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
constexpr std::size_t MostSheets = 32;
constexpr double HalfSphere = 2.0 * 3.14159265358979323846;

struct Sheet
{
  int Number = 0;
  std::vector<std::array<int, 3>> Triangles; // that agree
  Eigen::AlignedBox3d Box;
};

// Around the point, within 4 pi of a whole one for each time that the triangles enclose it.
double SolidAngle(const std::vector<Vector3>& points, const Sheet& sheet, const Vector3& from)
{
  double sum = 0.0;
  for (const std::array<int, 3>& triangle : sheet.Triangles)
  {
    const Vector3 a = points[triangle[0]] - from;
    const Vector3 b = points[triangle[1]] - from;
    const Vector3 c = points[triangle[2]] - from;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    sum += 2.0 * std::atan2(a.dot(b.cross(c)),
                            la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum;
}

bool Encloses(const std::vector<Vector3>& points, const Sheet& outer, const Sheet& inner)
{
  return outer.Box.contains(inner.Box) &&
         std::abs(SolidAngle(points, outer, points[inner.Triangles.front()[0]])) > HalfSphere;
}

// The largest, then the others that are closed and large enough, by falling volume.
std::vector<Sheet> LargeSheets(const EdgeRings& rings, const MeshSheets& sheets,
                               const std::vector<double>& volumes)
{
  std::vector<char> isClosed(volumes.size(), 1);
  for (std::size_t t = 0; t < sheets.SheetOf.size(); ++t)
  {
    for (int h = 3 * static_cast<int>(t); sheets.SheetOf[t] >= 0 && h < 3 * static_cast<int>(t) + 3;
         ++h)
    {
      isClosed[sheets.SheetOf[t]] &= rings.IsPair(h) ? 1 : 0;
    }
  }
  std::vector<int> order(volumes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&volumes](int one, int other)
                   { return std::abs(volumes[one]) > std::abs(volumes[other]); });
  std::vector<Sheet> large;
  for (const int number : order)
  {
    const bool isLarge =
        std::abs(volumes[number]) >= LeastVolume * std::abs(volumes[order.front()]);
    if (large.empty() || (isLarge && isClosed[number] != 0 && large.size() < MostSheets))
    {
      large.push_back({number, {}, {}});
    }
  }
  return large;
}

void Fill(const IndexedMesh& mesh, const MeshSheets& sheets, std::vector<Sheet>& large)
{
  std::vector<Sheet*> at(static_cast<std::size_t>(sheets.SheetCount), nullptr);
  for (Sheet& sheet : large)
  {
    at[sheet.Number] = &sheet;
  }
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    Sheet* sheet = sheets.SheetOf[t] >= 0 ? at[sheets.SheetOf[t]] : nullptr;
    if (sheet != nullptr)
    {
      const auto [a, b, c] = mesh.Triangles[t];
      sheet->Triangles.push_back(sheets.IsTurned[t] != 0 ? std::array<int, 3>{a, c, b}
                                                         : mesh.Triangles[t]);
      sheet->Box.extend(mesh.Points[a]).extend(mesh.Points[b]).extend(mesh.Points[c]);
    }
  }
}
} // namespace

std::vector<int> OutermostSheets(const IndexedMesh& mesh, const EdgeRings& rings,
                                 const MeshSheets& sheets, const std::vector<double>& volumes)
{
  std::vector<Sheet> large = LargeSheets(rings, sheets, volumes);
  if (large.size() < 2)
  {
    return std::vector<int>(volumes.size(), large.empty() ? 0 : large.front().Number);
  }
  Fill(mesh, sheets, large);
  std::vector<int> outermost(volumes.size(), large.front().Number);
  std::vector<const Sheet*> roots;
  for (const Sheet& sheet : large)
  {
    const auto around =
        std::find_if(roots.begin(), roots.end(),
                     [&](const Sheet* root) { return Encloses(mesh.Points, *root, sheet); });
    outermost[sheet.Number] = around == roots.end() ? sheet.Number : (*around)->Number;
    if (around == roots.end())
    {
      roots.push_back(&sheet);
    }
  }
  return outermost;
}
} // namespace palpate
