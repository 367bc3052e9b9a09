// PalpateSplitCohorts FOLDER BUMPED COHORTS PERMUTATIONS: rejections of a true null hypothesis and
// of bumps, in studies drawn from the cohort that `palpate fit` wrote into FOLDER and from its
// masks with bumps (PalpateFitBumps).
#include "CohortTable.h"
#include "SplitCohorts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
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
     {"told the place", &SplitResult::Told}}};

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

void ReportNull(SplitCohorts& cohorts, int count, const SplitSettings& settings)
{
  std::vector<SplitResult> results;
  for (int i = 0; i < count; ++i)
  {
    results.push_back(cohorts.Next(settings));
  }
  std::printf("No effect (5 %% are right), %d cohorts\n", count);
  for (std::size_t test = 0; test + 1 < Tests.size(); ++test) // the last one has no place
  {
    const auto rejected =
        std::count_if(results.begin(), results.end(),
                      [&](const SplitResult& one) { return one.*Tests[test].second <= Level; });
    std::printf("  %-16s %5.1f %%\n", Tests[test].first,
                100.0 * static_cast<double>(rejected) / count);
  }
  const auto [least, most] = BinomialInterval(count);
  std::printf("  99.9 %% interval of 5 %%: %.2f to %.2f %%\n", 100.0 * least / count,
              100.0 * most / count);
  std::printf("  p of single points: chi-squared %.1f of 10 bins (99.9 %%: 27.9)\n",
              Unevenness(results));
}

// A mean and its standard error.
struct MeanOf
{
  double Value = 0.0;
  double Error = 0.0;
};

MeanOf Average(const Eigen::VectorXd& values)
{
  const auto count = static_cast<double>(values.size());
  const double mean = values.mean();
  return {mean, std::sqrt((values.array() - mean).square().sum() / (count * (count - 1.0)))};
}

// Finds in the data of both kinds, by studies.
struct Finds
{
  double Ideal = 0.0;
  double Masks = 0.0;
  double OnlyOne = 0.0; ///< in one of them only

  Finds(const std::vector<BumpedResult>& results, double SplitResult::*p)
  {
    for (const BumpedResult& one : results)
    {
      const bool ideal = one.Ideal.*p <= Level;
      const bool masks = one.Masks.*p <= Level;
      this->Ideal += ideal ? 1.0 : 0.0;
      this->Masks += masks ? 1.0 : 0.0;
      this->OnlyOne += ideal != masks ? 1.0 : 0.0;
    }
  }
  double Ratio() const { return this->Masks / this->Ideal; }
  // Of a ratio of paired proportions, by its logarithm (Nam and Blackwelder, Stat. Med. 21, 2002).
  double RatioError() const
  {
    return this->Ratio() * std::sqrt(this->OnlyOne / (this->Masks * this->Ideal));
  }
};

void ReportFinds(const std::vector<BumpedResult>& results, bool hasEffect)
{
  const auto count = static_cast<double>(results.size());
  for (const auto& [name, p] : Tests)
  {
    if (p != &SplitResult::Told || hasEffect)
    {
      const Finds finds(results, p);
      std::printf("  %-16s ideal %5.1f %%, masks %5.1f %%, ratio %.3f +- %.3f\n", name,
                  100.0 * finds.Ideal / count, 100.0 * finds.Masks / count, finds.Ratio(),
                  finds.RatioError());
    }
  }
}

void ReportEstimates(const std::string& place, const std::vector<BumpedResult>& results,
                     const SplitCohorts& cohorts, const BumpedCases& bumped)
{
  const double truth = cohorts.True(bumped);
  Eigen::VectorXd ideal(static_cast<Eigen::Index>(results.size()));
  Eigen::VectorXd masks(ideal.size());
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    ideal[static_cast<Eigen::Index>(i)] = results[i].Ideal.Estimate - truth;
    masks[static_cast<Eigen::Index>(i)] = results[i].Masks.Estimate - truth;
  }
  const MeanOf idealBias = Average(ideal);
  const MeanOf masksBias = Average(masks);
  const MeanOf difference = Average(masks - ideal);
  const MeanOf found = Average(cohorts.Found(bumped));
  std::printf("  %-10s truth %.3f mm; estimate minus truth: ideal %+.3f +- %.3f mm, masks %+.3f +- "
              "%.3f mm, "
              "masks minus ideal %+.3f +- %.3f mm; all glands' fits find %.3f +- %.3f mm, the best "
              "model of their degree %.3f mm\n",
              place.c_str(), truth, idealBias.Value, idealBias.Error, masksBias.Value,
              masksBias.Error, difference.Value, difference.Error, found.Value, found.Error,
              cohorts.InModelsDegree(bumped));
}

void ReportBumps(SplitCohorts& cohorts, const std::filesystem::path& folder, int height, int count,
                 const SplitSettings& settings)
{
  const std::size_t places = BumpPlaces().size();
  const Eigen::MatrixXd flat = cohorts.ReadCoefficients(folder / "flat");
  std::vector<BumpedResult> all;
  std::printf("A bump of %d mm, %.0f mm wide, %d cohorts, %d modes as covariates\n", height,
              BumpExtent, count, static_cast<int>(settings.Modes));
  for (std::size_t place = 0; place < places; ++place)
  {
    const BumpPlace& where = BumpPlaces()[place];
    const BumpedCases bumped = cohorts.WithBump(
        cohorts.BumpAt(where, height), flat,
        height == 0
            ? flat
            : cohorts.ReadCoefficients(folder / (where.Name + "-" + std::to_string(height))));
    std::vector<BumpedResult> results;
    for (int i = 0; i < count / static_cast<int>(places); ++i)
    {
      results.push_back(cohorts.Next(settings, bumped));
    }
    ReportEstimates(where.Name, results, cohorts, bumped);
    ReportFinds(results, height > 0);
    all.insert(all.end(), results.begin(), results.end());
  }
  std::printf(" all places\n");
  ReportFinds(all, height > 0);
  std::fflush(stdout);
}

int RunAll(const std::string& folder, const std::string& bumped, int count, int permutations)
{
  SplitCohorts cohorts(MakeCohortGroup(CohortTable::Read(folder + "/cohort.csv"), folder, "",
                                       AlignmentAxes::Patient),
                       1);
  SplitSettings settings;
  settings.Permutations = permutations;
  ReportNull(cohorts, count, settings);
  for (const int height : {0, 1, 2, 3})
  {
    ReportBumps(cohorts, bumped, height, count, settings);
  }
  settings.Modes = 10;
  for (const int height : {0, 1})
  {
    ReportBumps(cohorts, bumped, height, count, settings);
  }
  return 0;
}
} // namespace
} // namespace palpate::test

int main(int count, char** arguments)
{
  if (count != 5)
  {
    std::fprintf(stderr, "usage: PalpateSplitCohorts FOLDER BUMPED COHORTS PERMUTATIONS\n");
    return 2;
  }
  try
  {
    return palpate::test::RunAll(arguments[1], arguments[2], std::atoi(arguments[3]),
                                 std::atoi(arguments[4]));
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
