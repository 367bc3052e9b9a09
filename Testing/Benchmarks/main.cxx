// PalpateBenchmarks: times ours beside named alternatives, after checking that both agree.
#include "ComparisonReport.h"
#include "EvaluationBenchmarks.h"
#include "FitBenchmarks.h"
#include "InstructionCounts.h"
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
// Instructions of one item, where a run under callgrind has counted them.
void AddInstructions(const std::string& folder, const std::vector<PairedBenchmark>& pairs,
                     std::vector<palpate::bench::Comparison>& comparisons)
{
  const auto counts = palpate::bench::ReadInstructionCounts(folder);
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    const auto count = counts.find(pairs[i].Name);
    if (count != counts.end())
    {
      comparisons[i].Instructions = count->second.Ours / pairs[i].Items;
      comparisons[i].AgainstInstructions = count->second.Against / pairs[i].Items;
    }
  }
}
} // namespace

int main(int argc, char** argv)
{
  std::string filter;
  std::string json;
  std::string instructions;
  bool verifyOnly = false;
  bool countOnly = false;
  CLI::App app("Times Palpate beside named alternatives in the same run.");
  app.add_option("--filter", filter, "only benchmarks whose name contains this");
  app.add_option("--json", json, "file to write the comparisons to");
  app.add_flag("--verify-only", verifyOnly, "run everything once and compare the results only");
  app.add_flag("--count-only", countOnly,
               "under valgrind --tool=callgrind --instr-atstart=no: count instructions only");
  app.add_option("--instructions", instructions, "folder with callgrind's files of such a run");
  CLI11_PARSE(app, argc, argv);

  const std::vector<PairedBenchmark> pairs = Matching(filter);
  if (pairs.empty())
  {
    std::cerr << "no benchmark's name contains " << filter << '\n';
    return 2;
  }
  if (countOnly)
  {
    return palpate::bench::CountInstructions(pairs) ? 0 : 1;
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
  std::vector<palpate::bench::Comparison> comparisons = palpate::bench::Measure(pairs);
  AddInstructions(instructions, pairs, comparisons);
  palpate::bench::PrintTable(std::cout, comparisons);
  if (!json.empty())
  {
    std::ofstream file(json);
    file << palpate::bench::ToJson(comparisons) << '\n';
    return file.good() ? 0 : 1;
  }
  return 0;
}
