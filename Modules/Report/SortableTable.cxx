#include "SortableTable.h"

#include "DecimalText.h"
#include "HtmlText.h"

#include <cctype>

namespace palpate
{
namespace
{
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

void SortableTable::AddHtml(const std::string& html)
{
  this->Rows += this->At == 0 ? "<tr>" : "";
  this->Rows +=
      std::string("<td class=\"") + this->Columns[this->At].Style + "\">" + html + "</td>";
  this->At = (this->At + 1) % this->Columns.size();
  this->Rows += this->At == 0 ? "</tr>\n" : "";
}

void SortableTable::AddText(const std::string& text)
{
  this->AddHtml(EscapeHtml(text));
}

void SortableTable::AddLink(const std::string& text, const std::filesystem::path& path)
{
  const std::string escaped = EscapeHtml(text);
  this->AddHtml(path.empty() ? escaped : "<a href=\"" + LinkText(path) + "\">" + escaped + "</a>");
}

void SortableTable::AddNumber(double number, int digits)
{
  this->AddHtml(FixedText(number, digits));
}

std::string SortableTable::Html() const
{
  std::string heads;
  for (const Column& column : this->Columns)
  {
    heads +=
        std::string("<th scope=\"col\" class=\"") + column.Style + "\">" + column.Head + "</th>";
  }
  return "<div class=\"wide\"><table><thead><tr>" + heads + "</tr></thead><tbody>\n" + this->Rows +
         "</tbody></table></div>\n" + SortScript;
}
} // namespace palpate
