#include "ShapeMirror.h"
#include "ShapeVector.h"
#include "SurfaceCompletionCases.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace palpate::surface_prior_test
{
namespace
{
using namespace palpate::test;

TEST(SurfacePrior, OfMirroredCasesIsSymmetric)
{
  const auto prior = PlatePrior(3, true);
  ASSERT_NE(prior, nullptr);
  const OrganModel like = SurfaceModel(prior->Degree, {});
  const OrganModel mean = ShapeFrom(prior->Mean, like);
  EXPECT_LT((VectorOf(MirrorShape(mean)) - prior->Mean).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(prior->Cases(), 24U);
  EXPECT_NEAR(prior->Relation->Offset.x(), 0.0, 1e-12);
}

TEST(SurfacePrior, OfLopsidedCasesKeepsTheirSide)
{
  Random random(4);
  std::vector<SurfacePrior::Case> cases = BentPlates(random, 12);
  for (SurfacePrior::Case& one : cases)
  {
    Eigen::VectorXd values = VectorOf(one.Surface);
    values[49 + 5] += 20.0;
    one.Surface = std::get<SurfaceModel>(ShapeFrom(values, one.Surface));
  }
  SurfacePrior prior;
  ASSERT_TRUE(SurfacePrior::OfGroup(cases, prior).IsOk());
  EXPECT_GT(prior.Mean[49 + 5], 15.0);
}

TEST(SurfacePrior, GivenAnotherOrganIsBlockGaussianConditioning)
{
  Random random(5);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd asked(40, 6);
  Eigen::MatrixXd known(40, OrganRelation::ScoreCount);
  for (Eigen::Index row = 0; row < 40; ++row)
  {
    for (Eigen::Index k = 0; k < known.cols(); ++k)
    {
      known(row, k) = 2.0 + normal(random) / (1.0 + static_cast<double>(k));
    }
    for (Eigen::Index k = 0; k < 6; ++k)
    {
      asked(row, k) = 3.0 * known(row, k) - known(row, k + 1) + 0.2 * normal(random);
    }
  }
  asked.rowwise() -= asked.colwise().mean().eval();
  OrganRelation relation;
  relation.Regress(asked, known);
  // The joint covariance, its known block enlarged by the ridge.
  const Eigen::RowVectorXd mean = known.colwise().mean();
  const Eigen::MatrixXd rest = known.rowwise() - mean;
  Eigen::MatrixXd own = rest.transpose() * rest / 39.0;
  for (Eigen::Index degree = 0; degree <= 4; ++degree)
  {
    auto part = own.diagonal().segment(degree * degree, 2 * degree + 1);
    part.array() += 0.1 * part.mean();
  }
  const Eigen::MatrixXd cross = asked.transpose() * rest / 39.0;
  const Eigen::MatrixXd covariance =
      asked.transpose() * asked / 39.0 - cross * own.inverse() * cross.transpose();
  LogSurface organ{Eigen::VectorXd::Constant(169, 2.1), Vector3(7.0, 8.0, 9.0)};
  relation.Offset = Vector3(1.0, 0.0, -1.0);
  Eigen::VectorXd expected;
  ASSERT_TRUE(relation.Predict(organ, expected).IsOk());
  Eigen::VectorXd wanted = cross * own.inverse() * (organ.Coefficients.head(25) - mean.transpose());
  wanted.tail<3>() += Vector3(8.0, 8.0, 8.0);
  EXPECT_LT((expected - wanted).cwiseAbs().maxCoeff(), 1e-8);
  // 1e-6 keeps it positive definite.
  EXPECT_LT((relation.Covariance - covariance).cwiseAbs().maxCoeff(), 2e-6);
  organ.Coefficients[0] += 100.0;
  EXPECT_NE(relation.Predict(organ, expected).Message().find("standard deviations"),
            std::string::npos);
}

TEST(SurfacePrior, KnowsHowFarTheOrgansAreApart)
{
  // Spheres of 6 to 10 mm at the centre of other spheres, twice as large.
  std::vector<SurfacePrior::Case> cases;
  for (int n = 0; n < 5; ++n)
  {
    const double radius = 6.0 + n;
    const RadialModel sphere(2, {radius / ShapePrior::ConstantHarmonic, 0, 0, 0, 0, 0, 0, 0, 0},
                             Vector3::Zero());
    LogSurface known{Eigen::VectorXd::Zero(169), Vector3(n, 0.0, 2.0)};
    known.Coefficients[0] = std::log(2.0 * radius) / ShapePrior::ConstantHarmonic;
    cases.push_back({SurfaceModel::FromModel(sphere), known.CenterWorld, known});
  }
  SurfacePrior prior;
  ASSERT_TRUE(SurfacePrior::OfGroup(cases, prior).IsOk());
  // r ln(r / R), the first order of r - R.
  EXPECT_NEAR(prior.Relation->WallMean.mean(), -8.0 * std::log(2.0), 1e-9);
}

TEST(SurfacePrior, LogSurfaceOfAModelIsItsLogarithm)
{
  Random random(6);
  const RadialModel organ = RandomOrgan(random, 4);
  LogSurface made;
  ASSERT_TRUE(FindLogSurface(organ, made).IsOk());
  const SurfaceModel surface = SurfaceModel::FromModel(organ);
  for (const Vector3& direction : RandomDirections(random, 50))
  {
    const Vector3 arm = surface.Point(direction) - made.CenterWorld;
    Eigen::VectorXd values(169);
    SphericalHarmonicBasis(12).Evaluate(arm.normalized(), values.data());
    EXPECT_NEAR(std::exp(values.dot(made.Coefficients)), arm.norm(), 0.02 * arm.norm());
  }
  EXPECT_FALSE(FindLogSurface(SurfaceModel(1, {}), made).IsOk());
}

TEST(SurfacePrior, RefusesNumbersThatAreNone)
{
  const auto prior = PlatePrior(7, true);
  const auto refusal = [&prior](const std::function<void(SurfacePrior&)>& change)
  {
    SurfacePrior changed = *prior;
    change(changed);
    return changed.Check().Message();
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([](SurfacePrior&) {}), "");
  EXPECT_NE(refusal([](SurfacePrior& p) { p.Degree = 7; }), "");
  EXPECT_NE(refusal([](SurfacePrior& p) { p.Degree = -1; }), "");
  EXPECT_NE(refusal([nan](SurfacePrior& p) { p.Mean[2] = nan; }), "");
  EXPECT_NE(refusal([](SurfacePrior& p) { p.Mean *= 1e4; }), "");
  EXPECT_NE(refusal([](SurfacePrior& p) { p.Modes.col(0) *= 2.0; }), "");
  EXPECT_NE(refusal([nan](SurfacePrior& p) { p.Modes(1, 1) = nan; }), "");
  EXPECT_NE(refusal([](SurfacePrior& p) { p.Variances[0] = 0.0; }), "");
  EXPECT_NE(refusal([nan](SurfacePrior& p) { p.Variances[0] = nan; }), "");
  EXPECT_NE(refusal([](SurfacePrior& p) { p.Rest[1] = -1.0; }), "");
  EXPECT_NE(refusal([](SurfacePrior& p) { p.Relation->Gain.conservativeResize(3, 25); }), "");
  EXPECT_NE(refusal([](SurfacePrior& p) { p.Relation->Covariance *= -1.0; }), "");
  EXPECT_NE(refusal([](SurfacePrior& p) { p.Relation->WallCovariance *= -1.0; }), "");
  EXPECT_NE(refusal([](SurfacePrior& p) { p.Relation->Deviations[3] = 0.0; }), "");
  SurfacePrior made;
  Random random(8);
  EXPECT_NE(SurfacePrior::OfGroup(BentPlates(random, 2), made).Message().find("at least 3"),
            std::string::npos);
  const SurfacePrior::Case one = BentPlates(random, 1).front();
  EXPECT_FALSE(SurfacePrior::OfGroup({one, one, one}, made).IsOk());
}
} // namespace
} // namespace palpate::surface_prior_test
