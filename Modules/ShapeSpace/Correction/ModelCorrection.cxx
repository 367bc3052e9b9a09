#include "ModelCorrection.h"

#include "IcosahedronDirections.h"
#include "SphericalHarmonicProjection.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

namespace palpate
{
namespace
{
constexpr double LeastRadiusLeft = 0.1; // mm

Status CorrectRadial(const RadialModel& start, const SurfaceCorrection& correction, int degree,
                     OrganModel& corrected)
{
  double least = std::numeric_limits<double>::infinity();
  const auto radius = [&](const Vector3& u)
  {
    const double moved = start.Radius(u) + correction.DisplacementAt(start.PointWorld(u), u).dot(u);
    least = std::min(least, moved);
    return moved;
  };
  std::vector<double> coefficients = ProjectOnHarmonics(degree, 3 * degree, radius);
  if (!(least > LeastRadiusLeft))
  {
    return Status::Failure("would be pushed through its own centre");
  }
  corrected = RadialModel(degree, std::move(coefficients), start.CenterWorld());
  return Status::Success();
}
} // namespace

SurfaceCorrection StartOfModel(const OrganModel& start, int frequency)
{
  const std::vector<Vector3> rays = IcosahedronDirections(frequency).Directions();
  std::vector<Vector3> points(rays.size());
  std::vector<Vector3> directions = rays;
  for (std::size_t n = 0; n < rays.size(); ++n)
  {
    if (const auto* radial = std::get_if<RadialModel>(&start))
    {
      points[n] = radial->PointWorld(rays[n]);
      continue;
    }
    const auto& surface = std::get<SurfaceModel>(start);
    points[n] = surface.Point(rays[n]);
    directions[n] = surface.Normal(rays[n]);
  }
  return {std::move(points), std::move(directions),
          std::holds_alternative<RadialModel>(start) ? SurfaceCorrection::Motion::AlongDirections
                                                     : SurfaceCorrection::Motion::Free};
}

Status ModelCorrection::Apply(const OrganModel& start, const SurfaceCorrection& correction,
                              OrganModel& corrected)
{
  const int degree = std::max(DegreeOf(start), LeastDegree);
  if (const auto* radial = std::get_if<RadialModel>(&start))
  {
    return CorrectRadial(*radial, correction, degree, corrected);
  }
  const auto& surface = std::get<SurfaceModel>(start);
  const auto moved = [&](const Vector3& u) -> Vector3
  {
    const Vector3 point = surface.Point(u);
    return point + correction.DisplacementAt(point, surface.Normal(u));
  };
  corrected = SurfaceModel(degree, ProjectPointsOnHarmonics(degree, 3 * degree, moved));
  return Status::Success();
}
} // namespace palpate
