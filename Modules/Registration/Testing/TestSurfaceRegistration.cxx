#include "SurfaceRegistration.h"

#include "MeshShapes.h"
#include "RandomMaps.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::surface_registration_test
{
namespace
{
// A lump without symmetry, about as large as a gland.
IndexedMesh Lump(int frequency)
{
  IndexedMesh mesh = test::Sphere(frequency);
  for (Vector3& point : mesh.Points)
  {
    const double x = point.x();
    const double y = point.y();
    const double z = point.z();
    point *= 20.0 * (1.0 + 0.2 * x * y - 0.15 * z * z * z + 0.1 * x * x * z + 0.08 * y * y * y);
    point = point.cwiseProduct(Vector3(1.2, 0.9, 1.0));
  }
  return mesh;
}

std::vector<Vector3> Some(const IndexedMesh& mesh, std::size_t count, test::Random& random)
{
  std::vector<Vector3> points = mesh.Points;
  std::shuffle(points.begin(), points.end(), random);
  points.resize(std::min(count, points.size()));
  return points;
}

Eigen::Affine3d Registered(const std::vector<Vector3>& points, const IndexedMesh& mesh,
                           const SurfaceRegistrationSettings& settings = {})
{
  SurfaceRegistration made;
  const Status status =
      RegisterToSurface(points, mesh, Eigen::Affine3d::Identity(), settings, {}, made);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  EXPECT_TRUE(made.HasConverged);
  return made.Map;
}

std::vector<Vector3> Moved(std::vector<Vector3> points, const Eigen::Affine3d& map)
{
  for (Vector3& point : points)
  {
    point = map * point;
  }
  return points;
}

// A body onto itself: within half a millimetre and half a degree of 200 starts.
TEST(SurfaceRegistration, ReturnsFromTenMillimetersAndTenDegrees)
{
  test::Random random(1);
  const IndexedMesh mesh = Lump(20);
  for (int draw = 0; draw < 200; ++draw)
  {
    const Eigen::Affine3d off = test::RandomMove(random, 10.0, M_PI / 18.0);
    const test::MapSize left(Registered(Moved(Some(mesh, 642, random), off), mesh) * off);
    EXPECT_LT(left.Shift, 0.01) << draw; // points lie on the triangles
    EXPECT_LT(left.Turn, 0.001) << draw;
  }
}

TEST(SurfaceRegistration, FindsSizeAndShearWhereItMay)
{
  test::Random random(2);
  const IndexedMesh mesh = Lump(20);
  Eigen::Affine3d off = test::RandomMove(random, 3.0, 0.1);
  off.linear() *= 1.1;
  const std::vector<Vector3> points = Some(mesh, 2000, random);
  const Eigen::Affine3d similar =
      Registered(Moved(points, off), mesh, {RegistrationKind::Similarity, 0.0, 200});
  EXPECT_NEAR((similar * off).linear().determinant(), 1.0, 1e-3);
  off.linear()(0, 2) += 0.05;
  const Eigen::Affine3d affine =
      Registered(Moved(points, off), mesh, {RegistrationKind::Affine, 0.0, 1000});
  EXPECT_NEAR(((affine * off).linear() - Matrix3::Identity()).norm(), 0.0, 0.01);
}

TEST(SurfaceRegistration, OutlyingPointsCountLittle)
{
  test::Random random(3);
  const IndexedMesh mesh = Lump(20);
  std::vector<Vector3> points = Some(mesh, 200, random);
  for (std::size_t i = 0; i < 30; ++i)
  {
    points[i] *= 1.6;
  }
  const Eigen::Affine3d off = test::RandomMove(random, 4.0, 0.1);
  const test::MapSize left(
      Registered(Moved(points, off), mesh, {RegistrationKind::Rigid, 0.2, 200}) * off);
  EXPECT_LT(left.Shift, 0.1);
  EXPECT_LT(left.Turn, 0.01);
}

// Of touched points with noise, from forty on.
TEST(SurfaceRegistration, PredictsItsErrorWithinAThird)
{
  test::Random random(4);
  const IndexedMesh mesh = Lump(20);
  for (const std::size_t count : {std::size_t{40}, std::size_t{100}})
  {
    test::ErrorRatios errors;
    for (int draw = 0; draw < 200; ++draw)
    {
      std::vector<Vector3> points = Some(mesh, count, random);
      for (Vector3& point : points)
      {
        point += test::RandomVector(random, 1.0);
      }
      SurfaceRegistration made;
      ASSERT_TRUE(RegisterToSurface(points, mesh, Eigen::Affine3d::Identity(),
                                    {RegistrationKind::Rigid, 1.0, 200}, {}, made)
                      .IsOk());
      errors.Add(made.Map, made.Error);
    }
    for (const double ratio : {errors.Turn(), errors.Shift()})
    {
      EXPECT_GT(ratio, 1.0 / 1.3) << count;
      EXPECT_LT(ratio, 1.3) << count;
    }
  }
}

// Its turn has no effect.
TEST(SurfaceRegistration, BallReturnsToItsPlace)
{
  test::Random random(5);
  const IndexedMesh ball = test::Sphere(20, 20.0);
  const Eigen::Affine3d off = test::RandomMove(random, 5.0, 0.0);
  const Eigen::Affine3d map = Registered(Moved(ball.Points, off), ball);
  EXPECT_LT((map * off * Vector3::Zero()).norm(), 0.01);
}

TEST(SurfaceRegistration, RefusesWhatIsNoInput)
{
  const IndexedMesh mesh = Lump(4);
  SurfaceRegistration made;
  const auto message = [&](const std::vector<Vector3>& points, const IndexedMesh& fixed)
  { return RegisterToSurface(points, fixed, Eigen::Affine3d::Identity(), {}, {}, made).Message(); };
  std::vector<Vector3> points(mesh.Points.begin(), mesh.Points.begin() + 5);
  EXPECT_EQ(message(points, mesh), "needs at least 6 points, has 5");
  points = mesh.Points;
  points[0].x() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message(points, mesh), "has points that are not finite");
  EXPECT_NE(message(mesh.Points, {}), "");
  const Status cancelled = RegisterToSurface(
      mesh.Points, mesh, Eigen::Affine3d::Identity(), {}, [](double) { return false; }, made);
  EXPECT_FALSE(cancelled.IsOk());
}
} // namespace
} // namespace palpate::surface_registration_test
