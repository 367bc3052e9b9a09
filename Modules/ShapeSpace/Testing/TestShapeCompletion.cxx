#include "CompletionCases.h"

#include <gtest/gtest.h>

#include <limits>

namespace palpate::shape_completion_test
{
namespace
{
using namespace palpate::test;

const Vector3 Center(12.0, -30.0, 7.0);

// mm, over 642 directions from the first one's centre; both centres close.
double LargestDifference(const RadialModel& one, const RadialModel& other)
{
  double largest = 0.0;
  for (const Vector3& direction : SphereDirections(8))
  {
    const Vector3 arm = one.PointWorld(direction) - other.CenterWorld();
    largest = std::max(largest, std::abs(arm.norm() - other.Radius(arm.normalized())));
  }
  return largest;
}

Eigen::VectorXd StateOf(const LogSurface& surface, const ShapePrior& prior, const Vector3& click)
{
  Eigen::VectorXd state(prior.Size() + 3);
  state.head(prior.Size()) = surface.Coefficients - prior.Mean();
  state.tail<3>() = surface.CenterWorld - click;
  return state;
}

TEST(ShapeCompletion, WithoutTouchesIsThePrior)
{
  const auto prior = GroupPrior(10);
  ShapeCompletion completion(prior, Center);
  ASSERT_TRUE(completion.Update({}).IsOk());
  EXPECT_EQ(completion.Surface().Coefficients, prior->Mean());
  EXPECT_EQ(completion.Surface().CenterWorld, Center);
  EXPECT_TRUE(completion.Judge().IsOk());
  EXPECT_EQ(completion.Model().Degree(), 12);
}

TEST(ShapeCompletion, RecoversAModelOfThePriorFromDenseTouches)
{
  const auto prior = GroupPrior(11);
  Random random(11);
  for (int n = 0; n < 3; ++n)
  {
    const LogSurface truth = SampleOf(*prior, random, Center);
    ShapeCompletion completion(prior, Center + Vector3(3.0, -2.0, 4.0));
    ASSERT_TRUE(completion.Update(TouchesOf(truth, SphereDirections(7), 0.01)).IsOk());
    ASSERT_TRUE(completion.Judge().IsOk());
    // 492 points of 0.4 mm for 169 coefficients whose prior pulls by less than that.
    EXPECT_LT(LargestDifference(completion.Model(),
                                RadialModelOf(truth.Coefficients, 12, truth.CenterWorld)),
              0.25);
    EXPECT_LT(completion.Distance(), 0.1);
  }
}

TEST(ShapeCompletion, IsStationaryAtTheEnd)
{
  const auto prior = GroupPrior(12);
  Random random(12);
  std::vector<SurfaceTouch> touches =
      TouchesOf(SampleOf(*prior, random, Center), RandomDirections(random, 15), 1.0);
  for (SurfaceTouch& touch : touches)
  {
    touch.PointWorld += RandomDirection(random);
    touch.Normal = touch.PointWorld - Center;
  }
  touches[3].Stroke = touches[7].Stroke = 2;
  ShapeCompletion completion(prior, Center);
  ASSERT_TRUE(completion.Update(touches).IsOk());
  TouchEquations equations(12);
  equations.SetTouches(touches);
  equations.Evaluate(completion.Surface());
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(equations.Rows(), equations.Rows());
  equations.AddCovariance(covariance);
  const Eigen::MatrixXd slopes = AllSlopes(equations);
  const Eigen::MatrixXd information =
      PriorInformation(*prior) + slopes.transpose() * covariance.llt().solve(slopes);
  const Eigen::VectorXd gradient =
      PriorInformation(*prior) * StateOf(completion.Surface(), *prior, Center) +
      slopes.transpose() * covariance.llt().solve(equations.Residuals());
  // What is left of the way to the optimum, in standard deviations.
  EXPECT_LT(std::sqrt(gradient.dot(information.llt().solve(gradient))), 0.02);
}

TEST(ShapeCompletion, OnASphereOfOneUnknownIsTheClosedForm)
{
  // A size of deviation s about radius R, all else fixed: of n touches at radius r with variance v
  // the logarithm moves by s^2 / (s^2 + v / (n R^2)) of ln(r / R), to first order.
  const double harmonic = ShapePrior::ConstantHarmonic;
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(9);
  mean[0] = std::log(20.0) / harmonic;
  Eigen::VectorXd variances = Eigen::VectorXd::Constant(9, 1e-12);
  variances[0] = std::pow(0.05 / harmonic, 2);
  ShapePrior prior;
  ASSERT_TRUE(ShapePrior::Of(mean, variances.asDiagonal(), 5, prior).IsOk());
  ShapeCompletion completion(std::make_shared<const ShapePrior>(prior), Center);
  std::vector<SurfaceTouch> touches;
  for (const Vector3& direction : SphereDirections(1))
  {
    touches.push_back({Center + 20.2 * direction, 1.0});
  }
  ASSERT_TRUE(completion.Update(touches).IsOk());
  const double share = 0.0025 / (0.0025 + 1.16 / (12.0 * 400.0));
  // Second order: (ln r / R)^2 of it, a hundredth.
  EXPECT_NEAR(harmonic * (completion.Surface().Coefficients[0] - mean[0]),
              share * std::log(20.2 / 20.0), 2e-4);
}

TEST(ShapeCompletion, WarmAndColdEndAtTheSameSurface)
{
  const auto prior = GroupPrior(13);
  Random random(13);
  const std::vector<SurfaceTouch> touches =
      TouchesOf(SampleOf(*prior, random, Center), RandomDirections(random, 20), 1.0);
  ShapeCompletion warm(prior, Center + Vector3(4.0, 0.0, 3.0));
  for (std::size_t count = 6; count <= touches.size(); ++count)
  {
    ASSERT_TRUE(warm.Update({touches.begin(), touches.begin() + count}).IsOk());
  }
  ShapeCompletion cold(prior, Center + Vector3(4.0, 0.0, 3.0));
  ASSERT_TRUE(cold.Update(touches).IsOk());
  EXPECT_LT(LargestDifference(warm.Model(), cold.Model()), 0.05);
  EXPECT_LT(warm.Steps(), cold.Steps());
}

TEST(ShapeCompletion, ConvergesUnderTheSmoothPriorFromFarAway)
{
  Random random(14);
  for (int n = 0; n < 20; ++n)
  {
    const RadialModel organ = RandomOrgan(random, 6);
    std::vector<SurfaceTouch> touches;
    for (const Vector3& direction : RandomDirections(random, 20))
    {
      touches.push_back({organ.PointWorld(direction), 1.0});
    }
    std::unique_ptr<ShapeCompletion> made;
    ASSERT_TRUE(
        CompleteSurface(touches, nullptr, Vector3(organ.CenterWorld() + Vector3(5, 5, -5)), made)
            .IsOk());
    EXPECT_TRUE(made->Judge().IsOk()) << n << ": " << made->Judge().Message();
  }
}

TEST(ShapeCompletion, RefusesABodyThatIsNotStarShaped)
{
  // A ring: its inner side is hidden from everywhere.
  std::vector<SurfaceTouch> touches;
  for (int n = 0; n < 12; ++n)
  {
    const Vector3 out(std::cos(0.5236 * n), std::sin(0.5236 * n), 0.0);
    touches.push_back({Center + 30.0 * out, 1.0});
    touches.push_back({Center + 14.0 * out, 1.0});
    touches.push_back({Center + 22.0 * out + Vector3(0, 0, n % 2 == 0 ? 8.0 : -8.0), 1.0});
  }
  ShapeCompletion completion(GroupPrior(15), Center);
  ASSERT_TRUE(completion.Update(touches).IsOk());
  EXPECT_NE(completion.Judge().Message().find("not star-shaped"), std::string::npos);
}

TEST(ShapeCompletion, APointOutsideHoldsTheSurfaceBack)
{
  const auto prior = GroupPrior(16);
  ShapeCompletion completion(prior, Center);
  const Vector3 front = PointOf({prior->Mean(), Center}, Vector3::UnitY());
  const Vector3 back = PointOf({prior->Mean(), Center}, -Vector3::UnitY());
  ASSERT_TRUE(completion.Update({{back, 0.5}}).IsOk());
  const double free = completion.Model().PointWorld(Vector3::UnitY()).y();
  SurfaceTouch outside{front - Vector3(0, 5.0, 0), 0.5, {}, 0, true};
  ASSERT_TRUE(completion.Update({{back, 0.5}, outside}).IsOk());
  EXPECT_LT(completion.Model().PointWorld(Vector3::UnitY()).y(), front.y() - 4.0);
  outside.PointWorld = front + Vector3(0, 40.0, 0);
  ASSERT_TRUE(completion.Update({{back, 0.5}, outside}).IsOk());
  EXPECT_NEAR(completion.Model().PointWorld(Vector3::UnitY()).y(), free, 2e-3);
}

TEST(ShapeCompletion, ManyPointsOfOneStrokeAreNotManyTouches)
{
  const auto prior = GroupPrior(17);
  const LogSurface mean{prior->Mean(), Center};
  std::vector<SurfaceTouch> touches;
  for (int n = 0; n < 48; ++n)
  {
    const Vector3 out(std::cos(0.1309 * n), std::sin(0.1309 * n), 0.0);
    touches.push_back({PointOf(mean, out) + 2.0 * out, 1.0});
  }
  const auto radius = [&](int stroke)
  {
    for (SurfaceTouch& touch : touches)
    {
      touch.Stroke = stroke;
    }
    ShapeCompletion completion(prior, Center);
    EXPECT_TRUE(completion.Update(touches).IsOk());
    return completion.Model().Radius(Vector3::UnitX());
  };
  EXPECT_LT(radius(1), radius(0) - 0.02);
  EXPECT_EQ(radius(1), radius(77));
}

TEST(ShapeCompletion, RefusesBadTouchesAndStaysAsItWas)
{
  ShapeCompletion completion(GroupPrior(18), Center);
  ASSERT_TRUE(completion.Update({{Center + Vector3(20, 0, 0), 1.0}}).IsOk());
  const Eigen::VectorXd before = completion.Surface().Coefficients;
  const auto refusal = [&completion](const SurfaceTouch& touch) {
    return completion.Update({{Center, 1.0}, touch}).Message();
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal({Vector3(nan, 0, 0), 1.0}).find("touch 2 is not within"), std::string::npos);
  EXPECT_NE(refusal({Center + Vector3(0, 0, 2000), 1.0}).find("1,000 mm"), std::string::npos);
  EXPECT_NE(refusal({Center, 0.0}).find("standard deviation"), std::string::npos);
  EXPECT_NE(refusal({Center, nan}).find("standard deviation"), std::string::npos);
  EXPECT_NE(refusal({Center, 1.0, Vector3(0, 0, 0)}).find("normal"), std::string::npos);
  EXPECT_NE(refusal({Center, 1.0, Vector3(0, nan, 1)}).find("normal"), std::string::npos);
  EXPECT_NE(completion.Update(std::vector<SurfaceTouch>(1001)).Message().find("take every tenth"),
            std::string::npos);
  EXPECT_EQ(completion.Surface().Coefficients, before);
}

TEST(ShapeCompletion, TouchesAtTheVeryCentreAreSurvived)
{
  ShapeCompletion completion(GroupPrior(19), Center);
  ASSERT_TRUE(completion.Update(std::vector<SurfaceTouch>(30, {Center, 0.01})).IsOk());
  EXPECT_TRUE(completion.Surface().Coefficients.allFinite());
}

TEST(ShapeCompletion, InOneCallFindsCentreAndSize)
{
  std::vector<SurfaceTouch> touches;
  for (const Vector3& direction : SphereDirections(1))
  {
    touches.push_back({Center + 40.0 * direction, 0.5});
  }
  std::unique_ptr<ShapeCompletion> made;
  ASSERT_TRUE(CompleteSurface(touches, nullptr, std::nullopt, made).IsOk());
  EXPECT_LT((made->Surface().CenterWorld - Center).norm(), 0.01);
  EXPECT_NEAR(made->Model().Radius(Vector3::UnitZ()), 40.0, 0.01);
  made.reset();
  EXPECT_FALSE(CompleteSurface({}, nullptr, std::nullopt, made).IsOk());
  EXPECT_EQ(made, nullptr);
  EXPECT_TRUE(CompleteSurface({}, nullptr, Center, made).IsOk());
}
} // namespace
} // namespace palpate::shape_completion_test
