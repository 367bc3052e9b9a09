#include "TaskPower.h"

#include "ProbabilityDistributions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

namespace palpate
{
namespace
{
constexpr double Tail = 0.025; // of a 95 % interval

struct ConditionMeans
{
  std::array<double, 2> Sums{{0.0, 0.0}};
  std::array<int, 2> Counts{{0, 0}};
};

// P of the paired t-test; 0 for a difference without any scatter.
double PairedProbability(const std::vector<double>& differences)
{
  const auto n = static_cast<double>(differences.size());
  double mean = 0.0;
  for (const double difference : differences)
  {
    mean += difference / n;
  }
  double squares = 0.0;
  for (const double difference : differences)
  {
    squares += (difference - mean) * (difference - mean);
  }
  const double error = std::sqrt(squares / (n - 1.0) / n);
  // The same differences to rounding.
  if (!(error > 1e-12 * std::abs(mean)))
  {
    return mean == 0.0 ? 1.0 : 0.0;
  }
  return StudentTwoSided(mean / error, n - 1.0);
}

StudyPower PowerOf(const std::vector<double>& pool, int participants, int studies,
                   std::mt19937_64& random)
{
  int found = 0;
  std::vector<double> drawn(static_cast<std::size_t>(participants));
  for (int study = 0; study < studies; ++study)
  {
    for (double& difference : drawn)
    {
      difference = pool[random() % pool.size()];
    }
    found += PairedProbability(drawn) < TaskComparison::Significance ? 1 : 0;
  }
  return BinomialInterval(participants, studies, found);
}

// Differences of participants that did both conditions; sums of their means into `comparison`.
std::vector<double> DifferencesOf(const TaskResults& results, TaskComparison& comparison)
{
  std::map<std::size_t, ConditionMeans> means;
  for (const TaskResult& row : results.Rows)
  {
    const double value = ValueOf(row, results.Kind, comparison.Measure);
    const bool isSecond = row.End.Condition == comparison.Second;
    if (!row.End.IsTraining && std::isfinite(value) &&
        (isSecond || row.End.Condition == comparison.First))
    {
      means[row.Participant].Sums.at(isSecond ? 1 : 0) += value;
      ++means[row.Participant].Counts.at(isSecond ? 1 : 0);
    }
  }
  std::vector<double> differences;
  for (const auto& [participant, mean] : means)
  {
    if (mean.Counts[0] > 0 && mean.Counts[1] > 0)
    {
      const double first = mean.Sums[0] / mean.Counts[0];
      const double second = mean.Sums[1] / mean.Counts[1];
      comparison.FirstMean += first;
      comparison.SecondMean += second;
      differences.push_back(second - first);
    }
  }
  return differences;
}
} // namespace

StudyPower BinomialInterval(int participants, int studies, int found)
{
  StudyPower power{participants, studies, found, 0.0, 1.0};
  const double k = found;
  const double n = studies;
  if (found > 0)
  {
    const double f = FisherUpperQuantile(Tail, 2.0 * (n - k + 1.0), 2.0 * k);
    power.Low = k / (k + (n - k + 1.0) * f);
  }
  if (found < studies)
  {
    const double f = FisherUpperQuantile(Tail, 2.0 * (k + 1.0), 2.0 * (n - k));
    power.High = (k + 1.0) * f / (n - k + (k + 1.0) * f);
  }
  return power;
}

TaskComparison CompareConditions(const TaskResults& results, int studies, std::uint64_t seed)
{
  TaskComparison comparison;
  comparison.Measure = PrimaryMeasure(results.Kind);
  if (results.Conditions.size() < 2)
  {
    return comparison;
  }
  comparison.First = results.Conditions[0];
  comparison.Second = results.Conditions[1];
  const std::vector<double> pool = DifferencesOf(results, comparison);
  comparison.Participants = static_cast<int>(pool.size());
  if (pool.size() < 2)
  {
    return comparison;
  }
  const auto n = static_cast<double>(pool.size());
  comparison.FirstMean /= n;
  comparison.SecondMean /= n;
  comparison.Difference = comparison.SecondMean - comparison.FirstMean;
  for (const double difference : pool)
  {
    comparison.DifferenceDeviation += std::pow(difference - comparison.Difference, 2) / (n - 1.0);
  }
  comparison.DifferenceDeviation = std::sqrt(comparison.DifferenceDeviation);
  comparison.PValue = PairedProbability(pool);
  std::mt19937_64 random(seed);
  for (const int participants : {4, 6, 8, 10, 12, 16, 20, 24, 32, 48})
  {
    comparison.Powers.push_back(PowerOf(pool, participants, studies, random));
  }
  for (auto power = comparison.Powers.rbegin();
       power != comparison.Powers.rend() && power->Low >= TaskComparison::Wanted; ++power)
  {
    comparison.Sufficient = power->Participants;
  }
  return comparison;
}
} // namespace palpate
