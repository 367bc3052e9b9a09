#include "CohortCorrespondence.h"

#include "CohortNotes.h"
#include "CsvText.h"
#include "DecimalText.h"
#include "Progress.h"
#include "Units.h"

#include <algorithm>
#include <iterator>

namespace palpate
{
namespace
{
void NoteCorrespondence(const CohortCorrespondence& correspondence, CohortGroup& group)
{
  std::vector<CohortNote> flipped;
  std::vector<CohortNote> outliers;
  for (const CorrespondingCase& one : correspondence.Cases)
  {
    const std::string& name = group.Rows[one.Row].Case;
    const ParameterCorrespondence& found = one.Found;
    if (found.IsFlipped())
    {
      flipped.push_back({name, ": it looks flipped, " + FixedText(found.OwnDistance, 2) +
                                   " mm from the mean of the others, but " +
                                   FixedText(found.TurnedDistance, 2) + " mm after a turn by " +
                                   FixedText(found.TurnAngle() * DegreesPerRadian, 0) +
                                   " degrees"});
    }
    if (one.IsOutlier)
    {
      outliers.push_back({name, ": it is " + FixedText(found.Distance, 2) +
                                    " mm from the mean of the others, more than usual (" +
                                    FixedText(correspondence.Fence, 2) + " mm)"});
    }
  }
  AddCohortNotes(flipped, "look flipped: turned they are clearly closer to the others",
                 "correspondence.csv", group);
  AddCohortNotes(outliers, "are farther from the mean of the others than usual",
                 "correspondence.csv", group);
}
} // namespace

CohortCorrespondence FindCohortCorrespondence(CohortGroup& group, const KernelProgress& progress)
{
  CohortCorrespondence correspondence;
  if (group.Models.size() < 3)
  {
    return correspondence;
  }
  std::vector<ParameterCorrespondence> found;
  if (!CompareParameters(group.Models, progress, found).IsOk())
  {
    throw Cancelled();
  }
  std::vector<double> distances;
  std::transform(found.begin(), found.end(), std::back_inserter(distances),
                 [](const ParameterCorrespondence& one) { return one.Distance; });
  correspondence.Fence = UpperLogFence(distances);
  for (std::size_t row = 0; row < found.size(); ++row)
  {
    correspondence.Cases.push_back({row, found[row], found[row].Distance > correspondence.Fence});
  }
  std::stable_sort(correspondence.Cases.begin(), correspondence.Cases.end(),
                   [](const CorrespondingCase& a, const CorrespondingCase& b)
                   { return a.Found.Distance > b.Found.Distance; });
  NoteCorrespondence(correspondence, group);
  return correspondence;
}

std::string CorrespondenceTable(const CohortGroup& group,
                                const CohortCorrespondence& correspondence)
{
  std::string text = CsvLine({"case", "label", "distance_mm", "own_mm", "turned_mm", "turn_ratio",
                              "turned", "turn_deg", "flipped", "outlier"});
  for (const CorrespondingCase& one : correspondence.Cases)
  {
    const CohortRow& row = group.Rows[one.Row];
    const ParameterCorrespondence& found = one.Found;
    text +=
        CsvLine({row.Case, std::to_string(row.Result.Structure.Label), ExactText(found.Distance),
                 ExactText(found.OwnDistance), ExactText(found.TurnedDistance),
                 ExactText(found.TurnRatio()), found.TurnsBody ? "body" : "parameters",
                 ExactText(found.TurnAngle() * DegreesPerRadian), found.IsFlipped() ? "yes" : "no",
                 one.IsOutlier ? "yes" : "no"});
  }
  return text;
}
} // namespace palpate
