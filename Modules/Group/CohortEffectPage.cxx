#include "CohortEffectPage.h"

#include "DecimalText.h"
#include "MappedMean.h"
#include "ReportPage.h"
#include "ReportTable.h"
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

ReportTable TermsOf(const CohortEffects& effects)
{
  ReportTable table({"Term", "Pillai", "F (df)", "p, scores", "p, surface", "least p, TFCE",
                     "least p, maximum", "largest, mm"});
  for (const TermEffect& effect : effects.Terms)
  {
    const MultivariateStatistic& pillai = effect.Scores.Pillai;
    table.Text(effect.Term.Name)
        .Number(pillai.Value, 3)
        .Value(SignificantText(pillai.F, 3) + " (" + SignificantText(pillai.NumeratorDegrees, 4) +
               ", " + SignificantText(pillai.DenominatorDegrees, 4) + ")")
        .Value(SignificantText(pillai.P, 2))
        .Value(SignificantText(effect.Points.WholeP, 2))
        .Value(SignificantText(effect.Points.EnhancedP.minCoeff(), 2))
        .Value(SignificantText(effect.Points.FamilyP.minCoeff(), 2))
        .Value(FixedText(effect.LargestMillimeters(), 2) + " " + effect.UnitText());
  }
  return table;
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
  std::string references;
  for (const auto& [factor, level] : effects.Design.References)
  {
    references.append(references.empty() ? " Reference levels: " : ", ")
        .append(factor)
        .append(" ")
        .append(level);
  }
  return "Linear model " + effects.Formula.Text() +
         " of the displacement along the mean\xE2\x80\x99s normal at " +
         std::to_string(effects.Surface.Points.size()) + " points, " +
         std::to_string(effects.Design.Cases.size()) + " cases, " +
         std::to_string(effects.Design.Columns.size()) + " coefficients." + references +
         (references.empty() ? "" : ".") + BeyondText(effects) +
         " In the images red is outward, blue inward; what is pale is not significant (TFCE, "
         "0.05).";
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

void AddCohortEffects(ReportPage& page, const CohortEffects& effects)
{
  page.Section("Covariates").Text(FormulaText(effects)).Table(TermsOf(effects));
  for (const TermEffect& effect : effects.Terms)
  {
    AddDisplacementFigures(page, effect, effect.Points.EnhancedP, effects.Surface);
  }
  AddDesignNotes(page, effects.Design);
}

void AddMapFigures(ReportPage& page, const std::string& title, const Eigen::VectorXd& map,
                   double limit, const Eigen::VectorXd& p, const NormalDisplacement& surface)
{
  ColoredShape shape;
  shape.Mesh = MeanSurface(surface);
  shape.Values.assign(map.data(), map.data() + map.size());
  const ShapeFigures drawing(MarginShare * shape.Extent(), std::max(limit, LeastLimit));
  std::vector<bool> isPale;
  for (const double one : p)
  {
    isPale.push_back(one >= ShownSignificance);
  }
  page.Subheading(title + ", full colour at " + SignificantText(drawing.Limit(), 3) + " mm");
  for (const ViewSide side : EffectSides)
  {
    page.Figure("views", drawing.Figure(shape, side, NameOf(side), isPale));
  }
}

void AddDisplacementFigures(ReportPage& page, const TermDisplacement& effect,
                            const Eigen::VectorXd& p, const NormalDisplacement& surface)
{
  for (const ColumnEffect& column : effect.Columns)
  {
    AddMapFigures(page, column.Name + ", " + effect.UnitText(),
                  effect.ShownUnits() * column.PerUnit, effect.LargestMillimeters(), p, surface);
  }
}

void AddDesignNotes(ReportPage& page, const LinearDesign& design)
{
  std::vector<std::string> notes = InflationNotes(design);
  if (!design.Omitted.empty())
  {
    notes.push_back(design.OmissionText());
  }
  page.Notes(notes);
}
} // namespace palpate
