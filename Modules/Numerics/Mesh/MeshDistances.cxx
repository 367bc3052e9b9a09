#include "MeshDistances.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace palpate
{
namespace
{
struct Weighted
{
  double Distance;
  double Weight;
};

// The least distance such that no more than `above` of the weight exceeds it. By halves: what is
// sorted out is not sorted.
double Quantile(std::vector<Weighted> entries, double above)
{
  auto begin = entries.begin();
  auto end = entries.end();
  while (end - begin > 1)
  {
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end,
                     [](const Weighted& a, const Weighted& b) { return a.Distance < b.Distance; });
    const double upper = std::accumulate(
        middle, end, 0.0, [](double sum, const Weighted& entry) { return sum + entry.Weight; });
    if (upper > above)
    {
      begin = middle;
    }
    else
    {
      above -= upper;
      end = middle;
    }
  }
  return begin != end ? begin->Distance : 0.0;
}

void Append(const std::vector<double>& distances, const std::vector<double>& weights, double share,
            std::vector<Weighted>& entries)
{
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    entries.push_back({distances[i], share * weights[i]});
  }
}

constexpr double BeyondPercentile95 = 0.05;

// Of both directions: the order of the two does not matter.
DistanceSummary Pool(const DistanceSummary& one, const DistanceSummary& other,
                     std::vector<Weighted> entries)
{
  return {0.5 * (one.Mean + other.Mean),
          std::sqrt(0.5 * (one.Rms * one.Rms + other.Rms * other.Rms)),
          Quantile(std::move(entries), BeyondPercentile95), std::max(one.Largest, other.Largest)};
}

// Without the percentile.
DistanceSummary Moments(const std::vector<double>& distances, const std::vector<double>& weights)
{
  DistanceSummary summary;
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    summary.Mean += weights[i] * distances[i];
    summary.Rms += weights[i] * distances[i] * distances[i];
    summary.Largest = std::max(summary.Largest, distances[i]);
  }
  summary.Rms = std::sqrt(summary.Rms);
  return summary;
}
// The share of a triangle in which a linear function with these values at its corners is at most 0.
double ShareBelow(std::array<double, 3> values)
{
  std::sort(values.begin(), values.end());
  const auto [low, middle, high] = values;
  if (high <= 0.0)
  {
    return 1.0;
  }
  if (low > 0.0)
  {
    return 0.0;
  }
  if (middle <= 0.0)
  {
    return 1.0 - high / (high - low) * (high / (high - middle));
  }
  return low / (low - high) * (low / (low - middle));
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

Status ComparedSurface::Make(const IndexedMesh& mesh, ComparedSurface& made)
{
  if (Status status = NearestOnMesh::Make(mesh, made.Nearest); !status.IsOk())
  {
    return status;
  }
  made.Parts = PointAreas(mesh);
  const double area = std::accumulate(made.Parts.begin(), made.Parts.end(), 0.0);
  for (double& part : made.Parts)
  {
    part = area > 0.0 ? part / area : 1.0 / static_cast<double>(made.Parts.size());
  }
  return Status::Success();
}

std::vector<double> ComparedSurface::DistancesFrom(const ComparedSurface& other) const
{
  return other.Nearest.DistancesOf(this->Nearest);
}

DistanceSummary Summarise(const std::vector<double>& distances, const std::vector<double>& weights)
{
  DistanceSummary summary = Moments(distances, weights);
  std::vector<Weighted> entries;
  entries.reserve(distances.size());
  Append(distances, weights, 1.0, entries);
  summary.Percentile95 = Quantile(std::move(entries), BeyondPercentile95);
  return summary;
}

DistanceSummary TwoSidedDistances(const std::vector<double>& there,
                                  const std::vector<double>& weightsThere,
                                  const std::vector<double>& back,
                                  const std::vector<double>& weightsBack)
{
  std::vector<Weighted> entries;
  entries.reserve(there.size() + back.size());
  Append(there, weightsThere, 0.5, entries);
  Append(back, weightsBack, 0.5, entries);
  return Pool(Moments(there, weightsThere), Moments(back, weightsBack), std::move(entries));
}

double VolumeWithin(const IndexedMesh& mesh, const Vector3& from,
                    const std::vector<double>& distances, double limit)
{
  double volume = 0.0;
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const Vector3 a = mesh.Points[t[0]] - from;
    const Vector3 b = mesh.Points[t[1]] - from;
    const Vector3 c = mesh.Points[t[2]] - from;
    // All parts of a triangle have the same height over the point.
    volume +=
        a.dot(b.cross(c)) / 6.0 *
        ShareBelow({distances[t[0]] - limit, distances[t[1]] - limit, distances[t[2]] - limit});
  }
  return volume;
}

double ShareWithin(const IndexedMesh& mesh, const std::vector<double>& distances, double limit)
{
  double within = 0.0;
  double area = 0.0;
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const Vector3& a = mesh.Points[t[0]];
    const double doubled = (mesh.Points[t[1]] - a).cross(mesh.Points[t[2]] - a).norm();
    area += doubled;
    within += doubled * ShareBelow({distances[t[0]] - limit, distances[t[1]] - limit,
                                    distances[t[2]] - limit});
  }
  return area > 0.0 ? within / area : 0.0;
}

Status MeasureMeshDistances(const IndexedMesh& one, const IndexedMesh& other,
                            MeshDistances& distances)
{
  ComparedSurface first;
  if (Status status = ComparedSurface::Make(one, first); !status.IsOk())
  {
    return status;
  }
  ComparedSurface second;
  if (Status status = ComparedSurface::Make(other, second); !status.IsOk())
  {
    return status;
  }
  const std::vector<double> there = first.DistancesFrom(second);
  const std::vector<double> back = second.DistancesFrom(first);
  distances.OneToOther = Summarise(there, first.Weights());
  distances.OtherToOne = Summarise(back, second.Weights());
  distances.Both = TwoSidedDistances(there, first.Weights(), back, second.Weights());
  return Status::Success();
}
} // namespace palpate
