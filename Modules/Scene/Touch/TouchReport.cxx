#include "TouchReport.h"

#include "DecimalText.h"
#include "JsonSchema.h"
#include "OutputFolder.h"
#include "ReportPage.h"
#include "SceneFile.h"
#include "SvgChart.h"
#include "Units.h"
#include "WholeFile.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
std::string RemovedText(double volume)
{
  return SignificantText(volume, 4) + " mm\u00b3 removed";
}

std::string ApproachText(const DrillApproach& one)
{
  std::string text = "smallest distance " + FixedText(one.Least, 2) + " mm at " +
                     FixedText(one.LeastTime, 2) + " s";
  if (one.AlarmSeconds > 0.0)
  {
    text += "; within " + FixedText(one.AlarmDistance, 2) + " mm for " +
            FixedText(one.AlarmSeconds, 2) + " s";
  }
  return text;
}

nlohmann::ordered_json DrillSummary(const PreparedTouch& touch, const TouchResult& result)
{
  nlohmann::ordered_json summary{{"orders", result.DrillOrders}, {"problem", result.DrillProblem}};
  for (std::size_t site = 0; site < result.RemovedVolumes.size(); ++site)
  {
    summary["removed"].push_back(
        {{"name", touch.Drill->Sites()[site].Name}, {"mm3", result.RemovedVolumes[site]}});
  }
  for (const DrillApproach& one : result.Approaches)
  {
    summary["forbidden"].push_back({{"name", one.Name},
                                    {"least_mm", one.Least},
                                    {"least_at_s", one.LeastTime},
                                    {"alarm_mm", one.AlarmDistance},
                                    {"alarm_s", one.AlarmSeconds}});
  }
  return summary;
}

void AddDrilled(ReportPage& page, const PreparedTouch& touch, const TouchResult& result)
{
  page.Section("Drilled");
  ReportRows rows;
  for (std::size_t site = 0; site < result.RemovedVolumes.size(); ++site)
  {
    const std::string& name = touch.Drill->Sites()[site].Name;
    rows.emplace_back(name, RemovedText(result.RemovedVolumes[site]));
    SvgChart chart("time, s", "removed, mm\u00b3");
    std::vector<std::pair<double, double>> points;
    for (const DrillMoment& moment : result.Removal)
    {
      points.emplace_back(moment.Time, moment.Volumes[site]);
    }
    chart.SetLine(std::move(points));
    page.Chart(chart, name);
  }
  for (const DrillApproach& one : result.Approaches)
  {
    rows.emplace_back(one.Name, ApproachText(one));
  }
  if (!result.DrillProblem.empty())
  {
    rows.emplace_back("problem", result.DrillProblem);
  }
  page.Facts("Removed volume and protected structures", rows);
}

using TouchQuantity = LeastAndMost TouchStretch::*;

double PercentOf(const TouchResult& result, double seconds)
{
  const double whole = result.Trace.Duration();
  return whole > 0.0 ? 100.0 * seconds / whole : 0.0;
}

double TouchingPercent(const TouchResult& result)
{
  double touched = 0.0;
  for (const double seconds : result.TouchedSeconds)
  {
    touched += seconds;
  }
  return PercentOf(result, touched);
}

nlohmann::ordered_json StatisticsAsJson(const PeriodStatistics& statistics)
{
  constexpr double Most = 0.99;
  constexpr double Almost = 0.999;
  return {{"count", statistics.Count()},
          {"median_us", MicrosecondsPerNanosecond * static_cast<double>(statistics.Median())},
          {"p99_us", MicrosecondsPerNanosecond * static_cast<double>(statistics.Quantile(Most))},
          {"p999_us", MicrosecondsPerNanosecond * static_cast<double>(statistics.Quantile(Almost))},
          {"max_us", MicrosecondsPerNanosecond * static_cast<double>(statistics.Max())},
          {"missed", statistics.Misses()}};
}

// Of a structure that yields there is none: its force is that of its tissue.
nlohmann::ordered_json StiffnessOf(const BuiltStructure& structure)
{
  return structure.Yields ? nlohmann::ordered_json(nullptr)
                          : nlohmann::ordered_json(structure.Touch.Law.Stiffness);
}

std::string StiffnessText(const BuiltStructure& structure)
{
  return structure.Yields ? "yields" : SignificantText(structure.Touch.Law.Stiffness, 3) + " N/mm";
}

const char* FaultText(const TouchResult& result)
{
  return Describe(result.Fault, result.HasResumed);
}

nlohmann::ordered_json SummaryOf(const PreparedTouch& touch, const TouchResult& result)
{
  nlohmann::ordered_json summary;
  summary[JsonSchemaKey] = JsonSchemaVersion;
  for (std::size_t s = 0; s < touch.Structures.size(); ++s)
  {
    const BuiltStructure& structure = touch.Structures[s];
    summary["structures"].push_back({{"name", structure.Touch.Name},
                                     {"representation", structure.Represented},
                                     {"stiffness_n_per_mm", StiffnessOf(structure)},
                                     {"build_s", structure.Seconds},
                                     {"touched_s", result.TouchedSeconds[s]}});
  }
  summary["device"] = touch.Settings.Device;
  summary["rate_hz"] = touch.Settings.Rate;
  summary["scale"] = touch.Frame.Scale;
  summary["seconds"] = result.Trace.Duration();
  summary["ticks"] = result.Ticks;
  summary["lost_ticks"] = result.LostTicks;
  summary["behind_ticks"] = result.BehindTicks;
  summary["touching_percent"] = TouchingPercent(result);
  summary["beyond_linear_percent"] = PercentOf(result, result.BeyondLinearSeconds);
  summary["force_max_n"] = result.Trace.Whole().Force.Most;
  summary["torque_max_n_mm"] = result.Trace.Whole().Torque.Most;
  summary["depth_max_mm"] = result.Trace.Whole().Depth.Most;
  summary["energy_least_n_mm"] = result.LeastEnergy;
  summary["tick"] = StatisticsAsJson(result.Durations);
  if (result.Periods.Count() > 0)
  {
    summary["period"] = StatisticsAsJson(result.Periods);
  }
  summary["fault"] = result.Fault == SafetyFault::None ? "" : FaultText(result);
  summary["device_problem"] = result.DeviceProblem;
  summary["warnings"] = touch.Warnings;
  if (!result.SweepNote.empty())
  {
    summary["warnings"].push_back(result.SweepNote);
  }
  summary["thread"] = result.ThreadAdvice;
  if (touch.Drill != nullptr)
  {
    summary["drilled"] = DrillSummary(touch, result);
  }
  return summary;
}

// Minimum and maximum of each of a few thousand intervals, so that single-tick peaks are visible.
// Zeros, which mark unknown values, are left out of logarithmic charts.
std::vector<std::pair<double, double>> Envelope(const std::vector<TouchStretch>& stretches,
                                                TouchQuantity quantity, bool isLogarithmic)
{
  constexpr std::size_t MostPoints = 1000;
  const std::size_t length = std::max<std::size_t>(1, stretches.size() / MostPoints);
  std::vector<std::pair<double, double>> points;
  for (std::size_t first = 0; first < stretches.size(); first += length)
  {
    LeastAndMost values = stretches[first].*quantity;
    for (std::size_t i = first; i < std::min(stretches.size(), first + length); ++i)
    {
      values.Join(stretches[i].*quantity);
    }
    const auto add = [&](float value)
    {
      if (value > 0.0F || !isLogarithmic)
      {
        points.emplace_back(stretches[first].Time, static_cast<double>(value));
      }
    };
    add(values.Least);
    if (values.Most > values.Least)
    {
      add(values.Most);
    }
  }
  return points;
}

void AddChart(ReportPage& page, const TouchTrace& trace, TouchQuantity quantity,
              const std::string& label, const std::string& caption, bool isLogarithmic = false)
{
  SvgChart chart("time, s", label);
  chart.SetLogarithmic(false, isLogarithmic);
  chart.SetLine(Envelope(trace.Stretches(), quantity, isLogarithmic));
  page.Chart(chart, caption);
}

ReportRows StructureRows(const PreparedTouch& touch, const TouchResult& result)
{
  ReportRows rows;
  for (std::size_t s = 0; s < touch.Structures.size(); ++s)
  {
    const BuiltStructure& structure = touch.Structures[s];
    rows.emplace_back(structure.Touch.Name,
                      structure.Represented + "; " + StiffnessText(structure) + "; touched for " +
                          FixedText(result.TouchedSeconds[s], 2) + " s; made in " +
                          FixedText(structure.Seconds, 2) + " s");
  }
  return rows;
}

ReportRows NumberRows(const PreparedTouch& touch, const TouchResult& result)
{
  constexpr double Almost = 0.999;
  const auto micro = [](std::int64_t nanoseconds)
  {
    return SignificantText(MicrosecondsPerNanosecond * static_cast<double>(nanoseconds), 3) + " µs";
  };
  ReportRows rows{
      {"device", touch.Settings.Device},
      {"scene mm per device mm", SignificantText(touch.Frame.Scale, 3)},
      {"rate", SignificantText(touch.Settings.Rate, 4) + " Hz"},
      {"ticks", std::to_string(result.Ticks)},
      {"touching", FixedText(TouchingPercent(result), 1) + " % of the time"},
      {"largest force", FixedText(result.Trace.Whole().Force.Most, 2) + " N"},
      {"largest depth", FixedText(result.Trace.Whole().Depth.Most, 2) + " mm"},
      {"tick time, median", micro(result.Durations.Median())},
      {"tick time, 99.9 %", micro(result.Durations.Quantile(Almost))},
      {"tick time, longest", micro(result.Durations.Max())},
      {"late ticks", std::to_string(result.Durations.Misses())},
      {"ticks whose work was left to the next", std::to_string(result.BehindTicks)},
      {"skipped ticks", std::to_string(result.Periods.Misses())},
      {"forces", result.Fault == SafetyFault::None ? "on until the end" : FaultText(result)}};
  if (result.Trace.Whole().Torque.Most > 0.0)
  {
    rows.emplace_back("largest torque", FixedText(result.Trace.Whole().Torque.Most, 1) + " N mm");
  }
  if (result.BeyondLinearSeconds > 0.0)
  {
    rows.emplace_back("beyond linear elasticity",
                      FixedText(PercentOf(result, result.BeyondLinearSeconds), 1) +
                          " % of the time: the force is an estimate there");
  }
  for (const std::string& warning : touch.Warnings)
  {
    rows.emplace_back("warning", warning);
  }
  if (!result.SweepNote.empty())
  {
    rows.emplace_back("warning", result.SweepNote);
  }
  if (!result.ThreadAdvice.empty())
  {
    rows.emplace_back("thread", result.ThreadAdvice);
  }
  return rows;
}

void AddCharts(ReportPage& page, const TouchTrace& trace)
{
  AddChart(page, trace, &TouchStretch::Force, "force, N", "Force applied to the hand.");
  AddChart(page, trace, &TouchStretch::Depth, "depth, mm",
           "Depth of the tool in the touched structure.");
  const bool isVirtual = trace.Whole().Computation.Most > 0.0F;
  AddChart(page, trace, isVirtual ? &TouchStretch::Computation : &TouchStretch::Period,
           isVirtual ? "tick time, µs" : "period, µs",
           isVirtual ? "Computation time of each tick. In virtual time, ticks follow each other "
                       "immediately."
                     : "Period from tick to tick.",
           true);
}

std::string PageOf(const PreparedTouch& touch, const TouchResult& result)
{
  std::string names;
  for (const BuiltStructure& structure : touch.Structures)
  {
    names += (names.empty() ? "" : ", ") + structure.Touch.Name;
  }
  ReportPage page;
  AddCharts(page.Header("touch", names).Section("Over time"), result.Trace);
  if (touch.Drill != nullptr)
  {
    AddDrilled(page, touch, result);
  }
  page.Section("All numbers")
      .Facts("Touched structures", StructureRows(touch, result))
      .Facts("Summary", NumberRows(touch, result));
  return page.Whole("Touch \xE2\x80\x93 Palpate", "For research; not a medical device.");
}
} // namespace

std::vector<std::string> DrillLines(const PreparedTouch& touch, const TouchResult& result)
{
  std::vector<std::string> lines;
  for (std::size_t site = 0; site < result.RemovedVolumes.size(); ++site)
  {
    lines.push_back(touch.Drill->Sites()[site].Name + ": " +
                    RemovedText(result.RemovedVolumes[site]));
  }
  for (const DrillApproach& one : result.Approaches)
  {
    lines.push_back(one.Name + ": " + ApproachText(one));
  }
  if (!result.DrillProblem.empty())
  {
    lines.push_back(result.DrillProblem);
  }
  return lines;
}

std::string TouchSummaryText(const PreparedTouch& touch, const TouchResult& result)
{
  return SummaryOf(touch, result).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
         "\n";
}

void WriteTouchFiles(const std::filesystem::path& folder, const PreparedTouch& touch,
                     const TouchResult& result)
{
  SceneSettings settings = touch.Settings;
  settings.Placement.Scale = touch.Frame.Scale; // so that the file reproduces this touch
  WriteOutputSet(folder,
                 [&](const std::filesystem::path& stage)
                 {
                   WriteWholeFile(stage / "summary.json", TouchSummaryText(touch, result));
                   WriteWholeFile(stage / "scene.json", SceneText(settings, folder));
                   WriteWholeFile(stage / "report.html", PageOf(touch, result));
                 });
}
} // namespace palpate
