#include "FitReport.h"

#include "CaseText.h"
#include "DecimalText.h"
#include "FitSettingsText.h"
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
std::vector<ReportCard> Cards(const FitResult& result)
{
  std::vector<ReportCard> cards;
  if (result.State == FitResult::Outcome::Fitted)
  {
    const double difference = 100.0 * (result.ModelMilliliters / result.InputMilliliters() - 1.0);
    const SurfaceDistances& distances = result.ModelToInput();
    const std::string input = result.IsOfSurface ? "surface" : "mask";
    const std::string grid = result.IsOfSurface
                                 ? "on cubes of " + SignificantText(result.DiceSpacing, 3) + " mm"
                                 : "on the mask\xE2\x80\x99s grid";
    cards = {
        {"Dice", FixedText(result.Dice, 4), "", grid},
        {"Mean distance", FixedText(distances.Mean, 2), "mm", "model to " + input},
        {"95th percentile", FixedText(distances.Percentile95, 2), "mm", "model to " + input},
        {"Maximum", FixedText(distances.Maximum, 2), "mm", "model to " + input},
        {"Model volume", FixedText(result.ModelMilliliters, 2), "ml",
         (difference >= 0.0 ? "+" : "") + FixedText(difference, 2) + " % against the " + input},
        {"Coverage", CoverageWord(result.Coverage), "", "how far to trust the fit"},
        {"Degree", std::to_string(DegreeOf(result.Model)), "",
         std::to_string(CoefficientCountOf(result.Model)) + " coefficients of a " +
             (result.Radial() != nullptr ? "radial" : "surface") + " model"}};
  }
  if (result.MaskMilliliters > 0.0)
  {
    cards.push_back({"Mask volume", FixedText(result.MaskMilliliters, 2), "ml",
                     result.TouchesBorder ? "touches the image\xE2\x80\x99s border" : ""});
  }
  if (result.IsSampled)
  {
    cards.push_back({"Star-shaped", result.StarShaped ? "yes" : "no", "",
                     FixedText(result.HiddenPercent, 2) + " % of the surface hidden"});
  }
  return cards;
}

std::vector<std::string> Notes(const FitResult& result, const Volume* volume)
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
  return notes;
}
} // namespace

void WriteFitReport(const FitResult& result, const Volume* volumeOrNull,
                    const std::filesystem::path& html)
{
  const OutcomeText outcome = TextOf(result.State);
  ReportPage page;
  page.Header("spherical-harmonic fit", StructureText(result),
              (result.IsOfSurface ? "surface "
                                  : "label " + std::to_string(result.Structure.Label) + " of ") +
                  result.Input.filename().string())
      .Verdict(outcome.Style, outcome.Title, VerdictText(result))
      .Cards(Cards(result))
      .Section("Notes")
      .Notes(Notes(result, volumeOrNull));
  ReportSlices(page.Section("Slices"), result, volumeOrNull);
  ReportRepair(page.Section("What the repair changed"), result, volumeOrNull);
  ReportViews(page.Section("From six sides"), result);
  ReportCharts(page.Section("By degree and by distance"), result);
  ReportNumbers(page.Section("All numbers"), result);
  page.Section("Settings and software")
      .Facts("Settings, named as the command line\xE2\x80\x99s options",
             DescribeSettings(result.Settings))
      .Facts("Software", SoftwareVersions());
  WriteWholeFile(html,
                 page.Whole(StructureText(result) + " \xE2\x80\x93 Palpate",
                            "Lengths are millimetres in the patient\xE2\x80\x99s frame (L, P, "
                            "S). For research; not a medical device."));
}
} // namespace palpate
