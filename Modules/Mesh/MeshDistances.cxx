#include "MeshDistances.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
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
    const double third = AreaVector(mesh, t).norm() / 3.0;
    for (const int corner : t)
    {
      areas[corner] += third;
    }
  }
  return areas;
}

Status ComparedSurface::Make(const IndexedMesh& mesh, ComparedSurface& made)
{
  made.Surface = {mesh, {}};
  return NearestOnMesh::Make(mesh, made.Nearest);
}

DistanceSamples ComparedSurface::SamplesFrom(const ComparedSurface& other) const
{
  DistanceSamples samples;
  [[maybe_unused]] const Status always = SampleDistances(
      this->Surface,
      [&other](const std::vector<Vector3>& points, std::vector<double>& distances)
      {
        distances = other.Nearest.DistancesOf(points);
        return Status::Success();
      },
      samples);
  return samples;
}

double AreaWithin(const IndexedMesh& mesh, const std::vector<double>& distances, double limit)
{
  double area = 0.0;
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    area += AreaVector(mesh, t).norm() *
            ShareBelow({distances[t[0]] - limit, distances[t[1]] - limit, distances[t[2]] - limit});
  }
  return area;
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
  const DistanceSamples there = first.SamplesFrom(second);
  const DistanceSamples back = second.SamplesFrom(first);
  distances.OneToOther = Summarise(there);
  distances.OtherToOne = Summarise(back);
  distances.Both = TwoSidedDistances(there, back);
  return Status::Success();
}
} // namespace palpate
