#include "PairedBenchmark.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <map>

namespace palpate::bench
{
namespace
{
constexpr int Repetitions = 20;
constexpr double RepetitionSeconds = 0.05;

// Keeps the times of every repetition, by name.
class Collector : public benchmark::BenchmarkReporter
{
public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override
  {
    for (const Run& run : runs)
    {
      if (run.run_type == Run::RT_Iteration)
      {
        this->Times[run.run_name.function_name].push_back(run.GetAdjustedRealTime());
      }
    }
  }

  double Shortest(const std::string& name) const
  {
    const std::vector<double>& times = this->Times.at(name);
    return *std::min_element(times.begin(), times.end());
  }

private:
  std::map<std::string, std::vector<double>> Times;
};

std::string AlternativeName(const PairedBenchmark& pair)
{
  return pair.Name + " against";
}

void Register(const std::string& name, const std::function<void()>& run)
{
  benchmark::RegisterBenchmark(name.c_str(),
                               [run](benchmark::State& state)
                               {
                                 for ([[maybe_unused]] auto step : state)
                                 {
                                   run();
                                 }
                               })
      ->Unit(benchmark::kNanosecond)
      ->UseRealTime()
      ->MinTime(RepetitionSeconds)
      ->Repetitions(Repetitions);
}
} // namespace

std::vector<std::string> Disagreements(const std::vector<PairedBenchmark>& pairs)
{
  std::vector<std::string> sentences;
  for (const PairedBenchmark& pair : pairs)
  {
    pair.Run();
    pair.RunAgainst();
    const std::string sentence = pair.Disagreement();
    if (!sentence.empty())
    {
      sentences.push_back(pair.Name + " and " + pair.Against + ": " + sentence);
    }
  }
  return sentences;
}

std::vector<Comparison> Measure(const std::vector<PairedBenchmark>& pairs)
{
  benchmark::ClearRegisteredBenchmarks();
  for (const PairedBenchmark& pair : pairs)
  {
    Register(pair.Name, pair.Run);
    Register(AlternativeName(pair), pair.RunAgainst);
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  std::vector<Comparison> comparisons;
  comparisons.reserve(pairs.size());
  for (const PairedBenchmark& pair : pairs)
  {
    comparisons.push_back({pair.Name, collector.Shortest(pair.Name) / pair.Items, pair.Against,
                           collector.Shortest(AlternativeName(pair)) / pair.Items, 0.0, 0.0});
  }
  return comparisons;
}
} // namespace palpate::bench
