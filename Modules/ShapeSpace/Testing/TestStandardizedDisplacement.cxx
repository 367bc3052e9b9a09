#include "StandardizedDisplacement.h"

#include "RandomScatter.h"
#include "SurfacePhantoms.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::standardized_displacement_test
{
namespace
{
using test::Random;

constexpr int Frequency = 3;

/// Cases around a shape, in its coefficients.
ShapeModes ModesAround(const Eigen::VectorXd& mean, const Eigen::MatrixXd& offsets)
{
  ShapeModes modes;
  EXPECT_TRUE(FindShapeModes(offsets.rowwise() + mean.transpose(), modes).IsOk());
  return modes;
}

Eigen::VectorXd Flat(const std::vector<double>& values)
{
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

TEST(StandardizedDisplacement, IsThatOfTheOtherCasesAtEachPoint)
{
  Random random(61);
  const RadialModel organ = test::RandomOrgan(random, 4);
  const Eigen::MatrixXd offsets = test::NormalMatrix(random, 12, 25);
  const ShapeModes modes = ModesAround(Flat(organ.Coefficients()), offsets);
  const NormalDisplacement mean = FindNormalDisplacement(organ, Frequency);
  const StandardizedDisplacement standardized(mean, modes);
  const Eigen::MatrixXd moved = offsets * mean.PerCoefficient.transpose();
  for (const Eigen::Index leftOut : {0, 5, 11})
  {
    Eigen::MatrixXd rest(11, moved.cols());
    rest << moved.topRows(leftOut), moved.bottomRows(11 - leftOut);
    const Eigen::RowVectorXd center = rest.colwise().mean();
    rest.rowwise() -= center;
    const Eigen::RowVectorXd deviation = (rest.colwise().squaredNorm() / 10.0).cwiseSqrt();
    const Eigen::RowVectorXd slow = (moved.row(leftOut) - center).cwiseQuotient(deviation);
    // Rounding, where the deviation is small against the mean radius.
    EXPECT_LE((standardized.Of(leftOut).transpose() - slow).cwiseAbs().maxCoeff(), 1e-9);
  }
}

// A sphere that is larger in one case by 3 mm, where the others vary by 1 mm.
TEST(StandardizedDisplacement, OfSpheresIsTheirRadiusOverItsDeviation)
{
  Eigen::MatrixXd radii(4, 1);
  radii << -1.0, 0.0, 1.0, 3.0;
  const double perRadius = std::sqrt(4.0 * M_PI);
  const RadialModel mean(0, {20.75 * perRadius}, Vector3::Zero());
  const ShapeModes modes =
      ModesAround(Eigen::VectorXd::Constant(1, 20.0 * perRadius), radii * perRadius);
  const StandardizedDisplacement standardized(FindNormalDisplacement(mean, Frequency), modes);
  const Eigen::VectorXd z = standardized.Of(3);
  EXPECT_NEAR(z.minCoeff(), 3.0, 1e-9);
  EXPECT_NEAR(z.maxCoeff(), 3.0, 1e-9);
  EXPECT_NEAR(standardized.Deviations()[0], std::sqrt(8.75 / 3.0), 1e-9);
}

TEST(StandardizedDisplacement, OfMovedSurfacesIsTheNormalPartOfTheMove)
{
  // Three of the cases are moved, each along one axis.
  const SurfaceModel ball = test::EllipsoidPhantom(Vector3(10.0, 10.0, 10.0));
  const NormalDisplacement mean = FindNormalDisplacement(ball, 1);
  Eigen::MatrixXd offsets = Eigen::MatrixXd::Zero(4, 12);
  offsets(1, 8) = 1.0;
  offsets(2, 0) = 1.0;
  offsets(3, 4) = 1.0;
  const ShapeModes modes = ModesAround(Eigen::VectorXd::Zero(12), offsets);
  const Eigen::VectorXd deviations = StandardizedDisplacement(mean, modes).Deviations();
  for (std::size_t p = 0; p < mean.Points.size(); ++p)
  {
    // Each coordinate has a variance of 1/4 in the coefficient; covariances are -1/12.
    const Vector3& n = mean.Normals[p];
    const double expected =
        (n.squaredNorm() / 4.0 - (n[0] * n[1] + n[1] * n[2] + n[2] * n[0]) / 6.0) / (4.0 * M_PI);
    EXPECT_NEAR(deviations[static_cast<Eigen::Index>(p)], std::sqrt(expected), 1e-9);
  }
}

TEST(StandardizedDisplacement, NeedsTwoOtherCases)
{
  Random random(62);
  const RadialModel organ = test::RandomOrgan(random, 2);
  const ShapeModes modes =
      ModesAround(Flat(organ.Coefficients()), test::NormalMatrix(random, 2, 9));
  const StandardizedDisplacement standardized(FindNormalDisplacement(organ, 1), modes);
  EXPECT_EQ(standardized.Of(0).cwiseAbs().maxCoeff(), 0.0);
}
} // namespace
} // namespace palpate::standardized_displacement_test
