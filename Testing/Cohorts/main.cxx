// PalpateSplitCohorts FOLDER COHORTS PERMUTATIONS: rejections of a true null hypothesis and of
// bumps, in studies drawn from the cohort that `palpate fit` wrote into a folder.
#include "CohortTable.h"
#include "SplitCohorts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace palpate::test
{
namespace
{
constexpr double Level = 0.05;
constexpr std::array<std::pair<const char*, double SplitResult::*>, 5> Tests{
    {{"scores (Pillai)", &SplitResult::Scores},
     {"surface", &SplitResult::Surface},
     {"maximum", &SplitResult::Maximum},
     {"TFCE", &SplitResult::Enhanced},
     {"ideal", &SplitResult::Ideal}}};

// The counts between which a binomial of probability `Level` lies with 99.9 %.
std::pair<int, int> BinomialInterval(int count)
{
  double term = std::exp(count * std::log1p(-Level));
  double sum = 0.0;
  std::pair<int, int> interval{0, count};
  for (int k = 0; k <= count; ++k)
  {
    interval.first = sum + term <= 0.0005 ? k + 1 : interval.first;
    sum += term;
    if (sum >= 0.9995)
    {
      interval.second = k;
      break;
    }
    term *= (count - k) * Level / ((k + 1.0) * (1.0 - Level));
  }
  return interval;
}

void Report(const std::string& title, const std::vector<SplitResult>& results, bool hasEffect)
{
  std::printf("%s, %zu cohorts\n", title.c_str(), results.size());
  for (const auto& [name, p] : Tests)
  {
    const auto rejected =
        std::count_if(results.begin(), results.end(),
                      [member = p](const SplitResult& one) { return one.*member <= Level; });
    std::printf("  %-16s %5.1f %%\n", name,
                100.0 * static_cast<double>(rejected) / static_cast<double>(results.size()));
    if (!hasEffect && std::string(name) == "TFCE")
    {
      break;
    }
  }
}

// Chi-squared of the p-values of single points over ten bins; 27.9 is its 99.9 % point with 9
// degrees.
double Unevenness(const std::vector<SplitResult>& results)
{
  std::array<double, 10> bins{};
  for (const SplitResult& one : results)
  {
    bins[std::min<std::size_t>(static_cast<std::size_t>(10.0 * (one.Point - 1e-9)), 9)] += 1.0;
  }
  const double expected = static_cast<double>(results.size()) / 10.0;
  double sum = 0.0;
  for (const double bin : bins)
  {
    sum += (bin - expected) * (bin - expected) / expected;
  }
  return sum;
}

std::vector<SplitResult> Run(SplitCohorts& cohorts, int count, const SplitSettings& settings)
{
  std::vector<SplitResult> results;
  for (int i = 0; i < count; ++i)
  {
    results.push_back(cohorts.Next(settings));
  }
  return results;
}

int RunAll(const std::string& folder, int count, int permutations)
{
  SplitCohorts cohorts(MakeCohortGroup(CohortTable::Read(folder + "/cohort.csv"), folder, "",
                                       AlignmentAxes::Patient),
                       1);
  SplitSettings settings;
  settings.Permutations = permutations;
  const std::vector<SplitResult> null = Run(cohorts, count, settings);
  Report("No effect (5 % are right)", null, false);
  const auto [least, most] = BinomialInterval(count);
  std::printf("  99.9 %% interval of 5 %%: %.2f to %.2f %%\n", 100.0 * least / count,
              100.0 * most / count);
  std::printf("  p of single points: chi-squared %.1f of 10 bins (99.9 %%: 27.9)\n",
              Unevenness(null));
  for (const double bump : {1.0, 2.0, 3.0})
  {
    settings.Bump = bump;
    char title[64];
    std::snprintf(title, sizeof title, "A bump of %.0f mm, 20 mm wide", bump);
    Report(title, Run(cohorts, std::max(count / 10, 1), settings), true);
  }
  return 0;
}
} // namespace
} // namespace palpate::test

int main(int count, char** arguments)
{
  if (count != 4)
  {
    std::fprintf(stderr, "usage: PalpateSplitCohorts FOLDER COHORTS PERMUTATIONS\n");
    return 2;
  }
  try
  {
    return palpate::test::RunAll(arguments[1], std::atoi(arguments[2]), std::atoi(arguments[3]));
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
