#include "CompletionCases.h"
#include "ShapeMirror.h"

#include <gtest/gtest.h>

#include <limits>

namespace palpate::shape_prior_test
{
namespace
{
using namespace palpate::test;

TEST(ShapePrior, OfMirroredCasesIsSymmetric)
{
  const auto prior = GroupPrior(1);
  ASSERT_NE(prior, nullptr);
  Eigen::VectorXd signs(prior->Size());
  Eigen::Index at = 0;
  for (int degree = 0; degree <= prior->Degree(); ++degree)
  {
    for (int order = -degree; order <= degree; ++order)
    {
      signs[at++] = MirrorSign(order);
    }
  }
  // Sums of 80 terms of 0.1 to 10.
  EXPECT_LT((signs.cwiseProduct(prior->Mean()) - prior->Mean()).cwiseAbs().maxCoeff(), 1e-13);
  const Eigen::MatrixXd mirrored = signs.asDiagonal() * prior->Covariance() * signs.asDiagonal();
  EXPECT_LT((mirrored - prior->Covariance()).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_EQ(prior->Cases(), 40U);
}

TEST(ShapePrior, OfLopsidedCasesKeepsTheirSide)
{
  Random random(2);
  std::vector<RadialModel> models;
  for (const RadialModel& model : RandomGroup(random, 20))
  {
    std::vector<double> coefficients = model.Coefficients();
    coefficients[3] += 15.0; // of order 1: towards +x
    models.emplace_back(12, coefficients, Vector3::Zero());
  }
  ShapePrior prior;
  std::vector<std::size_t> omitted;
  ASSERT_TRUE(ShapePrior::OfGroup(models, prior, omitted).IsOk());
  EXPECT_GT(prior.Mean()[3], 0.1);
}

TEST(ShapePrior, LogarithmAndBackIsTheModel)
{
  Random random(3);
  const RadialModel model = RandomGroup(random, 1).front();
  const RadialModel back = RadialModelOf(LogarithmOf(model, 20), 12, model.CenterWorld());
  for (const Vector3& direction : RandomDirections(random, 100))
  {
    EXPECT_NEAR(back.Radius(direction), model.Radius(direction), 1e-3); // of degrees above 20
  }
}

TEST(ShapePrior, LeavesOutModelsWithoutALogarithm)
{
  Random random(4);
  std::vector<RadialModel> models = RandomGroup(random, 5);
  std::vector<double> crossed = models[1].Coefficients();
  crossed[2] = 2.0 * crossed[0]; // below 0 on one side
  models[1] = RadialModel(12, crossed, Vector3::Zero());
  models[3] = RadialModel(0, {std::numeric_limits<double>::quiet_NaN()}, Vector3::Zero());
  ShapePrior prior;
  std::vector<std::size_t> omitted;
  ASSERT_TRUE(ShapePrior::OfGroup(models, prior, omitted).IsOk());
  EXPECT_EQ(omitted, (std::vector<std::size_t>{1, 3}));
  EXPECT_EQ(prior.Cases(), 3U);
  models.pop_back();
  const Status status = ShapePrior::OfGroup(models, prior, omitted);
  EXPECT_NE(status.Message().find("at least 3"), std::string::npos);
  EXPECT_EQ(prior.Cases(), 3U);
}

TEST(ShapePrior, SmoothHasTheRadiusAndItsSpread)
{
  const ShapePrior prior = ShapePrior::Smooth(18.0);
  const double harmonic = ShapePrior::ConstantHarmonic;
  EXPECT_NEAR(std::exp(prior.Mean()[0] * harmonic), 18.0, 1e-12);
  EXPECT_NEAR(std::sqrt(prior.Covariance()(0, 0)) * harmonic, 0.35, 1e-12);
  EXPECT_NEAR(prior.Covariance()(5, 5), std::pow(0.8 / 6.0, 2), 1e-15);
  EXPECT_EQ(prior.Cases(), 0U);
}

TEST(ShapePrior, RefusesNumbersThatAreNone)
{
  ShapePrior prior;
  const auto refusal = [&prior](Eigen::VectorXd mean, Eigen::MatrixXd covariance)
  { return ShapePrior::Of(std::move(mean), std::move(covariance), 1, prior).Message(); };
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(9);
  mean[0] = std::log(20.0) / ShapePrior::ConstantHarmonic;
  const Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(9, 9);
  EXPECT_EQ(refusal(mean, covariance), "");
  EXPECT_NE(refusal(mean.head(8), covariance.topLeftCorner(8, 8)), "");
  EXPECT_NE(refusal(mean, covariance.topLeftCorner(8, 8)), "");
  EXPECT_NE(refusal(mean, -covariance), "");
  EXPECT_NE(refusal(30.0 * mean, covariance), "");
  EXPECT_NE(refusal(std::numeric_limits<double>::quiet_NaN() * mean, covariance), "");
  EXPECT_NE(refusal({}, {}), "");
  EXPECT_EQ(prior.Degree(), 2);
}
} // namespace
} // namespace palpate::shape_prior_test
