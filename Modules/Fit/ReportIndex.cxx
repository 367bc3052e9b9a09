#include "ReportIndex.h"

#include "CaseText.h"
#include "HtmlText.h"
#include "ReportPage.h"
#include "ReportVerdict.h"
#include "WholeFile.h"

namespace palpate
{
namespace
{
// A file that cannot be read has no structure, and its message is complete.
bool HasStructure(const FitResult& result)
{
  return result.Structure.Label != 0 || !result.Structure.Name.empty();
}

std::string ReasonText(const FitResult& result)
{
  return HasStructure(result) ? VerdictText(result) : SharedText(result.Input, result.Message);
}
} // namespace

ReportIndex::ReportIndex()
    : Table({{"Structure", "text"},
             {"File", "text"},
             {"Verdict", "text"},
             {"Dice", "number"},
             {"Mean, mm", "number"},
             {"95 %, mm", "number"},
             {"Max, mm", "number"},
             {"Mask, ml", "number"},
             {"Model, ml", "number"},
             {"Degree", "number"},
             {"Hidden, %", "number"}})
{
}

void ReportIndex::Add(const FitResult& result, int degree, const std::filesystem::path& report)
{
  const bool isFitted = result.State == FitResult::Outcome::Fitted;
  ++this->CaseCount;
  this->FittedCount += isFitted ? 1 : 0;
  const OutcomeText outcome = TextOf(result.State);
  const auto number = [this](bool isKnown, double value, int digits)
  { isKnown ? this->Table.AddNumber(value, digits) : this->Table.AddNothing(); };
  this->Table.AddLink(HasStructure(result) ? StructureText(result) : "\xE2\x80\x93", report);
  this->Table.AddText(result.Input.filename().string());
  this->Table.AddHtml("<span class=\"" + outcome.Style + "\" title=\"" +
                      EscapeHtml(ReasonText(result)) + "\">" + outcome.Title + "</span>");
  number(isFitted, result.Dice, 4);
  number(isFitted, result.ModelToInput().Mean, 3);
  number(isFitted, result.ModelToInput().Percentile95, 3);
  number(isFitted, result.ModelToInput().Maximum, 3);
  number(result.MaskMilliliters > 0.0, result.MaskMilliliters, 2);
  number(isFitted, result.ModelMilliliters, 2);
  number(isFitted, degree, 0);
  number(isFitted || result.Surface != nullptr, result.HiddenPercent, 2);
  if (!isFitted)
  {
    this->Messages += "<li><strong>" + EscapeHtml(result.Input.filename().string()) +
                      "</strong>: " + EscapeHtml(ReasonText(result)) + "</li>\n";
  }
}

void ReportIndex::Write(const std::filesystem::path& html) const
{
  const std::string messages = this->Messages.empty()
                                   ? std::string()
                                   : "<ul class=\"notes\">\n" + this->Messages + "</ul>\n";
  WriteWholeFile(
      html,
      ReportPage("Palpate fits",
                 "<header>\n<div class=\"kicker\">Palpate \xC2\xB7 spherical-harmonic fits</div>\n"
                 "<h1>" +
                     std::to_string(this->CaseCount) + " cases, " +
                     std::to_string(this->FittedCount) + " fitted</h1>\n</header>\n<section>\n" +
                     this->Table.Html() +
                     "<p class=\"soft\">Distances are those between model "
                     "and mask boundary.</p>\n</section>\n" +
                     ReportSection("Not fitted", messages) + ReportFooter()));
}
} // namespace palpate
