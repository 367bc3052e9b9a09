#include "CohortEffects.h"

#include "DecimalText.h"
#include "FalseDiscovery.h"
#include "FilterRun.h"
#include "InputError.h"
#include "LinearModel.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int EffectFrequency = 16; // 2,562 points, some 3 mm apart on a prostate
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

/// Outcomes and the model that all terms share.
struct FittedEffects
{
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
    CheckEffects(TestTogether(effects.Design, term, fitted.Scores, effect.Scores));
  }
  effect.PartialR2 = TestTerm(effects.Design, term, fitted.Model, fitted.Displacements).PartialR2;
  SurfaceGraph graph{effects.Surface.Areas, effects.Surface.Edges};
  if (!TestByPermutation(FindEffectSpace(effects.Design, term), fitted.Displacements, graph,
                         effects.Permutations, progress, effect.Points)
           .IsOk())
  {
    throw Cancelled();
  }
  effect.Discovery = FalseDiscoveryRates(effect.Points.P);
  return effect;
}
} // namespace

double TermEffect::LargestMillimeters() const
{
  double largest = 0.0;
  for (const ColumnEffect& column : this->Columns)
  {
    largest = std::max(largest, this->ShownUnits() * column.PerUnit.cwiseAbs().maxCoeff());
  }
  return largest;
}

std::string TermEffect::UnitText() const
{
  return this->Term.IsNumeric ? "per sd (" + SignificantText(this->Term.Deviation, 3) + ")"
                              : "per level";
}

CohortEffects FindCohortEffects(const CohortGroup& group, const CovariateTable& covariates,
                                const ModelFormula& formula,
                                const std::map<std::string, std::string>& references,
                                const PermutationSettings& settings, const KernelProgress& progress)
{
  CohortEffects effects;
  effects.Formula = formula;
  effects.Permutations = settings;
  CheckEffects(MakeLinearDesign(covariates, formula, references, effects.Design));
  effects.Surface = FindNormalDisplacement(ShapeOf(group, -1, 0.0), EffectFrequency);
  FittedEffects fitted{{},
                       {KeptRows(CoefficientsOf(group), effects.Design.Cases).rowwise() -
                            group.Modes.Mean.transpose(),
                        effects.Surface.PerCoefficient.transpose()},
                       {}};
  fitted.Model = FitLinearModel(effects.Design, fitted.Displacements);
  effects.ScoreCount = CountStableModes(group.Modes, fitted.Model.FreeDegrees);
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
