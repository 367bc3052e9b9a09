#include "ReportIndex.h"

#include "CaseText.h"
#include "DecimalText.h"
#include "HtmlText.h"
#include "ReportPage.h"
#include "ReportVerdict.h"
#include "WholeFile.h"

#include <array>
#include <cctype>

namespace palpate
{
namespace
{
struct Column
{
  const char* Head;
  const char* Style;
};

constexpr std::array<Column, 11> Columns{{{"Structure", "text"},
                                          {"File", "text"},
                                          {"Verdict", "text"},
                                          {"Dice", "number"},
                                          {"Mean, mm", "number"},
                                          {"95 %, mm", "number"},
                                          {"Max, mm", "number"},
                                          {"Mask, ml", "number"},
                                          {"Model, ml", "number"},
                                          {"Degree", "number"},
                                          {"Hidden, %", "number"}}};

// Sorts the table's rows, numerically if the cells are numbers and otherwise as text.
const char* const SortScript = R"js(<script>
document.querySelectorAll("thead th").forEach(function (head, column) {
  head.addEventListener("click", function () {
    var down = head.getAttribute("aria-sort") === "ascending";
    document.querySelectorAll("thead th").forEach(function (h) { h.removeAttribute("aria-sort"); });
    head.setAttribute("aria-sort", down ? "descending" : "ascending");
    var body = document.querySelector("tbody");
    var key = function (row) { return row.cells[column].textContent.trim(); };
    Array.from(body.rows).sort(function (a, b) {
      var x = key(a), y = key(b), order = parseFloat(x) - parseFloat(y);
      if (isNaN(order)) { order = x.localeCompare(y, undefined, { numeric: true }); }
      return down ? -order : order;
    }).forEach(function (row) { body.appendChild(row); });
  });
});
</script>
)js";

std::string Cell(const char* style, const std::string& content)
{
  return std::string("<td class=\"") + style + "\">" + content + "</td>";
}

std::string NumberCell(bool isKnown, double number, int digits)
{
  return Cell("number", isKnown ? FixedText(number, digits) : std::string());
}

// A path encoded for a link: percent-encodes everything but letters, digits and - _ . /
std::string LinkText(const std::filesystem::path& path)
{
  static const char* const Digits = "0123456789ABCDEF";
  std::string link;
  for (const char c : path.generic_string())
  {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || c == '-' || c == '_' || c == '.' || c == '/')
    {
      link += c;
    }
    else
    {
      link += std::string("%") + Digits[byte >> 4U] + Digits[byte & 15U];
    }
  }
  return link;
}
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

void ReportIndex::Add(const FitResult& result, int degree, const std::filesystem::path& report)
{
  const bool isFitted = result.State == FitResult::Outcome::Fitted;
  ++this->CaseCount;
  this->FittedCount += isFitted ? 1 : 0;
  const std::string name =
      HasStructure(result) ? EscapeHtml(StructureText(result)) : std::string("\xE2\x80\x93");
  const OutcomeText outcome = TextOf(result.State);
  const std::string verdict = "<span class=\"" + outcome.Style + "\" title=\"" +
                              EscapeHtml(ReasonText(result)) + "\">" + outcome.Title + "</span>";
  this->Rows +=
      "<tr>" +
      Cell("text",
           report.empty() ? name : "<a href=\"" + LinkText(report) + "\">" + name + "</a>") +
      Cell("text", EscapeHtml(result.Input.filename().string())) + Cell("text", verdict) +
      NumberCell(isFitted, result.Dice, 4) + NumberCell(isFitted, result.ModelToInput().Mean, 3) +
      NumberCell(isFitted, result.ModelToInput().Percentile95, 3) +
      NumberCell(isFitted, result.ModelToInput().Maximum, 3) +
      NumberCell(result.MaskMilliliters > 0.0, result.MaskMilliliters, 2) +
      NumberCell(isFitted, result.ModelMilliliters, 2) + NumberCell(isFitted, degree, 0) +
      NumberCell(isFitted || result.Surface != nullptr, result.HiddenPercent, 2) + "</tr>\n";
  if (!isFitted)
  {
    this->Messages += "<li><strong>" + EscapeHtml(result.Input.filename().string()) +
                      "</strong>: " + EscapeHtml(ReasonText(result)) + "</li>\n";
  }
}

void ReportIndex::Write(const std::filesystem::path& html) const
{
  std::string heads;
  for (const Column& column : Columns)
  {
    heads +=
        std::string("<th scope=\"col\" class=\"") + column.Style + "\">" + column.Head + "</th>";
  }
  const std::string messages = this->Messages.empty()
                                   ? std::string()
                                   : "<ul class=\"notes\">\n" + this->Messages + "</ul>\n";
  WriteWholeFile(
      html,
      ReportPage("Palpate fits",
                 "<header>\n<div class=\"kicker\">Palpate \xC2\xB7 spherical-harmonic fits</div>\n"
                 "<h1>" +
                     std::to_string(this->CaseCount) + " cases, " +
                     std::to_string(this->FittedCount) +
                     " fitted</h1>\n</header>\n<section>\n<div class=\"wide\"><table><thead><tr>" +
                     heads + "</tr></thead><tbody>\n" + this->Rows +
                     "</tbody></table></div>\n<p class=\"soft\">Distances are those between model "
                     "and mask boundary.</p>\n</section>\n" +
                     ReportSection("Not fitted", messages) + ReportFooter() + SortScript));
}
} // namespace palpate
