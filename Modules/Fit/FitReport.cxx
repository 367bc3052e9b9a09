#include "FitReport.h"

#include "CaseText.h"
#include "DecimalText.h"
#include "HtmlText.h"
#include "ReportCharts.h"
#include "ReportPage.h"
#include "ReportSlices.h"
#include "ReportTables.h"
#include "ReportVerdict.h"
#include "ReportViews.h"
#include "SoftwareVersions.h"
#include "WholeFile.h"

namespace palpate
{
namespace
{
std::string Header(const FitResult& result)
{
  const OutcomeText outcome = TextOf(result.State);
  return "<header>\n<div class=\"kicker\">Palpate \xC2\xB7 spherical-harmonic fit</div>\n<h1>" +
         EscapeHtml(StructureText(result)) + "</h1>\n<div class=\"soft\">" +
         (result.IsOfSurface ? "surface "
                             : "label " + std::to_string(result.Structure.Label) + " of ") +
         EscapeHtml(result.Input.filename().string()) + "</div>\n<div class=\"verdict " +
         outcome.Style + "\"><strong>" + outcome.Title + "</strong><p>" +
         EscapeHtml(VerdictText(result)) + "</p></div>\n</header>\n";
}

std::string QualityCards(const FitResult& result)
{
  const double difference = 100.0 * (result.ModelMilliliters / result.InputMilliliters() - 1.0);
  const SurfaceDistances& distances = result.ModelToInput();
  const std::string to = result.IsOfSurface ? "model to surface" : "model to mask";
  const std::string grid = result.IsOfSurface
                               ? "on cubes of " + SignificantText(result.DiceSpacing, 3) + " mm"
                               : "on the mask\xE2\x80\x99s grid";
  return ReportCard("Dice", FixedText(result.Dice, 4), "", grid) +
         ReportCard("Mean distance", FixedText(distances.Mean, 2), "mm", to) +
         ReportCard("95th percentile", FixedText(distances.Percentile95, 2), "mm", to) +
         ReportCard("Maximum", FixedText(distances.Maximum, 2), "mm", to) +
         ReportCard("Model volume", FixedText(result.ModelMilliliters, 2), "ml",
                    (difference >= 0.0 ? "+" : "") + FixedText(difference, 2) + " % against the " +
                        (result.IsOfSurface ? "surface" : "mask")) +
         ReportCard("Coverage", CoverageWord(result.Coverage), "", "how far to trust the fit") +
         ReportCard("Degree", std::to_string(DegreeOf(result.Model)), "",
                    std::to_string(CoefficientCountOf(result.Model)) + " coefficients of a " +
                        (result.Radial() != nullptr ? "radial" : "surface") + " model");
}

std::string Cards(const FitResult& result)
{
  std::string cards;
  if (result.State == FitResult::Outcome::Fitted)
  {
    cards += QualityCards(result);
  }
  if (result.MaskMilliliters > 0.0)
  {
    cards += ReportCard("Mask volume", FixedText(result.MaskMilliliters, 2), "ml",
                        result.TouchesBorder ? "touches the image\xE2\x80\x99s border" : "");
  }
  if (result.IsSampled)
  {
    cards += ReportCard("Star-shaped", result.StarShaped ? "yes" : "no", "",
                        FixedText(result.HiddenPercent, 2) + " % of the surface hidden");
  }
  return cards.empty() ? cards : "<dl class=\"cards\">\n" + cards + "</dl>\n";
}

std::string Notes(const FitResult& result, const Volume* volume)
{
  std::vector<std::string> notes;
  for (const std::string& note : result.Notes)
  {
    notes.push_back(SharedText(result.Input, note));
  }
  if (volume)
  {
    for (const std::string& note : volume->Notes)
    {
      notes.push_back(SharedText(volume->Source, note));
    }
  }
  return ReportNotes(notes);
}
} // namespace

void WriteFitReport(const FitResult& result, const Volume* volumeOrNull,
                    const std::filesystem::path& html)
{
  const std::string body =
      Header(result) + Cards(result) + ReportSection("Notes", Notes(result, volumeOrNull)) +
      ReportSection("Slices", ReportSlices(result, volumeOrNull)) +
      ReportSection("What the repair changed", ReportRepair(result, volumeOrNull)) +
      ReportSection("From six sides", ReportViews(result)) +
      ReportSection("By degree and by distance", ReportCharts(result)) +
      ReportSection("All numbers", ReportNumbers(result)) +
      ReportSection("Settings and software",
                    "<div class=\"tables\">\n" + ReportSettings(result.Settings) +
                        HtmlTable("Software", SoftwareVersions()) + "</div>\n") +
      "<footer>Lengths are millimetres in the patient\xE2\x80\x99s frame (L, P, S). For research; "
      "not a medical device.</footer>\n";
  WriteWholeFile(html, ReportPage(StructureText(result) + " \xE2\x80\x93 Palpate", body));
}
} // namespace palpate
