#include "TradePage.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate::trade_pareto_test
{
namespace
{
using Point = std::pair<double, double>;

bool Dominates(const Point& a, const Point& b)
{
  return a.first <= b.first && a.second <= b.second && a != b;
}

TEST(TradePareto, KeepsExactlyUndominatedPoints)
{
  std::mt19937_64 random(17);
  // Few distinct numbers, so that many are equal.
  std::uniform_int_distribution<int> number(0, 12);
  for (int round = 0; round < 200; ++round)
  {
    std::vector<Point> points;
    for (int p = 0; p < 25; ++p)
    {
      const double cost = number(random);
      points.emplace_back(cost, number(random));
    }
    const std::vector<std::size_t> front = ParetoFront(points);
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      const bool isDominated =
          std::any_of(points.begin(), points.end(),
                      [&](const Point& other) { return Dominates(other, points[p]); });
      const bool isKept = std::find(front.begin(), front.end(), p) != front.end();
      EXPECT_NE(isKept, isDominated) << "round " << round << ", point " << p;
    }
    EXPECT_TRUE(std::is_sorted(front.begin(), front.end(),
                               [&](std::size_t a, std::size_t b)
                               { return points[a].first < points[b].first; }));
  }
}

TEST(TradePareto, RejectsNonFinitePoints)
{
  const std::vector<std::size_t> front =
      ParetoFront({{NAN, 0.0}, {1.0, 5.0}, {0.0, NAN}, {INFINITY, 1.0}});
  EXPECT_EQ(front, std::vector<std::size_t>{1});
}
} // namespace
} // namespace palpate::trade_pareto_test
