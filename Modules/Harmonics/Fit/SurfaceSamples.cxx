#include "SurfaceSamples.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
struct TriangleCorners
{
  std::array<Vector3, 3> Of;

  TriangleCorners(const std::vector<Vector3>& all, const std::array<int, 3>& triangle)
      : Of{all[static_cast<std::size_t>(triangle[0])], all[static_cast<std::size_t>(triangle[1])],
           all[static_cast<std::size_t>(triangle[2])]}
  {
  }
  Vector3 DoubledArea() const
  {
    return (this->Of[1] - this->Of[0]).cross(this->Of[2] - this->Of[0]);
  }
  double LongestEdge() const
  {
    return std::sqrt(std::max({(this->Of[1] - this->Of[0]).squaredNorm(),
                               (this->Of[2] - this->Of[1]).squaredNorm(),
                               (this->Of[0] - this->Of[2]).squaredNorm()}));
  }
  Vector3 At(double a, double b, double c) const
  {
    return a * this->Of[0] + b * this->Of[1] + c * this->Of[2];
  }
};

// Parts of an edge; 1 for a triangle that is not divided.
int PartsOf(const TriangleCorners& parameters, double longestEdge)
{
  constexpr double MostParts = 8.0;
  return static_cast<int>(
      std::clamp(std::ceil(parameters.LongestEdge() / longestEdge), 1.0, MostParts));
}

// The centres of the triangles into which `parts` divide a triangle.
template <typename Add>
void ForEachCenter(int parts, const Add& add)
{
  const double step = 1.0 / parts;
  for (int i = 0; i < parts; ++i)
  {
    for (int j = 0; i + j < parts; ++j)
    {
      const double a = step * (i + 1.0 / 3.0);
      const double b = step * (j + 1.0 / 3.0);
      add(a, b, 1.0 - a - b);
      if (i + j + 1 < parts) // the one that points the other way
      {
        add(a + step / 3.0, b + step / 3.0, 1.0 - a - b - 2.0 * step / 3.0);
      }
    }
  }
}
} // namespace

double SampleSpacingFor(int degree) noexcept
{
  return 2.0 * M_PI / (3.0 * std::max(degree, 1));
}

SurfaceSamples SampleMesh(const IndexedMesh& mesh, const std::vector<Vector3>& parameters,
                          double longestEdge)
{
  SurfaceSamples samples;
  samples.Points = mesh.Points;
  samples.Parameters = parameters;
  samples.Normals.assign(mesh.Points.size(), Vector3::Zero());
  samples.Weights.assign(mesh.Points.size(), 0.0);
  double total = 0.0;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const TriangleCorners points(mesh.Points, mesh.Triangles[t]);
    const TriangleCorners places(parameters, mesh.Triangles[t]);
    const Vector3 doubled = points.DoubledArea();
    const double area = doubled.norm();
    const int parts = PartsOf(places, longestEdge);
    total += area;
    for (const int corner : mesh.Triangles[t])
    {
      samples.Normals[static_cast<std::size_t>(corner)] += doubled;
      samples.Weights[static_cast<std::size_t>(corner)] += parts == 1 ? area / 3.0 : 0.0;
    }
    if (parts > 1)
    {
      ForEachCenter(parts,
                    [&](double a, double b, double c)
                    {
                      samples.Points.push_back(points.At(a, b, c));
                      samples.Parameters.push_back(places.At(a, b, c).normalized());
                      samples.Normals.push_back(doubled);
                      samples.Weights.push_back(area / (parts * parts));
                      samples.Triangles.push_back(static_cast<int>(t));
                    });
    }
  }
  for (std::size_t i = 0; i < samples.Points.size(); ++i)
  {
    samples.Normals[i].normalize();
    samples.Weights[i] /= total;
  }
  return samples;
}
} // namespace palpate
