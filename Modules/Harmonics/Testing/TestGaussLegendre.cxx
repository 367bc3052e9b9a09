#include "GaussLegendre.h"

#include "WorstCase.h"

#include <gtest/gtest.h>
#include <numeric>

namespace palpate::gauss_legendre_test
{
namespace
{
TEST(GaussLegendre, IsExactUpToTwiceTheNodes)
{
  for (int n = 1; n <= 100; ++n)
  {
    const GaussLegendre rule(n);
    test::WorstCase worst;
    for (int k = 0; k <= 2 * n - 1; ++k)
    {
      double sum = 0.0;
      for (std::size_t i = 0; i < rule.Nodes.size(); ++i)
      {
        sum += rule.Weights[i] * std::pow(rule.Nodes[i], k);
      }
      worst.Add(sum - (k % 2 == 0 ? 2.0 / (k + 1) : 0.0));
    }
    // Total weight 2; the rounding of a node is multiplied by k, but the k-th power then
    // contributes only about 1 / k: some tens of rounding errors.
    EXPECT_LE(worst.Value(), 5e-15) << n;
  }
}

TEST(GaussLegendre, IsInexactBeyondItsDegree)
{
  for (int n = 1; n <= 6; ++n)
  {
    const GaussLegendre rule(n);
    double sum = 0.0;
    for (std::size_t i = 0; i < rule.Nodes.size(); ++i)
    {
      sum += rule.Weights[i] * std::pow(rule.Nodes[i], 2 * n);
    }
    EXPECT_GT(std::abs(sum - 2.0 / (2 * n + 1)), 1e-5) << n;
  }
}

TEST(GaussLegendre, MatchesRuleOfThreeNodes)
{
  const GaussLegendre rule(3);
  const double tolerance = 2.3e-16; // one rounding
  EXPECT_NEAR(rule.Nodes[0], -std::sqrt(0.6), tolerance);
  EXPECT_NEAR(rule.Nodes[1], 0.0, tolerance);
  EXPECT_NEAR(rule.Nodes[2], std::sqrt(0.6), tolerance);
  EXPECT_NEAR(rule.Weights[0], 5.0 / 9.0, tolerance);
  EXPECT_NEAR(rule.Weights[1], 8.0 / 9.0, tolerance);
  EXPECT_NEAR(rule.Weights[2], 5.0 / 9.0, tolerance);
}

TEST(GaussLegendre, HasSortedNodesAndPositiveWeights)
{
  for (int n = 1; n <= 300; n += 13)
  {
    const GaussLegendre rule(n);
    ASSERT_EQ(rule.Nodes.size(), static_cast<std::size_t>(n));
    ASSERT_EQ(rule.Weights.size(), static_cast<std::size_t>(n));
    double previous = -1.0;
    for (std::size_t i = 0; i < rule.Nodes.size(); ++i)
    {
      EXPECT_GT(rule.Nodes[i], previous);
      EXPECT_GT(rule.Weights[i], 0.0);
      previous = rule.Nodes[i];
    }
    EXPECT_LT(previous, 1.0);
    // n roundings of weights that sum to 2.
    EXPECT_NEAR(std::accumulate(rule.Weights.begin(), rule.Weights.end(), 0.0), 2.0, n * 4e-16);
  }
}
} // namespace
} // namespace palpate::gauss_legendre_test
