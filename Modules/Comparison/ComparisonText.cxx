#include "ComparisonText.h"

#include "CaseText.h"
#include "ComparisonNames.h"
#include "ComparisonOverview.h"
#include "DecimalText.h"
#include "PatientSides.h"
#include "TextTable.h"
#include "Units.h"

#include <cmath>

namespace palpate
{
namespace
{
std::string TitleOf(const ComparedSide& side)
{
  return side.Structure.Label == 0 ? side.File.string() : CaseTitle(side.File, side.Structure);
}

std::string Distances(const DistanceSummary& summary)
{
  return "mean " + FixedText(summary.Mean, 3) + ", RMS " + FixedText(summary.Rms, 3) + ", 95 % " +
         FixedText(summary.Percentile95, 3) + ", maximum " + FixedText(summary.Largest, 3) + " mm";
}

std::string Direction(const DistanceMap& map)
{
  return Distances(map.Unsigned) + (std::isfinite(map.SignedMean)
                                        ? ", signed mean " + SignedText(map.SignedMean, 3) + " mm"
                                        : "");
}

std::string SurfaceDiceText(const BodyComparison& found)
{
  std::string text;
  for (const BodyComparison::Tolerance& tolerance : found.Tolerances)
  {
    text += (text.empty() ? "" : ", ") + FixedText(tolerance.SurfaceDice, 4) + " at " +
            ToleranceText(tolerance.Millimeters) + " mm";
  }
  return text;
}

std::string MotionText(const BodyMotion& motion)
{
  return "moved by " + FixedText(motion.Shift.norm(), 2) + " mm, turned by " +
         FixedText(motion.Turn * DegreesPerRadian, 1) + " degrees, " + FixedText(motion.Rest, 2) +
         " mm left";
}

std::string BiasText(const SideBias& bias)
{
  std::string text;
  for (std::size_t side = 0; side < PatientSides().size(); ++side)
  {
    text += (text.empty() ? "" : ", ") + std::string(PatientSides()[side].Name) + " " +
            SignedText(bias.Sides[side].Mean, 2);
  }
  return text + " mm";
}
} // namespace

std::string ComparisonText(const PairComparison& pair)
{
  const BodyComparison& found = pair.Numbers;
  TextTable table;
  table.AddRow({"first", TitleOf(pair.One)});
  table.AddRow({"reference", TitleOf(pair.Other) + (pair.Mirror ? ", mirrored" : "")});
  if (found.Overlap)
  {
    table.AddRow({"Dice", FixedText(found.Overlap->Dice(), 4) + ", Jaccard " +
                              FixedText(found.Overlap->Jaccard(), 4) + ", by " +
                              CellsText(*found.Overlap)});
  }
  if (std::isfinite(pair.VolumeDifference()))
  {
    table.AddRow({"volume", FixedText(pair.One.Milliliters, 3) + " ml, reference " +
                                FixedText(pair.Other.Milliliters, 3) + " ml (" +
                                SignedText(pair.VolumeDifferencePercent(), 2) + " %)"});
  }
  if (pair.Mirror && std::isfinite(pair.VolumeDifference()))
  {
    table.AddRow({"asymmetry", "of volume " + SignedText(pair.VolumeAsymmetryPercent(), 2) +
                                   " %, of shape " + FixedText(pair.ShapeAsymmetryPercent(), 2) +
                                   " % of a radius"});
  }
  table.AddRow({"distance", Distances(found.Both)});
  table.AddRow({"  first to reference", Direction(found.OneToOther)});
  table.AddRow({"  reference to first", Direction(found.OtherToOne)});
  table.AddRow({"95 % Hausdorff", FixedText(found.Hausdorff95(), 3) + " mm"});
  if (found.LeastDistance > 0.0)
  {
    table.AddRow({"least distance", FixedText(found.LeastDistance, 3) + " mm"});
  }
  if (!found.Tolerances.empty())
  {
    table.AddRow({"surface Dice", SurfaceDiceText(found)});
  }
  if (found.Bias)
  {
    table.AddRow({"bias", BiasText(*found.Bias)});
  }
  if (pair.Motion)
  {
    table.AddRow({"motion", MotionText(*pair.Motion)});
    for (const Vector3& landmark : pair.Motion->Landmarks)
    {
      table.AddRow({"  landmark at", FixedText(landmark.x(), 2) + ", " +
                                         FixedText(landmark.y(), 2) + ", " +
                                         FixedText(landmark.z(), 2) + " mm"});
    }
  }
  return table.Text();
}

std::string ComparisonLine(const PairComparison& pair)
{
  const BodyComparison& found = pair.Numbers;
  TextTable table;
  const Segment& structure = pair.One.Structure;
  table.AddRow({pair.Case +
                (structure.Label == 0 ? "" : ", label " + std::to_string(structure.Label)) + ": " +
                (found.Overlap ? "Dice " + FixedText(found.Overlap->Dice(), 4) + ", " : "") +
                "distance mean " + FixedText(found.Both.Mean, 3) + ", 95 % Hausdorff " +
                FixedText(found.Hausdorff95(), 3) + ", maximum " +
                FixedText(found.Both.Largest, 3) + " mm, surface Dice " + SurfaceDiceText(found) +
                (pair.Motion ? ", " + MotionText(*pair.Motion) : "")});
  return table.Text();
}

std::string SummaryText(const std::vector<PairComparison>& pairs)
{
  TextTable table;
  table.AlignRight({1, 2, 3, 4});
  table.AddRow({"", "mean", "median", "least", "largest"});
  std::size_t count = 0;
  for (const SummarisedNumber& one : SummariseComparisons(pairs))
  {
    const NumberSummary& summary = one.Summary;
    count = std::max(count, summary.Count);
    table.AddRow({one.Name + (one.Unit.empty() ? "" : ", " + one.Unit),
                  FixedText(summary.Mean, one.Digits), FixedText(summary.Median, one.Digits),
                  FixedText(summary.Least, one.Digits), FixedText(summary.Largest, one.Digits)});
  }
  return count == 0
             ? std::string()
             : CountText(static_cast<std::int64_t>(count), "pair\n", "pairs\n") + table.Text();
}
} // namespace palpate
