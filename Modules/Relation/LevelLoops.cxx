#include "LevelLoops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

namespace palpate
{
namespace
{
using EdgeKey = std::uint64_t;

struct EdgePoint
{
  Vector3 At;
  EdgeKey Next;
  bool IsTaken = false;
};

EdgeKey KeyOf(int one, int other)
{
  const auto [low, high] = std::minmax(one, other);
  return static_cast<EdgeKey>(static_cast<std::uint32_t>(low)) << 32 |
         static_cast<std::uint32_t>(high);
}
} // namespace

std::vector<Loop> LevelLoopsOf(const IndexedMesh& mesh, const std::vector<double>& values)
{
  std::unordered_map<EdgeKey, EdgePoint> points;
  std::vector<EdgeKey> starts; // in the order of the triangles, so that loops are, too
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const int above = (values[t[0]] >= 0.0) + (values[t[1]] >= 0.0) + (values[t[2]] >= 0.0);
    if (above == 0 || above == 3)
    {
      continue;
    }
    // The corner that is alone on its side: the curve leaves across one of its edges.
    std::size_t k = 0;
    while ((values[t[k]] >= 0.0) != (above == 1))
    {
      ++k;
    }
    const int alone = t[k];
    const int next = t[(k + 1) % 3];
    const int before = t[(k + 2) % 3];
    const int from = above == 1 ? next : before;
    const int to = above == 1 ? before : next;
    const double part = values[alone] / (values[alone] - values[from]);
    const Vector3& at = mesh.Points[alone];
    const EdgeKey key = KeyOf(alone, from);
    points[key] = {at + part * (mesh.Points[from] - at), KeyOf(alone, to), false};
    starts.push_back(key);
  }
  std::vector<Loop> loops;
  for (const EdgeKey start : starts)
  {
    Loop loop;
    for (auto at = points.find(start); at != points.end() && !at->second.IsTaken;
         at = points.find(at->second.Next))
    {
      at->second.IsTaken = true;
      loop.push_back(at->second.At);
    }
    if (loop.size() > 2)
    {
      loops.push_back(std::move(loop));
    }
  }
  return loops;
}

double LengthOf(const Loop& loop)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    length += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  }
  return length;
}

LoopSection EnclosedBy(const Loop& loop, const Vector3& normal)
{
  LoopSection section;
  if (loop.size() < 3)
  {
    return section;
  }
  const Vector3& origin = loop.front();
  double whole = 0.0;
  Vector3 moment = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
  {
    const Vector3 one = loop[i] - origin;
    const Vector3 other = loop[i + 1] - origin;
    const double area = 0.5 * normal.dot(one.cross(other));
    whole += area;
    moment += area / 3.0 * (one + other);
  }
  section.Area = std::abs(whole);
  section.Center = whole != 0.0 ? Vector3(origin + moment / whole) : origin;
  return section;
}

LoopSection SectionOf(const Loop& loop, const Vector3& normal)
{
  LoopSection section = EnclosedBy(loop, normal);
  if (loop.size() < 3)
  {
    return section;
  }
  constexpr int Directions = 90;
  const Vector3 one = normal.unitOrthogonal();
  const Vector3 other = normal.cross(one);
  section.Least = std::numeric_limits<double>::infinity();
  for (int n = 0; n < Directions; ++n)
  {
    const double angle = M_PI / Directions * n;
    const Vector3 direction = std::cos(angle) * one + std::sin(angle) * other;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Vector3& point : loop)
    {
      const double along = direction.dot(point);
      low = std::min(low, along);
      high = std::max(high, along);
    }
    section.Least = std::min(section.Least, high - low);
    section.Largest = std::max(section.Largest, high - low);
  }
  return section;
}
} // namespace palpate
