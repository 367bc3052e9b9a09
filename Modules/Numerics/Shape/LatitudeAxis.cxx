#include "LatitudeAxis.h"

#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
std::vector<Vector3> CircleOf(const ParametricSphericalSurface& surface, double theta,
                              int longitudes)
{
  std::vector<Vector3> points;
  for (int k = 0; k < longitudes; ++k)
  {
    const double phi = 2.0 * M_PI * k / longitudes;
    points.push_back(surface.Point(Vector3(std::sin(theta) * std::cos(phi),
                                           std::sin(theta) * std::sin(phi), std::cos(theta))));
  }
  return points;
}
} // namespace

LatitudeAxis FindLatitudeAxis(const ParametricSphericalSurface& surface, int latitudes,
                              int longitudes)
{
  LatitudeAxis axis;
  for (int i = 0; i < latitudes; ++i)
  {
    const double theta = M_PI * i / (latitudes - 1);
    const std::vector<Vector3> circle = CircleOf(surface, theta, longitudes);
    Vector3 middle = Vector3::Zero();
    for (const Vector3& point : circle)
    {
      middle += point / longitudes;
    }
    double radius = 0.0;
    double area = 0.0;
    for (std::size_t k = 0; k < circle.size(); ++k)
    {
      const Vector3 here = circle[k] - middle;
      radius += here.norm() / longitudes;
      area += 0.5 * here.cross(circle[(k + 1) % circle.size()] - middle).norm();
    }
    axis.Theta.push_back(theta);
    axis.Middles.push_back(middle);
    axis.Radii.push_back(radius);
    axis.Areas.push_back(area);
  }
  return axis;
}
} // namespace palpate
