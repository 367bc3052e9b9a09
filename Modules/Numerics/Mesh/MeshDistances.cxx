#include "MeshDistances.h"

#include "NearestOnMesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace palpate
{
namespace
{
struct Weighted
{
  double Distance;
  double Weight; ///< their sum is 1
};

std::vector<Weighted> DistancesFrom(const IndexedMesh& mesh, const NearestOnMesh& other)
{
  const std::vector<double> areas = PointAreas(mesh);
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  std::vector<Weighted> distances;
  distances.reserve(mesh.Points.size());
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const double weight =
        area > 0.0 ? areas[i] / area : 1.0 / static_cast<double>(mesh.Points.size());
    distances.push_back({other.Find(mesh.Points[i]).Distance, weight});
  }
  return distances;
}

// The sums are in the order of the points, whatever the sort does with equal distances.
DistanceSummary Summarise(std::vector<Weighted> distances)
{
  DistanceSummary summary;
  for (const Weighted& d : distances)
  {
    summary.Mean += d.Weight * d.Distance;
    summary.Rms += d.Weight * d.Distance * d.Distance;
    summary.Largest = std::max(summary.Largest, d.Distance);
  }
  summary.Rms = std::sqrt(summary.Rms);
  std::sort(distances.begin(), distances.end(),
            [](const Weighted& a, const Weighted& b) { return a.Distance < b.Distance; });
  double above = 1.0;
  const auto at = std::find_if(distances.begin(), distances.end(),
                               [&above](const Weighted& d) { return (above -= d.Weight) <= 0.05; });
  summary.Percentile95 = at != distances.end() ? at->Distance : summary.Largest;
  return summary;
}

std::vector<Weighted> Pool(const std::vector<Weighted>& one, const std::vector<Weighted>& other)
{
  std::vector<Weighted> both(one);
  both.insert(both.end(), other.begin(), other.end());
  for (Weighted& d : both)
  {
    d.Weight *= 0.5;
  }
  return both;
}
} // namespace

std::vector<double> PointAreas(const IndexedMesh& mesh)
{
  std::vector<double> areas(mesh.Points.size(), 0.0);
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const Vector3& a = mesh.Points[t[0]];
    const double third = (mesh.Points[t[1]] - a).cross(mesh.Points[t[2]] - a).norm() / 6.0;
    for (const int corner : t)
    {
      areas[corner] += third;
    }
  }
  return areas;
}

Status MeasureMeshDistances(const IndexedMesh& one, const IndexedMesh& other,
                            MeshDistances& distances)
{
  NearestOnMesh toOne;
  if (Status status = NearestOnMesh::Make(one, toOne); !status.IsOk())
  {
    return status;
  }
  NearestOnMesh toOther;
  if (Status status = NearestOnMesh::Make(other, toOther); !status.IsOk())
  {
    return status;
  }
  const std::vector<Weighted> fromOne = DistancesFrom(one, toOther);
  const std::vector<Weighted> fromOther = DistancesFrom(other, toOne);
  distances.OneToOther = Summarise(fromOne);
  distances.OtherToOne = Summarise(fromOther);
  distances.Both = Summarise(Pool(fromOne, fromOther));
  return Status::Success();
}
} // namespace palpate
