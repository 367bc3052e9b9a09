#include "OrganCompletion.h"
#include "SurfaceCompletionCases.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <limits>

namespace palpate::surface_completion_test
{
namespace
{
using namespace palpate::test;

std::vector<Vector3> Parameters(int frequency)
{
  return IcosahedronDirections(frequency).Directions();
}

// mm, RMS over parameters, of a completed surface from a case's, by the nearest of 2,562 points.
double Error(const SurfaceModel& model, const SurfacePrior::Case& one)
{
  std::vector<Vector3> points;
  for (const Vector3& parameter : Parameters(16))
  {
    points.emplace_back(one.CentroidWorld + one.Surface.Point(parameter));
  }
  double sum = 0.0;
  for (const Vector3& parameter : Parameters(4))
  {
    const Vector3 point = model.Point(parameter);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector3& other : points)
    {
      nearest = std::min(nearest, (other - point).squaredNorm());
    }
    sum += nearest;
  }
  return std::sqrt(sum / 162.0);
}

TEST(SurfaceCompletion, WithoutTouchesIsThePrior)
{
  const auto prior = PlatePrior(10, false);
  ASSERT_NE(prior, nullptr);
  const Vector3 click(4.0, 5.0, -6.0);
  SurfaceCompletion completion(prior, click);
  ASSERT_TRUE(completion.Update({}).IsOk());
  EXPECT_EQ(completion.Posterior().Coefficients(), prior->Mean);
  EXPECT_EQ(completion.Posterior().CentroidWorld(), click);
  EXPECT_TRUE(completion.Judge().IsOk());
  EXPECT_EQ(completion.Model().Degree(), 6);
}

TEST(SurfaceCompletion, EndsAtTheClosedFormOfItsLastRows)
{
  const auto prior = PlatePrior(11, true);
  Random random(11);
  const SurfacePrior::Case truth = BentPlates(random, 1).front();
  std::unique_ptr<SurfaceCompletion> completion;
  ASSERT_TRUE(SurfaceCompletion::WithKnown(prior, *truth.Known, completion).IsOk());
  std::vector<SurfaceTouch> touches = TouchesOn(truth, Parameters(1), 1.0);
  touches[2].Stroke = touches[5].Stroke = 3;
  touches[7].Normal.reset();
  ASSERT_TRUE(completion->Update(touches).IsOk());
  SurfaceDistribution before;
  ASSERT_TRUE(prior->Given(*truth.Known, before).IsOk());
  Eigen::VectorXd mean(before.Mean.size() + 3);
  mean << before.Mean, before.CentroidWorld;
  const Eigen::MatrixXd dense = DenseCovariance(*prior, before.Covariance);
  const Eigen::MatrixXd rows = DenseRows(completion->Rows());
  ASSERT_EQ(rows.rows(), 12 + 2 * 11 + OrganRelation::WallCount);
  const Eigen::MatrixXd system = rows * dense * rows.transpose() + completion->Noise();
  EXPECT_EQ(completion->Noise()(6, 15), 0.25); // the points of touches 3 and 6 share a stroke
  const Eigen::VectorXd expected =
      mean + dense * rows.transpose() * system.llt().solve(completion->Values() - rows * mean);
  // An inverse of condition 1e4 of sums of 1e3.
  EXPECT_LT((completion->Posterior().Coefficients() - expected.head(before.Mean.size()))
                .cwiseAbs()
                .maxCoeff(),
            1e-6);
  EXPECT_LT((completion->Posterior().CentroidWorld() - expected.tail<3>()).norm(), 1e-6);
}

TEST(SurfaceCompletion, RecoversCasesOfTheGroupFromDenseTouches)
{
  const auto prior = PlatePrior(12, false);
  Random random(112);
  for (const SurfacePrior::Case& truth : BentPlates(random, 3))
  {
    SurfaceCompletion completion(prior, truth.CentroidWorld + Vector3(3.0, -2.0, 3.0));
    ASSERT_TRUE(completion.Update(TouchesOn(truth, Parameters(4), 0.05)).IsOk());
    EXPECT_TRUE(completion.Judge().IsOk()) << completion.Judge().Message();
    // Points of the truth's grid are 1 mm apart, and each touch leaves 0.4 mm.
    EXPECT_LT(Error(completion.Model(), truth), 0.8);
    EXPECT_LT(completion.Distance(), 0.3);
  }
}

TEST(SurfaceCompletion, TheOtherOrganNarrowsAndImproves)
{
  const auto prior = PlatePrior(13, true);
  Random random(113);
  double alone = 0.0;
  double related = 0.0;
  for (const SurfacePrior::Case& truth : BentPlates(random, 6))
  {
    std::unique_ptr<SurfaceCompletion> known;
    ASSERT_TRUE(SurfaceCompletion::WithKnown(prior, *truth.Known, known).IsOk());
    SurfaceCompletion clicked(prior, truth.CentroidWorld + Vector3(3.0, 3.0, -3.0));
    ASSERT_TRUE(clicked.Update({}).IsOk());
    alone += Error(clicked.Model(), truth);
    related += Error(known->Model(), truth);
    EXPECT_LT(known->Deviations(4).squaredNorm(), clicked.Deviations(4).squaredNorm());
  }
  EXPECT_LT(related, 0.6 * alone);
}

TEST(SurfaceCompletion, RefusesPointsThatAreNotOnIt)
{
  const auto prior = PlatePrior(14, false);
  Random random(14);
  const SurfacePrior::Case truth = BentPlates(random, 1).front();
  std::vector<SurfaceTouch> touches = TouchesOn(truth, Parameters(2), 0.5);
  SurfaceCompletion completion(prior, truth.CentroidWorld);
  ASSERT_TRUE(completion.Update(touches).IsOk());
  EXPECT_TRUE(completion.Judge().IsOk()) << completion.Judge().Message();
  for (std::size_t n = 0; n < touches.size(); n += 2)
  {
    touches[n].PointWorld += 14.0 * touches[n].Normal->normalized();
  }
  ASSERT_TRUE(completion.Update(touches).IsOk());
  EXPECT_NE(completion.Judge().Message().find("unlike those of the prior"), std::string::npos);
}

TEST(SurfaceCompletion, APointOutsideHoldsTheSurfaceBack)
{
  const auto prior = PlatePrior(15, false);
  const Vector3 click(0.0, 0.0, 0.0);
  SurfaceCompletion completion(prior, click);
  const Vector3 side = completion.Model().Point(Vector3::UnitY());
  const Vector3 outward = completion.Model().Normal(Vector3::UnitY());
  const SurfaceTouch beyond{side + 5.0 * outward, 0.5, {}, 0, true};
  ASSERT_TRUE(completion.Update({beyond}).IsOk());
  EXPECT_EQ(completion.Posterior().Coefficients(), prior->Mean);
  const SurfaceTouch inside{side - 3.0 * outward, 0.5, {}, 0, true};
  ASSERT_TRUE(completion.Update({inside}).IsOk());
  EXPECT_LT((completion.Model().Point(Vector3::UnitY()) - side).dot(outward), -2.0);
  EXPECT_EQ(completion.Distance(), 0.0);
}

TEST(SurfaceCompletion, DeviationsShrinkWhereItIsTouchedAndNextTouchesAreElsewhere)
{
  const auto prior = PlatePrior(16, false);
  Random random(16);
  const SurfacePrior::Case truth = BentPlates(random, 1).front();
  SurfaceCompletion completion(prior, truth.CentroidWorld);
  const double before = completion.Deviations(4).norm();
  const std::vector<Vector3> places = completion.NextTouches(4);
  ASSERT_EQ(places.size(), 4U);
  EXPECT_GT((places[0] - places[1]).norm(), 5.0);
  ASSERT_TRUE(completion.Update(TouchesOn(truth, Parameters(1), 0.5)).IsOk());
  EXPECT_LT(completion.Deviations(4).norm(), 0.5 * before);
  EXPECT_GE(completion.Deviations(4).minCoeff(), 0.5);
}

TEST(SurfaceCompletion, RefusesBadTouchesAndStaysAsItWas)
{
  SurfaceCompletion completion(PlatePrior(17, false), Vector3::Zero());
  const Eigen::VectorXd before = completion.Posterior().Coefficients();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(completion.Update({{Vector3(nan, 0, 0), 1.0}}).IsOk());
  EXPECT_FALSE(completion.Update({{Vector3(0, 0, 2000), 1.0}}).IsOk());
  EXPECT_FALSE(completion.Update({{Vector3::Zero(), 0.0}}).IsOk());
  EXPECT_FALSE(completion.Update({{Vector3::Zero(), 1.0, Vector3(0, 0, 0)}}).IsOk());
  EXPECT_EQ(completion.Posterior().Coefficients(), before);
  ASSERT_TRUE(completion.Update(std::vector<SurfaceTouch>(30, {Vector3::Zero(), 0.01})).IsOk());
  EXPECT_TRUE(completion.Posterior().Coefficients().allFinite());
}

TEST(OrganCompletion, OnePathCompletesBothKinds)
{
  Random random(18);
  const SurfacePrior::Case truth = BentPlates(random, 1).front();
  CompletionRequest request;
  request.Touches = TouchesOn(truth, Parameters(2), 1.0);
  request.Frequency = 4;
  request.NextCount = 3;
  OrganCompletion made;
  request.Prior = PlatePrior(18, true);
  ASSERT_TRUE(CompleteOrgan(request, made).IsOk());
  EXPECT_TRUE(std::holds_alternative<SurfaceModel>(made.Model));
  EXPECT_EQ(made.Deviations.size(), 162);
  EXPECT_EQ(made.Next.size(), 3U);
  EXPECT_EQ(made.PriorCases, 24U);
  request.Known = truth.Known;
  ASSERT_TRUE(CompleteOrgan(request, made).IsOk());
  request.Prior = OrganPrior();
  EXPECT_NE(CompleteOrgan(request, made).Message().find("radial"), std::string::npos);
  request.Known.reset();
  ASSERT_TRUE(CompleteOrgan(request, made).IsOk());
  EXPECT_TRUE(std::holds_alternative<RadialModel>(made.Model));
  request.Prior = PlatePrior(18, false);
  request.Known = truth.Known;
  EXPECT_NE(CompleteOrgan(request, made).Message().find("no other organ"), std::string::npos);
  request.Known.reset();
  request.Touches.clear();
  EXPECT_NE(CompleteOrgan(request, made).Message().find("no centre"), std::string::npos);
}
} // namespace
} // namespace palpate::surface_completion_test
