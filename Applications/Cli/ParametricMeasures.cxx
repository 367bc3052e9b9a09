#include "ParametricMeasures.h"

#include "SphereQuadrature.h"
#include "SphericalHarmonicModel.h"

#include <Eigen/Geometry>
#include <vector>

namespace palpate::cli
{
ParametricMeasures::ParametricMeasures(const ParametricSphericalSurface& surface)
{
  std::vector<SphericalHarmonicModel> coordinates;
  for (int k = 0; k < 3; ++k)
  {
    coordinates.emplace_back(surface.Degree(), surface.Coefficients(k), Vector3::Zero());
  }
  // The triple product has degree 3L + 2 at most; the area's root needs some more.
  const SphereQuadrature sphere(4 * surface.Degree() + 16);
  for (std::size_t i = 0; i < sphere.Directions.size(); ++i)
  {
    const Vector3& u = sphere.Directions[i];
    const Vector3 first = u.unitOrthogonal();
    const Vector3 second = u.cross(first);
    Vector3 point;
    Eigen::Matrix3d gradients; // row k: surface gradient of coordinate k
    for (int k = 0; k < 3; ++k)
    {
      const SphericalHarmonicModel::Sample sample =
          coordinates[static_cast<std::size_t>(k)].Evaluate(u);
      point[k] = sample.Radius;
      gradients.row(k) = sample.SurfaceGradient;
    }
    const Vector3 normal = (gradients * first).cross(gradients * second);
    this->Volume += sphere.Weights[i] * point.dot(normal) / 3.0;
    this->Area += sphere.Weights[i] * normal.norm();
  }
}
} // namespace palpate::cli
