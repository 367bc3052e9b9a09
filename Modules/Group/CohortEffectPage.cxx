#include "CohortEffectPage.h"

#include "DecimalText.h"
#include "HtmlText.h"
#include "MappedMean.h"
#include "ReportPage.h"
#include "ShapeFigures.h"
#include "VarianceInflation.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr double ShownSignificance = 0.05;
constexpr double MarginShare = 1.05; // of the mean's extent
constexpr double LeastLimit = 1e-3;  // mm; below it only rounding would be coloured
constexpr std::array<ViewSide, 4> EffectSides{
    {ViewSide::Anterior, ViewSide::Posterior, ViewSide::Right, ViewSide::Superior}};

std::string TermRows(const CohortEffects& effects)
{
  std::string rows;
  const auto cell = [](const std::string& text)
  { return "<td class=\"number\">" + text + "</td>"; };
  for (const TermEffect& effect : effects.Terms)
  {
    const MultivariateStatistic& pillai = effect.Scores.Pillai;
    rows += "<tr><td class=\"text\">" + EscapeHtml(effect.Term.Name) + "</td>" +
            cell(FixedText(pillai.Value, 3)) +
            cell(SignificantText(pillai.F, 3) + " (" + SignificantText(pillai.NumeratorDegrees, 4) +
                 ", " + SignificantText(pillai.DenominatorDegrees, 4) + ")") +
            cell(SignificantText(pillai.P, 2)) + cell(SignificantText(effect.Points.WholeP, 2)) +
            cell(SignificantText(effect.Points.EnhancedP.minCoeff(), 2)) +
            cell(SignificantText(effect.Points.FamilyP.minCoeff(), 2)) +
            cell(FixedText(effect.LargestMillimeters(), 2) + " " + EscapeHtml(effect.UnitText())) +
            "</tr>\n";
  }
  return "<div class=\"wide\"><table><thead><tr><th scope=\"col\" class=\"text\">Term</th>"
         "<th scope=\"col\" class=\"number\">Pillai</th><th scope=\"col\" class=\"number\">F "
         "(df)</th>"
         "<th scope=\"col\" class=\"number\">p, scores</th><th scope=\"col\" class=\"number\">p, "
         "surface</th>"
         "<th scope=\"col\" class=\"number\">least p, TFCE</th>"
         "<th scope=\"col\" class=\"number\">least p, maximum</th>"
         "<th scope=\"col\" class=\"number\">largest, mm</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string BeyondText(const CohortEffects& effects)
{
  return effects.Settings.BeyondModes > 0
             ? " Displacements and tests at points are those that the first " +
                   std::to_string(effects.Settings.BeyondModes) +
                   " modes do not explain: their scores are covariates there."
             : std::string();
}

std::string FormulaText(const CohortEffects& effects)
{
  const auto code = [](const std::string& text) { return "<code>" + EscapeHtml(text) + "</code>"; };
  std::string references;
  for (const auto& [factor, level] : effects.Design.References)
  {
    references +=
        (references.empty() ? " Reference levels: " : ", ") + EscapeHtml(factor + " " + level);
  }
  return "<p>Linear model " + code(effects.Formula.Text()) +
         " of the displacement along the mean\xE2\x80\x99s normal at " +
         std::to_string(effects.Surface.Points.size()) + " points, " +
         std::to_string(effects.Design.Cases.size()) + " cases, " +
         std::to_string(effects.Design.Columns.size()) + " coefficients." + references +
         (references.empty() ? "" : ".") + BeyondText(effects) +
         " In the images red is outward, blue inward; what is pale is not significant (TFCE, "
         "0.05).</p>\n";
}

std::string DesignNotes(const LinearDesign& design)
{
  std::vector<std::string> notes = InflationNotes(design);
  if (!design.Omitted.empty())
  {
    notes.push_back(design.OmissionText());
  }
  return notes.empty() ? std::string() : ReportNotes(notes);
}

std::string EffectFigures(const CohortEffects& effects, const TermEffect& effect, vtkPolyData* mean)
{
  ColoredShape shape;
  shape.Mesh = mean;
  std::string figures;
  const ShapeFigures drawing(MarginShare * shape.Extent(),
                             std::max(effect.LargestMillimeters(), LeastLimit));
  for (const ColumnEffect& column : effect.Columns)
  {
    const Eigen::VectorXd shown = effect.ShownUnits() * column.PerUnit;
    shape.Values.assign(shown.data(), shown.data() + shown.size());
    std::vector<bool> isPale;
    for (const double p : effect.Points.EnhancedP)
    {
      isPale.push_back(p >= ShownSignificance);
    }
    figures += "<h3>" +
               EscapeHtml(column.Name + ", " + effect.UnitText() + ", full colour at " +
                          SignificantText(drawing.Limit(), 3) + " mm") +
               "</h3>\n<div class=\"views\">\n";
    for (const ViewSide side : EffectSides)
    {
      figures += drawing.Figure(shape, side, NameOf(side), isPale);
    }
    figures += "</div>\n";
  }
  return figures;
}
} // namespace

std::string CohortEffectMethods(const CohortEffects& effects)
{
  return "Covariates were related to the shapes by the linear model " + effects.Formula.Text() +
         " of the displacement along the mean\xE2\x80\x99s normal at " +
         std::to_string(effects.Surface.Points.size()) + " points (" +
         std::to_string(effects.Design.Cases.size()) +
         " cases). Each term was tested given all others. Scores: multivariate analysis of "
         "variance of the first " +
         std::to_string(effects.ScoreCount) + " modes (Pillai\xE2\x80\x99s trace)." +
         BeyondText(effects) +
         " Surface, TFCE and maximum: " + std::to_string(effects.Settings.Permutations.Count) +
         " permutations of the residuals under the other terms (Freedman and Lane), seed " +
         std::to_string(effects.Settings.Permutations.Seed) +
         "; the surface\xE2\x80\x99s p is that of the explained over the residual variance of "
         "the whole, the other two are corrected for all points, by threshold-free cluster "
         "enhancement (area^0.5 height^2; Smith and Nichols 2009) and by the largest statistic; "
         "false-discovery rates are those of Benjamini and Hochberg.";
}

std::string CohortEffectSection(const CohortEffects& effects)
{
  std::string content = FormulaText(effects) + TermRows(effects);
  const vtkSmartPointer<vtkPolyData> mean = MeanSurface(effects.Surface);
  for (const TermEffect& effect : effects.Terms)
  {
    content += EffectFigures(effects, effect, mean);
  }
  return ReportSection("Covariates", content + DesignNotes(effects.Design));
}
} // namespace palpate
