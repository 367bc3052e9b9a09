#include "TopologyReport.h"

#include <cstdio>

namespace palpate
{
namespace
{
std::string Rounded(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", value);
  return text;
}
} // namespace

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
  if (report.FilledCavities.LargestExtent > limits.CavityExtent)
  {
    return Status::Failure("A cavity of " + Rounded(report.FilledCavities.LargestExtent) +
                           " mm would be filled.");
  }
  if (report.Bridges.LargestExtent > limits.BridgedGap)
  {
    return Status::Failure("Parts that are " + Rounded(report.Bridges.LargestExtent) +
                           " mm apart would be joined.");
  }
  if (!(report.ChangedPercent() <= limits.ChangedPercent))
  {
    return Status::Failure("To remove handles, cavities and small parts, " +
                           Rounded(report.ChangedPercent()) + " % of the volume would be changed.");
  }
  return Status::Success();
}
} // namespace palpate
