#include "ClosestPointSearch.h"

#include "IcosahedronDirections.h"
#include "NearestByBruteForce.h"
#include "RandomShapes.h"
#include "SurfaceCurvature.h"
#include "WorstCase.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>

namespace palpate::closest_point_sweep_test
{
namespace
{
using test::Random;

// Points of a surface, dense enough to detect a point on the wrong side of the body.
class SurfacePoints
{
public:
  explicit SurfacePoints(const RadialModel& model)
  {
    const IcosahedronDirections sphere(16);
    this->Points.resize(3, static_cast<Eigen::Index>(sphere.Directions().size()));
    Eigen::Index column = 0;
    for (const Vector3& u : sphere.Directions())
    {
      this->Points.col(column++) = model.PointWorld(u);
    }
  }

  double Distance(const Vector3& query) const
  {
    return std::sqrt((this->Points.colwise() - query).colwise().squaredNorm().minCoeff());
  }

private:
  Eigen::Matrix3Xd Points;
};

enum class Place
{
  Inside,
  Outside,
  Center, ///< within a thousandth of the radius
  Focal   ///< the centre of the surface's strongest curvature: an end of the medial axis
};

Vector3 QueryAt(Place place, const RadialModel& model, Random& random)
{
  std::uniform_real_distribution<double> uniform;
  const Vector3 u = test::RandomDirection(random);
  const Vector3 outwards = model.PointWorld(u) - model.CenterWorld();
  switch (place)
  {
  case Place::Inside:
    return model.CenterWorld() + std::cbrt(uniform(random)) * outwards;
  case Place::Outside:
    return model.CenterWorld() + (1.0 + 2.0 * uniform(random)) * outwards;
  case Place::Center:
    return model.CenterWorld() + 1e-3 * uniform(random) * outwards;
  case Place::Focal:
    break;
  }
  const double bend = CurvatureAt(u, model.EvaluateSecondOrder(u)).Principal[0];
  const double depth = bend > 0.0 ? std::min(1.0 / bend, outwards.norm()) : outwards.norm();
  return model.PointWorld(u) - depth * model.Normal(u);
}

// 25,000 queries in each of four places.
class ClosestPointSweep : public testing::TestWithParam<Place>
{
};

TEST_P(ClosestPointSweep, NoSurfacePointIsCloser)
{
  Random random(960 + static_cast<unsigned>(GetParam()));
  for (const RadialModel& model :
       {test::RandomOrgan(random, 12), test::RandomOrgan(random, 6),
        test::RandomRough(random, 12, 20.0), test::RandomRough(random, 5, 20.0)})
  {
    const ClosestPointSearch search(std::make_shared<const RadialModel>(model));
    const SurfacePoints points(model);
    test::WorstCase excess;
    test::WorstCase off;
    for (int i = 0; i < 6250; ++i)
    {
      const Vector3 query = QueryAt(GetParam(), model, random);
      const ClosestPoint found = search.Nearest(query);
      const double distance = std::abs(found.SignedDistance);
      excess.Add(std::max(distance - points.Distance(query), 0.0));
      off.Add((model.PointWorld(found.Direction) - found.PointWorld).norm());
      off.Add((found.PointWorld - query).norm() - distance);
    }
    // Roundings of coordinates of up to 300 mm.
    EXPECT_LE(excess.Value(), 1e-12);
    EXPECT_LE(off.Value(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Everywhere, ClosestPointSweep,
                         testing::Values(Place::Inside, Place::Outside, Place::Center,
                                         Place::Focal));
} // namespace
} // namespace palpate::closest_point_sweep_test
