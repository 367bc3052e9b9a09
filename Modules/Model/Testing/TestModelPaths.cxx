#include "ModelPaths.h"

#include "ComparedCases.h"
#include "RandomShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace palpate::model_paths_test
{
namespace
{
using namespace palpate::test;

std::unique_ptr<const ModelPaths> PathsOf(const OrganModel& model)
{
  std::unique_ptr<const ModelPaths> paths;
  const Status status = ModelPaths::Make(model, paths);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return paths;
}

GeodesicCurve Between(const ModelPaths& paths, const Vector3& from, const Vector3& to)
{
  GeodesicCurve curve;
  const Status status = paths.Find(from, to, {}, curve);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return curve;
}

// The arc of an ellipse with these semi-axes, by angles from the second one: Simpson's rule.
double ArcLength(double along, double across, double first, double last)
{
  constexpr int Parts = 2000;
  const auto speed = [&](double angle)
  { return std::hypot(along * std::cos(angle), across * std::sin(angle)); };
  double sum = 0.0;
  for (int i = 0; i < Parts; ++i)
  {
    const double a = first + (last - first) * i / Parts;
    const double b = first + (last - first) * (i + 1) / Parts;
    sum += (b - a) / 6.0 * (speed(a) + 4.0 * speed(0.5 * (a + b)) + speed(b));
  }
  return sum;
}

RadialModel Lump()
{
  return {3,
          {70.0, 3.0, -2.0, 4.0, 5.0, -3.0, 6.0, 2.0, -4.0, 1.0, 3.0, -2.0, 2.0, 1.0, -3.0, 2.0},
          {5.0, -3.0, 40.0}};
}

TEST(ModelPaths, AreGreatCirclesOfASphere)
{
  const Vector3 center(3.0, 40.0, -8.0);
  const auto paths = PathsOf(SphereModel(20.0, center));
  Random random(1);
  for (int n = 0; n < 3; ++n)
  {
    const Vector3 u = RandomDirection(random);
    const Vector3 v = RandomDirection(random);
    const double exact = 20.0 * std::atan2(u.cross(v).norm(), u.dot(v));
    // From points off the surface, whose nearest ones count.
    const GeodesicCurve curve = Between(*paths, center + 23.0 * u, center + 18.0 * v);
    EXPECT_NEAR(curve.Length, exact, 1e-6 * exact);
    EXPECT_LT((curve.Points.front() - center - 20.0 * u).norm(), 1e-6);
    EXPECT_TRUE(curve.HasConverged);
    EXPECT_LE(curve.Points.size(), 97u) << "extrapolation saves chords";
  }
}

TEST(ModelPaths, AreArcsOverTheFlatFaceOfAnEllipsoid)
{
  const auto paths = PathsOf(EllipsoidModel({40.0, 20.0, 10.0}));
  const auto at = [](double angle)
  { return Vector3(40.0 * std::sin(angle), 0.0, 10.0 * std::cos(angle)); };
  for (const auto& [first, last] : {std::pair{-1.2, 1.1}, {-0.4, 0.9}, {0.2, 0.5}})
  {
    const double exact = ArcLength(40.0, 10.0, first, last);
    EXPECT_NEAR(Between(*paths, at(first), at(last)).Length, exact, 1e-6 * exact);
  }
}

TEST(ModelPaths, HaveNoCurvatureWithinTheSurface)
{
  const RadialModel model = Lump();
  const auto paths = PathsOf(model);
  Random random(5);
  const GeodesicCurve curve = Between(*paths, model.PointWorld(RandomDirection(random)),
                                      model.PointWorld(RandomDirection(random)));
  const double chord = (curve.Points[1] - curve.Points[0]).norm();
  for (std::size_t k = 1; k + 1 < curve.Points.size(); ++k)
  {
    const Vector3 direction = (curve.Points[k] - model.CenterWorld()).normalized();
    const Vector3 normal = model.Normal(direction);
    const Vector3 bend = curve.Points[k + 1] - 2.0 * curve.Points[k] + curve.Points[k - 1];
    EXPECT_LT((bend - bend.dot(normal) * normal).norm(), 1e-7 * chord);
    EXPECT_NEAR((curve.Points[k + 1] - curve.Points[k]).norm(), chord, 1e-3 * chord); // of arcs
  }
}

TEST(ModelPaths, AreTheSameBackwardsAndForBothKindsOfModel)
{
  const RadialModel model = Lump();
  const auto paths = PathsOf(model);
  const auto others = PathsOf(SurfaceModel::FromModel(model));
  Random random(9);
  for (int n = 0; n < 1; ++n)
  {
    const Vector3 from = model.PointWorld(RandomDirection(random));
    const Vector3 to = model.PointWorld(RandomDirection(random));
    const double length = Between(*paths, from, to).Length;
    EXPECT_NEAR(Between(*paths, to, from).Length, length, 1e-5 * length);
    EXPECT_NEAR(Between(*others, from, to).Length, length, 1e-5 * length);
  }
}

TEST(ModelPaths, VanishBetweenEqualPoints)
{
  const auto paths = PathsOf(SphereModel(20.0));
  EXPECT_LT(Between(*paths, {20.0, 0.0, 0.0}, {20.0, 0.0, 0.0}).Length, 1e-9);
}

TEST(ModelPaths, MapsTheLengthsToAllPoints)
{
  const auto paths = PathsOf(EllipsoidModel({40.0, 20.0, 10.0}));
  const Vector3 from(0.0, 0.0, 10.0);
  std::vector<double> distances;
  ASSERT_TRUE(paths->Distances(from, {}, distances).IsOk());
  ASSERT_EQ(distances.size(), paths->Drawing().Points.size());
  for (std::size_t i = 0; i < distances.size(); i += distances.size() / 2)
  {
    const double length = Between(*paths, from, paths->Drawing().Points[i]).Length;
    EXPECT_NEAR(distances[i], length, 2e-3 * length + 1e-3); // h / R is 0.2 at the tips
  }
}

TEST(ModelPaths, RefusesWhatEnclosesNothing)
{
  std::unique_ptr<const ModelPaths> paths;
  EXPECT_FALSE(ModelPaths::Make(SphereModel(0.0), paths).IsOk());
}
} // namespace
} // namespace palpate::model_paths_test
