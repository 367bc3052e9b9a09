#include "CohortPage.h"

#include "AnatomicalView.h"
#include "CohortCorrespondencePage.h"
#include "CohortEffectPage.h"
#include "CohortMethods.h"
#include "CohortQualityPage.h"
#include "CohortReparametrisation.h"
#include "DecimalText.h"
#include "HtmlText.h"
#include "ModeSlider.h"
#include "ReportPage.h"
#include "ShapeFigures.h"
#include "SvgChart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <utility>

namespace palpate
{
namespace
{
constexpr double FrameShare = 1.05; // of the largest shape's extent
constexpr std::array<ViewSide, 3> Sides{{ViewSide::Anterior, ViewSide::Right, ViewSide::Superior}};

std::string Explained(const ShapeModes& modes)
{
  SvgChart chart("mode", "explained variance, %");
  std::vector<std::pair<double, double>> bars;
  for (Eigen::Index k = 0; k < std::min<Eigen::Index>(modes.Explained.size(), 12); ++k)
  {
    bars.emplace_back(static_cast<double>(k + 1), 100.0 * modes.Explained[k]);
  }
  chart.SetBars(std::move(bars), 0.8);
  return "<div class=\"charts\">" + ReportFigure(chart.Svg(), "Variance explained by each mode") +
         "</div>\n";
}

std::string CaseRows(const CohortGroup& group, bool showsNames)
{
  std::string rows;
  const auto cell = [](const std::string& text)
  { return "<td class=\"number\">" + text + "</td>"; };
  const Eigen::Index scores = std::min<Eigen::Index>(group.Modes.Modes.cols(), 2);
  for (std::size_t row = 0; row < group.Rows.size(); ++row)
  {
    rows += "<tr><td class=\"text\">" +
            (showsNames ? EscapeHtml(group.Rows[row].Case) : std::to_string(row + 1)) + "</td>" +
            cell(FixedText(group.Bodies[row].Volume / 1000.0, 2)) +
            cell(FixedText(group.Rows[row].Result.Dice, 4));
    for (Eigen::Index k = 0; k < 2; ++k)
    {
      const bool isKnown = k < scores;
      rows += cell(isKnown ? FixedText(group.Modes.Scores(static_cast<Eigen::Index>(row), k) /
                                           group.Modes.Deviations[k],
                                       2)
                           : std::string());
    }
    rows += "</tr>\n";
  }
  return "<div class=\"wide\"><table><thead><tr><th scope=\"col\" class=\"text\">Case</th>"
         "<th scope=\"col\" class=\"number\">Model, ml</th>"
         "<th scope=\"col\" class=\"number\">Dice</th>"
         "<th scope=\"col\" class=\"number\">Mode 1, sd</th>"
         "<th scope=\"col\" class=\"number\">Mode 2, sd</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}

// Cases that are not in the group have no number.
std::vector<std::string> NoteTexts(const CohortGroup& group, bool showsNames)
{
  std::vector<std::string> texts;
  for (const CohortNote& note : group.Notes)
  {
    const auto row = std::find_if(group.Rows.begin(), group.Rows.end(),
                                  [&](const CohortRow& one) { return one.Case == note.Case; });
    const std::string number =
        row == group.Rows.end() ? "A case" : "Case " + std::to_string(row - group.Rows.begin() + 1);
    texts.push_back(showsNames ? note.Case + note.Text + note.Reason : number + note.Text);
  }
  return texts;
}

std::string ModeTitle(const CohortGroup& group, int mode)
{
  const ShapeModes& modes = group.Modes;
  const bool isRadial = std::holds_alternative<SphericalHarmonicModel>(group.Models.front());
  return "Mode " + std::to_string(mode + 1) + ": " + FixedText(100.0 * modes.Explained[mode], 1) +
         " % of the variance, standard deviation " +
         FixedText(modes.Deviations[mode] / std::sqrt(4.0 * M_PI), 2) + " mm (RMS of the " +
         (isRadial ? "radius" : "position") + ")";
}

// The mean first, then the two shapes of each shown mode.
std::vector<ColoredShape> DrawAll(const CohortGroup& group, double deviations)
{
  const SurfaceModel mean = ShapeOf(group, -1, 0.0);
  std::vector<ColoredShape> drawn{DrawOffsets(mean, mean)};
  for (int mode = 0; mode < ShownModes(group); ++mode)
  {
    drawn.push_back(DrawOffsets(ShapeOf(group, mode, -deviations), mean));
    drawn.push_back(DrawOffsets(ShapeOf(group, mode, deviations), mean));
  }
  return drawn;
}

std::string MethodsSection(const CohortGroup& group, const CohortOutput& output,
                           const std::string& program)
{
  std::string paragraphs;
  for (const std::string& paragraph : CohortMethods(group, output, program))
  {
    paragraphs += "<p>" + EscapeHtml(paragraph) + "</p>\n";
  }
  return ReportSection("Methods", paragraphs);
}
} // namespace

int ShownModes(const CohortGroup& group)
{
  return static_cast<int>(std::min<Eigen::Index>(group.Modes.Modes.cols(), MostShownModes));
}

void WriteCohortPage(const CohortGroup& group, const CohortOutput& output, double deviations,
                     const std::string& program, std::ostream& page)
{
  const std::vector<ColoredShape> drawn = DrawAll(group, deviations);
  double extent = 0.0;
  double offset = 1e-3; // below a micrometre only rounding would be coloured
  for (const ColoredShape& shape : drawn)
  {
    extent = std::max(extent, shape.Extent());
    offset = std::max(offset, shape.LargestValue());
  }
  const ShapeFigures figures(FrameShare * extent, offset);
  const std::string several = SignificantText(deviations, 2) + " sd";
  std::string meanViews;
  for (const ViewSide side : Sides)
  {
    meanViews += figures.Figure(drawn.front(), side, NameOf(side));
  }
  std::string modes = Explained(group.Modes);
  for (int mode = 0; mode < ShownModes(group); ++mode)
  {
    const auto first = static_cast<std::size_t>(2 * mode + 1);
    modes += "<h3>" + ModeTitle(group, mode) + "</h3>\n<div class=\"views\">\n" +
             figures.Figure(drawn[first], ViewSide::Anterior, "mean \xE2\x88\x92 " + several) +
             ModeSlider(group, mode, deviations, figures) +
             figures.Figure(drawn[first + 1], ViewSide::Anterior, "mean + " + several) + "</div>\n";
  }
  page << ReportPageStart("Palpate cohort")
       << "<header>\n<div class=\"kicker\">Palpate \xC2\xB7 cohort</div>\n<h1>" +
              std::to_string(group.Rows.size()) + " shapes, degree " +
              std::to_string(DegreeOf(group.Models.front())) +
              "</h1>\n<p class=\"soft\">The centres are aligned; axes are " +
              CohortAxesText(group, output) +
              ". All images have the same scale; red is outside the mean, blue inside, full colour "
              "at " +
              SignificantText(figures.Limit(), 3) + " mm.</p>\n</header>\n"
       << ReportSection("Mean shape", "<div class=\"views\">\n" + meanViews + "</div>\n")
       << ReportSection("Principal modes", modes);
  if (output.Reparametrisation != nullptr)
  {
    page << ReparametrisationSection(*output.Reparametrisation);
  }
  if (output.Effects != nullptr)
  {
    page << CohortEffectSection(*output.Effects);
  }
  if (output.Quality != nullptr)
  {
    page << CohortQualitySections(group, *output.Quality, output.ShowsNames);
  }
  if (output.Correspondence != nullptr)
  {
    WriteCohortCorrespondenceSection(group, *output.Correspondence, output.ShowsNames, page);
  }
  page << ReportSection("Cases", CaseRows(group, output.ShowsNames))
       << ReportSection("Notes", ReportNotes(NoteTexts(group, output.ShowsNames)))
       << MethodsSection(group, output, program) << ReportFooter() << ReportPageEnd();
}
} // namespace palpate
