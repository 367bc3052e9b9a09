#include "BernsteinCrossings.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace palpate::bernstein_crossings_test
{
namespace
{
using Cubic = BernsteinCrossings<3>;
using Nonic = BernsteinCrossings<9>;

template <int Degree>
std::vector<double> CrossingsOf(const std::vector<double>& coefficients)
{
  const BernsteinCrossings<Degree> crossings(coefficients.data());
  std::vector<double> parameters;
  parameters.reserve(Degree);
  for (int n = 0; n < crossings.Count(); ++n)
  {
    parameters.push_back(crossings.Parameter(n));
  }
  return parameters;
}

// sign (u - r0) (u - r1) ... as Bernstein coefficients: products are convolutions once the
// coefficients are multiplied by their binomials.
std::vector<double> WithRoots(const std::vector<double>& roots, double sign)
{
  std::vector<double> scaled{sign};
  for (const double root : roots)
  {
    std::vector<double> product(scaled.size() + 1, 0.0);
    for (std::size_t n = 0; n < scaled.size(); ++n)
    {
      product[n] -= root * scaled[n];
      product[n + 1] += (1.0 - root) * scaled[n];
    }
    scaled = product;
  }
  double binomial = 1.0;
  const auto degree = static_cast<double>(roots.size());
  for (std::size_t n = 0; n < scaled.size(); ++n)
  {
    scaled[n] /= binomial;
    binomial *= (degree - static_cast<double>(n)) / (static_cast<double>(n) + 1.0);
  }
  return scaled;
}

TEST(BernsteinCrossings, FindsTheKnownRoots)
{
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> place(-0.5, 1.5);
  for (int round = 0; round < 2000; ++round)
  {
    std::vector<double> roots(round % 2 == 0 ? 3 : 9);
    for (double& root : roots)
    {
      root = place(random);
    }
    std::sort(roots.begin(), roots.end());
    double nearest = 1.0;
    for (std::size_t n = 0; n + 1 < roots.size(); ++n)
    {
      nearest = std::min(nearest, roots[n + 1] - roots[n]);
    }
    if (nearest < 0.02)
    {
      continue; // ill-conditioned, which is not tested here
    }
    const std::vector<double> coefficients = WithRoots(roots, round % 4 < 2 ? 1.0 : -1.0);
    const std::vector<double> found =
        roots.size() == 3 ? CrossingsOf<3>(coefficients) : CrossingsOf<9>(coefficients);
    roots.erase(std::remove_if(roots.begin(), roots.end(),
                               [](double root) { return root < 0.0 || root > 1.0; }),
                roots.end());
    ASSERT_EQ(found.size(), roots.size()) << "round " << round;
    for (std::size_t n = 0; n < roots.size(); ++n)
    {
      ASSERT_NEAR(found[n], roots[n], 1e-8) << "round " << round;
    }
  }
}

TEST(BernsteinCrossings, CountHasTheParityOfTheEndSigns)
{
  std::mt19937_64 random(42);
  for (int round = 0; round < 20000; ++round)
  {
    std::vector<double> coefficients(10);
    for (double& c : coefficients)
    {
      c = static_cast<double>(random() % 5) - 2.0;
    }
    const bool differ = (coefficients.front() >= 0.0) != (coefficients.back() >= 0.0);
    const Nonic crossings(coefficients.data());
    ASSERT_EQ(crossings.Count() % 2 == 1, differ) << "round " << round;
    for (int n = 1; n < crossings.Count(); ++n)
    {
      ASSERT_LE(crossings.Parameter(n - 1), crossings.Parameter(n));
    }
  }
}

TEST(BernsteinCrossings, ZerosAtTheEndsAreInside)
{
  EXPECT_EQ(CrossingsOf<3>({0, 1, 1, 1}), (std::vector<double>{}));
  EXPECT_EQ(CrossingsOf<3>({0, 0, 0, 0}), (std::vector<double>{}));
  EXPECT_EQ(CrossingsOf<3>({0, -1, -1, -1}), (std::vector<double>{0.0}));
  EXPECT_EQ(CrossingsOf<3>({-1, -1, -1, 0}), (std::vector<double>{1.0}));
  // (1 - u) u (2 u - 1) is zero at both ends and at 1/2.
  EXPECT_EQ(CrossingsOf<3>({0, -1, 1, 0}), (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(CrossingsOf<3>({0, 1, -1, 0}), (std::vector<double>{0.5, 1.0}));
}

// 2 u^3 - 5 u^2 + 3 u - 1/2 = (u - 1/2) (2 u^2 - 4 u + 1): bisection puts a root on the cut, and
// the left half has another one at its end, or just beyond.
TEST(BernsteinCrossings, FindsNeighboursOfARootAtTheBisection)
{
  const std::vector<double> whole = CrossingsOf<3>({-0.5, 0.5, -1.0 / 6.0, -0.5});
  ASSERT_EQ(whole.size(), 2u);
  EXPECT_NEAR(whole[0], 1.0 - std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(whole[1], 0.5, 1e-12);
  for (const double end : {0.0, 1e-17, 1e-14, 1e-300})
  {
    const std::vector<double> left = CrossingsOf<3>({-0.5, 0.0, 1.0 / 12.0, end});
    ASSERT_EQ(left.size(), 1u) << end;
    EXPECT_NEAR(left[0], 2.0 - std::sqrt(2.0), 1e-12) << end;
    const std::vector<double> mirrored = CrossingsOf<3>({end, 1.0 / 12.0, 0.0, -0.5});
    ASSERT_EQ(mirrored.size(), 1u) << end;
    EXPECT_NEAR(mirrored[0], std::sqrt(2.0) - 1.0, 1e-12) << end;
  }
}

TEST(BernsteinCrossings, SeparatesTwoCrossingsDownToRounding)
{
  for (const double gap : {1e-2, 1e-4, 1e-6})
  {
    const std::vector<double> found = CrossingsOf<3>(WithRoots({0.3, 0.3 + gap, 2.0}, 1.0));
    ASSERT_EQ(found.size(), 2u) << gap;
    EXPECT_NEAR(found[1] - found[0], gap, 1e-14 / gap);
  }
}

TEST(BernsteinCrossings, ValueAndSlopeMatchThePolynomial)
{
  // u^3 and its derivative.
  const double coefficients[] = {0.0, 0.0, 0.0, 1.0};
  double slope = 0.0;
  EXPECT_DOUBLE_EQ(Cubic::Evaluate(coefficients, 0.75, slope), 0.421875);
  EXPECT_DOUBLE_EQ(slope, 1.6875);
}
} // namespace
} // namespace palpate::bernstein_crossings_test
