#include "SurfaceTopology.h"

#include "DecimalText.h"
#include "EdgeRings.h"
#include "MeshSheets.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace palpate
{
namespace
{
constexpr std::size_t MostOfTopology = 700'000'000; // three half-edges each, numbered by int

void CountTriangles(const IndexedMesh& mesh, SurfaceTopology& topology)
{
  const int count = static_cast<int>(mesh.Points.size());
  for (const std::array<int, 3>& triangle : mesh.Triangles)
  {
    const bool isValid = std::all_of(triangle.begin(), triangle.end(),
                                     [count](int p) { return p >= 0 && p < count; });
    topology.InvalidTriangles += isValid ? 0 : 1;
    topology.DegenerateTriangles +=
        isValid && !HasThreePoints(triangle, mesh.Points.size()) ? 1 : 0;
  }
}

// Marks the endpoints of boundary edges and joins them; each set is a hole.
int CountHoles(const IndexedMesh& mesh, const EdgeRings& rings)
{
  std::vector<int> parents(mesh.Points.size(), -1);
  const auto rootOf = [&parents](int p)
  {
    for (parents[p] = parents[p] < 0 ? p : parents[p]; parents[p] != p;)
    {
      parents[p] = parents[parents[p]];
      p = parents[p];
    }
    return p;
  };
  const int count = 3 * static_cast<int>(mesh.Triangles.size());
  for (int h = 0; h < count; ++h)
  {
    if (rings.IsBoundary(h))
    {
      const int one = rootOf(StartOf(mesh, h));
      parents[one] = rootOf(StartOf(mesh, NextInTriangle(h)));
    }
  }
  int holes = 0;
  for (std::size_t p = 0; p < parents.size(); ++p)
  {
    holes += parents[p] == static_cast<int>(p) ? 1 : 0;
  }
  return holes;
}

// A triangle belongs to the ring of its two smallest points.
int CountDuplicates(const IndexedMesh& mesh, const EdgeRings& rings, int first,
                    std::vector<int>& thirds)
{
  thirds.clear();
  int h = first;
  do
  {
    const int third = StartOf(mesh, PreviousInTriangle(h));
    if (third > StartOf(mesh, h) && third > StartOf(mesh, NextInTriangle(h)))
    {
      thirds.push_back(third);
    }
    h = rings.Next(h);
  } while (h != first);
  std::sort(thirds.begin(), thirds.end());
  return static_cast<int>(thirds.end() - std::unique(thirds.begin(), thirds.end()));
}

// Each edge once, at its smallest half-edge; rings ascend but for their last link.
void CountEdges(const IndexedMesh& mesh, const EdgeRings& rings, SurfaceTopology& topology)
{
  std::vector<int> thirds;
  const int count = 3 * static_cast<int>(mesh.Triangles.size());
  for (int h = 0; h < count; ++h)
  {
    if (rings.IsLeftOut(h / 3))
    {
      continue;
    }
    if (rings.IsBoundary(h))
    {
      ++topology.BoundaryEdges;
    }
    else if (rings.IsPair(h))
    {
      const int other = rings.Next(h);
      const bool isAlike = StartOf(mesh, h) == StartOf(mesh, other);
      topology.OrientationConflicts += h < other && isAlike ? 1 : 0;
      topology.DuplicateTriangles += h < other ? CountDuplicates(mesh, rings, h, thirds) : 0;
    }
    else if (rings.Next(h) < h) // the last of a larger ring
    {
      ++topology.NonManifoldEdges;
      topology.DuplicateTriangles += CountDuplicates(mesh, rings, h, thirds);
    }
  }
  topology.Edges = rings.EdgeCount();
  topology.Holes = topology.BoundaryEdges > 0 ? CountHoles(mesh, rings) : 0;
}

// Walks over the corners of one fan around a point, from corner `first` across the half-edge that
// leaves it or the one that arrives, and marks them. Returns true if it came back.
bool WalkFan(const IndexedMesh& mesh, const EdgeRings& rings, int first, bool leaves,
             std::vector<bool>& isSeen)
{
  const int point = StartOf(mesh, first);
  int edge = leaves ? first : PreviousInTriangle(first);
  while (rings.IsPair(edge))
  {
    const int other = rings.Next(edge);
    const bool starts = StartOf(mesh, other) == point;
    const int corner = starts ? other : NextInTriangle(other);
    if (isSeen[corner])
    {
      return true;
    }
    isSeen[corner] = true;
    edge = starts ? PreviousInTriangle(other) : NextInTriangle(other);
  }
  return false;
}

void CountFans(const IndexedMesh& mesh, const EdgeRings& rings, SurfaceTopology& topology)
{
  std::vector<bool> isSeen(3 * mesh.Triangles.size(), false);
  std::vector<char> fans(mesh.Points.size(), 0); // 0, 1, or 2 for more
  int fanCount = 0;
  const int count = 3 * static_cast<int>(mesh.Triangles.size());
  for (int h = 0; h < count; ++h)
  {
    if (isSeen[h] || rings.IsLeftOut(h / 3))
    {
      continue;
    }
    isSeen[h] = true;
    if (!WalkFan(mesh, rings, h, true, isSeen))
    {
      WalkFan(mesh, rings, h, false, isSeen);
    }
    char& number = fans[StartOf(mesh, h)];
    topology.PinchedPoints += number == 1 ? 1 : 0;
    number = static_cast<char>(std::min(2, number + 1));
    ++fanCount;
  }
  topology.UnusedPoints = static_cast<int>(std::count(fans.begin(), fans.end(), 0));
  topology.EulerCharacteristic = fanCount - topology.Edges + topology.Triangles -
                                 topology.InvalidTriangles - topology.DegenerateTriangles;
}

// Relative to one of the points, so that far from the origin no digits are lost.
void Measure(const IndexedMesh& mesh, const EdgeRings& rings, SurfaceTopology& topology)
{
  const Vector3 base = mesh.Points.front();
  const int count = static_cast<int>(mesh.Triangles.size());
  for (int t = 0; t < count; ++t)
  {
    if (rings.IsLeftOut(t))
    {
      continue;
    }
    const auto [i, j, k] = mesh.Triangles[t];
    const Vector3 a = mesh.Points[i] - base;
    const Vector3 ab = mesh.Points[j] - mesh.Points[i];
    const Vector3 ac = mesh.Points[k] - mesh.Points[i];
    const Vector3 normal = ab.cross(ac);
    const double length = normal.norm();
    topology.FlatTriangles += length > 1e-14 * ab.norm() * ac.norm() ? 0 : 1;
    topology.Area += 0.5 * length;
    topology.Volume += a.dot(normal) / 6.0;
  }
}

std::string Counted(int count, const std::string& noun)
{
  return CountText(count, noun, noun + "s");
}

// Facts about single points, triangles and edges; empty if they form closed, oriented surfaces.
std::string ManifoldFault(const SurfaceTopology& is)
{
  return is.Triangles == 0        ? "has no triangles"
         : is.NonFinitePoints > 0 ? "has " + Counted(is.NonFinitePoints, "non-finite point")
         : is.InvalidTriangles > 0
             ? "has " + Counted(is.InvalidTriangles, "triangle") + " with invalid point indices"
         : is.DegenerateTriangles > 0
             ? "has " + Counted(is.DegenerateTriangles, "triangle") + " with a repeated point"
         : is.DuplicateTriangles > 0 ? "has " + Counted(is.DuplicateTriangles, "duplicate triangle")
         : is.NonManifoldEdges > 0
             ? "has " + Counted(is.NonManifoldEdges, "edge") + " with more than two triangles"
         : is.Holes > 0 ? "has " + Counted(is.Holes, "hole")
         : is.PinchedPoints > 0
             ? "has " + Counted(is.PinchedPoints, "pinched point") + ", where it touches itself"
         : !is.IsOrientable            ? "is one-sided, like a Klein bottle"
         : is.OrientationConflicts > 0 ? "has " + Counted(is.OrientationConflicts, "edge") +
                                             " between triangles of opposite orientation"
                                       : "";
}

std::string GenusZeroFault(const SurfaceTopology& is)
{
  return is.Parts > 1          ? "has " + Counted(is.Parts, "separate part")
         : is.Handles() > 0    ? "has " + Counted(is.Handles(), "handle")
         : is.UnusedPoints > 0 ? "has " + Counted(is.UnusedPoints, "unused point")
         : is.Volume < 0.0     ? "is inside out"
         : is.Volume > 0.0     ? ""
                               : "encloses no volume";
}
} // namespace

EnclosedMeasure MeasureEnclosed(const IndexedMesh& mesh)
{
  EnclosedMeasure measure;
  for (const auto& [i, j, k] : mesh.Triangles)
  {
    const Vector3& a = mesh.Points[static_cast<std::size_t>(i)];
    const Vector3 doubled = (mesh.Points[static_cast<std::size_t>(j)] - a)
                                .cross(mesh.Points[static_cast<std::size_t>(k)] - a);
    // From a point of the surface: less cancellation.
    measure.Volume += (a - mesh.Points.front()).dot(doubled) / 6.0;
    measure.Area += 0.5 * doubled.norm();
  }
  return measure;
}

SurfaceTopology DescribeTopology(const IndexedMesh& mesh)
{
  SurfaceTopology topology;
  const auto bounded = [](std::size_t count)
  { return static_cast<int>(std::min<std::size_t>(count, std::numeric_limits<int>::max())); };
  topology.Points = bounded(mesh.Points.size());
  topology.Triangles = bounded(mesh.Triangles.size());
  if (std::max(mesh.Triangles.size(), mesh.Points.size()) > MostOfTopology)
  {
    return topology;
  }
  topology.NonFinitePoints = static_cast<int>(std::count_if(
      mesh.Points.begin(), mesh.Points.end(), [](const Vector3& p) { return !p.allFinite(); }));
  CountTriangles(mesh, topology);
  const EdgeRings rings(mesh);
  CountEdges(mesh, rings, topology);
  CountFans(mesh, rings, topology);
  const MeshSheets sheets(mesh, rings);
  topology.IsOrientable = sheets.IsOrientable;
  topology.Parts = sheets.PartCount;
  if (topology.NonFinitePoints == 0 && !mesh.Points.empty())
  {
    Measure(mesh, rings, topology);
  }
  return topology;
}

std::string FaultOfGenusZero(const SurfaceTopology& topology)
{
  if (std::max(topology.Triangles, topology.Points) > static_cast<int>(MostOfTopology))
  {
    return "has more than 700 million triangles or points";
  }
  const std::string fault = ManifoldFault(topology);
  return fault.empty() ? GenusZeroFault(topology) : fault;
}

Status CheckClosedGenusZero(const SurfaceTopology& topology)
{
  const std::string fault = FaultOfGenusZero(topology);
  return fault.empty() ? Status::Success() : Status::Failure("The surface " + fault + ".");
}
} // namespace palpate
