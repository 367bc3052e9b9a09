#include "PhantomNodule.h"

#include "ClosestPointSearch.h"
#include "DecimalText.h"

#include <memory>
#include <string>

namespace palpate
{
Status PhantomNodule::Place(const RadialModel& body, double diameter, double depth,
                            PhantomNodule& nodule)
{
  // A nodule may touch the surface; roundings of the search must not decide.
  constexpr double Tolerance = 1e-6; // mm
  const std::string name =
      "a nodule of " + SignificantText(diameter) + " mm, " + SignificantText(depth) + " mm deep, ";
  if (!(diameter > 0.0) || !(depth >= 0.0))
  {
    return Status::Failure(
        name + "is not possible: the diameter has to be positive and the depth not negative");
  }
  const Vector3 posterior = Vector3::UnitY();
  const double radius = 0.5 * diameter;
  const Vector3 center = body.PointWorld(posterior) - (depth + radius) * body.Normal(posterior);
  const ClosestPointSearch search(std::make_shared<const RadialModel>(body));
  const ClosestPoint nearest = search.Nearest(center);
  // The signed distance is negative inside.
  const double room = -nearest.SignedDistance - nearest.DistanceError;
  if (!(room >= radius - Tolerance))
  {
    return Status::Failure(name + "is not inside the body: it would reach " +
                           SignificantText(radius - room, 3) +
                           " mm out of it; give a smaller diameter or another depth");
  }
  nodule = {center - body.CenterWorld(), radius};
  return Status::Success();
}
} // namespace palpate
