#include "ModelMeasures.h"

#include "IcosahedronDirections.h"
#include "ProjectedShapes.h"
#include "RandomShapes.h"
#include "SphereQuadrature.h"
#include "SphericalHarmonicBasis.h"
#include "TurnedModel.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace palpate::spherical_harmonic_measures_test
{
namespace
{
using test::Random;

const Vector3 Center(10.0, -20.0, 30.0);

RadialModel Ellipsoid(const Vector3& axes, int degree)
{
  const RadialModel centered = test::Ellipsoid(axes, Matrix3::Identity(), degree);
  return {degree, centered.Coefficients(), Center};
}

// A sphere seen from a point inside it.
RadialModel ShiftedSphere(double radius, const Vector3& shift, int degree)
{
  const RadialModel centered = test::OffCenterSphere(radius, shift, degree);
  return {degree, centered.Coefficients(), Center};
}

BodyMoments Measure(const RadialModel& model)
{
  BodyMoments moments;
  const Status status = MeasureBody(model, moments);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return moments;
}

double LargestRelative(const Eigen::Matrix3d& matrix, const Eigen::Matrix3d& expected)
{
  return (matrix - expected).norm() / expected.norm();
}

// The divergence theorem on a mesh: exact moments of its tetrahedra with the centre.
BodyMoments OfMesh(const RadialModel& model, int frequency)
{
  const IcosahedronDirections directions(frequency);
  std::vector<Vector3> points;
  for (const Vector3& u : directions.Directions())
  {
    points.push_back(model.Radius(u) * u);
  }
  double volume = 0.0;
  Vector3 first = Vector3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const auto& face : directions.Triangles())
  {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k)
    {
      corners.col(k) = points[static_cast<std::size_t>(face[static_cast<std::size_t>(k)])];
    }
    const double part = corners.determinant() / 6.0;
    const Vector3 sum = corners.rowwise().sum();
    volume += part;
    first += part * sum / 4.0;
    second += part / 20.0 * (corners * corners.transpose() + sum * sum.transpose());
  }
  BodyMoments moments{};
  moments.Volume = volume;
  moments.CentroidWorld = model.CenterWorld() + first / volume;
  moments.SecondMoments = second - first * first.transpose() / volume;
  return moments;
}

TEST(RadialModelMeasures, SphereMatchesClosedForms)
{
  const double r = 7.0;
  const RadialModel sphere(0, {r * std::sqrt(4 * M_PI)}, Center);
  const BodyMoments moments = Measure(sphere);
  // Relative: some roundings.
  EXPECT_NEAR(VolumeOf(sphere) / (4 * M_PI / 3 * r * r * r), 1.0, 1e-14);
  EXPECT_NEAR(AreaOf(sphere) / (4 * M_PI * r * r), 1.0, 1e-14);
  EXPECT_NEAR(moments.Volume / VolumeOf(sphere), 1.0, 1e-14);
  EXPECT_LE((moments.CentroidWorld - Center).norm(), 1e-14 * Center.norm());
  const double second = 4 * M_PI / 15 * std::pow(r, 5);
  EXPECT_LE(LargestRelative(moments.SecondMoments, second * Eigen::Matrix3d::Identity()), 1e-14);
  EXPECT_LE((moments.SemiAxes - Vector3::Constant(r)).norm(), 1e-13);
}

TEST(RadialModelMeasures, LinearRadiusMatchesClosedForms)
{
  // R = r + a.u: integrals of (a.u)^2 and u u^T (a.u)^2 by hand.
  Random random(441);
  const double r = 20.0;
  const Vector3 a(3.0, -1.0, 2.0);
  const double scale = std::sqrt(4 * M_PI / 3);
  const RadialModel model(1, {r * std::sqrt(4 * M_PI), a.y() * scale, a.z() * scale, a.x() * scale},
                          Center);
  const double a2 = a.squaredNorm();
  const double volume = 4 * M_PI / 3 * r * (r * r + a2);
  const Vector3 first = 4 * M_PI * r * (r * r / 3 + a2 / 5) * a;
  const BodyMoments moments = Measure(model);
  EXPECT_NEAR(VolumeOf(model) / volume, 1.0, 1e-14); // rounding
  EXPECT_NEAR(moments.Volume / volume, 1.0, 1e-14);
  EXPECT_LE((moments.CentroidWorld - Center - first / volume).norm(), 1e-13);
}

TEST(RadialModelMeasures, EllipsoidConvergesToClosedForms)
{
  const Vector3 axes(28.0, 24.0, 20.0);
  const double volume = 4 * M_PI / 3 * axes.prod();
  double volumeError = 1.0;
  double momentError = 1.0;
  for (const int degree : {2, 4, 6, 8})
  {
    const BodyMoments moments = Measure(Ellipsoid(axes, degree));
    const double error = std::abs(moments.Volume / volume - 1.0);
    const double axesError = (moments.SemiAxes - axes).norm() / axes.norm();
    // Not band-limited: coefficients fall geometrically, and integrals of their products faster.
    EXPECT_LT(error, 0.3 * volumeError) << degree;
    EXPECT_LT(axesError, 0.3 * momentError) << degree;
    volumeError = error;
    momentError = axesError;
  }
  const BodyMoments moments = Measure(Ellipsoid(axes, 48));
  // Terms above degree 48 are below the rounding of 2,401 coefficients.
  EXPECT_NEAR(moments.Volume / volume, 1.0, 1e-12);
  EXPECT_LE((moments.CentroidWorld - Center).norm(), 1e-12);
  EXPECT_LE((moments.SemiAxes - axes).norm(), 1e-11);
  const Eigen::Matrix3d second = volume / 5 * axes.cwiseAbs2().asDiagonal().toDenseMatrix();
  EXPECT_LE(LargestRelative(moments.SecondMoments, second), 1e-12);
  EXPECT_LE((moments.PrincipalAxes - Eigen::Matrix3d::Identity()).norm(), 1e-10);
}

TEST(RadialModelMeasures, ProlateSpheroidMatchesClosedForm)
{
  const double a = 20.0;
  const double c = 26.0;
  const double e = std::sqrt(1.0 - a * a / (c * c));
  const double exact = 2.0 * M_PI * a * a * (1.0 + c / (a * e) * std::asin(e));
  EXPECT_NEAR(AreaOf(Ellipsoid({a, a, c}, 48)) / exact, 1.0, 1e-12); // the series, as above
}

TEST(RadialModelMeasures, ShiftedSphereConvergesToClosedForms)
{
  const double r = 15.0;
  const Vector3 shift(6.0, 8.0, -3.0);
  double error = 1.0;
  for (const int degree : {2, 4, 6, 8})
  {
    const BodyMoments moments = Measure(ShiftedSphere(r, shift, degree));
    const double now = (moments.CentroidWorld - Center - shift).norm() / r;
    EXPECT_LT(now, 0.3 * error) << degree;
    error = now;
  }
  const RadialModel sphere = ShiftedSphere(r, shift, 40);
  const BodyMoments moments = Measure(sphere);
  // As for the ellipsoid; the series falls by 2.5 per degree.
  EXPECT_NEAR(moments.Volume / (4 * M_PI / 3 * r * r * r), 1.0, 1e-12);
  EXPECT_LE((moments.CentroidWorld - Center - shift).norm(), 1e-12 * r);
  const double second = 4 * M_PI / 15 * std::pow(r, 5);
  EXPECT_LE(LargestRelative(moments.SecondMoments, second * Eigen::Matrix3d::Identity()), 1e-12);
  EXPECT_NEAR(AreaOf(sphere) / (4 * M_PI * r * r), 1.0, 1e-12);
}

TEST(RadialModelMeasures, MatchLimitOfMesh)
{
  Random random(442);
  const RadialModel model = test::RandomOrgan(random, 6);
  const BodyMoments moments = Measure(model);
  const BodyMoments coarse = OfMesh(model, 20);
  const BodyMoments fine = OfMesh(model, 40);
  // The error of inscribed facets is a series in f^-2: one extrapolation leaves f^-4.
  const auto limit = [](const auto& once, const auto& twice)
  { return ((4.0 * twice - once) / 3.0).eval(); };
  EXPECT_NEAR(moments.Volume / ((4.0 * fine.Volume - coarse.Volume) / 3.0), 1.0, 1e-5);
  EXPECT_LE((moments.CentroidWorld - limit(coarse.CentroidWorld, fine.CentroidWorld)).norm(), 1e-4);
  EXPECT_LE(LargestRelative(moments.SecondMoments, limit(coarse.SecondMoments, fine.SecondMoments)),
            2e-5);
}

TEST(RadialModelMeasures, MomentsMatchFinerQuadrature)
{
  Random random(443);
  for (const int degree : {1, 5, 12, 20})
  {
    const RadialModel model = test::RandomOrgan(random, degree);
    const SphereQuadrature sphere(5 * degree + 60);
    double volume = 0.0;
    Vector3 first = Vector3::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
    {
      const Vector3& u = sphere.Directions[i];
      const double r = model.Radius(u);
      volume += sphere.Weights[i] * std::pow(r, 3) / 3;
      first += sphere.Weights[i] * std::pow(r, 4) / 4 * u;
      second += sphere.Weights[i] * std::pow(r, 5) / 5 * u * u.transpose();
    }
    const BodyMoments moments = Measure(model);
    // The integrands are polynomials: only thousands of roundings differ.
    EXPECT_NEAR(moments.Volume / volume, 1.0, 1e-13);
    EXPECT_NEAR(VolumeOf(model) / volume, 1.0, 1e-13);
    const Vector3 centroid = first / volume;
    EXPECT_LE((moments.CentroidWorld - model.CenterWorld() - centroid).norm(), 1e-12);
    second -= volume * centroid * centroid.transpose();
    EXPECT_LE(LargestRelative(moments.SecondMoments, second), 1e-13);
  }
}

TEST(RadialModelMeasures, RotateWithBody)
{
  Random random(444);
  for (int sample = 0; sample < 5; ++sample)
  {
    const RadialModel model = test::RandomOrgan(random, 9);
    const Eigen::Matrix3d q =
        Eigen::AngleAxisd(1.0 + sample, test::RandomDirection(random)).toRotationMatrix();
    const Vector3 pivot = 50.0 * test::RandomDirection(random);
    const BodyMoments before = Measure(model);
    const RadialModel turned = test::TurnedModel(model, q, pivot);
    const BodyMoments after = Measure(turned);
    // Exact quadratures of two orientations: thousands of rounding errors.
    EXPECT_NEAR(after.Volume / before.Volume, 1.0, 1e-13);
    EXPECT_LE((after.CentroidWorld - pivot - q * (before.CentroidWorld - pivot)).norm(), 1e-12);
    EXPECT_LE(LargestRelative(after.SecondMoments, q * before.SecondMoments * q.transpose()),
              1e-13);
    EXPECT_LE((after.SemiAxes - before.SemiAxes).norm(), 1e-11);
    // The area's quadrature is accurate to its tolerance.
    EXPECT_NEAR(AreaOf(turned) / AreaOf(model), 1.0, 1e-9);
  }
}

TEST(RadialModelMeasures, ScaleWithBody)
{
  Random random(445);
  const RadialModel model = test::RandomOrgan(random, 7);
  std::vector<double> doubled = model.Coefficients();
  for (double& c : doubled)
  {
    c *= 2.0;
  }
  const RadialModel large(7, doubled, model.CenterWorld());
  // Scaling by a power of two is exact.
  EXPECT_EQ(VolumeOf(large), 8.0 * VolumeOf(model));
  EXPECT_EQ(AreaOf(large), 4.0 * AreaOf(model));
  EXPECT_LE(LargestRelative(Measure(large).SecondMoments, 32.0 * Measure(model).SecondMoments),
            1e-15);
}

TEST(RadialModelMeasures, PrincipalAxesDiagonaliseAndAreRightHanded)
{
  Random random(446);
  for (int sample = 0; sample < 10; ++sample)
  {
    const BodyMoments moments = Measure(test::RandomOrgan(random, 8));
    const Eigen::Matrix3d& axes = moments.PrincipalAxes;
    EXPECT_LE((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_NEAR(axes.determinant(), 1.0, 1e-14);
    EXPECT_GT(axes.col(0).maxCoeff(), -axes.col(0).minCoeff());
    EXPECT_GT(axes.col(1).maxCoeff(), -axes.col(1).minCoeff());
    const Vector3 expected = moments.Volume / 5 * moments.SemiAxes.cwiseAbs2();
    const Eigen::Matrix3d diagonal = axes.transpose() * moments.SecondMoments * axes;
    EXPECT_LE(LargestRelative(diagonal, expected.asDiagonal().toDenseMatrix()), 1e-13);
    EXPECT_GE(moments.SemiAxes[0], moments.SemiAxes[1]);
    EXPECT_GE(moments.SemiAxes[1], moments.SemiAxes[2]);
  }
}

TEST(RadialModelMeasures, AreaIsWithinTolerance)
{
  Random random(447);
  const auto areaAtDegree = [](const RadialModel& model, int degree)
  {
    const SphereQuadrature sphere(degree);
    double area = 0.0;
    for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
    {
      const RadialModel::Sample s = model.Evaluate(sphere.Directions[i]);
      area +=
          sphere.Weights[i] * std::abs(s.Radius) * std::hypot(s.Radius, s.SurfaceGradient.norm());
    }
    return area;
  };
  for (const double tolerance : {1e-2, 1e-5, 1e-9})
  {
    for (int sample = 0; sample < 4; ++sample)
    {
      const RadialModel model = test::RandomOrgan(random, 12);
      const double area = AreaOf(model, tolerance);
      EXPECT_LE(std::abs(area - areaAtDegree(model, 300)), (tolerance + 1e-14) * area);
    }
  }
}

TEST(RadialModelMeasures, VolumeIsNegativeForNegativeRadii)
{
  const RadialModel inverted(0, {-3.0}, Center);
  const RadialModel upright(0, {3.0}, Center);
  EXPECT_EQ(VolumeOf(inverted), -VolumeOf(upright));
  EXPECT_EQ(AreaOf(inverted), AreaOf(upright));
  EXPECT_EQ(VolumeOf(RadialModel()), 0.0);
  EXPECT_EQ(AreaOf(RadialModel()), 0.0);
}

TEST(RadialModelMeasures, RejectBodyWithoutVolume)
{
  BodyMoments moments{};
  EXPECT_FALSE(MeasureBody(RadialModel(), moments).IsOk());
  EXPECT_FALSE(MeasureBody({0, {-3.0}, Center}, moments).IsOk());
  EXPECT_FALSE(MeasureBody({1, {3.0, std::nan(""), 0.0, 0.0}, Center}, moments).IsOk());
  EXPECT_FALSE(MeasureBody({1, {INFINITY, 1.0, 0.0, 0.0}, Center}, moments).IsOk());
  EXPECT_TRUE(std::isnan(AreaOf({1, {3.0, std::nan(""), 0.0, 0.0}, Center})));
}
} // namespace
} // namespace palpate::spherical_harmonic_measures_test
