// PalpateBenchmarks: times ours beside named alternatives, after checking that both agree.
#include "BoundsBenchmarks.h"
#include "ComparisonReport.h"
#include "EvaluationBenchmarks.h"
#include "FitBenchmarks.h"
#include "NearestBenchmarks.h"
#include "PairedBenchmark.h"
#include "PipelineBenchmarks.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <iostream>

namespace
{
using palpate::bench::PairedBenchmark;

// Every group of benchmarks joins here.
std::vector<PairedBenchmark> AllBenchmarks()
{
  std::vector<PairedBenchmark> all;
  for (auto& group : {palpate::bench::EvaluationBenchmarks(), palpate::bench::FitBenchmarks(),
                      palpate::bench::BoundsBenchmarks(), palpate::bench::NearestBenchmarks(),
                      palpate::bench::PipelineBenchmarks()})
  {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

std::vector<PairedBenchmark> Matching(const std::string& filter)
{
  std::vector<PairedBenchmark> pairs = AllBenchmarks();
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                             [&filter](const PairedBenchmark& pair)
                             { return pair.Name.find(filter) == std::string::npos; }),
              pairs.end());
  return pairs;
}
} // namespace

int main(int argc, char** argv)
{
  std::string filter;
  std::string json;
  bool verifyOnly = false;
  CLI::App app("Times Palpate beside named alternatives in the same run.");
  app.add_option("--filter", filter, "only benchmarks whose name contains this");
  app.add_option("--json", json, "file to write the comparisons to");
  app.add_flag("--verify-only", verifyOnly, "run everything once and compare the results only");
  CLI11_PARSE(app, argc, argv);

  const std::vector<PairedBenchmark> pairs = Matching(filter);
  if (pairs.empty())
  {
    std::cerr << "no benchmark's name contains " << filter << '\n';
    return 2;
  }
  const std::vector<std::string> disagreements = palpate::bench::Disagreements(pairs);
  for (const std::string& sentence : disagreements)
  {
    std::cerr << sentence << '\n';
  }
  if (!disagreements.empty() || verifyOnly)
  {
    return disagreements.empty() ? 0 : 1;
  }
  const auto comparisons = palpate::bench::Measure(pairs);
  palpate::bench::PrintTable(std::cout, comparisons);
  if (!json.empty())
  {
    std::ofstream file(json);
    file << palpate::bench::ToJson(comparisons) << '\n';
    return file.good() ? 0 : 1;
  }
  return 0;
}
