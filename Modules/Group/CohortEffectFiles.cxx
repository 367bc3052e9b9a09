#include "CohortEffectFiles.h"

#include "CsvText.h"
#include "DecimalText.h"
#include "InputError.h"
#include "MappedMean.h"
#include "ScreenText.h"
#include "SurfaceFile.h"
#include "VarianceInflation.h"
#include "WholeFile.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
constexpr double Significance = 0.05;

vtkSmartPointer<vtkPolyData> EffectSurface(const CohortEffects& effects)
{
  auto surface = MeanSurface(effects.Surface);
  for (const TermEffect& effect : effects.Terms)
  {
    AddDisplacementMaps(surface, effect);
    const std::string& name = effect.Term.Name;
    AddPointMap(surface, name + (effect.Term.Count == 1 ? " t" : " root F"),
                effect.Points.Statistic);
    AddPointMap(surface, name + " partial R2", effect.PartialR2);
    AddPointMap(surface, name + " p", effect.Points.P);
    AddPointMap(surface, name + " p family", effect.Points.FamilyP);
    AddPointMap(surface, name + " p TFCE", effect.Points.EnhancedP);
    AddPointMap(surface, name + " q", effect.Discovery);
  }
  return surface;
}

std::string TermTable(const CohortEffects& effects)
{
  std::string text = CsvLine({"term",          "columns",
                              "cases",         "scores",
                              "pillai",        "pillai_f",
                              "pillai_df1",    "pillai_df2",
                              "pillai_p",      "wilks",
                              "wilks_p",       "surface_f",
                              "surface_p",     "least_p_family",
                              "least_p_tfce",  "least_q",
                              "family_mm2",    "tfce_mm2",
                              "discovery_mm2", "largest_mm",
                              "largest_unit",  "largest_r2",
                              "permutations",  "seed",
                              "beyond_modes",  "variance_inflation"});
  for (const TermEffect& effect : effects.Terms)
  {
    const MultivariateStatistic& pillai = effect.Scores.Pillai;
    const auto number = [](double value) { return ExactText(value); };
    text += CsvLine({effect.Term.Name,
                     std::to_string(effect.Term.Count),
                     std::to_string(effects.Design.Cases.size()),
                     std::to_string(effects.ScoreCount),
                     number(pillai.Value),
                     number(pillai.F),
                     number(pillai.NumeratorDegrees),
                     number(pillai.DenominatorDegrees),
                     number(pillai.P),
                     number(effect.Scores.Wilks.Value),
                     number(effect.Scores.Wilks.P),
                     number(effect.Points.WholeF),
                     number(effect.Points.WholeP),
                     number(effect.Points.FamilyP.minCoeff()),
                     number(effect.Points.EnhancedP.minCoeff()),
                     number(effect.Discovery.minCoeff()),
                     number(SignificantArea(effects.Surface, effect.Points.FamilyP)),
                     number(SignificantArea(effects.Surface, effect.Points.EnhancedP)),
                     number(SignificantArea(effects.Surface, effect.Discovery)),
                     number(effect.LargestMillimeters()),
                     effect.UnitText(),
                     number(effect.PartialR2.maxCoeff()),
                     std::to_string(effects.Settings.Permutations.Count),
                     std::to_string(effects.Settings.Permutations.Seed),
                     std::to_string(effects.Settings.BeyondModes),
                     number(VarianceInflation(effects.Design, effect.Term))});
  }
  return text;
}
} // namespace

void AddDisplacementMaps(vtkPolyData* surface, const TermDisplacement& term)
{
  for (const ColumnEffect& column : term.Columns)
  {
    AddPointMap(surface, column.Name + " (mm)", column.PerUnit);
    AddPointMap(surface, column.Name + " 95% half width (mm)", column.HalfWidth);
  }
}

double SignificantArea(const NormalDisplacement& surface, const Eigen::VectorXd& p)
{
  double area = 0.0;
  for (std::size_t i = 0; i < surface.Areas.size(); ++i)
  {
    area += p[static_cast<Eigen::Index>(i)] < Significance ? surface.Areas[i] : 0.0;
  }
  return area;
}

std::string DesignTable(const CohortGroup& group, const LinearDesign& design)
{
  std::vector<std::string> head{"case"};
  head.insert(head.end(), design.Columns.begin(), design.Columns.end());
  std::string text = CsvLine(head);
  for (std::size_t i = 0; i < design.Cases.size(); ++i)
  {
    std::vector<std::string> fields{group.Rows[design.Cases[i]].Case};
    for (Eigen::Index k = 0; k < design.Matrix.cols(); ++k)
    {
      fields.push_back(ExactText(design.Matrix(static_cast<Eigen::Index>(i), k)));
    }
    text += CsvLine(fields);
  }
  return text;
}

std::string CohortEffectText(const CohortEffects& effects)
{
  const auto right = [](const std::string& text, std::size_t width)
  { return std::string(width - std::min(width - 1, text.size()), ' ') + text; };
  std::string table =
      effects.Formula.Text() + ", " + std::to_string(effects.Design.Cases.size()) + " cases, " +
      std::to_string(effects.Settings.Permutations.Count) + " permutations" +
      (effects.Settings.BeyondModes > 0
           ? "; on the surface beyond the first " + std::to_string(effects.Settings.BeyondModes) +
                 " modes"
           : std::string()) +
      "\n" + "term                  p, scores  p, surface  least p, TFCE  largest, mm\n";
  for (const TermEffect& effect : effects.Terms)
  {
    std::string name = Printable(effect.Term.Name);
    name.resize(std::max<std::size_t>(name.size(), 20), ' ');
    table += name + right(SignificantText(effect.Scores.Pillai.P, 3), 11) +
             right(SignificantText(effect.Points.WholeP, 3), 12) +
             right(SignificantText(effect.Points.EnhancedP.minCoeff(), 3), 15) +
             right(FixedText(effect.LargestMillimeters(), 2), 13) + " " + effect.UnitText() + "\n";
  }
  return table;
}

void WriteCohortEffects(const CohortGroup& group, const CohortEffects& effects,
                        const std::filesystem::path& folder)
{
  WriteWholeFile(folder / "effects.csv", TermTable(effects));
  WriteWholeFile(folder / "design.csv", DesignTable(group, effects.Design));
  WriteSurface(folder / "effects.vtp", EffectSurface(effects));
}
} // namespace palpate
