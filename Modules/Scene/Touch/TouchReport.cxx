#include "TouchReport.h"

#include "DecimalText.h"
#include "DrillReport.h"
#include "HtmlText.h"
#include "JsonSchema.h"
#include "OutputFolder.h"
#include "ReportPage.h"
#include "SceneFile.h"
#include "TouchPlots.h"
#include "WholeFile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
constexpr double Micro = 1e-3; // us in a ns

double TouchingPercent(const TouchResult& result)
{
  double touched = 0.0;
  for (const double seconds : result.TouchedSeconds)
  {
    touched += seconds;
  }
  const double whole = result.Trace.Duration();
  return whole > 0.0 ? 100.0 * touched / whole : 0.0;
}

nlohmann::ordered_json StatisticsAsJson(const PeriodStatistics& statistics)
{
  constexpr double Most = 0.99;
  constexpr double Almost = 0.999;
  return {{"count", statistics.Count()},
          {"median_us", Micro * static_cast<double>(statistics.Median())},
          {"p99_us", Micro * static_cast<double>(statistics.Quantile(Most))},
          {"p999_us", Micro * static_cast<double>(statistics.Quantile(Almost))},
          {"max_us", Micro * static_cast<double>(statistics.Max())},
          {"missed", statistics.Misses()}};
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
                                     {"stiffness_n_per_mm", structure.Touch.Law.Stiffness},
                                     {"build_s", structure.Seconds},
                                     {"touched_s", result.TouchedSeconds[s]}});
  }
  summary["device"] = touch.Settings.Device;
  summary["rate_hz"] = touch.Settings.Rate;
  summary["scale"] = touch.Frame.Scale;
  summary["seconds"] = result.Trace.Duration();
  summary["ticks"] = result.Ticks;
  summary["lost_ticks"] = result.LostTicks;
  summary["touching_percent"] = TouchingPercent(result);
  summary["force_max_n"] = result.Trace.Whole().Force.Most;
  summary["depth_max_mm"] = result.Trace.Whole().Depth.Most;
  summary["energy_least_n_mm"] = result.LeastEnergy;
  summary["tick"] = StatisticsAsJson(result.Durations);
  if (result.Periods.Count() > 0)
  {
    summary["period"] = StatisticsAsJson(result.Periods);
  }
  summary["memory_start_mib"] = result.MebibytesAtStart;
  summary["memory_end_mib"] = result.MebibytesAtEnd;
  summary["fault"] = result.Fault == SafetyFault::None ? "" : Describe(result.Fault);
  summary["device_problem"] = result.DeviceProblem;
  summary["warnings"] = touch.Warnings;
  summary["thread"] = result.ThreadAdvice;
  if (touch.Drill != nullptr)
  {
    summary["drilled"] = DrillSummary(touch, result);
  }
  return summary;
}

std::string Chart(const TouchTrace& trace, TouchQuantity quantity, const std::string& label,
                  const std::string& caption, bool isLogarithmic = false)
{
  return ReportFigure(TouchChart(trace, quantity, label, isLogarithmic).Svg(), caption);
}

std::string StructuresTable(const PreparedTouch& touch, const TouchResult& result)
{
  HtmlRows rows;
  for (std::size_t s = 0; s < touch.Structures.size(); ++s)
  {
    const BuiltStructure& structure = touch.Structures[s];
    rows.emplace_back(structure.Touch.Name,
                      structure.Represented + "; " +
                          SignificantText(structure.Touch.Law.Stiffness, 3) +
                          " N/mm; touched for " + FixedText(result.TouchedSeconds[s], 2) +
                          " s; made in " + FixedText(structure.Seconds, 2) + " s");
  }
  return HtmlTable("Touched structures", rows);
}

std::string NumbersTable(const PreparedTouch& touch, const TouchResult& result)
{
  constexpr double Almost = 0.999;
  const auto micro = [](std::int64_t nanoseconds)
  { return SignificantText(Micro * static_cast<double>(nanoseconds), 3) + " µs"; };
  HtmlRows rows{
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
      {"skipped ticks", std::to_string(result.Periods.Misses())},
      {"memory after 1 s and at the end", FixedText(result.MebibytesAtStart, 1) + " and " +
                                              FixedText(result.MebibytesAtEnd, 1) + " MiB"},
      {"forces", result.Fault == SafetyFault::None ? "on until the end" : Describe(result.Fault)}};
  for (const std::string& warning : touch.Warnings)
  {
    rows.emplace_back("warning", warning);
  }
  if (!result.ThreadAdvice.empty())
  {
    rows.emplace_back("thread", result.ThreadAdvice);
  }
  return HtmlTable("Summary", rows);
}

std::string Header(const PreparedTouch& touch)
{
  std::string names;
  for (const BuiltStructure& structure : touch.Structures)
  {
    names += (names.empty() ? "" : ", ") + structure.Touch.Name;
  }
  return "<header>\n<div class=\"kicker\">Palpate \xC2\xB7 touch</div>\n<h1>" + EscapeHtml(names) +
         "</h1>\n</header>\n";
}

std::string Charts(const TouchTrace& trace)
{
  const bool isVirtual = trace.Whole().Computation.Most > 0.0F;
  const std::string time = isVirtual ? Chart(trace, &TouchStretch::Computation, "tick time, µs",
                                             "Computation time of each tick. In virtual time, "
                                             "ticks follow each other immediately.",
                                             true)
                                     : Chart(trace, &TouchStretch::Period, "period, µs",
                                             "Period from tick to tick.", true);
  return "<div class=\"charts\">\n" +
         Chart(trace, &TouchStretch::Force, "force, N", "Force applied to the hand.") +
         Chart(trace, &TouchStretch::Depth, "depth, mm",
               "Depth of the tool in the touched structure.") +
         time + "</div>\n";
}

std::string PageOf(const PreparedTouch& touch, const TouchResult& result)
{
  return ReportPage("Touch \xE2\x80\x93 Palpate",
                    Header(touch) + ReportSection("Over time", Charts(result.Trace)) +
                        (touch.Drill != nullptr ? DrillSection(touch, result) : "") +
                        ReportSection("All numbers", "<div class=\"tables\">\n" +
                                                         StructuresTable(touch, result) +
                                                         NumbersTable(touch, result) + "</div>\n") +
                        "<footer>For research; not a medical device.</footer>\n");
}

std::string TraceAsCsv(const TouchTrace& trace)
{
  std::string text = "time_s,force_least_n,force_most_n,depth_least_mm,depth_most_mm,"
                     "period_most_us,computed_most_us\n";
  const auto append = [&text](double value, std::chars_format format, int digits, char after)
  {
    std::array<char, 64> cell{};
    const auto end = std::to_chars(cell.data(), cell.data() + cell.size(), value, format, digits);
    text.append(cell.data(), end.ptr);
    text += after;
  };
  for (const TouchStretch& s : trace.Stretches())
  {
    append(s.Time, std::chars_format::fixed, 6, ',');
    for (const float value : {s.Force.Least, s.Force.Most, s.Depth.Least, s.Depth.Most})
    {
      append(static_cast<double>(value), std::chars_format::general, 6, ',');
    }
    append(static_cast<double>(s.Period.Most), std::chars_format::general, 5, ',');
    append(static_cast<double>(s.Computation.Most), std::chars_format::general, 4, '\n');
  }
  return text;
}
} // namespace

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
                   WriteWholeFile(stage / "trace.csv", TraceAsCsv(result.Trace));
                   WriteWholeFile(stage / "report.html", PageOf(touch, result));
                 });
}
} // namespace palpate
