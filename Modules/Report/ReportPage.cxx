#include "ReportPage.h"

#include "EarlierFiles.h"
#include "HtmlText.h"
#include "ReportTable.h"
#include "SoftwareVersions.h"
#include "SvgChart.h"

namespace palpate
{
namespace
{
const char* const Colors = R"css(
:root {
  color-scheme: light dark;
  --paper: #ffffff; --panel: #f6f7f9; --ink: #1c2127; --soft: #5c6670; --rule: #dde1e6;
  --bar: #33709f; --good: #1a7046; --poor: #9a5b00; --bad: #ad2131;
  --model: #d95f02; --surface: #2c7fb8; --mask: #8a8f98;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #14171b; --panel: #1d2228; --ink: #e6e9ed; --soft: #9aa4af; --rule: #333b44;
    --bar: #6aaee0; --good: #5fc490; --poor: #e0a54b; --bad: #f07884;
    --model: #ff9a4d; --surface: #6bbdf0; --mask: #aab1ba;
  }
}
)css";

const char* const PageLayout = R"css(
* { box-sizing: border-box; }
body {
  margin: 0; background: var(--paper); color: var(--ink);
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", "Noto Sans", "Helvetica Neue", Arial,
    sans-serif;
}
main { max-width: 1140px; margin: 0 auto; padding: 32px 24px 56px; }
h1 { font-size: 28px; line-height: 1.2; margin: 4px 0 6px; font-weight: 650; overflow-wrap: anywhere; }
h2 { font-size: 18px; margin: 40px 0 12px; padding-bottom: 6px; border-bottom: 1px solid var(--rule);
  font-weight: 650; }
p { margin: 6px 0; max-width: 80ch; }
a { color: var(--bar); }
.soft, figcaption { color: var(--soft); }
.kicker { color: var(--soft); font-size: 13px; letter-spacing: .04em; text-transform: uppercase; }
.verdict { display: flex; gap: 12px; align-items: baseline; margin-top: 16px; padding: 12px 16px;
  background: var(--panel); border-left: 4px solid currentColor; border-radius: 4px; }
.verdict p { color: var(--ink); margin: 0; overflow-wrap: anywhere; }
.verdict strong { white-space: nowrap; }
.good { color: var(--good); } .poor { color: var(--poor); } .bad { color: var(--bad); }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(210px, 1fr)); gap: 12px;
  margin: 20px 0 0; }
.card { background: var(--panel); border-radius: 8px; padding: 12px 14px; }
.card dt { color: var(--soft); font-size: 13px; }
.card dd { margin: 2px 0 0; font-size: 23px; font-weight: 600; font-variant-numeric: tabular-nums;
  white-space: nowrap; }
.card small { display: block; font-size: 12.5px; font-weight: 400; color: var(--soft);
  white-space: normal; }
.card dd .unit { font-size: 14px; font-weight: 400; color: var(--soft); }
.notes { padding-left: 20px; } .notes li { overflow-wrap: anywhere; }
)css";

const char* const Images = R"css(
figure { margin: 0; break-inside: avoid; }
figcaption { font-size: 13px; margin-top: 4px; }
.slices { display: grid; grid-template-columns: repeat(auto-fill, minmax(280px, 1fr)); gap: 18px;
  align-items: end; }
.views { display: grid; grid-template-columns: repeat(auto-fill, minmax(300px, 1fr)); gap: 14px; }
.thumbnails { display: grid; grid-template-columns: repeat(auto-fill, minmax(104px, 1fr)); gap: 6px; }
.thumbnails figcaption { font-size: 11px; margin-top: 1px; overflow-wrap: anywhere; }
.marked { outline: 2px solid var(--bad); border-radius: 4px; }
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(340px, 1fr)); gap: 22px; }
svg { display: block; width: 100%; height: auto; }
svg text { fill: var(--ink); font-size: 12px; }
.slice { border-radius: 4px; background: #000; }
.slice path { fill: none; vector-effect: non-scaling-stroke; stroke-width: 1.7; }
.slice text, .view text { font-size: 14px; font-weight: 600; }
.slice text { fill: #f2f2f2; paint-order: stroke; stroke: #000; stroke-width: 3px; }
.slice .scale { stroke: #f2f2f2; stroke-width: 2; }
.slice path.mask { stroke: #f5e663; opacity: .75; stroke-width: 1; }
.slice path.surface { stroke: #5ec3ff; stroke-width: 2.6; } .slice path.model { stroke: #ff7f2a; }
.slice .place { fill: none; stroke: #ffffff; stroke-width: 2; }
.legend { display: flex; flex-wrap: wrap; gap: 6px 22px; font-size: 13.5px; margin: 0 0 12px;
  padding: 0; list-style: none; }
.legend i { display: inline-block; width: 26px; height: 0; border-top: 3px solid; margin-right: 7px;
  vertical-align: middle; }
.legend .mask { border-color: #d8c422; } .legend .surface { border-color: #39a9ec; }
.legend .model { border-color: #ff7f2a; }
.view { background: var(--panel); border-radius: 6px; }
.colorbar { max-width: 430px; margin: 14px 0 0; }
.chart .axis { stroke: var(--soft); } .chart .grid { stroke: var(--rule); }
.chart .bar { fill: var(--bar); } .chart .line { fill: none; stroke: var(--bar); stroke-width: 1.6; }
.chart .first { fill: var(--bar); } .chart .second { fill: var(--model); }
.chart .third { fill: var(--good); } .chart .faint { opacity: .5; }
.legend .first { border-color: var(--bar); } .legend .second { border-color: var(--model); }
.legend .third { border-color: var(--good); }
.chart .marker { stroke: var(--model); stroke-dasharray: 4 3; stroke-width: 1.4; }
)css";

const char* const Tables = R"css(
.tables { columns: 330px; column-gap: 30px; }
table { border-collapse: collapse; width: 100%; font-size: 13.5px; margin: 0 0 20px;
  break-inside: avoid; }
caption { text-align: left; font-weight: 650; padding: 0 0 4px; }
th, td { padding: 3px 0; border-bottom: 1px solid var(--rule); vertical-align: top; }
th { text-align: left; font-weight: 400; color: var(--soft); padding-right: 14px; }
td { text-align: right; font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
.wide { overflow-x: auto; }
.wide th, .wide td { padding: 6px 12px 6px 0; white-space: nowrap; }
.wide thead th { font-weight: 600; color: var(--ink); border-bottom: 2px solid var(--soft); }
.sortable thead th { cursor: pointer; } .sortable thead th:hover { color: var(--bar); }
.wide thead th[aria-sort="ascending"]::after { content: " \2191"; }
.wide thead th[aria-sort="descending"]::after { content: " \2193"; }
.wide .text { text-align: left; } .wide .number { text-align: right; }
.wide .image { min-width: 130px; }
footer { margin-top: 36px; color: var(--soft); font-size: 13px; }
@media print {
  :root {
    --paper: #ffffff; --panel: #f4f5f7; --ink: #111418; --soft: #4c545c; --rule: #ccd1d6;
    --bar: #33709f; --good: #1a7046; --poor: #9a5b00; --bad: #ad2131; --model: #d95f02;
  }
  body { font-size: 11pt; -webkit-print-color-adjust: exact; print-color-adjust: exact; }
  main { max-width: none; padding: 0; } h2 { break-after: avoid; }
  .slices { grid-template-columns: repeat(3, 1fr); } .views { grid-template-columns: repeat(6, 1fr); }
  .charts { grid-template-columns: repeat(2, 1fr); } .tables { columns: 2; }
}
)css";
std::string Closed(const std::string& layout)
{
  return layout.empty() ? std::string() : "</div>\n";
}
} // namespace

std::string ReportFigure::Html() const
{
  return this->Svg.empty() ? std::string()
                           : std::string("<figure") + (this->IsMarked ? " class=\"marked\"" : "") +
                                 ">" + this->Svg + "<figcaption>" + EscapeHtml(this->Caption) +
                                 "</figcaption></figure>\n";
}

ReportPage& ReportPage::Put(const std::string& layout, const std::string& html)
{
  if (html.empty())
  {
    return *this;
  }
  if (!this->Heading.empty())
  {
    this->Html = this->Body() + "<section>\n<h2>" + EscapeHtml(this->Heading) + "</h2>\n";
    this->IsInSection = true;
    this->Heading.clear();
    this->Layout.clear();
  }
  if (this->Layout != layout)
  {
    this->Html +=
        Closed(this->Layout) + (layout.empty() ? layout : "<div class=\"" + layout + "\">\n");
    this->Layout = layout;
  }
  this->Html += html;
  return *this;
}

ReportPage& ReportPage::Section(const std::string& heading)
{
  this->Heading = heading;
  return *this;
}

ReportPage& ReportPage::Header(const std::string& kind, const std::string& heading,
                               const std::string& about)
{
  return this->Put(
      {}, "<header>\n<div class=\"kicker\">Palpate \xC2\xB7 " + EscapeHtml(kind) + "</div>\n<h1>" +
              EscapeHtml(heading) + "</h1>\n" +
              (about.empty() ? about : "<p class=\"soft\">" + EscapeHtml(about) + "</p>\n") +
              "</header>\n");
}

ReportPage& ReportPage::Verdict(const std::string& style, const std::string& word,
                                const std::string& text)
{
  return this->Put({}, "<div class=\"verdict " + style + "\">" +
                           (word.empty() ? word : "<strong>" + EscapeHtml(word) + "</strong>") +
                           "<p>" + EscapeHtml(text) + "</p></div>\n");
}

ReportPage& ReportPage::Subheading(const std::string& heading)
{
  return this->Put({}, "<h3>" + EscapeHtml(heading) + "</h3>\n");
}

ReportPage& ReportPage::Text(const std::string& text)
{
  return this->Put({}, text.empty() ? text : "<p>" + EscapeHtml(text) + "</p>\n");
}

ReportPage& ReportPage::SoftText(const std::string& text)
{
  return this->Put({}, "<p class=\"soft\">" + EscapeHtml(text) + "</p>\n");
}

ReportPage& ReportPage::Notes(const std::vector<std::string>& notes)
{
  std::string items;
  for (const std::string& note : notes)
  {
    items += "<li>" + EscapeHtml(note) + "</li>\n";
  }
  return this->Put({}, items.empty() ? items : "<ul class=\"notes\">\n" + items + "</ul>\n");
}

ReportPage& ReportPage::Cards(const std::vector<ReportCard>& cards)
{
  const auto element = [](const char* start, const std::string& text, const char* end)
  { return text.empty() ? text : start + EscapeHtml(text) + end; };
  std::string html;
  for (const ReportCard& card : cards)
  {
    html += element("<div class=\"card\"><dt>", card.Name, "</dt>") + "<dd>" +
            EscapeHtml(card.Value) + element(" <span class=\"unit\">", card.Unit, "</span>") +
            element("<small>", card.Remark, "</small>") + "</dd></div>\n";
  }
  return this->Put({}, html.empty() ? html : "<dl class=\"cards\">\n" + html + "</dl>\n");
}

ReportPage& ReportPage::Facts(const std::string& caption, const ReportRows& rows)
{
  std::string html;
  for (const auto& [name, value] : rows)
  {
    html += "<tr><th scope=\"row\">" + EscapeHtml(name) + "</th><td>" + EscapeHtml(value) +
            "</td></tr>\n";
  }
  return this->Put("tables", html.empty()
                                 ? html
                                 : "<table><caption>" + EscapeHtml(caption) +
                                       "</caption><tbody>\n" + html + "</tbody></table>\n");
}

ReportPage& ReportPage::Table(const ReportTable& table)
{
  return this->Put({}, table.Html());
}

ReportPage& ReportPage::Legend(const ReportRows& styles)
{
  std::string html;
  for (const auto& [style, text] : styles)
  {
    html += (style.empty() ? "<li class=\"soft\">" : "<li><i class=\"" + style + "\"></i>") +
            EscapeHtml(text) + "</li>";
  }
  return this->Put({}, "<ul class=\"legend\">" + html + "</ul>\n");
}

ReportPage& ReportPage::Chart(const SvgChart& chart, const std::string& caption)
{
  return this->Figure("charts", {chart.Svg(), caption});
}

ReportPage& ReportPage::Figure(const char* layout, const ReportFigure& figure)
{
  return this->Put(layout, figure.Html());
}

std::string ReportPage::Body() const
{
  return this->Html + Closed(this->Layout) + (this->IsInSection ? "</section>\n" : "");
}

std::string ReportPage::Whole(const std::string& title, const std::string& footer) const
{
  std::string versions = footer;
  for (const auto& [name, version] : SoftwareVersions())
  {
    versions.append(versions.empty() ? "" : " \xC2\xB7 ").append(name).append(" ").append(version);
  }
  return std::string("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n") +
         PageGenerator +
         "\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>" +
         EscapeHtml(title) + "</title>\n<style>" + Colors + PageLayout + Images + Tables +
         "</style>\n</head>\n<body>\n<main>\n" + this->Body() + "<footer>" + EscapeHtml(versions) +
         "</footer>\n</main>\n</body>\n</html>\n";
}
} // namespace palpate
