#include "RepeatedEffects.h"

#include "FalseDiscovery.h"
#include "InputError.h"
#include "LinearOutcomes.h"
#include "Progress.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace palpate
{
namespace
{
constexpr Eigen::Index MostRepeatedModes = 10;
constexpr double RepeatedConfidence = 0.95;
constexpr Eigen::Index PointsAtATime = 256;

void CheckRepeated(const Status& status)
{
  if (!status.IsOk())
  {
    throw InputError(status.Message());
  }
}

// A number for each patient, in the order of the cases.
std::vector<Eigen::Index> PatientsOf(const CovariateTable& table, RepeatedEffects& effects)
{
  std::map<std::string, Eigen::Index> numbers;
  std::vector<Eigen::Index> patients;
  for (const std::size_t row : effects.Design.Cases)
  {
    const std::string& name = table.Find(effects.Columns.Patient)->Texts()[row];
    patients.push_back(
        numbers.emplace(name, static_cast<Eigen::Index>(numbers.size())).first->second);
  }
  std::vector<int> counts(numbers.size());
  for (const Eigen::Index patient : patients)
  {
    effects.SeveralCount += ++counts[static_cast<std::size_t>(patient)] == 2 ? 1 : 0;
  }
  effects.PatientCount = static_cast<Eigen::Index>(numbers.size());
  return patients;
}

Eigen::VectorXd TimesOf(const CovariateTable& table, const RepeatedEffects& effects)
{
  const Covariate& column = *table.Find(effects.Columns.Time);
  if (!column.IsNumeric())
  {
    throw InputError("the time " + column.Name() + " is no number in some cases, such as \"" +
                     column.Texts()[column.FirstTextRow()] + "\"");
  }
  Eigen::VectorXd times(effects.Design.Matrix.rows());
  for (Eigen::Index i = 0; i < times.size(); ++i)
  {
    times[i] = column.Number(effects.Design.Cases[static_cast<std::size_t>(i)]);
  }
  return times;
}

MixedModel ModelOf(const CovariateTable& table, RepeatedEffects& effects,
                   std::vector<std::string>& notes)
{
  const std::vector<Eigen::Index> patients = PatientsOf(table, effects);
  MixedModel model;
  if (!effects.Columns.Time.empty())
  {
    const Status status =
        MixedModel::Make(effects.Design.Matrix, patients, TimesOf(table, effects), model);
    if (status.IsOk())
    {
      return model;
    }
    notes.push_back(status.Message() + "; only intercepts of " + effects.Columns.Patient +
                    " are random");
    effects.Columns.Time.clear();
  }
  CheckRepeated(MixedModel::Make(effects.Design.Matrix, patients, {}, model));
  return model;
}

// Of those that are no covariates and vary.
std::vector<RepeatedFigure> FitFigures(const MixedModel& model, const RepeatedEffects& effects,
                                       const std::vector<std::string>& names,
                                       const Eigen::MatrixXd& values)
{
  const std::vector<std::string> covariates = effects.Formula.Columns();
  std::vector<RepeatedFigure> figures;
  for (std::size_t k = 0; k < names.size(); ++k)
  {
    const Eigen::VectorXd column = values.col(static_cast<Eigen::Index>(k));
    RepeatedFigure figure{names[k], model.Fit(column(effects.Design.Cases)), {}, {}};
    for (const DesignTerm& term : effects.Design.Terms)
    {
      if (term.IsTested)
      {
        figure.Tests.push_back(MixedModel::Test(figure.Fit, term.First, term.Count));
      }
    }
    const bool isCovariate =
        std::find(covariates.begin(), covariates.end(), names[k]) != covariates.end();
    if (figure.Fit.IsFound && !isCovariate)
    {
      figures.push_back(std::move(figure));
    }
  }
  for (std::size_t t = 0; !figures.empty() && t < figures.front().Tests.size(); ++t)
  {
    Eigen::VectorXd p(static_cast<Eigen::Index>(figures.size()));
    std::transform(figures.begin(), figures.end(), p.begin(),
                   [t](const RepeatedFigure& figure) { return figure.Tests[t].P; });
    const Eigen::VectorXd rates = FalseDiscoveryRates(p);
    for (std::size_t k = 0; k < figures.size(); ++k)
    {
      figures[k].Discovery.push_back(rates[static_cast<Eigen::Index>(k)]);
    }
  }
  return figures;
}

void AllocatePoints(RepeatedEffects& effects)
{
  const auto count = static_cast<Eigen::Index>(effects.Surface.Points.size());
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(count);
  effects.BetweenPatients = effects.Slopes = effects.WithinPatients = effects.Singular = zero;
  for (const DesignTerm& term : effects.Design.Terms)
  {
    if (!term.IsTested)
    {
      continue;
    }
    RepeatedTerm repeated;
    repeated.Term = term;
    repeated.Statistic = zero;
    repeated.P = Eigen::VectorXd::Ones(count);
    for (Eigen::Index k = term.First; k < term.First + term.Count; ++k)
    {
      repeated.Columns.push_back({effects.Design.Columns[static_cast<std::size_t>(k)], zero, zero});
    }
    effects.Terms.push_back(std::move(repeated));
  }
}

// Points are independent, so that threads write none twice.
void TakePoint(const MixedFit& fit, Eigen::Index point, RepeatedEffects& effects)
{
  if (!fit.IsFound)
  {
    return;
  }
  effects.BetweenPatients[point] = std::sqrt(fit.SubjectCovariance(0, 0));
  effects.Slopes[point] = std::sqrt(fit.SubjectCovariance(1, 1));
  effects.WithinPatients[point] = std::sqrt(fit.ResidualVariance);
  effects.Singular[point] = fit.IsSingular ? 1.0 : 0.0;
  for (RepeatedTerm& term : effects.Terms)
  {
    const Eigen::Index first = term.Term.First;
    for (Eigen::Index k = 0; k < term.Term.Count; ++k)
    {
      ColumnEffect& column = term.Columns[static_cast<std::size_t>(k)];
      column.PerUnit[point] = fit.Coefficients[first + k];
      column.HalfWidth[point] = MixedModel::ConfidenceWidth(fit, first + k, RepeatedConfidence);
    }
    const FixedTest test = MixedModel::Test(fit, first, term.Term.Count);
    term.Statistic[point] = term.Term.Count == 1
                                ? std::copysign(std::sqrt(test.F), fit.Coefficients[first])
                                : std::sqrt(test.F);
    term.P[point] = test.P;
  }
}

void FitPoints(const CohortGroup& group, const MixedModel& model, const KernelProgress& progress,
               RepeatedEffects& effects)
{
  effects.Surface = FindNormalDisplacement(ShapeOf(group, -1, 0.0), EffectFrequency);
  AllocatePoints(effects);
  const Eigen::MatrixXd coefficients = CoefficientsOf(group)(effects.Design.Cases, Eigen::all);
  const Eigen::MatrixXd centred = coefficients.rowwise() - group.Modes.Mean.transpose();
  const auto count = static_cast<Eigen::Index>(effects.Surface.Points.size());
  for (Eigen::Index first = 0; first < count; first += PointsAtATime)
  {
    if (progress && !progress(static_cast<double>(first) / static_cast<double>(count)))
    {
      throw Cancelled();
    }
    const Eigen::Index size = std::min(PointsAtATime, count - first);
    const Eigen::MatrixXd outcomes =
        centred * effects.Surface.PerCoefficient.middleRows(first, size).transpose();
    vtkSMPTools::For(0, size,
                     [&](vtkIdType from, vtkIdType to)
                     {
                       for (vtkIdType i = from; i < to; ++i)
                       {
                         TakePoint(model.Fit(outcomes.col(i)), first + i, effects);
                       }
                     });
  }
  effects.UnfoundPoints = (effects.WithinPatients.array() == 0.0).count();
  for (RepeatedTerm& term : effects.Terms)
  {
    term.Discovery = FalseDiscoveryRates(term.P);
  }
}
} // namespace

std::string RepeatedEffects::RandomText() const
{
  return std::string("random intercept") +
         (this->Columns.Time.empty() ? "" : " and slope on " + this->Columns.Time) + " of each " +
         this->Columns.Patient;
}

std::string RepeatedEffects::SingularText() const
{
  const auto isSingular = [](const RepeatedFigure& figure) { return figure.Fit.IsSingular; };
  const auto count = std::count_if(this->Figures.begin(), this->Figures.end(), isSingular) +
                     std::count_if(this->Modes.begin(), this->Modes.end(), isSingular);
  return std::to_string(count) + " of " +
         std::to_string(this->Figures.size() + this->Modes.size()) + " figures and modes and " +
         std::to_string(static_cast<int>(this->Singular.sum())) + " of " +
         std::to_string(this->Singular.size()) +
         " points have a singular fit (no variance between patients, or slopes that follow from "
         "intercepts); their tests reject less" +
         (this->UnfoundPoints == 0
              ? ""
              : "; " + std::to_string(this->UnfoundPoints) + " points do not vary and have none");
}

RepeatedEffects FindRepeatedEffects(const CohortGroup& group, const CovariateTable& covariates,
                                    const ModelFormula& formula,
                                    const std::map<std::string, std::string>& references,
                                    const RepeatedColumns& columns, std::vector<std::string>& notes,
                                    const KernelProgress& progress)
{
  RepeatedEffects effects;
  effects.Formula = formula;
  effects.Columns = columns;
  std::vector<std::string> needed{columns.Patient};
  if (!columns.Time.empty())
  {
    needed.push_back(columns.Time);
  }
  for (const std::string& name : needed)
  {
    if (covariates.Find(name) == nullptr)
    {
      throw InputError("the covariates have no column " + name);
    }
  }
  CheckRepeated(MakeLinearDesign(covariates, formula, references, effects.Design, needed));
  const MixedModel model = ModelOf(covariates, effects, notes);
  effects.Figures = FitFigures(model, effects, FigureNames(), FiguresOf(group));
  const Eigen::Index modes = std::min(MostRepeatedModes, group.Modes.Scores.cols());
  effects.Modes = FitFigures(model, effects, ModeNames(modes), group.Modes.Scores);
  FitPoints(group, model, progress, effects);
  return effects;
}
} // namespace palpate
