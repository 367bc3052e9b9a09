#include "FieldCases.h"
#include "FieldSampler.h"
#include "ProceduralFields.h"
#include "RayCaster.h"

#include <cmath>
#include <limits>

namespace palpate::ray_caster_test
{
namespace
{
using test::MakeField;
using test::PlainGrid;

const double Infinity = std::numeric_limits<double>::infinity();
const double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr FieldInterpolation Methods[] = {FieldInterpolation::Trilinear,
                                          FieldInterpolation::TricubicBSpline};

double After(double t)
{
  return std::nextafter(t, Infinity);
}

// All boundaries on a ray, in order.
std::vector<FieldHit> AllHits(const RayCaster& caster, const FieldRay& ray)
{
  std::vector<FieldHit> hits;
  FieldHit hit = caster.CastIndex(ray, -Infinity, Infinity);
  while (hit.Kind != HitKind::Missed && hits.size() < 1000)
  {
    hits.push_back(hit);
    hit = caster.CastIndex(ray, After(hit.T), Infinity);
  }
  return hits;
}

// A wall of one voxel at i = 10: 1 there, 0 elsewhere.
std::shared_ptr<const ScalarField> MakeWall(double iso)
{
  const FieldGrid grid = PlainGrid({21, 9, 9});
  std::vector<std::uint8_t> samples(grid.NodeCount(), 0);
  for (std::size_t at = 10; at < samples.size(); at += 21)
  {
    samples[at] = 1;
  }
  return MakeField(grid, samples, iso);
}

TEST(RayCaster, EntersAndLeavesAOneVoxelWall)
{
  const double thin = 1e-9;
  for (const double iso : {0.5, 0.999, 1.0 - thin})
  {
    const RayCaster caster(MakeWall(iso));
    for (const Vector3& direction :
         {Vector3(1, 0, 0), Vector3(-1, 0, 0), Vector3(1, 0.3, 0.1), Vector3(2, -0.25, 0.4)})
    {
      const FieldRay ray{Vector3(10, 4.3, 4) - 10 * direction, direction};
      const std::vector<FieldHit> hits = AllHits(caster, ray);
      ASSERT_EQ(hits.size(), 2u) << iso;
      const double half = (1.0 - iso) / std::abs(direction[0]);
      EXPECT_TRUE(hits[0].IsEntering);
      EXPECT_FALSE(hits[1].IsEntering);
      // Roundings of coordinates of up to 20 voxels.
      EXPECT_NEAR(hits[0].T, 10.0 - half, 1e-13);
      EXPECT_NEAR(hits[1].T, 10.0 + half, 1e-13);
      EXPECT_NEAR(hits[0].Gradient[0], direction[0] > 0 ? 1.0 : -1.0, 1e-15);
    }
  }
}

TEST(RayCaster, FindsAWallAsThinAsTheIsoValue)
{
  const RayCaster caster(MakeWall(1.0));
  const FieldHit hit = caster.CastIndex({{0, 4, 4}, {1, 0, 0}}, 0.0, Infinity);
  EXPECT_EQ(hit.Kind, HitKind::Surface);
  EXPECT_TRUE(hit.IsEntering);
  EXPECT_EQ(hit.T, 10.0);
}

TEST(RayCaster, ReportsTheBorderWhereAMaterialReachesIt)
{
  const FieldGrid grid({11, 11, 11}, Vector3::Zero(), {2, 2, 2}, Matrix3::Identity());
  const auto samples = test::SampleAtIndices(grid.Size(), test::PlaneField{{1, 0, 0}, 0.0});
  const RayCaster caster(MakeField(grid, samples, 4.25));
  const FieldHit in = caster.CastWorld({{30, 5, 5}, {-1, 0, 0}}, 0.0, Infinity);
  EXPECT_EQ(in.Kind, HitKind::Border);
  EXPECT_TRUE(in.IsEntering);
  EXPECT_EQ(in.StartsInside, 0u);
  EXPECT_EQ(in.T, 10.0);
  EXPECT_EQ(in.Gradient, Vector3(-0.5, 0, 0)); // 1 per voxel, into the grid
  const FieldHit out = caster.CastWorld({{30, 5, 5}, {-1, 0, 0}}, After(in.T), Infinity);
  EXPECT_EQ(out.Kind, HitKind::Surface);
  EXPECT_FALSE(out.IsEntering);
  EXPECT_EQ(out.StartsInside, 1u);
  EXPECT_NEAR(out.T, 30.0 - 8.5, 1e-13); // roundings of 30 mm
  const FieldHit beyond = caster.CastWorld({{5, 5, 5}, {1, 0, 0}}, 4.0, Infinity);
  EXPECT_EQ(beyond.Kind, HitKind::Border);
  EXPECT_FALSE(beyond.IsEntering);
  EXPECT_EQ(beyond.T, 15.0);
  EXPECT_EQ(beyond.Gradient, Vector3(-0.5, 0, 0));
  const FieldHit top = caster.CastWorld({{15, 5, 5}, {0, 0, 3}}, 0.0, Infinity);
  EXPECT_EQ(top.Kind, HitKind::Border);
  EXPECT_EQ(top.T, 5.0);
  EXPECT_EQ(caster.CastWorld({{15, 5, 5}, {0, 0, 3}}, 0.0, 4.9).Kind, HitKind::Missed);
}

TEST(RayCaster, ReportsInvalidRays)
{
  const RayCaster caster(MakeWall(0.5));
  const FieldRay ray{{0, 4, 4}, {1, 0, 0}};
  EXPECT_EQ(caster.CastIndex({{0, 4, 4}, Vector3::Zero()}, 0, 1).Kind, HitKind::BadRay);
  EXPECT_EQ(caster.CastIndex({{0, NaN, 4}, {1, 0, 0}}, 0, 1).Kind, HitKind::BadRay);
  EXPECT_EQ(caster.CastIndex({{0, 4, 4}, {1, 0, NaN}}, 0, 1).Kind, HitKind::BadRay);
  EXPECT_EQ(caster.CastIndex({{0, 4, Infinity}, {1, 0, 0}}, 0, 1).Kind, HitKind::BadRay);
  EXPECT_EQ(caster.CastIndex({{0, 4, 4}, {Infinity, 0, 0}}, 0, 1).Kind, HitKind::BadRay);
  EXPECT_EQ(caster.CastIndex(ray, NaN, 1).Kind, HitKind::BadRay);
  EXPECT_EQ(caster.CastIndex(ray, 0, NaN).Kind, HitKind::BadRay);
  EXPECT_EQ(caster.CastIndex(ray, 20, 0).Kind, HitKind::Missed);
  EXPECT_EQ(caster.CastIndex(ray, 0, 9).Kind, HitKind::Missed);
  EXPECT_EQ(caster.CastIndex(ray, 0, 9.5).Kind, HitKind::Surface);
  EXPECT_EQ(caster.CastIndex(ray, -Infinity, Infinity).T, 9.5);
  EXPECT_EQ(caster.CastIndex({{1e300, 4, 4}, {1, 0, 0}}, -Infinity, Infinity).Kind,
            HitKind::Missed);
  EXPECT_EQ(caster.CastIndex({{0, 4, 4}, {1, 1e-320, -0.0}}, 0, Infinity).T, 9.5);
  // So slow that crossing a voxel takes more than any finite t: any result but BadRay is accepted.
  EXPECT_NE(caster.CastIndex({{0, 4, 4}, {1e-308, 0, 0}}, 0, Infinity).Kind, HitKind::BadRay);
  EXPECT_NE(caster.CastIndex({{0.5, 4, 4}, {0, -1e-308, 1e-308}}, -Infinity, Infinity).Kind,
            HitKind::BadRay);
  EXPECT_EQ(caster.CastIndex({{0, 8.5, 4}, {1, 0, 0}}, 0, Infinity).Kind, HitKind::Missed);
  EXPECT_EQ(caster.CastIndex({{0, 8, 8}, {1, 0, 0}}, 0, Infinity).T, 9.5); // on the grid's edge
  EXPECT_EQ(caster.CastIndex({{20, 0, 0}, {-1, 0, 0}}, 0, Infinity).T, 9.5);
}

TEST(RayCaster, FindsTheExitWhenStartingInside)
{
  const FieldGrid grid = PlainGrid({41, 41, 41});
  const test::QuadraticSphereField sphere{{20, 20, 20}, 12.0};
  for (const FieldInterpolation method : Methods)
  {
    const RayCaster caster(
        MakeField(grid, test::SampleAtIndices(grid.Size(), sphere), 0.0, method));
    std::mt19937_64 random(21);
    std::normal_distribution<double> normal;
    for (int round = 0; round < 200; ++round)
    {
      const Vector3 u = Vector3(normal(random), normal(random), normal(random)).normalized();
      const FieldHit hit = caster.CastIndex({sphere.Center, u}, 0.0, Infinity);
      ASSERT_EQ(hit.Kind, HitKind::Surface);
      ASSERT_EQ(hit.StartsInside, 1u);
      ASSERT_FALSE(hit.IsEntering);
      // Trilinear: the field lies below its chords by at most 3/4, at a slope of 24.
      ASSERT_NEAR(hit.T, 12.0, method == FieldInterpolation::Trilinear ? 0.75 / 24 : 1e-3);
    }
  }
}

TEST(RayCaster, FindsBothCrossingsOfRaysThatNearlyGraze)
{
  const FieldGrid grid = PlainGrid({33, 33, 33});
  // Constant along k and bilinear in i, j: a hyperbola (i - 16)(j - 16) = c, tangent to diagonals.
  std::vector<double> samples;
  for (int k = 0; k < 33; ++k)
  {
    for (int j = 0; j < 33; ++j)
    {
      for (int i = 0; i < 33; ++i)
      {
        samples.push_back((i - 16.0) * (j - 16.0));
      }
    }
  }
  const RayCaster caster(MakeField(grid, samples, 6.25)); // touches i + j - 32 = 5 at (18.5, 18.5)
  for (const double depth : {1e-2, 1e-4, 1e-6})
  {
    // Along i + j - 32 = 5 + depth, with both crossings at +- sqrt(s^2 / 4 - 6.25).
    const double sum = 5.0 + depth;
    const FieldRay ray{{16 + sum / 2 - 10, 16 + sum / 2 + 10, 16.2}, {1, -1, 0}};
    const double half = std::sqrt(0.25 * sum * sum - 6.25);
    const FieldHit in = caster.CastIndex(ray, 0.0, Infinity);
    ASSERT_EQ(in.Kind, HitKind::Surface) << depth;
    const FieldHit out = caster.CastIndex(ray, After(in.T), Infinity);
    ASSERT_EQ(out.Kind, HitKind::Surface) << depth;
    // Roundings of coordinates of up to 30 voxels, those of the ray's own origin among them, change
    // the value by up to 2e-13; along the ray it changes by 2 half per voxel.
    EXPECT_NEAR(in.T, 10.0 - half, 1e-13 / half);
    EXPECT_NEAR(out.T, 10.0 + half, 1e-13 / half);
  }
  const FieldRay nearby{{16 + 2.5 - 1e-6 - 10, 16 + 2.5 - 1e-6 + 10, 16.2}, {1, -1, 0}};
  EXPECT_EQ(caster.CastIndex(nearby, 8.0, 12.0).Kind, HitKind::Missed);
}

TEST(RayCaster, HitsRepresentableFieldsToRounding)
{
  const FieldGrid grid = PlainGrid({30, 30, 30});
  std::mt19937_64 random(22);
  std::uniform_real_distribution<double> place(0.0, 29.0);
  const test::SaddleField saddle{{14.3, 15.1, 13.7}};
  const RayCaster caster(MakeField(grid, test::SampleAtIndices(grid.Size(), saddle), 20.0));
  int hits = 0;
  for (int round = 0; round < 1000; ++round)
  {
    const Vector3 from(place(random), place(random), place(random));
    const Vector3 to(place(random), place(random), place(random));
    const Vector3 direction = (to - from).normalized();
    const FieldHit hit = caster.CastIndex({from, direction}, 0.0, (to - from).norm());
    if (hit.Kind == HitKind::Surface)
    {
      ++hits;
      const Vector3 gradient = saddle.Gradient(hit.Position);
      const double distance = (saddle.Value(hit.Position) - 20.0) / gradient.norm();
      ASSERT_LE(std::abs(distance), 1e-10); // 1e-3 is required
      ASSERT_LE(hit.Gradient.normalized().cross(gradient.normalized()).norm(), 1e-10);
      ASSERT_EQ(saddle.Value(from) < 20.0, hit.IsEntering);
    }
  }
  EXPECT_GE(hits, 400);
}

TEST(RayCaster, WorldRaysHitAPlaneInObliqueGrids)
{
  std::mt19937_64 random(24);
  std::normal_distribution<double> normal;
  for (const FieldInterpolation method : Methods)
  {
    const FieldGrid grid = test::ObliqueGrid({31, 40, 25}, random);
    const Vector3 middle = grid.PointWorld({15.0, 19.5, 12.0});
    const Vector3 inwards = Vector3(normal(random), normal(random), normal(random)).normalized();
    const test::PlaneField plane{inwards, inwards.dot(middle)};
    std::vector<double> samples;
    for (std::size_t n = 0; n < grid.NodeCount(); ++n)
    {
      samples.push_back(plane.Value(grid.PointWorld(test::NodeIndex(grid.Size(), n))));
    }
    const RayCaster caster(MakeField(grid, samples, 0.0, method));
    for (int round = 0; round < 300; ++round)
    {
      // Into the centre, where the B-spline is not affected by its mirrored border.
      const Vector3 u = Vector3(normal(random), normal(random), normal(random)).normalized();
      if (std::abs(u.dot(inwards)) < 0.2)
      {
        continue;
      }
      const Vector3 aim = middle + inwards.unitOrthogonal() * normal(random) * 0.3;
      const double speed = std::exp(normal(random));
      const FieldHit hit = caster.CastWorld({aim - u, speed * u}, 0.0, 2.0 / speed);
      ASSERT_EQ(hit.Kind, HitKind::Surface);
      ASSERT_EQ(hit.IsEntering, u.dot(inwards) > 0.0);
      // Some ten roundings of coordinates of up to 100 mm, over a cosine of at least 0.2. B-spline:
      // coefficients are floats of numbers up to 40; its border is 12 voxels away.
      const double allowed = method == FieldInterpolation::Trilinear ? 1e-11 : 1e-4;
      ASSERT_NEAR(hit.T * speed, 1.0, allowed);
      ASSERT_LE((hit.Position - aim).norm(), 1e-4);
      ASSERT_LE((hit.Gradient - inwards).norm(),
                method == FieldInterpolation::Trilinear ? 1e-12 : 1e-4);
    }
  }
}

// Largest distance of hits from a sphere, and largest angle of their normals, both from all sides.
struct HitErrors
{
  double Distance = 0.0;
  double Angle = 0.0;
};

HitErrors ErrorsOfHits(int nodes, FieldInterpolation method)
{
  const double unit = (nodes - 1) / 10.0;
  const FieldGrid grid({nodes, nodes, nodes}, Vector3::Constant(-5.0),
                       Vector3::Constant(1.0 / unit), Matrix3::Identity());
  const test::SphereField sphere{{0.03, -0.02, 0.01}, 3.3};
  std::vector<double> samples;
  samples.reserve(grid.NodeCount());
  for (int k = 0; k < nodes; ++k)
  {
    for (int j = 0; j < nodes; ++j)
    {
      for (int i = 0; i < nodes; ++i)
      {
        // Smooth in the centre, where the distance is not, and flat where the B-spline's border is.
        const double distance = -sphere.Value(grid.PointWorld({1.0 * i, 1.0 * j, 1.0 * k}));
        samples.push_back(-distance * (2 * sphere.Radius + distance));
      }
    }
  }
  for (double& sample : samples)
  {
    sample = std::tanh(sample / 10.0);
  }
  const RayCaster caster(MakeField(grid, samples, 0.0, method));
  std::mt19937_64 random(23);
  std::normal_distribution<double> normal;
  HitErrors errors;
  for (int round = 0; round < 3000; ++round)
  {
    const Vector3 u = Vector3(normal(random), normal(random), normal(random)).normalized();
    const FieldHit hit = caster.CastWorld({sphere.Center + 8.0 * u, -u}, 0.0, Infinity);
    EXPECT_EQ(hit.Kind, HitKind::Surface);
    errors.Distance = std::max(errors.Distance, std::abs(sphere.Value(hit.Position)));
    errors.Angle =
        std::max(errors.Angle, std::atan2(hit.Gradient.cross(-u).norm(), hit.Gradient.dot(-u)));
  }
  return errors;
}

// The slope of log error over log size, by least squares.
double FittedOrder(const std::vector<double>& errors)
{
  const double middle = (static_cast<double>(errors.size()) - 1.0) / 2.0;
  double product = 0.0;
  double square = 0.0;
  for (std::size_t n = 0; n < errors.size(); ++n)
  {
    const double x = static_cast<double>(n) - middle;
    product -= x * std::log2(errors[n]);
    square += x * x;
  }
  return product / square;
}

void ExpectOrders(FieldInterpolation method, double distanceOrder, double angleOrder)
{
  std::vector<double> distances;
  std::vector<double> angles;
  for (const int nodes : {21, 41, 81})
  {
    const HitErrors errors = ErrorsOfHits(nodes, method);
    distances.push_back(errors.Distance);
    angles.push_back(errors.Angle);
  }
  EXPECT_NEAR(FittedOrder(distances), distanceOrder, 0.1 * distanceOrder);
  EXPECT_NEAR(FittedOrder(angles), angleOrder, 0.15 * angleOrder);
  ::testing::Test::RecordProperty("distance", std::to_string(FittedOrder(distances)));
  ::testing::Test::RecordProperty("angle", std::to_string(FittedOrder(angles)));
}

TEST(RayCaster, TrilinearHitsConvergeWithOrderTwoAndNormalsWithOne)
{
  ExpectOrders(FieldInterpolation::Trilinear, 2.0, 1.0);
}

TEST(RayCaster, TricubicHitsConvergeWithOrderFourAndNormalsWithThree)
{
  ExpectOrders(FieldInterpolation::TricubicBSpline, 4.0, 3.0);
}
} // namespace
} // namespace palpate::ray_caster_test
