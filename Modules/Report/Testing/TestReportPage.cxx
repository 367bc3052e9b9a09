#include "ReportPage.h"

#include "MarkupCheck.h"
#include "ReportTable.h"
#include "SvgChart.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::report_page_test
{
namespace
{
bool Has(const std::string& html, const std::string& part)
{
  return html.find(part) != std::string::npos;
}

TEST(ReportPage, EscapesEveryText)
{
  ReportTable table({"<b>"}, true);
  table.Text("<b>").Link("<b>", "<b>").Link("<b>", "").Marked("good", "<b>", "<b>").Value("<b>");
  ReportPage page;
  page.Header("<b>", "<b>", "<b>")
      .Verdict("good", "<b>", "<b>")
      .Cards({{"<b>", "<b>", "<b>", "<b>"}})
      .Section("<b>")
      .Subheading("<b>")
      .Text("<b>")
      .SoftText("<b>")
      .Notes({"<b>"})
      .Facts("<b>", {{"<b>", "<b>"}})
      .Legend({{"", "<b>"}, {"mask", "<b>"}})
      .Table(table)
      .Figure("views", {"<svg></svg>", "<b>", true});
  const std::string html = page.Whole("<b>", "<b>");
  EXPECT_EQ(palpate::test::MarkupError(html), "");
  EXPECT_FALSE(Has(html, "<b>"));
}

TEST(ReportPage, LeavesOutSectionsWithoutContent)
{
  ReportPage page;
  page.Section("empty").Notes({}).Text("").Facts("none", {}).Cards({});
  page.Figure("views", {"", "no image"}).Chart(SvgChart("x", "y"), "no points");
  EXPECT_EQ(page.Body(), "");
  page.Section("full").Text("text");
  EXPECT_FALSE(Has(page.Body(), "empty"));
  EXPECT_EQ(page.Body(), "<section>\n<h2>full</h2>\n<p>text</p>\n</section>\n");
}

TEST(ReportPage, PutsFiguresOfOneLayoutSideBySide)
{
  ReportPage page;
  const ReportFigure figure{"<svg></svg>", "caption"};
  page.Figure("views", figure).Figure("views", figure).Figure("charts", figure).Section("next");
  page.Figure("charts", figure);
  const std::string html = page.Body();
  EXPECT_EQ(palpate::test::MarkupError("<html>" + html + "</html>"), "");
  const std::string one = figure.Html();
  EXPECT_TRUE(Has(html, "<div class=\"views\">\n" + one + one + "</div>\n<div class=\"charts\">\n" +
                            one + "</div>\n<section>"));
}

TEST(ReportTable, AlignsColumnsAsTheirCells)
{
  ReportTable table({"name", "number"});
  table.Text("a").Number(1.25, 1).Text("b").Nothing().Text("c").Number(
      std::numeric_limits<double>::quiet_NaN(), 1);
  const std::string html = table.Html();
  EXPECT_TRUE(Has(html, "<th scope=\"col\" class=\"text\">name</th><th scope=\"col\" "
                        "class=\"number\">number</th>"));
  EXPECT_TRUE(Has(html, "<tr><td class=\"text\">a</td><td class=\"number\">1.2</td></tr>"));
  EXPECT_TRUE(Has(html, "<td class=\"number\"></td>"));
  EXPECT_TRUE(Has(html, "<td class=\"number\">\u2013</td>"));
  EXPECT_FALSE(Has(html, "<script"));
}
} // namespace
} // namespace palpate::report_page_test
