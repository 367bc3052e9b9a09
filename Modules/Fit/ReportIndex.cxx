#include "ReportIndex.h"

#include "CaseText.h"
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
    : Table({"Structure", "File", "Verdict", "Dice", "Mean, mm", "95 %, mm", "Max, mm", "Mask, ml",
             "Model, ml", "Degree", "Hidden, %"},
            true)
{
}

void ReportIndex::Add(const FitResult& result, int degree, const std::filesystem::path& report)
{
  const bool isFitted = result.State == FitResult::Outcome::Fitted;
  ++this->CaseCount;
  this->FittedCount += isFitted ? 1 : 0;
  const OutcomeText outcome = TextOf(result.State);
  const std::string file = result.Input.filename().string();
  const auto number = [this](bool isKnown, double value, int digits)
  { isKnown ? this->Table.Number(value, digits) : this->Table.Nothing(); };
  this->Table.Link(HasStructure(result) ? StructureText(result) : "\xE2\x80\x93", report)
      .Text(file)
      .Marked(outcome.Style, outcome.Title, ReasonText(result));
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
    this->Messages.push_back(file + ": " + ReasonText(result));
  }
}

void ReportIndex::Write(const std::filesystem::path& html) const
{
  ReportPage page;
  page.Header("spherical-harmonic fits", std::to_string(this->CaseCount) + " cases, " +
                                             std::to_string(this->FittedCount) + " fitted")
      .Table(this->Table)
      .SoftText("Distances are those between model and mask boundary.")
      .Section("Not fitted")
      .Notes(this->Messages);
  WriteWholeFile(html, page.Whole("Palpate fits"));
}
} // namespace palpate
