#include "ShapeModelQuality.h"

#include "RandomScatter.h"
#include "WorstCase.h"

#include <cmath>
#include <gtest/gtest.h>
#include <utility>

namespace palpate::shape_model_quality_test
{
namespace
{
using test::Random;
using test::WorstCase;

const double Sphere = std::sqrt(4.0 * M_PI);

ShapeModes ModesOf(const Eigen::MatrixXd& cases)
{
  ShapeModes modes;
  EXPECT_TRUE(FindShapeModes(cases, modes).IsOk());
  return modes;
}

/// The distance of every case from its best description by the first modes of the others, each with
/// a decomposition of its own: cases x numbers of modes.
Eigen::MatrixXd SlowGeneralisation(const Eigen::MatrixXd& cases, Eigen::Index most)
{
  Eigen::MatrixXd distances(cases.rows(), most + 1);
  for (Eigen::Index i = 0; i < cases.rows(); ++i)
  {
    Eigen::MatrixXd rest(cases.rows() - 1, cases.cols());
    rest << cases.topRows(i), cases.bottomRows(cases.rows() - 1 - i);
    const ShapeModes others = ModesOf(rest);
    Eigen::VectorXd left = cases.row(i).transpose() - others.Mean;
    for (Eigen::Index k = 0; k <= most; ++k)
    {
      distances(i, k) = left.norm() / Sphere;
      if (k < others.Modes.cols())
      {
        left -= others.Modes.col(k) * others.Modes.col(k).dot(left);
      }
    }
  }
  return distances;
}

Eigen::VectorXd StandardError(const Eigen::MatrixXd& samples)
{
  const auto count = static_cast<double>(samples.rows());
  const Eigen::MatrixXd off = samples.rowwise() - samples.colwise().mean();
  return (off.colwise().squaredNorm() / (count * (count - 1.0))).cwiseSqrt().transpose();
}

TEST(ShapeModelQuality, GeneralisationIsThatOfADecompositionForEachCase)
{
  Random random(41);
  for (const auto& [count, size] : {std::pair<int, int>{30, 16}, {10, 36}})
  {
    const Eigen::MatrixXd cases = test::RandomCases(random, count, size, size);
    const ShapeModes modes = ModesOf(cases);
    const QualityCurve curve = MeasureShapeModel(modes, {10, 1}).Generalisation;
    const Eigen::MatrixXd slow = SlowGeneralisation(cases, modes.Modes.cols());
    ASSERT_EQ(curve.Values.size(), slow.cols());
    const Eigen::VectorXd mean = slow.colwise().mean().transpose();
    EXPECT_LE((curve.Values - mean).cwiseAbs().maxCoeff(), 1e-10); // mm, rounding
    EXPECT_LE((curve.StandardErrors - StandardError(slow)).cwiseAbs().maxCoeff(), 1e-10);
  }
}

TEST(ShapeModelQuality, GeneralisationIsZeroFromTheTrueRankOn)
{
  Random random(42);
  const ShapeModes modes = ModesOf(test::RandomCases(random, 25, 49, 6));
  const ShapeModelQuality quality = MeasureShapeModel(modes, {10, 1});
  ASSERT_EQ(quality.Generalisation.Values.size(), 7);
  EXPECT_GT(quality.Generalisation.Values[5], 0.1);
  EXPECT_EQ(quality.Generalisation.Values[6], 0.0);
  EXPECT_EQ(quality.Generalisation.StandardErrors[6], 0.0);
}

TEST(ShapeModelQuality, CompactnessCumulatesVariances)
{
  Random random(43);
  const Eigen::MatrixXd cases = test::RandomCases(random, 25, 16, 16);
  const QualityCurve curve = MeasureShapeModel(ModesOf(cases), {10, 1}).Compactness;
  const Eigen::MatrixXd off = cases.rowwise() - cases.colwise().mean();
  EXPECT_EQ(curve.Values[0], 0.0);
  EXPECT_NEAR(curve.Values[16], off.squaredNorm() / 24.0 / (4.0 * M_PI), 1e-10);
  EXPECT_NEAR(curve.StandardErrors[1], std::sqrt(2.0 / 24.0) * curve.Values[1], 1e-12);
  for (Eigen::Index k = 0; k < 16; ++k)
  {
    EXPECT_LT(curve.Values[k], curve.Values[k + 1]);
    EXPECT_LT(curve.StandardErrors[k], curve.StandardErrors[k + 1]);
  }
}

// The stated error of the cumulated variance against the spread over many normal cohorts.
TEST(ShapeModelQuality, ErrorOfCompactnessIsItsSpreadOverCohorts)
{
  Random random(44);
  constexpr int Cohorts = 400;
  Eigen::MatrixXd variances(Cohorts, 1);
  double stated = 0.0;
  for (int cohort = 0; cohort < Cohorts; ++cohort)
  {
    Eigen::MatrixXd cases = test::NormalMatrix(random, 60, 4);
    cases.col(0) *= 9.0;
    cases.col(1) *= 3.0;
    const QualityCurve curve = MeasureShapeModel(ModesOf(cases), {1, 1}).Compactness;
    variances(cohort, 0) = curve.Values[2];
    stated += curve.StandardErrors[2] / Cohorts;
  }
  const double spread = StandardError(variances)[0] * std::sqrt(Cohorts);
  // The spread of 400 has a relative error of 3.5 %; four of these.
  EXPECT_NEAR(stated / spread, 1.0, 0.14);
}

TEST(ShapeModelQuality, SpecificityIsThatOfTheRandomShapesOneByOne)
{
  Random random(45);
  const Eigen::MatrixXd cases = test::RandomCases(random, 12, 16, 5);
  const ShapeModes modes = ModesOf(cases);
  constexpr int Shapes = 7;
  const QualityCurve curve = MeasureShapeModel(modes, {Shapes, 3}).Specificity;
  Eigen::MatrixXd slow(Shapes, modes.Modes.cols() + 1);
  for (int shape = 0; shape < Shapes; ++shape)
  {
    const Eigen::VectorXd scores = RandomScores(modes, 3, static_cast<std::uint64_t>(shape));
    for (Eigen::Index k = 0; k < slow.cols(); ++k)
    {
      const Eigen::RowVectorXd drawn =
          (modes.Mean + modes.Modes.leftCols(k) * scores.head(k)).transpose();
      slow(shape, k) = (cases.rowwise() - drawn).rowwise().norm().minCoeff() / Sphere;
    }
  }
  const Eigen::VectorXd mean = slow.colwise().mean().transpose();
  EXPECT_LE((curve.Values - mean).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_LE((curve.StandardErrors - StandardError(slow)).cwiseAbs().maxCoeff(), 1e-10);
}

// Two cases at -a and a: the distance is ||z| - a| with z normal, of deviation a sqrt(2).
TEST(ShapeModelQuality, SpecificityOfTwoCasesIsKnownInClosedForm)
{
  const double a = 2.5;
  const ShapeModes modes = ModesOf((Eigen::MatrixXd(2, 1) << 10.0 - a, 10.0 + a).finished());
  const QualityCurve curve = MeasureShapeModel(modes, {20000, 5}).Specificity;
  const double deviation = a * std::sqrt(2.0);
  const auto density = [&](double z)
  { return std::exp(-0.5 * z * z / deviation / deviation) / std::sqrt(2.0 * M_PI) * deviation; };
  // E||z| - a| = 2 (integral of (a - z) to a, of (z - a) from a) for z > 0.
  const double within = 0.5 * std::erf(a / deviation / std::sqrt(2.0));
  const double expected =
      2.0 * (a * within - (density(0.0) - density(a)) + density(a) - a * (0.5 - within));
  EXPECT_NEAR(curve.Values[1] * Sphere, expected, 4.0 * curve.StandardErrors[1] * Sphere);
  EXPECT_NEAR(curve.Values[0] * Sphere, a, 1e-12);
  EXPECT_LE(curve.StandardErrors[0], 1e-15);
}

TEST(ShapeModelQuality, RandomScoresHaveTheDeviationsOfTheModes)
{
  Random random(46);
  const ShapeModes modes = ModesOf(test::RandomCases(random, 12, 16, 3));
  Eigen::MatrixXd scores(20000, 3);
  for (Eigen::Index shape = 0; shape < scores.rows(); ++shape)
  {
    scores.row(shape) = RandomScores(modes, 9, static_cast<std::uint64_t>(shape)).transpose();
  }
  scores = scores * modes.Deviations.cwiseInverse().asDiagonal();
  const Eigen::Matrix3d covariance = scores.transpose() * scores / 20000.0;
  // Five standard errors of a covariance of 20,000.
  EXPECT_LE((covariance - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 0.05);
  EXPECT_LE(scores.colwise().mean().cwiseAbs().maxCoeff(), 5.0 / std::sqrt(20000.0));
  EXPECT_EQ(RandomScores(modes, 9, 4), RandomScores(modes, 9, 4));
  EXPECT_NE(RandomScores(modes, 9, 4), RandomScores(modes, 10, 4));
}

TEST(ShapeModelQuality, EqualCasesHaveNoDistances)
{
  const ShapeModes modes = ModesOf(Eigen::MatrixXd::Constant(4, 9, 1.5));
  const ShapeModelQuality quality = MeasureShapeModel(modes, {5, 1});
  ASSERT_EQ(quality.Generalisation.Values.size(), 1);
  EXPECT_EQ(quality.Generalisation.Values[0], 0.0);
  EXPECT_EQ(quality.Specificity.Values[0], 0.0);
}
} // namespace
} // namespace palpate::shape_model_quality_test
