#include "SurfaceTessellation.h"

#include <vector>

namespace palpate
{
IndexedMesh Tessellated(const SurfaceModel& surface, const IcosahedronDirections& parameters)
{
  std::vector<SurfaceModel::Sample> samples(parameters.Directions().size());
  surface.EvaluateBatch(parameters.Directions().data(), samples.size(), samples.data());
  IndexedMesh mesh;
  mesh.Triangles = parameters.Triangles();
  mesh.Points.reserve(samples.size());
  for (const auto& sample : samples)
  {
    mesh.Points.push_back(sample.Point);
  }
  return mesh;
}
} // namespace palpate
