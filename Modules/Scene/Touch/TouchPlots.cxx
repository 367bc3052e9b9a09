#include "TouchPlots.h"

#include "DecimalText.h"
#include "HtmlText.h"
#include "WholeFile.h"

#include <algorithm>

namespace palpate
{
namespace
{
// As the report's style for print.
constexpr const char* Style =
    "<style>text { font: 11px sans-serif; fill: #1c2127; } .axis { stroke: #5c6670; } "
    ".grid { stroke: #dde1e6; } .bar { fill: #33709f; } "
    ".line { fill: none; stroke: #33709f; stroke-width: 1.6; }</style>";

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

TouchTrace TraceOf(const std::vector<TouchState>& ticks)
{
  TouchTrace trace;
  for (std::size_t n = 0; n < ticks.size(); ++n)
  {
    const TouchState& before = ticks[n == 0 ? 0 : n - 1];
    trace.Add(StretchOf(ticks[n], ticks.front().Tick.Started, before.Tick.Started));
  }
  return trace;
}
} // namespace

SvgChart TouchChart(const TouchTrace& trace, TouchQuantity quantity, const std::string& label,
                    bool isLogarithmic)
{
  SvgChart chart("time, s", label);
  chart.SetLogarithmic(false, isLogarithmic);
  chart.SetLine(Envelope(trace.Stretches(), quantity, isLogarithmic));
  return chart;
}

bool IsTouchPlots(const std::filesystem::path& file)
{
  return file.extension() == ".svg";
}

void WriteTouchPlots(const std::vector<TouchState>& ticks, const std::filesystem::path& file)
{
  const TouchTrace trace = TraceOf(ticks);
  std::string charts;
  double height = 0.0;
  for (const SvgChart& chart : {TouchChart(trace, &TouchStretch::Force, "force, N", false),
                                TouchChart(trace, &TouchStretch::Depth, "depth, mm", false),
                                TouchChart(trace, &TouchStretch::Period, "period, us", true)})
  {
    charts +=
        "<g transform=\"translate(0 " + FixedText(height, 0) + ")\">" + chart.Content() + "</g>";
    height += SvgChart::Height;
  }
  const std::string size = FixedText(SvgChart::Width, 0) + " " + FixedText(height, 0);
  WriteWholeFile(file, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size +
                           "\" width=\"" + FixedText(2.0 * SvgChart::Width, 0) + "\">" + Style +
                           "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>" + charts +
                           "</svg>\n");
}
} // namespace palpate
