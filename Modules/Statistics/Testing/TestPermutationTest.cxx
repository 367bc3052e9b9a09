#include "PermutationTest.h"
#include "ProbabilityDistributions.h"
#include "RandomStudy.h"

#include <algorithm>
#include <numeric>

namespace palpate::test
{
namespace
{
/// A ring of points of 1 mm^2 each.
SurfaceGraph Ring(int count)
{
  SurfaceGraph ring;
  ring.Areas.assign(static_cast<std::size_t>(count), 1.0);
  for (int i = 0; i < count; ++i)
  {
    ring.Edges.emplace_back(i, (i + 1) % count);
  }
  return ring;
}

PermutationTest TestedOn(const SurfaceGraph& surface, const LinearDesign& design,
                         const Eigen::MatrixXd& outcomes, int count)
{
  PermutationTest test;
  PermutationSettings settings;
  settings.Count = count;
  EXPECT_TRUE(TestByPermutation(FindEffectSpace(design, design.Terms[0]), outcomes, surface,
                                settings, {}, test)
                  .IsOk());
  return test;
}

PermutationTest Tested(const LinearDesign& design, std::size_t term,
                       const Eigen::MatrixXd& outcomes, int count, unsigned threads = 1)
{
  PermutationTest test;
  PermutationSettings settings;
  settings.Count = count;
  settings.Threads = threads;
  EXPECT_TRUE(TestByPermutation(FindEffectSpace(design, design.Terms[term]), outcomes,
                                Ring(static_cast<int>(outcomes.cols())), settings, {}, test)
                  .IsOk());
  return test;
}

TEST(PermutationTest, StatisticsAreThoseOfTheLinearModel)
{
  const LinearDesign design = DesignOf(RandomCovariates(30, 1), "~ age + center");
  const Eigen::MatrixXd outcomes = RandomOutcomes(30, 12, 2);
  const LinearModel model = FitLinearModel(design, outcomes);
  const Eigen::VectorXd t = model.Coefficients.row(1).cwiseQuotient(model.StandardErrors.row(1));
  EXPECT_LT((Tested(design, 0, outcomes, 10).Statistic - t).cwiseAbs().maxCoeff(), 1e-10);
  const Eigen::VectorXd f = TestTerm(design, design.Terms[1], model, outcomes).F;
  EXPECT_LT((Tested(design, 1, outcomes, 10).Statistic.cwiseAbs2() - f).cwiseAbs().maxCoeff(),
            1e-10);
}

TEST(PermutationTest, DoesNotDependOnTheNumberOfThreads)
{
  const LinearDesign design = DesignOf(RandomCovariates(20, 1), "~ age + sex");
  const Eigen::MatrixXd outcomes = RandomOutcomes(20, 30, 2);
  const PermutationTest one = Tested(design, 0, outcomes, 203, 1);
  const PermutationTest three = Tested(design, 0, outcomes, 203, 3);
  EXPECT_EQ(one.P, three.P);
  EXPECT_EQ(one.FamilyP, three.FamilyP);
  EXPECT_EQ(one.EnhancedP, three.EnhancedP);
  EXPECT_EQ(one.WholeP, three.WholeP);
}

// All 7! orders, refitted one by one, against random ones.
TEST(PermutationTest, ApproachesTheRefitsOfAllOrders)
{
  const LinearDesign design = DesignOf(RandomCovariates(7, 21), "~ age + psa");
  const Eigen::MatrixXd outcomes = RandomOutcomes(7, 2, 22);
  const EffectSpace space = FindEffectSpace(design, design.Terms[0]);
  const Eigen::MatrixXd fitted = space.Others * (space.Others.transpose() * outcomes);
  const Eigen::MatrixXd residuals = outcomes - fitted;
  const auto largest = [&](const Eigen::MatrixXd& y)
  { return TestTerm(design, design.Terms[0], FitLinearModel(design, y), y).F; };
  const Eigen::VectorXd observed = largest(outcomes);
  std::vector<int> order(7);
  std::iota(order.begin(), order.end(), 0);
  Eigen::Vector2d reached = Eigen::Vector2d::Zero();
  Eigen::Vector2d family = Eigen::Vector2d::Zero();
  do
  {
    Eigen::MatrixXd permuted(7, 2);
    for (int i = 0; i < 7; ++i)
    {
      permuted.row(i) = residuals.row(order[static_cast<std::size_t>(i)]);
    }
    const Eigen::VectorXd f = largest(fitted + permuted);
    reached += (f.array() >= observed.array() * (1.0 - 1e-9)).cast<double>().matrix();
    family += (observed.array() * (1.0 - 1e-9) <= f.maxCoeff()).cast<double>().matrix();
  } while (std::next_permutation(order.begin(), order.end()));
  const PermutationTest test = Tested(design, 0, outcomes, 40000);
  // Four standard errors of a share of 40,000.
  EXPECT_LT((test.P - reached / 5040.0).cwiseAbs().maxCoeff(), 0.01);
  EXPECT_LT((test.FamilyP - family / 5040.0).cwiseAbs().maxCoeff(), 0.01);
}

// Of the 20 ways to divide six cases into two groups of three, the observed one and its opposite
// have the largest F; many orders equal them up to rounding.
TEST(PermutationTest, SingleOutcomeIsItsOwnFamily)
{
  CovariateTable table({"a", "b", "c", "d", "e", "f"});
  table.Add("group", {"ill", "ill", "ill", "well", "well", "well"});
  const Eigen::MatrixXd outcome =
      (Eigen::VectorXd(6) << 1.13, 2.71, 3.07, 11.9, 13.3, 17.7).finished();
  const PermutationTest test = TestedOn({{1.0}, {}}, DesignOf(table, "~ group"), outcome, 4000);
  EXPECT_NEAR(test.P[0], 0.1, 0.02); // four standard errors
  EXPECT_EQ(test.FamilyP[0], test.P[0]);
  EXPECT_EQ(test.EnhancedP[0], test.P[0]);
  EXPECT_EQ(test.WholeP, test.P[0]);
}

TEST(PermutationTest, WholeSurfaceWeighsPointsByTheirArea)
{
  const LinearDesign design = DesignOf(RandomCovariates(20, 1), "~ age + sex");
  const Eigen::MatrixXd outcomes = RandomOutcomes(20, 2, 3);
  Eigen::MatrixXd finer(20, 4); // the second point's area in three parts
  finer << outcomes, outcomes.col(1), outcomes.col(1);
  const PermutationTest one = TestedOn({{1.0, 3.0}, {}}, design, outcomes, 199);
  const PermutationTest parts = TestedOn({{1.0, 1.0, 1.0, 1.0}, {}}, design, finer, 199);
  EXPECT_NEAR(one.WholeF, parts.WholeF, 1e-12 * one.WholeF);
  EXPECT_EQ(one.WholeP, parts.WholeP);
}

TEST(PermutationTest, OfNormalOutcomesApproachesTheParametricP)
{
  const LinearDesign design = DesignOf(RandomCovariates(60, 5), "~ age + sex");
  const Eigen::MatrixXd outcomes = RandomOutcomes(60, 10, 6);
  const TermTest exact =
      TestTerm(design, design.Terms[0], FitLinearModel(design, outcomes), outcomes);
  const PermutationTest test = Tested(design, 0, outcomes, 10000, 2);
  EXPECT_LT((test.P - exact.P).cwiseAbs().maxCoeff(), 0.03);
}

TEST(PermutationTest, FindsAnEffectWhereItIs)
{
  const LinearDesign design = DesignOf(RandomCovariates(40, 5), "~ sex + age");
  Eigen::MatrixXd outcomes = 0.5 * RandomOutcomes(40, 60, 6);
  outcomes.middleCols(20, 10) -= design.Matrix.col(1).replicate(1, 10);
  const PermutationTest test = Tested(design, 0, outcomes, 999, 2);
  EXPECT_LT(test.WholeP, 0.002);
  for (Eigen::Index k = 0; k < 60; ++k)
  {
    const bool isThere = k >= 20 && k < 30;
    EXPECT_EQ(test.EnhancedP[k] < 0.05, isThere) << k;
    EXPECT_LT(isThere ? test.Statistic[k] : -1.0, 0.0) << k;
  }
}

TEST(PermutationTest, HasNoEffectWhereNothingVaries)
{
  const LinearDesign design = DesignOf(RandomCovariates(15, 5), "~ age");
  Eigen::MatrixXd outcomes = RandomOutcomes(15, 5, 6);
  outcomes.col(2).setConstant(0.0);
  const PermutationTest test = Tested(design, 0, outcomes, 99);
  EXPECT_EQ(test.Statistic[2], 0.0);
  EXPECT_EQ(test.P[2], 1.0);
  EXPECT_EQ(test.EnhancedP[2], 1.0);
}

// A smaller version of Utilities/null_cohorts.sh: the share of rejections of a true null
// hypothesis.
TEST(PermutationTest, RejectsATrueNullInOneOfTwentyCohorts)
{
  constexpr int Cohorts = 400;
  int whole = 0;
  int family = 0;
  int enhanced = 0;
  for (unsigned cohort = 0; cohort < Cohorts; ++cohort)
  {
    const LinearDesign design = DesignOf(RandomCovariates(20, 1000 + cohort), "~ sex + age");
    // Skewed and dependent on age.
    Eigen::MatrixXd outcomes = RandomOutcomes(20, 12, 5000 + cohort).array().exp();
    outcomes += design.Matrix.col(2) * Eigen::RowVectorXd::LinSpaced(12, -1.0, 1.0);
    const PermutationTest test = Tested(design, 0, outcomes, 199);
    whole += test.WholeP <= 0.05 ? 1 : 0;
    family += test.FamilyP.minCoeff() <= 0.05 ? 1 : 0;
    enhanced += test.EnhancedP.minCoeff() <= 0.05 ? 1 : 0;
  }
  for (const int rejections : {whole, family, enhanced})
  {
    // The 99.9 % interval of a binomial of 400 and 0.05.
    EXPECT_GE(rejections, 7);
    EXPECT_LE(rejections, 36);
  }
}

TEST(PermutationTest, CanBeCancelled)
{
  const LinearDesign design = DesignOf(RandomCovariates(15, 5), "~ age");
  PermutationTest test;
  int calls = 0;
  EXPECT_FALSE(TestByPermutation(
                   FindEffectSpace(design, design.Terms[0]), RandomOutcomes(15, 5, 6), Ring(5), {},
                   [&](double) { return ++calls < 3; }, test)
                   .IsOk());
  EXPECT_EQ(calls, 3);
}
} // namespace
} // namespace palpate::test
