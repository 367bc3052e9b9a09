#include "ReportTable.h"

#include "DecimalText.h"
#include "HtmlText.h"
#include "ReportPage.h"

#include <cctype>

namespace palpate
{
namespace
{
const char* const SortScript = R"js(<script>
document.querySelectorAll(".sortable th").forEach(function (head) {
  head.addEventListener("click", function () {
    var down = head.getAttribute("aria-sort") === "ascending";
    Array.from(head.parentNode.cells).forEach(function (h) { h.removeAttribute("aria-sort"); });
    head.setAttribute("aria-sort", down ? "descending" : "ascending");
    var body = head.closest("table").tBodies[0];
    var key = function (row) { return row.cells[head.cellIndex].textContent.trim(); };
    Array.from(body.rows).sort(function (a, b) {
      var x = key(a), y = key(b), order = parseFloat(x) - parseFloat(y);
      if (isNaN(order)) { order = x.localeCompare(y, undefined, { numeric: true }); }
      return down ? -order : order;
    }).forEach(function (row) { body.appendChild(row); });
  });
});
</script>
)js";

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
} // namespace

ReportTable& ReportTable::Cell(const char* style, const std::string& html)
{
  if (this->Styles.size() < this->Heads.size())
  {
    this->Styles.push_back(style);
  }
  this->Rows += this->At == 0 ? "<tr>" : "";
  this->Rows += std::string("<td class=\"") + style + "\">" + html + "</td>";
  this->At = (this->At + 1) % this->Heads.size();
  this->Rows += this->At == 0 ? "</tr>\n" : "";
  return *this;
}

ReportTable& ReportTable::Text(const std::string& text)
{
  return this->Cell("text", EscapeHtml(text));
}

ReportTable& ReportTable::Link(const std::string& text, const std::filesystem::path& path)
{
  return path.empty() ? this->Text(text)
                      : this->Cell("text", "<a href=\"" + LinkText(path) + "\">" +
                                               EscapeHtml(text) + "</a>");
}

ReportTable& ReportTable::Marked(const std::string& style, const std::string& text,
                                 const std::string& toolTip)
{
  return this->Cell("text", "<strong class=\"" + style + "\"" +
                                (toolTip.empty() ? "" : " title=\"" + EscapeHtml(toolTip) + "\"") +
                                ">" + EscapeHtml(text) + "</strong>");
}

ReportTable& ReportTable::Image(const ReportFigure& figure)
{
  return this->Cell("image", figure.Html());
}

ReportTable& ReportTable::Value(const std::string& number)
{
  return this->Cell("number", EscapeHtml(number));
}

ReportTable& ReportTable::Number(double number, int digits)
{
  return this->Value(FixedText(number, digits));
}

std::string ReportTable::Html() const
{
  std::string heads;
  for (std::size_t i = 0; i < this->Heads.size(); ++i)
  {
    heads += std::string("<th scope=\"col\" class=\"") +
             (i < this->Styles.size() ? this->Styles[i] : "text") + "\">" +
             EscapeHtml(this->Heads[i]) + "</th>";
  }
  return std::string("<div class=\"wide") + (this->IsSortable ? " sortable" : "") +
         "\"><table><thead><tr>" + heads + "</tr></thead><tbody>\n" + this->Rows +
         "</tbody></table></div>\n" + (this->IsSortable ? SortScript : "");
}
} // namespace palpate
