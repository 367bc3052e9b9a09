#include "StructureRemarks.h"

#include "DecimalText.h"

#include <numeric>

namespace palpate
{
double AllParts(const FitResult& result)
{
  const std::vector<double>& parts = result.ComponentMilliliters;
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

void RemarkOnComponents(FitResult& result)
{
  if (result.ComponentMilliliters.size() > 1 && result.Settings.Component > 0)
  {
    result.Notes.push_back("the label has " + std::to_string(result.ComponentMilliliters.size()) +
                           " connected components; number " +
                           std::to_string(result.Settings.Component) + " (" +
                           FixedText(result.MaskMilliliters, 2) + " ml, " +
                           SignificantText(100.0 * result.MaskMilliliters / AllParts(result), 3) +
                           " % of it) was used");
  }
}

void RemarkOnStructure(FitResult& result)
{
  if (result.TouchesBorder)
  {
    result.Notes.push_back("the structure touches the border of its volume and is closed there; "
                           "the true surface may continue");
  }
}

void RemarkOnRest(FitResult& result)
{
  RemarkOnComponents(result);
  if (result.CavityCount > 0)
  {
    result.Notes.push_back(CountText(result.CavityCount, "cavity", "cavities") + " of " +
                           FixedText(result.CavityMilliliters, 3) + " ml in total filled");
  }
}
} // namespace palpate
