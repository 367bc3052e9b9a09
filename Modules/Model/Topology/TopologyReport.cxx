#include "TopologyReport.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace palpate
{
namespace
{
std::string PlainNumber(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", value);
  return text;
}

std::string PercentText(double percent)
{
  constexpr double Least = 0.01;
  return percent < Least ? "less than 0.01 %" : PlainNumber(percent) + " %";
}

// Of the sphere of a volume.
double DiameterOf(double volume)
{
  return std::cbrt(6.0 * volume / M_PI);
}

double VolumeOfSphere(double diameter)
{
  return M_PI / 6.0 * diameter * diameter * diameter;
}
} // namespace

void TopologyReport::Add(const TopologyChange& dropped)
{
  TopologyChange& parts = this->DroppedParts;
  const TopologyChange before = parts;
  parts = dropped.LargestVolume > before.LargestVolume ? dropped : before;
  parts.Count = before.Count + dropped.Count;
  parts.Volume = before.Volume + dropped.Volume;
  this->ObjectVolume += dropped.Volume;
}

double TopologyReport::ChangedVolume() const
{
  return this->DroppedParts.Volume + this->Bridges.Volume + this->FilledCavities.Volume +
         this->CutHandles.Volume + this->FilledHandles.Volume;
}

double TopologyReport::AddedVolume() const
{
  return this->Bridges.Volume + this->FilledCavities.Volume + this->FilledHandles.Volume -
         this->DroppedParts.Volume - this->CutHandles.Volume;
}

double TopologyReport::ChangedPercent() const
{
  return this->ObjectVolume > 0.0 ? 100.0 * this->ChangedVolume() / this->ObjectVolume : 0.0;
}

std::string ChangeText(const TopologyReport& report)
{
  std::vector<std::string> texts;
  const auto add = [&texts](const TopologyChange& change, const char* one, const char* several)
  {
    if (change.Count > 0)
    {
      texts.push_back(std::to_string(change.Count) + " " + (change.Count == 1 ? one : several));
    }
  };
  add(report.DroppedParts, "part left out", "parts left out");
  add(report.Bridges, "part joined by a bridge", "parts joined by bridges");
  add(report.FilledCavities, "cavity filled", "cavities filled");
  add(report.CutHandles, "handle cut", "handles cut");
  add(report.FilledHandles, "handle filled", "handles filled");
  std::string text;
  for (std::size_t i = 0; i < texts.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 == texts.size() ? " and " : ", ") + texts[i];
  }
  return text.empty() ? text
                      : text + ", " + PercentText(report.ChangedPercent()) + " of the volume";
}

std::array<TopologyLimitUse, 3> UseOfLimits(const TopologyReport& report,
                                            const TopologyLimits& limits)
{
  const double cavity = DiameterOf(report.FilledCavities.LargestVolume);
  const std::string cavityText =
      "a cavity of " + PlainNumber(report.FilledCavities.LargestVolume) + " mm\xC2\xB3";
  const double gap = report.Bridges.LargestExtent;
  const double longest =
      std::min(limits.BridgedGap, limits.GapShare * DiameterOf(report.ObjectVolume));
  const std::string percent = PlainNumber(report.ChangedPercent()) + " % of ";
  const auto limited = [](const std::string& text, double limit, const char* unit)
  { return text + " (limit " + PlainNumber(limit) + unit + ")"; };
  return {
      {{cavity / limits.CavityDiameter, "has " + cavityText + ", which a model would fill",
        limited(cavityText + " filled", VolumeOfSphere(limits.CavityDiameter), " mm\xC2\xB3")},
       {gap > 0.0 ? gap / longest : 0.0,
        "has parts that are " + PlainNumber(gap) + " mm apart, which a model would join",
        limited("a gap of " + PlainNumber(gap) + " mm joined", longest, " mm")},
       {report.ChangedPercent() / limits.ChangedPercent,
        2.0 * report.DroppedParts.Volume > report.ChangedVolume()
            ? "has several parts, and a model of the largest leaves out " + percent + "the volume"
            : "has handles, cavities and small parts whose removal would change " + percent +
                  "its volume",
        limited("changes of " + percent + "the volume", limits.ChangedPercent, " %")}}};
}

Status CheckTopology(const TopologyReport& report, const TopologyLimits& limits)
{
  for (const TopologyLimitUse& use : UseOfLimits(report, limits))
  {
    if (!(use.Share <= 1.0))
    {
      return Status::Failure(use.Excess);
    }
  }
  return Status::Success();
}
} // namespace palpate
