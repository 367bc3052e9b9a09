#include "RepairRemarks.h"

#include "DecimalText.h"

namespace palpate
{
namespace
{
void RemarkOnChange(const TopologyChange& change, const char* one, const char* several,
                    FitResult& result)
{
  if (change.Count > 0)
  {
    result.Notes.push_back(CountText(change.Count, one, several) + ", " +
                           VolumeText(change.Volume) + "; the largest of " +
                           FixedText(change.LargestExtent, 1) + " mm at " +
                           PlaceText(change.LargestCentre));
  }
}
} // namespace

std::string PlaceText(const Vector3& placeWorld)
{
  return "(" + FixedText(placeWorld.x(), 1) + ", " + FixedText(placeWorld.y(), 1) + ", " +
         FixedText(placeWorld.z(), 1) + ")";
}

std::string VolumeText(double volume)
{
  constexpr double LeastWhole = 99.95; // three digits
  return (volume < LeastWhole ? SignificantText(volume, 3) : FixedText(volume, 0)) + " mm\xC2\xB3";
}

void RemarkOnChanges(const TopologyReport& report, FitResult& result)
{
  RemarkOnChange(report.DroppedParts, "small part dropped", "small parts dropped", result);
  RemarkOnChange(report.Bridges, "part joined by a bridge", "parts joined by bridges", result);
  RemarkOnChange(report.FilledCavities, "cavity filled", "cavities filled", result);
  RemarkOnChange(report.CutHandles, "handle cut", "handles cut", result);
  RemarkOnChange(report.FilledHandles, "handle filled", "handles filled", result);
}
} // namespace palpate
