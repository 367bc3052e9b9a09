#include "ProofCount.h"
#include "RProgram.h"
#include "RandomStudy.h"
#include "SideAsymmetry.h"

namespace palpate::test
{
namespace
{
PermutationSettings FlipsOf(int count)
{
  PermutationSettings settings;
  settings.Count = count;
  return settings;
}

// Sides of `count` individuals with correlated coordinates of different size.
Eigen::MatrixXd RandomDifferences(Eigen::Index count, Eigen::Index points, unsigned seed)
{
  const Eigen::MatrixXd wide = RandomOutcomes(count, 3, seed) * RandomOutcomes(3, points, seed + 1);
  return wide + 0.3 * RandomOutcomes(count, points, seed + 2);
}

TEST(SideAsymmetry, AnalysisOfVarianceIsThatOfR)
{
  if (!RProgram::IsThere())
  {
    GTEST_SKIP() << "R (r-base-core), the judge, is not installed";
  }
  constexpr int Count = 9;
  constexpr int Coordinates = 4;
  const Eigen::MatrixXd left = RandomOutcomes(Count, Coordinates, 3).array() + 0.4;
  const Eigen::MatrixXd right = RandomOutcomes(Count, Coordinates, 4);
  Eigen::MatrixXd both(2 * Count, Coordinates);
  both << left, right;
  std::vector<std::string> names;
  std::vector<std::string> individuals;
  std::vector<std::string> sides;
  for (int i = 0; i < 2 * Count; ++i)
  {
    names.push_back(std::to_string(i));
    individuals.push_back("i" + std::to_string(i % Count));
    sides.emplace_back(i < Count ? "left" : "right");
  }
  CovariateTable table(names);
  table.Add("individual", individuals);
  table.Add("side", sides);
  const RProgram judge;
  // Two rows per individual: what is left beside both is their interaction.
  const std::vector<double> said = judge.Run(
      table, both,
      "s <- Reduce(`+`, lapply(1:4, function(k) { a <- summary(aov(y[, k] ~ individual + side, "
      "d))[[1]]; as.matrix(a[, c('Sum Sq', 'Df')]) }))\n"
      "out(t(s)); out(s[2, 1] / s[2, 2] / (s[3, 1] / s[3, 2]))");
  ASSERT_EQ(said.size(), 7U) << judge.Log();
  const SideAnova anova = FindSideAnova(left, right, Coordinates, Coordinates);
  const std::vector<double> ours{
      anova.Individual.Squares,  anova.Individual.Degrees,  anova.Side.Squares, anova.Side.Degrees,
      anova.Interaction.Squares, anova.Interaction.Degrees, anova.SideF()};
  for (std::size_t i = 0; i < ours.size(); ++i)
  {
    EXPECT_NEAR(ours[i], said[i], 1e-10 * said[i]) << i;
  }
}

// All 2^6 flips, listed.
TEST(SideAsymmetry, SharesAreThoseOfAllFlips)
{
  const Eigen::MatrixXd differences = RandomDifferences(6, 5, 11).array() + 0.3;
  const std::vector<double> areas{1.0, 2.0, 0.5, 1.0, 3.0};
  SideTest test;
  ASSERT_TRUE(TestSides(differences, areas, FlipsOf(40000), {}, test).IsOk());
  double whole = 0.0;
  Eigen::VectorXd family = Eigen::VectorXd::Zero(5);
  for (int flip = 0; flip < 64; ++flip)
  {
    Eigen::MatrixXd flipped = differences;
    for (int i = 0; i < 6; ++i)
    {
      flipped.row(i) *= (flip >> i & 1) == 0 ? 1.0 : -1.0;
    }
    SideTest one;
    ASSERT_TRUE(TestSides(flipped, areas, FlipsOf(0), {}, one).IsOk());
    whole += one.WholeF > test.WholeF - 1e-9 ? 1.0 / 64.0 : 0.0;
    const double largest = one.Statistic.cwiseAbs().maxCoeff();
    for (Eigen::Index k = 0; k < 5; ++k)
    {
      family[k] += largest > std::abs(test.Statistic[k]) - 1e-9 ? 1.0 / 64.0 : 0.0;
    }
  }
  // 40,000 random flips have a standard error of 0.0025 at most.
  EXPECT_NEAR(test.WholeP, whole, 0.01);
  EXPECT_LT((test.FamilyP - family).cwiseAbs().maxCoeff(), 0.01);
}

TEST(SideAsymmetry, AtEachPointIsThePairedTest)
{
  const Eigen::MatrixXd differences = RandomDifferences(12, 3, 5).array() + 0.5;
  SideTest test;
  ASSERT_TRUE(TestSides(differences, {1.0, 1.0, 1.0}, FlipsOf(0), {}, test).IsOk());
  for (Eigen::Index k = 0; k < 3; ++k)
  {
    const Eigen::ArrayXd column = differences.col(k);
    const double deviation = std::sqrt((column - column.mean()).square().sum() / 11.0);
    EXPECT_NEAR(test.Mean[k], column.mean(), 1e-14);
    EXPECT_NEAR(test.Deviation[k], deviation, 1e-13);
    EXPECT_NEAR(test.Statistic[k], column.mean() / deviation * std::sqrt(12.0), 1e-12);
  }
  const Eigen::MatrixXd nothing = Eigen::MatrixXd::Zero(4, 3);
  ASSERT_TRUE(TestSides(nothing, {1.0, 1.0, 1.0}, FlipsOf(99), {}, test).IsOk());
  EXPECT_EQ(test.WholeP, 1.0);
  EXPECT_EQ(test.FamilyP.minCoeff(), 1.0);
}

TEST(SideAsymmetry, StopsIfCancelled)
{
  SideTest test;
  EXPECT_FALSE(
      TestSides(
          RandomDifferences(4, 2, 1), {1.0, 1.0}, FlipsOf(99), [](double) { return false; }, test)
          .IsOk());
}

// Within 3.3 standard deviations of the binomial distribution.
TEST(SideAsymmetryTypeOne, IsFivePercent)
{
  const int count = ProofCount(2000, 10000);
  int whole = 0;
  int family = 0;
  for (int i = 0; i < count; ++i)
  {
    SideTest test;
    ASSERT_TRUE(TestSides(RandomDifferences(10 + i % 15, 20, 100 + 3 * static_cast<unsigned>(i)),
                          std::vector<double>(20, 1.0), FlipsOf(199), {}, test)
                    .IsOk());
    whole += test.WholeP <= 0.05 ? 1 : 0;
    family += test.FamilyP.minCoeff() <= 0.05 ? 1 : 0;
  }
  const double margin = 3.3 * std::sqrt(0.05 * 0.95 * count);
  EXPECT_NEAR(whole, 0.05 * count, margin);
  EXPECT_NEAR(family, 0.05 * count, margin);
}
} // namespace
} // namespace palpate::test
