#include "CohortEffects.h"

#include "DecimalText.h"
#include "FalseDiscovery.h"
#include "InputError.h"
#include "LinearModel.h"
#include "Progress.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr double Confidence = 0.95;

Eigen::MatrixXd KeptRows(const Eigen::MatrixXd& all, const std::vector<std::size_t>& cases)
{
  Eigen::MatrixXd kept(static_cast<Eigen::Index>(cases.size()), all.cols());
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    kept.row(static_cast<Eigen::Index>(i)) = all.row(static_cast<Eigen::Index>(cases[i]));
  }
  return kept;
}

void CheckEffects(const Status& status)
{
  if (!status.IsOk())
  {
    throw InputError(status.Message());
  }
}

LinearDesign BeyondModes(const CohortGroup& group, const LinearDesign& design, int count)
{
  const Eigen::Index most =
      std::min(group.Modes.Scores.cols(), (design.Matrix.rows() - design.Matrix.cols()) / 2);
  if (count > most)
  {
    throw InputError("tests beyond the first " + std::to_string(count) +
                     " modes are impossible: " + std::to_string(design.Matrix.rows()) +
                     " complete cases allow for " + std::to_string(most));
  }
  return WithColumns(design, KeptRows(group.Modes.Scores, design.Cases).leftCols(count),
                     ModeNames(count));
}

/// Outcomes and the model that all terms share.
struct FittedEffects
{
  LinearDesign ScoreDesign; ///< without scores, which are its outcomes
  Eigen::MatrixXd Scores;
  LinearOutcomes Displacements;
  LinearModel Model;
};

TermEffect FindTermEffect(const CohortEffects& effects, const FittedEffects& fitted,
                          const DesignTerm& term, const KernelProgress& progress)
{
  TermEffect effect;
  effect.Term = term;
  const Eigen::MatrixXd widths = fitted.Model.ConfidenceWidths(Confidence);
  for (Eigen::Index k = term.First; k < term.First + term.Count; ++k)
  {
    effect.Columns.push_back({effects.Design.Columns[static_cast<std::size_t>(k)],
                              fitted.Model.Coefficients.row(k).transpose(),
                              widths.row(k).transpose()});
  }
  if (fitted.Scores.cols() > 0)
  {
    CheckEffects(TestTogether(fitted.ScoreDesign, term, fitted.Scores, effect.Scores));
  }
  effect.PartialR2 = TestTerm(effects.Design, term, fitted.Model, fitted.Displacements).PartialR2;
  SurfaceGraph graph{effects.Surface.Areas, effects.Surface.Edges};
  if (!TestByPermutation(FindEffectSpace(effects.Design, term), fitted.Displacements, graph,
                         effects.Settings.Permutations, progress, effect.Points)
           .IsOk())
  {
    throw Cancelled();
  }
  effect.Discovery = FalseDiscoveryRates(effect.Points.P);
  return effect;
}
} // namespace

double TermDisplacement::LargestMillimeters() const
{
  double largest = 0.0;
  for (const ColumnEffect& column : this->Columns)
  {
    largest = std::max(largest, this->ShownUnits() * column.PerUnit.cwiseAbs().maxCoeff());
  }
  return largest;
}

std::string TermDisplacement::UnitText() const
{
  return this->Term.IsNumeric ? "per sd (" + SignificantText(this->Term.Deviation, 3) + ")"
                              : "per level";
}

CohortEffects FindCohortEffects(const CohortGroup& group, const CovariateTable& covariates,
                                const ModelFormula& formula,
                                const std::map<std::string, std::string>& references,
                                const EffectSettings& settings, const KernelProgress& progress)
{
  CohortEffects effects;
  effects.Formula = formula;
  effects.Settings = settings;
  LinearDesign design;
  CheckEffects(MakeLinearDesign(covariates, formula, references, design));
  effects.Design = BeyondModes(group, design, settings.BeyondModes);
  effects.Surface = FindNormalDisplacement(ShapeOf(group, -1, 0.0), EffectFrequency);
  const Eigen::Index freeDegrees = design.Matrix.rows() - design.Matrix.cols();
  FittedEffects fitted{std::move(design),
                       {},
                       {KeptRows(CoefficientsOf(group), effects.Design.Cases).rowwise() -
                            group.Modes.Mean.transpose(),
                        effects.Surface.PerCoefficient.transpose()},
                       {}};
  fitted.Model = FitLinearModel(effects.Design, fitted.Displacements);
  effects.ScoreCount = CountStableModes(group.Modes, freeDegrees);
  fitted.Scores = KeptRows(group.Modes.Scores, effects.Design.Cases).leftCols(effects.ScoreCount);
  const auto tested =
      static_cast<double>(std::count_if(effects.Design.Terms.begin(), effects.Design.Terms.end(),
                                        [](const DesignTerm& term) { return term.IsTested; }));
  for (const DesignTerm& term : effects.Design.Terms)
  {
    if (term.IsTested)
    {
      const auto done = static_cast<double>(effects.Terms.size());
      const KernelProgress part = [&](double fraction)
      { return !progress || progress((done + fraction) / tested); };
      effects.Terms.push_back(FindTermEffect(effects, fitted, term, part));
    }
  }
  return effects;
}
} // namespace palpate
