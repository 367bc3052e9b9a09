#include "ComparisonPage.h"

#include "ComparisonCharts.h"
#include "ComparisonNames.h"
#include "DecimalText.h"
#include "PatientSides.h"
#include "ReportPage.h"

#include <cmath>

namespace palpate
{
namespace
{
std::string SideText(const ComparedSide& side)
{
  const bool isLabel = side.Structure.Label != 0;
  return side.File.filename().string() +
         (isLabel ? ", label " + std::to_string(side.Structure.Label) : "") +
         (isLabel && !side.Structure.Name.empty() ? " (" + side.Structure.Name + ")" : "");
}

std::vector<ReportCard> Cards(const PairComparison& pair)
{
  const BodyComparison& found = pair.Numbers;
  std::vector<ReportCard> cards;
  if (found.Overlap)
  {
    const std::string cells = "by " + CellsText(*found.Overlap);
    cards = {{"Dice", FixedText(found.Overlap->Dice(), 4), "", cells},
             {"Jaccard", FixedText(found.Overlap->Jaccard(), 4), "", cells}};
  }
  cards.push_back(
      {"Mean distance", FixedText(found.Both.Mean, 2), "mm", "of both surfaces, by area"});
  cards.push_back({"95 % Hausdorff distance", FixedText(found.Hausdorff95(), 2), "mm",
                   "the larger of both directions"});
  cards.push_back({"Hausdorff distance", FixedText(found.Both.Largest, 2), "mm", "the largest"});
  if (std::isfinite(pair.VolumeDifference()))
  {
    cards.push_back({"Volume", FixedText(pair.One.Milliliters, 2), "ml",
                     SignedText(pair.VolumeDifferencePercent(), 1) +
                         " % of the reference\xE2\x80\x99s " +
                         FixedText(pair.Other.Milliliters, 2) + " ml"});
  }
  for (const BodyComparison::Tolerance& tolerance : found.Tolerances)
  {
    cards.push_back({"Surface Dice at " + ToleranceText(tolerance.Millimeters) + " mm",
                     FixedText(tolerance.SurfaceDice, 3), "", "of the surfaces\xE2\x80\x99 area"});
  }
  return cards;
}

ReportRows SummaryOf(const DistanceSummary& summary)
{
  return {{"Mean", FixedText(summary.Mean, 3) + " mm"},
          {"Root mean square", FixedText(summary.Rms, 3) + " mm"},
          {"95th percentile", FixedText(summary.Percentile95, 3) + " mm"},
          {"Maximum", FixedText(summary.Largest, 3) + " mm"}};
}

ReportRows DirectionOf(const DistanceMap& map)
{
  ReportRows rows = SummaryOf(map.Unsigned);
  if (std::isfinite(map.SignedMean))
  {
    rows.emplace_back("Signed mean", SignedText(map.SignedMean, 3) + " mm");
  }
  return rows;
}

ReportRows BodyOf(const ComparedSide& side)
{
  ReportRows rows{{"Kind", side.Kind}};
  if (std::isfinite(side.Milliliters))
  {
    rows.emplace_back("Volume", FixedText(side.Milliliters, 3) + " ml");
  }
  rows.emplace_back("Area", FixedText(side.Area, 1) + " mm\xC2\xB2");
  return rows;
}

void AddBias(ReportPage& page, const SideBias& bias)
{
  const auto text = [](const SideBias::Part& part)
  {
    return SignedText(part.Mean, 2) + " mm, on " + FixedText(100.0 * part.Share, 0) +
           " % of the area";
  };
  ReportRows sides;
  for (std::size_t side = 0; side < PatientSides().size(); ++side)
  {
    sides.emplace_back(PatientSides()[side].Name, text(bias.Sides[side]));
  }
  ReportRows octants;
  for (std::size_t octant = 0; octant < bias.Octants.size(); ++octant)
  {
    octants.emplace_back(OctantName(octant), text(bias.Octants[octant]));
  }
  page.Section("Bias by side")
      .SoftText(
          "Mean signed distance of the first surface from the reference where it lies on that "
          "side of the reference\xE2\x80\x99s centre: positive where the first surface is "
          "farther out.")
      .Facts("Sides", sides)
      .Facts("Octants", octants);
}

constexpr const char* Definitions =
    "Dice is twice the shared volume over the sum of both volumes; Jaccard is the shared volume "
    "over "
    "that of both together. Distances are from points of one surface to the nearest point of the "
    "other, over the area, within 1 %; distances from a model are those from the model itself. A "
    "mask\xE2\x80\x99s surface lies half way between the centres of voxels inside and outside, "
    "with "
    "the steps of the voxels. The normalised surface Dice is the area of both surfaces that lies "
    "within a tolerance of the other one, over the area of both (Nikolov et al., J. Med. Internet "
    "Res. 23, 2021, e26151).";
} // namespace

std::string ComparisonVerdict(const PairComparison& pair)
{
  const BodyComparison& found = pair.Numbers;
  std::string text = found.Overlap ? "Dice " + FixedText(found.Overlap->Dice(), 4) + ". " : "";
  text += "The surfaces are " + FixedText(found.Both.Mean, 2) +
          " mm apart on average; 95 % of each "
          "lies within " +
          FixedText(found.Hausdorff95(), 2) + " mm of the other one.";
  const double percent = pair.VolumeDifferencePercent();
  if (std::isfinite(percent))
  {
    text += " The first is " + FixedText(std::abs(percent), 1) + " % " +
            (percent < 0.0 ? "smaller" : "larger") + " than the reference.";
  }
  return text;
}

std::string ComparisonPage(const PairComparison& pair, const ComparisonMap& map)
{
  const auto [one, other] = TitlesOf(pair);
  ReportPage page;
  page.Header("comparison", one + " and " + other,
              SideText(pair.One) + " (" + pair.One.Kind + "), against " + SideText(pair.Other) +
                  " (" + pair.Other.Kind + ") as the reference")
      .Text(ComparisonVerdict(pair))
      .Cards(Cards(pair))
      .Section("Notes")
      .Notes(pair.Notes);
  AddComparisonSlices(page.Section("Outlines"), pair, map);
  map.AddViews(page.Section("The first surface, by its distance from the reference"), map.One());
  map.AddViews(page.Section("The reference, by its distance from the first surface"), map.Other());
  AddComparisonCharts(page.Section("By distance"), pair);
  if (pair.Numbers.Bias)
  {
    AddBias(page, *pair.Numbers.Bias);
  }
  page.Section("All numbers")
      .Facts("The first", BodyOf(pair.One))
      .Facts("The reference", BodyOf(pair.Other))
      .Facts("Both directions together", SummaryOf(pair.Numbers.Both))
      .Facts("From the first surface to the reference", DirectionOf(pair.Numbers.OneToOther))
      .Facts("From the reference to the first surface", DirectionOf(pair.Numbers.OtherToOne))
      .Section("Definitions")
      .Text(Definitions);
  return page.Whole(one + " and " + other,
                    "Lengths are millimetres in the patient\xE2\x80\x99s frame (L, P, S). For "
                    "research; not a medical device.");
}
} // namespace palpate
