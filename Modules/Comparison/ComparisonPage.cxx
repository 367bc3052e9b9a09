#include "ComparisonPage.h"

#include "ComparisonCharts.h"
#include "ComparisonNames.h"
#include "DecimalText.h"
#include "HtmlText.h"
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

std::string Header(const PairComparison& pair)
{
  const auto [one, other] = TitlesOf(pair);
  return "<header>\n<div class=\"kicker\">Palpate \xC2\xB7 comparison</div>\n<h1>" +
         EscapeHtml(one) + " and " + EscapeHtml(other) + "</h1>\n<div class=\"soft\">" +
         EscapeHtml(SideText(pair.One)) + " (" + pair.One.Kind + "), against " +
         EscapeHtml(SideText(pair.Other)) + " (" + pair.Other.Kind +
         ") as the reference</div>\n<p>" + EscapeHtml(ComparisonVerdict(pair)) +
         "</p>\n</header>\n";
}

std::string Cards(const PairComparison& pair)
{
  const BodyComparison& found = pair.Numbers;
  std::string cards;
  if (found.Overlap)
  {
    const std::string cells = "by " + CellsText(*found.Overlap);
    cards += ReportCard("Dice", FixedText(found.Overlap->Dice(), 4), "", cells) +
             ReportCard("Jaccard", FixedText(found.Overlap->Jaccard(), 4), "", cells);
  }
  cards += ReportCard("Mean distance", FixedText(found.Both.Mean, 2), "mm",
                      "of both surfaces, by area") +
           ReportCard("95 % Hausdorff distance", FixedText(found.Hausdorff95(), 2), "mm",
                      "the larger of both directions") +
           ReportCard("Hausdorff distance", FixedText(found.Both.Largest, 2), "mm", "the largest");
  if (std::isfinite(pair.VolumeDifference()))
  {
    cards += ReportCard("Volume", FixedText(pair.One.Milliliters, 2), "ml",
                        SignedText(pair.VolumeDifferencePercent(), 1) +
                            " % of the reference\xE2\x80\x99s " +
                            FixedText(pair.Other.Milliliters, 2) + " ml");
  }
  for (const BodyComparison::Tolerance& tolerance : found.Tolerances)
  {
    cards +=
        ReportCard("Surface Dice at " + ToleranceText(tolerance.Millimeters) + " mm",
                   FixedText(tolerance.SurfaceDice, 3), "", "of the surfaces\xE2\x80\x99 area");
  }
  return "<dl class=\"cards\">\n" + cards + "</dl>\n";
}

void AddSummary(const DistanceSummary& summary, HtmlRows& rows)
{
  rows.emplace_back("Mean", FixedText(summary.Mean, 3) + " mm");
  rows.emplace_back("Root mean square", FixedText(summary.Rms, 3) + " mm");
  rows.emplace_back("95th percentile", FixedText(summary.Percentile95, 3) + " mm");
  rows.emplace_back("Maximum", FixedText(summary.Largest, 3) + " mm");
}

std::string DirectionTable(const std::string& caption, const DistanceMap& map)
{
  HtmlRows rows;
  AddSummary(map.Unsigned, rows);
  if (std::isfinite(map.SignedMean))
  {
    rows.emplace_back("Signed mean", SignedText(map.SignedMean, 3) + " mm");
  }
  return HtmlTable(caption, rows);
}

std::string BodyTable(const std::string& caption, const ComparedSide& side)
{
  HtmlRows rows{{"Kind", side.Kind}};
  if (std::isfinite(side.Milliliters))
  {
    rows.emplace_back("Volume", FixedText(side.Milliliters, 3) + " ml");
  }
  rows.emplace_back("Area", FixedText(side.Area, 1) + " mm\xC2\xB2");
  return HtmlTable(caption, rows);
}

std::string NumberTables(const PairComparison& pair)
{
  HtmlRows both;
  AddSummary(pair.Numbers.Both, both);
  return "<div class=\"tables\">\n" + BodyTable("The first", pair.One) +
         BodyTable("The reference", pair.Other) + HtmlTable("Both directions together", both) +
         DirectionTable("From the first surface to the reference", pair.Numbers.OneToOther) +
         DirectionTable("From the reference to the first surface", pair.Numbers.OtherToOne) +
         "</div>\n";
}

std::string BiasTables(const PairComparison& pair)
{
  if (!pair.Numbers.Bias)
  {
    return {};
  }
  const auto text = [](const SideBias::Part& part)
  {
    return SignedText(part.Mean, 2) + " mm, on " + FixedText(100.0 * part.Share, 0) +
           " % of the area";
  };
  HtmlRows sides;
  for (std::size_t side = 0; side < PatientSides().size(); ++side)
  {
    sides.emplace_back(PatientSides()[side].Name, text(pair.Numbers.Bias->Sides[side]));
  }
  HtmlRows octants;
  for (std::size_t octant = 0; octant < pair.Numbers.Bias->Octants.size(); ++octant)
  {
    octants.emplace_back(OctantName(octant), text(pair.Numbers.Bias->Octants[octant]));
  }
  return "<p class=\"soft\">Mean signed distance of the first surface from the reference where it "
         "lies on that side of the reference\xE2\x80\x99s centre: positive where the first "
         "surface is farther out.</p>\n<div class=\"tables\">\n" +
         HtmlTable("Sides", sides) + HtmlTable("Octants", octants) + "</div>\n";
}

std::string Definitions()
{
  return "<p>Dice is twice the shared volume over the sum of both volumes; Jaccard is the shared "
         "volume over that of both together. Distances are from points of one surface to the "
         "nearest point of the other, over the area, within 1 %; distances "
         "from a model are those from the model itself. A mask\xE2\x80\x99s surface lies half way "
         "between the centres of voxels inside and outside, with the steps of the voxels. The "
         "normalised surface Dice is the area of both surfaces that lies within a tolerance of "
         "the other one, over the area of both (Nikolov et al., J. Med. Internet Res. 23, 2021, "
         "e26151).</p>\n";
}
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
  return ReportPage(
      one + " and " + other,
      Header(pair) + Cards(pair) + ReportSection("Notes", ReportNotes(pair.Notes)) +
          ReportSection("Outlines", ComparisonSlices(pair, map)) +
          ReportSection("The first surface, by its distance from the reference", map.OneViews()) +
          ReportSection("The reference, by its distance from the first surface", map.OtherViews()) +
          ReportSection("By distance", ComparisonCharts(pair)) +
          ReportSection("Bias by side", BiasTables(pair)) +
          ReportSection("All numbers", NumberTables(pair)) +
          ReportSection("Definitions", Definitions()) +
          ReportFooter("Lengths are millimetres in the patient\xE2\x80\x99s frame (L, P, S). For "
                       "research; not a medical device."));
}
} // namespace palpate
