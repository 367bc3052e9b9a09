#include "CohortPage.h"

#include "AnatomicalView.h"
#include "CohortAsymmetry.h"
#include "CohortCorrespondencePage.h"
#include "CohortEffectPage.h"
#include "CohortMethods.h"
#include "CohortQualityPage.h"
#include "CohortReparametrisation.h"
#include "DecimalText.h"
#include "ModeSlider.h"
#include "RepeatedEffectFiles.h"
#include "ReportPage.h"
#include "ReportTable.h"
#include "ShapeFigures.h"
#include "SvgChart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr double FrameShare = 1.05; // of the largest shape's extent
constexpr std::array<ViewSide, 3> Sides{{ViewSide::Anterior, ViewSide::Right, ViewSide::Superior}};

void AddExplained(ReportPage& page, const ShapeModes& modes)
{
  SvgChart chart("mode", "explained variance, %");
  std::vector<std::pair<double, double>> bars;
  for (Eigen::Index k = 0; k < std::min<Eigen::Index>(modes.Explained.size(), 12); ++k)
  {
    bars.emplace_back(static_cast<double>(k + 1), 100.0 * modes.Explained[k]);
  }
  chart.SetBars(std::move(bars), 0.8);
  page.Chart(chart, "Variance explained by each mode");
}

ReportTable CaseTable(const CohortGroup& group, bool showsNames)
{
  ReportTable table({"Case", "Model, ml", "Dice", "Mode 1, sd", "Mode 2, sd"});
  for (std::size_t row = 0; row < group.Rows.size(); ++row)
  {
    table.Text(group.ShownName(row, showsNames))
        .Number(group.Bodies[row].Volume / 1000.0, 2)
        .Number(group.Rows[row].Result.Dice, 4);
    for (Eigen::Index k = 0; k < 2; ++k)
    {
      k < group.Modes.Modes.cols()
          ? table.Number(group.Modes.Scores(static_cast<Eigen::Index>(row), k) /
                             group.Modes.Deviations[k],
                         2)
          : table.Nothing();
    }
  }
  return table;
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
  const bool isRadial = std::holds_alternative<RadialModel>(group.Models.front());
  return "Mode " + std::to_string(mode + 1) + ": " + FixedText(100.0 * modes.Explained[mode], 1) +
         " % of the variance, standard deviation " +
         FixedText(modes.Deviations[mode] / std::sqrt(4.0 * M_PI), 2) + " mm (RMS of the " +
         (isRadial ? "radius" : "position") + ")";
}

// The mean first, then the two shapes of each shown mode.
std::vector<ColoredShape> DrawAll(const CohortGroup& group, double deviations)
{
  const OrganModel mean = ShapeOf(group, -1, 0.0);
  std::vector<ColoredShape> drawn{DrawOffsets(mean, mean)};
  for (int mode = 0; mode < ShownModes(group); ++mode)
  {
    drawn.push_back(DrawOffsets(ShapeOf(group, mode, -deviations), mean));
    drawn.push_back(DrawOffsets(ShapeOf(group, mode, deviations), mean));
  }
  return drawn;
}

// The mean from three sides, and the shown modes.
void AddShapes(ReportPage& page, const CohortGroup& group, const std::vector<ColoredShape>& drawn,
               const ShapeFigures& figures, double deviations)
{
  page.Section("Mean shape");
  for (const ViewSide side : Sides)
  {
    page.Figure("views", figures.Figure(drawn.front(), side, NameOf(side)));
  }
  const std::string several = SignificantText(deviations, 2) + " sd";
  AddExplained(page.Section("Principal modes"), group.Modes);
  for (int mode = 0; mode < ShownModes(group); ++mode)
  {
    const auto first = static_cast<std::size_t>(2 * mode + 1);
    page.Subheading(ModeTitle(group, mode))
        .Figure("views",
                figures.Figure(drawn[first], ViewSide::Anterior, "mean \xE2\x88\x92 " + several))
        .Put("views", ModeSlider(group, mode, deviations, figures))
        .Figure("views", figures.Figure(drawn[first + 1], ViewSide::Anterior, "mean + " + several));
  }
}
} // namespace

int ShownModes(const CohortGroup& group)
{
  return static_cast<int>(std::min<Eigen::Index>(group.Modes.Modes.cols(), MostShownModes));
}

std::string CohortPage(const CohortGroup& group, const CohortOutput& output, double deviations,
                       const std::string& program)
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
  ReportPage page;
  page.Header("cohort",
              std::to_string(group.Rows.size()) + " shapes, degree " +
                  std::to_string(DegreeOf(group.Models.front())),
              "The centres are aligned; axes are " + CohortAxesText(group, output) +
                  ". All images have the same scale; red is outside the mean, blue inside, full "
                  "colour at " +
                  SignificantText(figures.Limit(), 3) + " mm.");
  AddShapes(page, group, drawn, figures, deviations);
  if (output.Reparametrisation != nullptr)
  {
    AddReparametrisation(page, *output.Reparametrisation);
  }
  if (output.Effects != nullptr)
  {
    AddCohortEffects(page, *output.Effects);
  }
  if (output.Repeated != nullptr)
  {
    AddRepeatedEffects(page, *output.Repeated);
  }
  if (output.Asymmetry != nullptr)
  {
    AddCohortAsymmetry(page, *output.Asymmetry);
  }
  if (output.Quality != nullptr)
  {
    AddCohortQuality(page, group, *output.Quality, output.ShowsNames);
  }
  if (output.Correspondence != nullptr)
  {
    AddCohortCorrespondence(page, group, *output.Correspondence, output.ShowsNames);
  }
  page.Section("Cases").Table(CaseTable(group, output.ShowsNames));
  page.Section("Notes").Notes(NoteTexts(group, output.ShowsNames)).Section("Methods");
  for (const std::string& paragraph : CohortMethods(group, output, program))
  {
    page.Text(paragraph);
  }
  return page.Whole("Palpate cohort");
}
} // namespace palpate
