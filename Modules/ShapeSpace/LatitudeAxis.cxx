#include "LatitudeAxis.h"

#include "SphericalHarmonicBasis.h"
#include "SphericalPlacement.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
void AddCircle(const SurfaceModel& surface, double theta, LatitudeAxis& axis)
{
  const int distinct = axis.Longitudes - 1;
  std::vector<Vector3> points;
  Vector3 middle = Vector3::Zero();
  for (int k = 0; k < distinct; ++k)
  {
    const double phi = 2.0 * M_PI * k / distinct;
    points.push_back(surface.Point(Vector3(std::cos(theta), std::sin(theta) * std::sin(phi),
                                           -std::sin(theta) * std::cos(phi))));
    middle += points.back() / distinct;
  }
  points.push_back(points.front());
  double radii = 0.0;
  double areas = 0.0;
  for (int k = 0; k < axis.Longitudes; ++k)
  {
    const Vector3 here = points[static_cast<std::size_t>(k)] - middle;
    const Vector3 next = points[static_cast<std::size_t>((k + 1) % axis.Longitudes)] - middle;
    axis.PartialRadii.push_back(here.norm());
    axis.PartialAreas.push_back(k < distinct ? 0.5 * here.cross(next).norm() : 0.0);
    radii += k < distinct ? here.norm() : 0.0;
    areas += axis.PartialAreas.back();
  }
  axis.Points.insert(axis.Points.end(), points.begin(), points.end());
  axis.Theta.push_back(theta);
  axis.Middles.push_back(middle);
  axis.Radii.push_back(radii / distinct);
  axis.Areas.push_back(areas);
}
} // namespace

LatitudeAxis FindLatitudeAxis(const SurfaceModel& surface, int latitudes, int longitudes)
{
  LatitudeAxis axis;
  axis.Longitudes = longitudes;
  for (int i = 0; i < latitudes; ++i)
  {
    AddCircle(surface, M_PI * i / (latitudes - 1), axis);
  }
  return axis;
}

SurfaceModel WithLongAxisFirst(const SurfaceModel& surface)
{
  if (surface.Degree() < 1)
  {
    return surface;
  }
  const std::array<int, 3> orders{1, -1, 0}; // x, y and z
  Matrix3 degreeOne;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      const std::size_t index =
          SphericalHarmonicBasis::Index(1, orders[static_cast<std::size_t>(column)]);
      degreeOne(row, column) = std::sqrt(3.0 / (4.0 * M_PI)) * surface.Coefficients(row)[index];
    }
  }
  EllipsoidPlacement placed;
  return PlaceByEllipsoid(degreeOne, placed).IsOk()
             ? surface.Reparametrized(placed.Placement.Rotation.transpose())
             : surface;
}
} // namespace palpate
