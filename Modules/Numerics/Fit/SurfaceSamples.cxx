#include "SurfaceSamples.h"

#include <utility>

namespace palpate
{
SurfaceSamples SampleVertices(const IndexedMesh& mesh, std::vector<Vector3> parameters)
{
  SurfaceSamples samples;
  samples.Points = mesh.Points;
  samples.Parameters = std::move(parameters);
  samples.Normals.assign(mesh.Points.size(), Vector3::Zero());
  samples.Weights.assign(mesh.Points.size(), 0.0);
  double total = 0.0;
  for (const std::array<int, 3>& triangle : mesh.Triangles)
  {
    const auto a = static_cast<std::size_t>(triangle[0]);
    const auto b = static_cast<std::size_t>(triangle[1]);
    const auto c = static_cast<std::size_t>(triangle[2]);
    const Vector3 doubled =
        (mesh.Points[b] - mesh.Points[a]).cross(mesh.Points[c] - mesh.Points[a]);
    const double area = doubled.norm();
    total += 3.0 * area;
    for (const std::size_t corner : {a, b, c})
    {
      samples.Normals[corner] += doubled;
      samples.Weights[corner] += area;
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
