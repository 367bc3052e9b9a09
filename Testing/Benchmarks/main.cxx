// PalpateBenchmarks: times ours next to named alternatives, after checking that both agree.
#include "BodyBenchmarks.h"
#include "BumpyTouchBenchmarks.h"
#include "ComparisonReport.h"
#include "CompletionBenchmarks.h"
#include "DisplayCheck.h"
#include "DrillBenchmarks.h"
#include "ElasticBenchmarks.h"
#include "ElasticBuilds.h"
#include "EvaluationBenchmarks.h"
#include "FieldBenchmarks.h"
#include "FieldFootprint.h"
#include "FitBenchmarks.h"
#include "InstructionCounts.h"
#include "MachineName.h"
#include "MissingCaps.h"
#include "NearestBenchmarks.h"
#include "PairedBenchmark.h"
#include "PipelineBenchmarks.h"
#include "PublishedRates.h"
#include "RenderBenchmarks.h"
#include "RigidToolBenchmarks.h"
#include "SurfaceBenchmarks.h"
#include "TouchBenchmarks.h"
#include "TouchQuality.h"
#include "TradeOff.h"
#include "ViewBenchmarks.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace
{
using palpate::bench::PairedBenchmark;

std::vector<PairedBenchmark> DrawingBenchmarks()
{
  try
  {
    palpate::RequireDisplay();
  }
  catch (const std::runtime_error& error)
  {
    std::cerr << "No frames are timed: " << error.what() << '\n';
    return {};
  }
  std::vector<PairedBenchmark> all = palpate::bench::RenderBenchmarks();
  const std::vector<PairedBenchmark> views = palpate::bench::ViewBenchmarks();
  all.insert(all.end(), views.begin(), views.end());
  return all;
}

// Every group of benchmarks joins here.
std::vector<PairedBenchmark> AllBenchmarks()
{
  std::vector<PairedBenchmark> all;
  for (auto& group :
       {palpate::bench::EvaluationBenchmarks(), palpate::bench::SurfaceBenchmarks(),
        palpate::bench::FitBenchmarks(), palpate::bench::CompletionBenchmarks(),
        palpate::bench::NearestBenchmarks(), palpate::bench::BodyBenchmarks(),
        palpate::bench::FieldBenchmarks(), DrawingBenchmarks(), palpate::bench::TouchBenchmarks(),
        palpate::bench::BumpyTouchBenchmarks(), palpate::bench::RigidToolBenchmarks(),
        palpate::bench::DrillBenchmarks(), palpate::bench::ElasticBenchmarks(),
        palpate::bench::TradeOffBenchmarks(), palpate::bench::PipelineBenchmarks()})
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

bool WriteText(const std::string& fileName, const std::string& text)
{
  std::ofstream file(fileName);
  file << text << '\n';
  return file.good();
}

// What the page of measurements holds besides the comparisons.
std::string PageJson(const std::vector<palpate::bench::Comparison>& comparisons)
{
  constexpr int Bodies = 8;
  const nlohmann::json page = {
      {"machine", palpate::MachineName()},
      {"compiler", std::string("GCC ") + __VERSION__},
      {"tradeoff",
       nlohmann::json::parse(palpate::bench::ToJson(palpate::bench::TradeOffRows(comparisons)))},
      {"caps", palpate::bench::ToMarkdown(palpate::bench::MissingCaps(Bodies))},
      {"footprints", palpate::bench::ToMarkdown(palpate::bench::FieldFootprints())},
      {"published", palpate::bench::ToMarkdown(palpate::bench::ComparePublished())},
      {"touch", palpate::bench::ToMarkdown(palpate::bench::TouchQuality())},
      {"elastic_builds", palpate::bench::ToMarkdown(palpate::bench::ElasticBuilds())},
      {"elastic_maps", palpate::bench::ToMarkdown(palpate::bench::ElasticMapRows(comparisons))}};
  return page.dump(2);
}
} // namespace

int main(int argc, char** argv)
{
  std::string filter;
  std::string json;
  std::string page;
  std::string counts;
  bool verifyOnly = false;
  bool countOnly = false;
  CLI::App app("Times Palpate next to named alternatives in the same run.");
  app.add_option("--filter", filter, "only benchmarks whose name contains this");
  app.add_option("--json", json, "file to write the comparisons to");
  app.add_option("--page-json", page, "file to write what the page of measurements needs to");
  app.add_flag("--verify-only", verifyOnly, "run everything once and compare the results only");
  app.add_flag("--count-only", countOnly,
               "under Callgrind: have it dump the instructions of every side, and do no more");
  app.add_option("--instructions", counts, "folder of what Callgrind dumped");
  CLI11_PARSE(app, argc, argv);

  const std::vector<PairedBenchmark> pairs = Matching(filter);
  if (pairs.empty())
  {
    std::cerr << "no benchmark's name contains " << filter << '\n';
    return 2;
  }
  if (countOnly)
  {
    return palpate::bench::InstructionCounts::Count(pairs) ? 0 : 1;
  }
  const std::vector<std::string> disagreements = palpate::bench::Disagreements(pairs);
  for (const std::string& message : disagreements)
  {
    std::cerr << message << '\n';
  }
  if (!disagreements.empty() || verifyOnly)
  {
    return disagreements.empty() ? 0 : 1;
  }
  const auto comparisons =
      palpate::bench::Measure(pairs, palpate::bench::InstructionCounts(counts));
  palpate::bench::PrintTable(std::cout, comparisons);
  const bool isWritten = (json.empty() || WriteText(json, palpate::bench::ToJson(comparisons))) &&
                         (page.empty() || WriteText(page, PageJson(comparisons)));
  return isWritten ? 0 : 1;
}
