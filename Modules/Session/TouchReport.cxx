#include "TouchReport.h"

#include "HtmlText.h"
#include "ReportPage.h"
#include "SvgChart.h"
#include "TouchSceneFile.h"
#include "WholeFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
constexpr double Micro = 1e-3; // us in a ns

double LargestOf(const std::vector<float>& values)
{
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

double TouchingPercent(const TouchResult& result)
{
  double touched = 0.0;
  for (const double seconds : result.TouchedSeconds)
  {
    touched += seconds;
  }
  const double whole = result.Trace.Time.empty() ? 0.0 : result.Trace.Time.back();
  return whole > 0.0 ? 100.0 * touched / whole : 0.0;
}

nlohmann::ordered_json StatisticsAsJson(const PeriodStatistics& statistics)
{
  constexpr double Almost = 0.999;
  return {{"count", statistics.Count()},
          {"median_us", Micro * static_cast<double>(statistics.Median())},
          {"p999_us", Micro * static_cast<double>(statistics.Quantile(Almost))},
          {"max_us", Micro * static_cast<double>(statistics.Max())},
          {"missed", statistics.Misses()}};
}

nlohmann::ordered_json SummaryOf(const PreparedTouch& touch, const TouchResult& result)
{
  nlohmann::ordered_json summary;
  for (std::size_t s = 0; s < touch.Structures.size(); ++s)
  {
    const TouchableStructure& structure = touch.Structures[s];
    summary["structures"].push_back({{"name", structure.Touch.Name},
                                     {"representation", structure.Represented},
                                     {"stiffness_n_per_mm", structure.Touch.Law.Stiffness},
                                     {"build_s", structure.Seconds},
                                     {"touched_s", result.TouchedSeconds[s]}});
  }
  summary["device"] = touch.Settings.Device;
  summary["rate_hz"] = touch.Settings.Rate;
  summary["scale"] = touch.Scale;
  summary["seconds"] = result.Trace.Time.empty() ? 0.0 : result.Trace.Time.back();
  summary["ticks"] = result.Ticks;
  summary["lost_ticks"] = result.LostTicks;
  summary["touching_percent"] = TouchingPercent(result);
  summary["force_max_n"] = LargestOf(result.Trace.Force);
  summary["depth_max_mm"] = LargestOf(result.Trace.Depth);
  summary["energy_least_n_mm"] = result.LeastEnergy;
  summary["tick"] = StatisticsAsJson(result.Durations);
  if (result.Periods.Count() > 0)
  {
    summary["period"] = StatisticsAsJson(result.Periods);
  }
  summary["fault"] = result.Fault == SafetyFault::None ? "" : Describe(result.Fault);
  summary["device_problem"] = result.DeviceProblem;
  summary["warnings"] = touch.Warnings;
  summary["thread"] = result.ThreadAdvice;
  return summary;
}

// Of many values the smallest and the largest in each of some thousand stretches of time, so that
// a peak of one tick is seen.
std::vector<std::pair<double, double>> Envelope(const std::vector<double>& time,
                                                const std::vector<float>& values)
{
  constexpr std::size_t MostStretches = 1000;
  const std::size_t count = std::min(time.size(), values.size());
  const std::size_t length = std::max<std::size_t>(1, count / MostStretches);
  std::vector<std::pair<double, double>> points;
  for (std::size_t first = 0; first < count; first += length)
  {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(std::min(count, first + length));
    const auto [low, high] = std::minmax_element(begin, end);
    points.emplace_back(time[first], *low);
    if (length > 1)
    {
      points.emplace_back(time[first], *high);
    }
  }
  return points;
}

std::string Chart(const TouchTrace& trace, const std::vector<float>& values,
                  const std::string& quantity, const std::string& caption,
                  bool isLogarithmic = false)
{
  SvgChart chart("time, s", quantity);
  chart.SetLogarithmic(isLogarithmic);
  chart.SetLine(Envelope(trace.Time, values));
  return ReportFigure(chart.Svg(), caption);
}

// From each tick's start to the next's, us.
std::vector<float> PeriodsOf(const TouchTrace& trace)
{
  std::vector<float> periods(trace.Time.size(), 0.0F);
  for (std::size_t t = 1; t < periods.size(); ++t)
  {
    periods[t] = static_cast<float>(1e6 * (trace.Time[t] - trace.Time[t - 1]));
  }
  if (periods.size() > 1)
  {
    periods[0] = periods[1];
  }
  return periods;
}

std::string StructuresTable(const PreparedTouch& touch, const TouchResult& result)
{
  HtmlRows rows;
  for (std::size_t s = 0; s < touch.Structures.size(); ++s)
  {
    const TouchableStructure& structure = touch.Structures[s];
    rows.emplace_back(structure.Touch.Name,
                      structure.Represented + "; " +
                          SignificantText(structure.Touch.Law.Stiffness, 3) +
                          " N/mm; touched for " + FixedText(result.TouchedSeconds[s], 2) +
                          " s; made in " + FixedText(structure.Seconds, 2) + " s");
  }
  return HtmlTable("What was touched", rows);
}

std::string NumbersTable(const PreparedTouch& touch, const TouchResult& result)
{
  constexpr double Almost = 0.999;
  const auto micro = [](std::int64_t nanoseconds)
  { return SignificantText(Micro * static_cast<double>(nanoseconds), 3) + " µs"; };
  HtmlRows rows{
      {"device", touch.Settings.Device},
      {"millimetres of the scene for one of the hand", SignificantText(touch.Scale, 3)},
      {"rate", SignificantText(touch.Settings.Rate, 4) + " Hz"},
      {"ticks", std::to_string(result.Ticks)},
      {"touching", FixedText(TouchingPercent(result), 1) + " % of the time"},
      {"largest force", FixedText(LargestOf(result.Trace.Force), 2) + " N"},
      {"largest depth", FixedText(LargestOf(result.Trace.Depth), 2) + " mm"},
      {"a tick takes, median", micro(result.Durations.Median())},
      {"99.9 %", micro(result.Durations.Quantile(Almost))},
      {"at most", micro(result.Durations.Max())},
      {"late ticks", std::to_string(result.Durations.Misses())},
      {"left out", std::to_string(result.Periods.Misses())},
      {"forces", result.Fault == SafetyFault::None ? "on to the end" : Describe(result.Fault)}};
  for (const std::string& warning : touch.Warnings)
  {
    rows.emplace_back("warning", warning);
  }
  if (!result.ThreadAdvice.empty())
  {
    rows.emplace_back("thread", result.ThreadAdvice);
  }
  return HtmlTable("How it went", rows);
}

std::string Header(const PreparedTouch& touch)
{
  std::string names;
  for (const TouchableStructure& structure : touch.Structures)
  {
    names += (names.empty() ? "" : ", ") + structure.Touch.Name;
  }
  return "<header>\n<div class=\"kicker\">Palpate \xC2\xB7 touch</div>\n<h1>" + EscapeHtml(names) +
         "</h1>\n</header>\n";
}

std::string Charts(const TouchTrace& trace)
{
  const bool isVirtual = !trace.TickMicroseconds.empty();
  const std::string time =
      isVirtual ? Chart(trace, trace.TickMicroseconds, "time of a tick, µs",
                        "What each tick took to compute. Virtual time: ticks follow each other at "
                        "once.",
                        true)
                : Chart(trace, PeriodsOf(trace), "period, µs", "From tick to tick.", true);
  return "<div class=\"charts\">\n" + Chart(trace, trace.Force, "force, N", "Force on the hand.") +
         Chart(trace, trace.Depth, "depth, mm", "How deep the tool is in what it touches.") + time +
         "</div>\n";
}

std::string PageOf(const PreparedTouch& touch, const TouchResult& result)
{
  return ReportPage("Touch \xE2\x80\x93 Palpate",
                    Header(touch) + ReportSection("Over time", Charts(result.Trace)) +
                        ReportSection("All numbers", "<div class=\"tables\">\n" +
                                                         StructuresTable(touch, result) +
                                                         NumbersTable(touch, result) + "</div>\n") +
                        "<footer>For research; not a medical device.</footer>\n");
}

std::string TraceAsCsv(const TouchTrace& trace)
{
  const bool hasTicks = !trace.TickMicroseconds.empty();
  std::string text = hasTicks ? "time_s,force_n,depth_mm,tick_us\n" : "time_s,force_n,depth_mm\n";
  std::array<char, 96> line{};
  for (std::size_t t = 0; t < trace.Time.size(); ++t)
  {
    const auto force = static_cast<double>(trace.Force[t]);
    const auto depth = static_cast<double>(trace.Depth[t]);
    const int length =
        hasTicks ? std::snprintf(line.data(), line.size(), "%.6f,%.6g,%.6g,%.4g\n", trace.Time[t],
                                 force, depth, static_cast<double>(trace.TickMicroseconds[t]))
                 : std::snprintf(line.data(), line.size(), "%.6f,%.6g,%.6g\n", trace.Time[t], force,
                                 depth);
    text.append(line.data(), static_cast<std::size_t>(length));
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
  WriteWholeFile(folder / "summary.json", TouchSummaryText(touch, result));
  TouchSettings settings = touch.Settings;
  settings.Scale = touch.Scale; // so that the same file means the same touch
  WriteWholeFile(folder / "scene.json", TouchSceneText(settings, folder));
  WriteWholeFile(folder / "trace.csv", TraceAsCsv(result.Trace));
  WriteWholeFile(folder / "report.html", PageOf(touch, result));
}
} // namespace palpate
