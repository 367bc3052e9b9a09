#include "ModelMeasures.h"

#include "RandomShapes.h"
#include "SurfaceCases.h"

#include <gtest/gtest.h>

namespace palpate::parametric_surface_measures_test
{
namespace
{
using test::Random;
using test::SurfaceModelEllipsoid;

BodyMoments MomentsOf(const SurfaceModel& surface)
{
  BodyMoments moments{};
  const Status status = MeasureBody(surface, moments);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return moments;
}

void ExpectSameBody(const BodyMoments& found, const BodyMoments& exact, double relative)
{
  const double size = std::cbrt(exact.Volume);
  EXPECT_NEAR(found.Volume, exact.Volume, relative * exact.Volume);
  EXPECT_LE((found.CentroidWorld - exact.CentroidWorld).norm(),
            relative * (size + exact.CentroidWorld.norm()));
  EXPECT_LE((found.SecondMoments - exact.SecondMoments).norm(),
            relative * exact.SecondMoments.norm());
}

TEST(SurfaceModelMeasures, EllipsoidHasExactMoments)
{
  const Vector3 axes(3.0, 8.0, 5.0);
  const Vector3 center(100.0, -50.0, 30.0);
  const SurfaceModel surface = SurfaceModelEllipsoid(axes).Transformed(Matrix3::Identity(), center);
  const BodyMoments found = MomentsOf(surface);
  const double volume = 4.0 / 3.0 * M_PI * axes.prod();
  BodyMoments exact{};
  exact.Volume = volume;
  exact.CentroidWorld = center;
  exact.SecondMoments = (volume / 5.0 * axes.cwiseAbs2()).asDiagonal();
  ExpectSameBody(found, exact, 1e-13); // some hundred nodes
  EXPECT_LE((found.SemiAxes - Vector3(8.0, 5.0, 3.0)).norm(), 1e-12);
}

TEST(SurfaceModelMeasures, AgreeWithRadialModel)
{
  Random random(1401);
  for (const int degree : {1, 5, 12})
  {
    const RadialModel model = test::RandomOrgan(random, degree);
    const SurfaceModel surface = SurfaceModel::FromModel(model);
    BodyMoments exact{};
    ASSERT_TRUE(MeasureBody(model, exact).IsOk());
    ExpectSameBody(MomentsOf(surface), exact, 1e-12); // thousands of nodes, |x| / size = 10
    EXPECT_NEAR(AreaOf(surface), AreaOf(model), 1e-8 * AreaOf(model)); // two tolerances of 1e-9
  }
}

TEST(SurfaceModelMeasures, AreaOfEllipsoidConverges)
{
  // Prolate spheroid, semi-axes a = 3, c = 5: 2 pi a^2 (1 + c / (a e) asin e), e^2 = 1 - a^2 / c^2.
  const double exact = 2.0 * M_PI * 9.0 * (1.0 + 5.0 / (3.0 * 0.8) * std::asin(0.8));
  EXPECT_NEAR(AreaOf(SurfaceModelEllipsoid({3.0, 3.0, 5.0})), exact, 1e-9 * exact);
}

TEST(SurfaceModelMeasures, FollowRotationScaleAndMirror)
{
  Random random(1402);
  const SurfaceModel surface = test::RandomSurface(random, 8);
  const BodyMoments before = MomentsOf(surface);
  Matrix3 linear = 1.5 * Eigen::AngleAxisd(2.0, test::RandomDirection(random)).toRotationMatrix();
  linear.col(1) *= -1.0;
  const Vector3 offset(7.0, 8.0, -9.0);
  BodyMoments exact{};
  exact.Volume = 1.5 * 1.5 * 1.5 * before.Volume;
  exact.CentroidWorld = linear * before.CentroidWorld + offset;
  exact.SecondMoments = 1.5 * 1.5 * 1.5 * linear * before.SecondMoments * linear.transpose();
  ExpectSameBody(MomentsOf(surface.Transformed(linear, offset)), exact, 1e-12);
}

TEST(SurfaceModelMeasures, DoNotDependOnParametrisation)
{
  Random random(1403);
  const SurfaceModel surface = test::RandomSurface(random, 8);
  const BodyMoments exact = MomentsOf(surface);
  Matrix3 turned = Eigen::AngleAxisd(1.0, test::RandomDirection(random)).toRotationMatrix();
  ExpectSameBody(MomentsOf(surface.Reparametrized(turned)), exact, 1e-12);
  turned.row(2) *= -1.0; // inside out
  ExpectSameBody(MomentsOf(surface.Reparametrized(turned)), exact, 1e-12);
  EXPECT_NEAR(AreaOf(surface.Reparametrized(turned)), AreaOf(surface), 1e-7 * AreaOf(surface));
}

TEST(SurfaceModelMeasures, RejectsSurfaceWithoutVolume)
{
  BodyMoments moments{};
  EXPECT_FALSE(MeasureBody(SurfaceModelEllipsoid({3.0, 5.0, 0.0}), moments).IsOk());
  EXPECT_FALSE(MeasureBody(SurfaceModelEllipsoid({0.0, 0.0, 0.0}), moments).IsOk());
  EXPECT_FALSE(MeasureBody(SurfaceModelEllipsoid({3.0, std::nan(""), 1.0}), moments).IsOk());
  EXPECT_FALSE(MeasureBody(SurfaceModelEllipsoid({1e200, 1e200, 1e200}), moments).IsOk());
}
} // namespace
} // namespace palpate::parametric_surface_measures_test
