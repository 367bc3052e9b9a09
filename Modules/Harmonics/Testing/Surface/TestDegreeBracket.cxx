#include "DegreeBracket.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using palpate::DegreeBracket;

namespace
{
constexpr double Tolerance = 0.2;

struct Search
{
  int Best = -1;
  int Fits = 0;
};

// `rms` by degree.
Search SearchAmong(const std::vector<double>& rms, int least)
{
  const int highest = static_cast<int>(rms.size()) - 1;
  DegreeBracket bracket(Tolerance, least, highest);
  Search search;
  for (auto degree = bracket.Next(); degree && search.Fits <= highest; degree = bracket.Next())
  {
    EXPECT_GE(*degree, least);
    EXPECT_LE(*degree, highest);
    ++search.Fits;
    if (bracket.Add(*degree, rms[static_cast<std::size_t>(*degree)]))
    {
      search.Best = *degree;
    }
  }
  return search;
}

int SmallestOf(const std::vector<double>& rms, int least)
{
  int degree = least;
  while (degree + 1 < static_cast<int>(rms.size()) &&
         rms[static_cast<std::size_t>(degree)] > Tolerance)
  {
    ++degree;
  }
  return degree;
}
} // namespace

TEST(DegreeBracket, FindsSmallestDegreeOrTheNextOfSteadyDecay)
{
  for (const double decay : {0.02, 0.045, 0.06, 0.1, 0.25, 0.8})
  {
    for (const double first : {0.15, 0.3, 0.5, 0.9, 3.0})
    {
      std::vector<double> rms;
      for (int degree = 0; degree <= 40; ++degree)
      {
        rms.push_back(first * std::exp(-decay * (degree - 12)));
      }
      const Search search = SearchAmong(rms, 1);
      const int smallest = SmallestOf(rms, 1);
      EXPECT_GE(search.Best, smallest) << decay << " " << first;
      EXPECT_LE(search.Best, smallest + (smallest < 12 ? 0 : 1)) << decay << " " << first;
      EXPECT_LE(search.Fits, 5) << decay << " " << first;
    }
  }
}

TEST(DegreeBracket, MeetsToleranceNearTheSmallestDegree)
{
  std::mt19937 random(61);
  std::uniform_real_distribution<double> decays(0.02, 0.12);
  std::uniform_real_distribution<double> firsts(0.1, 0.8);
  int fits = 0;
  int isSmallest = 0;
  for (int trial = 0; trial < 500; ++trial)
  {
    std::vector<double> rms{5.0 * firsts(random)};
    while (rms.size() <= 40)
    {
      rms.push_back(rms.back() * std::exp(-decays(random)));
    }
    const Search search = SearchAmong(rms, 3);
    const int smallest = SmallestOf(rms, 3);
    EXPECT_GE(search.Best, smallest);
    EXPECT_LE(search.Best, smallest + 2); // decays differ by a factor of six
    isSmallest += search.Best == smallest ? 1 : 0;
    fits += search.Fits;
  }
  EXPECT_GE(isSmallest, 250);
  EXPECT_LE(fits, 500 * 4);
}

TEST(DegreeBracket, FindsStepOfBandLimitedBody)
{
  for (int step = 1; step <= 12; ++step)
  {
    std::vector<double> rms(41, 0.19);
    std::fill(rms.begin(), rms.begin() + step, 1.0);
    EXPECT_EQ(SearchAmong(rms, 1).Best, step);
  }
}

TEST(DegreeBracket, TakesHighestDegreeIfNoneMeets)
{
  EXPECT_EQ(SearchAmong(std::vector<double>(31, 1.0), 12).Best, 30);
}

TEST(DegreeBracket, TriesLeastDegreeAloneIfItMeets)
{
  const Search search = SearchAmong(std::vector<double>(31, 0.1), 12);
  EXPECT_EQ(search.Best, 12);
  EXPECT_EQ(search.Fits, 1);
}

TEST(DegreeBracket, EndsWhereResidualsRiseOrAreNotNumbers)
{
  std::vector<double> rms(41, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(SearchAmong(rms, 1).Best, 40);
  for (std::size_t degree = 0; degree < rms.size(); ++degree)
  {
    rms[degree] = 0.1 + 0.02 * static_cast<double>(degree);
  }
  EXPECT_LT(SearchAmong(rms, 1).Fits, 40);
}
