#include "CrossingRemedy.h"

#include "MeshCrossings.h"
#include "SurfaceTessellation.h"
#include "WindingMesh.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// A crossing's place on one of its sheets, and which way that is to go: 1 outwards, -1 inwards, 0
// for a pleat.
struct CrossingEnd
{
  Vector3 Point; // of the samples
  Vector3 Normal;
  double Side;
};

class CrossingSearch
{
public:
  CrossingSearch(const SurfaceModel& surface, const SurfaceSamples& samples,
                 const IcosahedronDirections& sphere, const IndexedMesh& mesh)
      : Samples(samples), Sphere(sphere), Mesh(mesh), Winding(mesh.Points, mesh.Triangles),
        HalfWave(M_PI / surface.Degree())
  {
  }

  // Of pairs from all over the list, which is in the order of places.
  std::vector<CrossingEnd> Ends(const std::vector<MeshCrossing>& pairs) const
  {
    constexpr std::size_t Most = 200;
    const std::size_t stride = 1 + (pairs.size() - 1) / Most;
    std::vector<CrossingEnd> ends;
    for (std::size_t i = 0; i < pairs.size(); i += stride)
    {
      const MeshCrossing& pair = pairs[i];
      const std::size_t first = this->NearestSample(pair.First);
      const std::size_t second = this->NearestSample(pair.Second);
      const Vector3& u = this->Samples.Parameters[first];
      const bool isPleat = u.dot(this->Samples.Parameters[second]) > std::cos(2.0 * this->HalfWave);
      const double side = isPleat ? 0.0 : this->SideOf(pair);
      for (const std::size_t sample : {first, second})
      {
        ends.push_back({this->Samples.Points[sample], this->Samples.Normals[sample], side});
      }
    }
    return ends;
  }

private:
  const Vector3& Corner(int triangle, std::size_t corner) const
  {
    const int point = this->Mesh.Triangles[static_cast<std::size_t>(triangle)][corner];
    return this->Mesh.Points[static_cast<std::size_t>(point)];
  }

  Vector3 NormalOf(int triangle) const
  {
    const Vector3& a = this->Corner(triangle, 0);
    return (this->Corner(triangle, 1) - a).cross(this->Corner(triangle, 2) - a).normalized();
  }

  // By parameters.
  std::size_t NearestSample(int triangle) const
  {
    Vector3 middle = Vector3::Zero();
    for (const int corner : this->Mesh.Triangles[static_cast<std::size_t>(triangle)])
    {
      middle += this->Sphere.Directions()[static_cast<std::size_t>(corner)];
    }
    const auto& all = this->Samples.Parameters;
    const auto nearest = std::max_element(all.begin(), all.end(),
                                          [&](const Vector3& a, const Vector3& b)
                                          { return a.dot(middle) < b.dot(middle); });
    return static_cast<std::size_t>(nearest - all.begin());
  }

  // Between two sheets that cross, on the outer side of the one and the inner side of the other,
  // the winding number is 1 if they overlap, and 0 if a thin wall is turned inside out.
  double SideOf(const MeshCrossing& pair) const
  {
    const double reach = 0.5 * (this->Corner(pair.First, 1) - this->Corner(pair.First, 0)).norm();
    const Vector3 between =
        reach * (this->NormalOf(pair.First) - this->NormalOf(pair.Second)).normalized();
    const int both = this->Winding.WindingNumber(pair.Place + between) +
                     this->Winding.WindingNumber(pair.Place - between);
    return both >= 1 ? -1.0 : 1.0;
  }

  const SurfaceSamples& Samples;
  const IcosahedronDirections& Sphere;
  const IndexedMesh& Mesh;
  WindingMesh Winding;
  double HalfWave; // rad
};

// What is to be changed where a tessellation crosses itself.
Status AddRemedy(const SurfaceModel& surface, const SurfaceSamples& samples, int frequency,
                 CrossingRemedy& remedy)
{
  constexpr std::size_t Most = 20000;
  const IcosahedronDirections sphere(frequency);
  const IndexedMesh mesh = Tessellated(surface, sphere);
  MeshCrossings found;
  Status status = FindMeshCrossings(mesh, {Most, Most}, found);
  if (!status.IsOk() || found.Count == 0)
  {
    return status;
  }
  remedy.Crossings += found.Count;
  const CrossingSearch search(surface, samples, sphere, mesh);
  constexpr double Pleated = 0.3;   // of a crossing's influence
  constexpr double SameSheet = 0.3; // cosine
  const double width = 0.5 * HalfWavelengthOf(surface);
  const double step = 0.1 * width;
  for (const CrossingEnd& end : search.Ends(found.Pairs))
  {
    for (std::size_t i = 0; i < remedy.Shifts.size(); ++i)
    {
      const double squared = (end.Point - samples.Points[i]).squaredNorm();
      const double influence = std::exp(-0.5 * squared / (width * width));
      if (end.Side == 0.0)
      {
        remedy.IsPleated[i] |= influence > Pleated ? 1 : 0;
      }
      else if (end.Normal.dot(samples.Normals[i]) > SameSheet)
      {
        const double shift = step * influence;
        double& most = remedy.Shifts[i];
        most = shift > std::abs(most) ? end.Side * shift : most;
      }
    }
  }
  return status;
}
} // namespace

double HalfWavelengthOf(const SurfaceModel& surface)
{
  return std::sqrt(surface.Area() / (4.0 * M_PI)) * M_PI / surface.Degree();
}

Status FindCrossingRemedy(const SurfaceModel& surface, const SurfaceSamples& samples,
                          std::size_t vertices, CrossingRemedy& remedy)
{
  remedy = {0, std::vector<double>(vertices), std::vector<char>(vertices)};
  if (surface.Degree() < 2) // an ellipsoid
  {
    return Status::Success();
  }
  // As in touch and as drawn: sheets that almost touch may cross in either one.
  constexpr int LeastTouched = 8;
  constexpr int LeastDrawn = 20;
  const int touched = std::max(LeastTouched, 2 * surface.Degree());
  const int drawn = std::max(LeastDrawn, static_cast<int>(std::ceil(1.6 * surface.Degree())));
  const Status status = AddRemedy(surface, samples, touched, remedy);
  return status.IsOk() ? AddRemedy(surface, samples, drawn, remedy) : status;
}
} // namespace palpate
