#include "PairedBenchmark.h"

#include "InstructionCounts.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <map>

namespace palpate::bench
{
namespace
{
// Short repetitions, so that some run undisturbed; as many as fit into a second, but at least a few
// for long benchmarks.
constexpr double RepetitionSeconds = 0.002;
constexpr double TotalSeconds = 1.0;
constexpr int FewestRepetitions = 5;

int RepetitionsOf(const std::function<void()>& run)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  run();
  const std::chrono::duration<double> once = Clock::now() - start;
  return std::max(FewestRepetitions,
                  static_cast<int>(TotalSeconds / std::max(once.count(), RepetitionSeconds)));
}

// Stores the times of every repetition, by name.
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

  // The machine's best time, since any disturbance only adds to it.
  double Shortest(const std::string& name) const
  {
    const std::vector<double>& times = this->Times.at(name);
    return *std::min_element(times.begin(), times.end());
  }

private:
  std::map<std::string, std::vector<double>> Times;
};

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
      ->Repetitions(RepetitionsOf(run));
}
} // namespace

std::vector<std::string> Disagreements(const std::vector<PairedBenchmark>& pairs)
{
  std::vector<std::string> messages;
  for (const PairedBenchmark& pair : pairs)
  {
    pair.Run();
    pair.RunAgainst();
    const std::string message = pair.Disagreement();
    if (!message.empty())
    {
      messages.push_back(pair.Name + " and " + pair.Against + ": " + message);
    }
  }
  return messages;
}

std::vector<Comparison> Measure(const std::vector<PairedBenchmark>& pairs,
                                const InstructionCounts& counts)
{
  benchmark::ClearRegisteredBenchmarks();
  for (const PairedBenchmark& pair : pairs)
  {
    Register(pair.Name, pair.Run);
    Register(pair.AlternativeName(), pair.RunAgainst);
  }
  // A disturbance of the machine of about a second affects both sides alike.
  char program[] = "PalpateBenchmarks";
  char interleaving[] = "--benchmark_enable_random_interleaving=true";
  char* arguments[] = {program, interleaving, nullptr};
  int argumentCount = 2;
  benchmark::Initialize(&argumentCount, arguments);
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  std::vector<Comparison> comparisons;
  comparisons.reserve(pairs.size());
  for (const PairedBenchmark& pair : pairs)
  {
    const auto each = [&pair](std::optional<double> count)
    { return count ? std::optional<double>(*count / pair.Items) : std::nullopt; };
    comparisons.push_back({pair.Name, collector.Shortest(pair.Name) / pair.Items, pair.Against,
                           collector.Shortest(pair.AlternativeName()) / pair.Items,
                           each(counts.Of(pair.Name)), each(counts.Of(pair.AlternativeName()))});
  }
  return comparisons;
}
} // namespace palpate::bench
