#include "DeviationMap.h"

#include "CompletionCases.h"
#include "IcosahedronDirections.h"

#include <gtest/gtest.h>

namespace palpate::deviation_map_test
{
namespace
{
using namespace palpate::test;

const Vector3 Center(1.0, 2.0, -3.0);

// Of a small degree, so that brute force takes little.
std::shared_ptr<const ShapePrior> SmallPrior(Random& random)
{
  Eigen::MatrixXd cases(60, 25);
  for (Eigen::Index n = 0; n < cases.rows(); ++n)
  {
    const std::vector<double> values = RandomCoefficients(random, 4, 1.5);
    cases.row(n) = 0.4 * Eigen::Map<const Eigen::RowVectorXd>(values.data(), 25);
  }
  cases.col(0).array() += std::log(20.0) / ShapePrior::ConstantHarmonic;
  const Eigen::MatrixXd rest = cases.rowwise() - cases.colwise().mean();
  ShapePrior prior;
  const Status status =
      ShapePrior::Of(cases.colwise().mean().transpose(), rest.transpose() * rest / 59.0, 60, prior);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return std::make_shared<const ShapePrior>(prior);
}

// P^-1 + J' R^-1 J, of the touches at the completed surface.
Eigen::MatrixXd Information(const ShapeCompletion& completion,
                            const std::vector<SurfaceTouch>& touches)
{
  TouchEquations equations(completion.Prior()->Degree());
  equations.SetTouches(touches);
  equations.Evaluate(completion.Surface());
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(equations.Rows(), equations.Rows());
  equations.AddCovariance(covariance);
  const Eigen::MatrixXd slopes = AllSlopes(equations);
  return PriorInformation(*completion.Prior()) +
         slopes.transpose() * covariance.llt().solve(slopes);
}

// What the surface's points in these directions do, a row each: they are on the surface.
Eigen::MatrixXd SurfaceSlopes(const ShapeCompletion& completion,
                              const std::vector<Vector3>& directions)
{
  TouchEquations equations(completion.Prior()->Degree());
  equations.SetTouches(TouchesOf(completion.Surface(), directions, 1.0));
  equations.Evaluate(completion.Surface());
  return AllSlopes(equations);
}

TEST(DeviationMap, IsThePosteriorInClosedForm)
{
  Random random(1);
  const auto prior = SmallPrior(random);
  std::vector<SurfaceTouch> touches =
      TouchesOf(SampleOf(*prior, random, Center), RandomDirections(random, 9), 0.8);
  touches[2].Normal = touches[2].PointWorld - Center;
  touches[4].Stroke = touches[5].Stroke = touches[6].Stroke = 3;
  ShapeCompletion completion(prior, Center);
  // Twice: the derivatives are those of the last but one surface, less than 5e-3 mm away.
  ASSERT_TRUE(completion.Update(touches).IsOk() && completion.Update(touches).IsOk());
  DeviationMap map(prior, 3);
  const Eigen::MatrixXd slopes = SurfaceSlopes(completion, map.Directions());
  const Eigen::MatrixXd posterior =
      slopes * Information(completion, touches).inverse() * slopes.transpose();
  const Eigen::VectorXd wanted =
      (posterior.diagonal().array() + DeviationMap::LeftOut * DeviationMap::LeftOut).sqrt();
  EXPECT_LT((map.Evaluate(completion) - wanted).cwiseAbs().maxCoeff(), 2e-4);
}

TEST(DeviationMap, TouchesMakeItSurerThereAndNowhereLessSure)
{
  const auto prior = GroupPrior(2);
  ShapeCompletion completion(prior, Center);
  DeviationMap map(prior, 8);
  ASSERT_EQ(map.Directions().size(), 642U);
  ASSERT_TRUE(completion.Update({}).IsOk());
  const Eigen::VectorXd before = map.Evaluate(completion);
  // On the mean surface: the surface does not move.
  ASSERT_TRUE(
      completion.Update(TouchesOf(completion.Surface(), {map.Directions()[100]}, 1.0)).IsOk());
  const Eigen::VectorXd after = map.Evaluate(completion);
  EXPECT_LT(after[100], 1.2);
  EXPECT_GT(before[100], 3.0);
  EXPECT_LT((after - before).maxCoeff(), 1e-9);
}

TEST(DeviationMap, NextTouchLeavesTheLeastVarianceOfAll)
{
  Random random(3);
  const auto prior = SmallPrior(random);
  std::vector<SurfaceTouch> touches =
      TouchesOf(SampleOf(*prior, random, Center), RandomDirections(random, 3), 1.0);
  ShapeCompletion completion(prior, Center);
  ASSERT_TRUE(completion.Update(touches).IsOk());
  DeviationMap map(prior, 2);
  const std::vector<Vector3>& directions = map.Directions();
  const std::vector<double> angles = IcosahedronDirections(2).SolidAngles();
  const Eigen::MatrixXd slopes = SurfaceSlopes(completion, directions);
  const auto leftAfter = [&](const std::vector<SurfaceTouch>& all)
  {
    const Eigen::MatrixXd posterior =
        slopes * Information(completion, all).inverse() * slopes.transpose();
    double sum = 0.0;
    for (std::size_t n = 0; n < directions.size(); ++n)
    {
      const double radius =
          (PointOf(completion.Surface(), directions[n]) - completion.Surface().CenterWorld).norm();
      const Vector3 normal = slopes.row(static_cast<Eigen::Index>(n)).tail<3>().transpose();
      sum += angles[n] * radius * radius / std::abs(normal.dot(directions[n])) *
             posterior(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    }
    return sum;
  };
  for (const Vector3& place : map.NextTouches(completion, 3))
  {
    std::vector<SurfaceTouch> chosen = touches;
    chosen.push_back({place, 1.0});
    for (const Vector3& direction : directions)
    {
      std::vector<SurfaceTouch> other = touches;
      other.push_back({PointOf(completion.Surface(), direction), 1.0});
      ASSERT_LE(leftAfter(chosen), leftAfter(other) * (1.0 + 1e-9));
    }
    touches = chosen;
  }
}

TEST(DeviationMap, FirstTouchesDependOnThePriorAlone)
{
  const auto prior = GroupPrior(4);
  DeviationMap map(prior, 6);
  const ShapeCompletion here(prior, Center);
  const ShapeCompletion there(prior, -Center);
  const std::vector<Vector3> ofHere = map.NextTouches(here, 6);
  const std::vector<Vector3> ofThere = map.NextTouches(there, 6);
  ASSERT_EQ(ofHere.size(), 6U);
  for (std::size_t n = 0; n < 6; ++n)
  {
    EXPECT_LT(((ofHere[n] - Center) - (ofThere[n] + Center)).norm(), 1e-9);
    for (std::size_t m = 0; m < n; ++m)
    {
      EXPECT_GT((ofHere[n] - ofHere[m]).norm(), 5.0);
    }
  }
}
} // namespace
} // namespace palpate::deviation_map_test
