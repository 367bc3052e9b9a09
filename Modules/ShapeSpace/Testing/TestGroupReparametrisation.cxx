#include "GroupReparametrisation.h"

#include "IcosahedronDirections.h"
#include "MeshDistances.h"
#include "ReparametrisedSurface.h"
#include "SurfacePhantoms.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::group_reparametrisation_test
{
namespace
{
using test::Random;
using Surfaces = std::vector<SurfaceModel>;

constexpr int Degree = 10;

// About the origin; no symmetry, relief of some millimetres.
SurfaceModel Body(double stretch, double bulge)
{
  return test::ProjectMap(Degree,
                          [=](const Vector3& u)
                          {
                            const Vector3 side = Vector3(0.6, 0.0, 0.8);
                            const Vector3 body(20.0 * stretch * u[0], 14.0 * u[1], 17.0 * u[2]);
                            return Vector3(body +
                                           bulge * std::exp(3.0 * (u.dot(side) - 1.0)) * side +
                                           2.0 * u[0] * u[1] * Vector3::UnitY());
                          });
}

// Moves by at most some `turn` rad along smooth fields.
SphereFlow SmallFlow(Random& random, double turn)
{
  std::normal_distribution<double> normal;
  SphereFlow flow(2);
  flow.Add(SphereFlow::Field::NullaryExpr(3, 9, [&] { return turn * normal(random); }));
  return flow;
}

// One body with six different parameters.
Surfaces OneBody()
{
  Random random(21);
  Surfaces surfaces;
  for (int i = 0; i < 6; ++i)
  {
    surfaces.push_back(Reparametrise(Body(1.0, 5.0), SmallFlow(random, 0.06)).Surface);
  }
  return surfaces;
}

// Bodies of two modes, with parameters that differ, too.
Surfaces Family(int count)
{
  Random random(22);
  std::normal_distribution<double> normal;
  Surfaces surfaces;
  for (int i = 0; i < count; ++i)
  {
    const double stretch = 1.0 + 0.1 * normal(random);
    const double bulge = 5.0 + normal(random);
    surfaces.push_back(Reparametrise(Body(stretch, bulge), SmallFlow(random, 0.04)).Surface);
  }
  return surfaces;
}

ReparametrisationResult ResultOf(const Surfaces& surfaces,
                                 const ReparametrisationSettings& settings = {})
{
  ReparametrisationResult result;
  const Status status = ReparametriseGroup(surfaces, settings, result);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return result;
}

double LargestDifference(const SurfaceModel& one, const SurfaceModel& other)
{
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (std::size_t i = 0; i < one.Coefficients(axis).size(); ++i)
    {
      largest =
          std::max(largest, std::abs(one.Coefficients(axis)[i] - other.Coefficients(axis)[i]));
    }
  }
  return largest;
}

// Surfaces that are one body need no description. What is left is what its degree cannot hold.
TEST(GroupReparametrisation, FindsThatSurfacesWithOtherParametersAreOneBody)
{
  const ReparametrisationResult result = ResultOf(OneBody());
  EXPECT_GT(result.VarianceBefore, 1.0);
  EXPECT_LT(result.VarianceAfter, 0.03 * result.VarianceBefore);
  EXPECT_LT(result.LengthAfter, 0.05 * result.LengthBefore);
}

TEST(GroupReparametrisation, EveryRoundShortensTheDescription)
{
  for (const double noise : {0.05, 0.5, 2.0})
  {
    ReparametrisationSettings settings;
    settings.NoiseMillimeters = noise;
    const ReparametrisationResult result = ResultOf(Family(7), settings);
    ASSERT_GT(result.Lengths.size(), 2U);
    EXPECT_TRUE(std::is_sorted(result.Lengths.rbegin(), result.Lengths.rend()));
    EXPECT_LT(result.LengthAfter, result.LengthBefore);
  }
}

// By meshes, which know nothing of parameters; their facets leave a surface by 0.03 mm.
TEST(GroupReparametrisation, SurfacesStayWithinTheTolerance)
{
  const Surfaces before = Family(6);
  ReparametrisationSettings settings;
  settings.ToleranceMillimeters = 0.05;
  const ReparametrisationResult result = ResultOf(before, settings);
  const IcosahedronDirections sphere(24);
  const auto mesh = [&](const SurfaceModel& surface)
  {
    IndexedMesh made;
    made.Triangles = sphere.Triangles();
    for (const Vector3& u : sphere.Directions())
    {
      made.Points.push_back(surface.Point(u));
    }
    return made;
  };
  int moved = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    moved += result.Cases[i].IsMoved ? 1 : 0;
    EXPECT_LE(result.Cases[i].RmsChange, settings.ToleranceMillimeters);
    EXPECT_GT(result.Cases[i].LeastAreaRatio, 0.1);
    MeshDistances distances;
    ASSERT_TRUE(MeasureMeshDistances(mesh(before[i]), mesh(result.Surfaces[i]), distances).IsOk());
    EXPECT_NEAR(distances.Both.Rms, result.Cases[i].RmsChange, 0.03);
  }
  EXPECT_GT(moved, 3);
}

TEST(GroupReparametrisation, ThreadsHaveNoInfluence)
{
  const Surfaces surfaces = Family(5);
  ReparametrisationSettings settings;
  settings.Threads = 1;
  const ReparametrisationResult one = ResultOf(surfaces, settings);
  settings.Threads = 3;
  const ReparametrisationResult three = ResultOf(surfaces, settings);
  EXPECT_EQ(one.Lengths, three.Lengths);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    EXPECT_EQ(LargestDifference(one.Surfaces[i], three.Surfaces[i]), 0.0);
  }
}

// Sums in another order differ in rounding, which a descent of some ten rounds does not amplify
// much.
TEST(GroupReparametrisation, OrderHasNoInfluence)
{
  Surfaces surfaces = Family(5);
  const ReparametrisationResult one = ResultOf(surfaces);
  std::reverse(surfaces.begin(), surfaces.end());
  const ReparametrisationResult other = ResultOf(surfaces);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    EXPECT_LT(LargestDifference(one.Surfaces[i], other.Surfaces[surfaces.size() - 1 - i]), 1e-6);
  }
}

TEST(GroupReparametrisation, LeavesSurfacesAloneThatNeedNoDescription)
{
  const Surfaces surfaces(4, Body(1.0, 5.0));
  const ReparametrisationResult result = ResultOf(surfaces);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    EXPECT_FALSE(result.Cases[i].IsMoved);
    EXPECT_EQ(LargestDifference(result.Surfaces[i], surfaces[i]), 0.0);
  }
  EXPECT_EQ(result.LengthAfter, result.LengthBefore);
}

TEST(GroupReparametrisation, LeavesAllAloneIfNoChangeIsTolerated)
{
  const Surfaces surfaces = Family(5);
  ReparametrisationSettings settings;
  settings.ToleranceMillimeters = 0.0;
  const ReparametrisationResult result = ResultOf(surfaces, settings);
  EXPECT_EQ(result.LengthAfter, result.LengthBefore);
  EXPECT_EQ(LargestDifference(result.Surfaces[2], surfaces[2]), 0.0);
}

TEST(GroupReparametrisation, RefusesWhatIsNoGroup)
{
  ReparametrisationResult result;
  const SurfaceModel body = Body(1.0, 5.0);
  EXPECT_FALSE(ReparametriseGroup({body, body}, {}, result).IsOk());
  EXPECT_FALSE(ReparametriseGroup({body, body, body.WithDegree(8)}, {}, result).IsOk());
  std::array<std::vector<double>, 3> broken{
      {body.Coefficients(0), body.Coefficients(1), body.Coefficients(2)}};
  broken[1][5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(ReparametriseGroup({body, body, {Degree, broken}}, {}, result).IsOk());
}

TEST(GroupReparametrisation, CancelsWithinARound)
{
  ReparametrisationResult result;
  int calls = 0;
  const Status status = ReparametriseGroup(Family(4), {}, result,
                                           [&](double done)
                                           {
                                             EXPECT_GE(done, 0.0);
                                             EXPECT_LE(done, 1.0);
                                             return ++calls < 3;
                                           });
  EXPECT_FALSE(status.IsOk());
  EXPECT_EQ(calls, 3);
}

// The flow is a polynomial map, so degree 10 does not hold the result; along normals it nearly
// does.
TEST(Reparametrise, KeepsTheSurfaceAndMovesItsParameters)
{
  Random random(23);
  const SurfaceModel body = Body(1.0, 5.0);
  const SphereFlow flow = SmallFlow(random, 0.05);
  const ReparametrisedSurface moved = Reparametrise(body, flow);
  EXPECT_TRUE(moved.IsOneToOne);
  EXPECT_GT(moved.RmsTurn, 0.02);
  EXPECT_LT(moved.RmsChange, 0.02);
  EXPECT_LT(moved.LargestChange, 0.2);
  std::vector<Vector3> directions = test::RandomDirections(random, 50);
  const std::vector<Vector3> before = directions;
  flow.Map(directions);
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    EXPECT_LT((moved.Surface.Point(before[i]) - body.Point(directions[i])).norm(), 0.3);
  }
  EXPECT_LT(LargestDifference(Reparametrise(body, SphereFlow(2)).Surface, body), 1e-3);
}
} // namespace
} // namespace palpate::group_reparametrisation_test
