#include "TopologyReport.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

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

// Of the sphere of a volume.
double DiameterOf(double volume)
{
  return std::cbrt(6.0 * volume / M_PI);
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

Status CheckTopology(const TopologyReport& report, const TopologyLimits& limits)
{
  if (DiameterOf(report.FilledCavities.LargestVolume) > limits.CavityDiameter)
  {
    return Status::Failure("has a cavity of " + PlainNumber(report.FilledCavities.LargestVolume) +
                           " mm\xC2\xB3, which a model would fill");
  }
  const double longest =
      std::min(limits.BridgedGap, limits.GapShare * DiameterOf(report.ObjectVolume));
  if (report.Bridges.LargestExtent > longest)
  {
    return Status::Failure("has parts that are " + PlainNumber(report.Bridges.LargestExtent) +
                           " mm apart, which a model would join");
  }
  if (!(report.ChangedPercent() <= limits.ChangedPercent))
  {
    return Status::Failure("has handles, cavities and small parts whose removal would change " +
                           PlainNumber(report.ChangedPercent()) + " % of its volume");
  }
  return Status::Success();
}
} // namespace palpate
