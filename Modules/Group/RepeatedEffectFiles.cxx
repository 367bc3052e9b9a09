#include "RepeatedEffectFiles.h"

#include "CohortEffectFiles.h"
#include "CohortEffectPage.h"
#include "CsvText.h"
#include "DecimalText.h"
#include "MappedMean.h"
#include "ReportPage.h"
#include "ReportTable.h"
#include "ScreenText.h"
#include "SurfaceFile.h"
#include "VarianceInflation.h"
#include "WholeFile.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace palpate
{
namespace
{
// Calls with each figure or mode, each tested term and its place, and each column of it.
using RepeatedRow =
    std::function<void(const RepeatedFigure&, const DesignTerm&, std::size_t, Eigen::Index)>;
void ForEachRow(const RepeatedEffects& effects, const RepeatedRow& row)
{
  for (const std::vector<RepeatedFigure>* figures : {&effects.Figures, &effects.Modes})
  {
    for (const RepeatedFigure& figure : *figures)
    {
      for (std::size_t t = 0; t < effects.Terms.size(); ++t)
      {
        const DesignTerm& term = effects.Terms[t].Term;
        for (Eigen::Index k = term.First; k < term.First + term.Count; ++k)
        {
          row(figure, term, t, k);
        }
      }
    }
  }
}

std::string CoefficientTable(const RepeatedEffects& effects)
{
  std::string text = CsvLine({"figure", "term", "column", "estimate", "standard_error", "degrees",
                              "t", "p", "term_f", "term_df1", "term_df2", "term_p", "term_q"});
  ForEachRow(
      effects,
      [&](const RepeatedFigure& figure, const DesignTerm& term, std::size_t t, Eigen::Index column)
      {
        const FixedTest one = MixedModel::Test(figure.Fit, column, 1);
        const FixedTest& all = figure.Tests[t];
        const double estimate = figure.Fit.Coefficients[column];
        std::vector<std::string> fields{figure.Name, term.Name,
                                        effects.Design.Columns[static_cast<std::size_t>(column)]};
        for (const double number :
             {estimate, std::sqrt(figure.Fit.Covariance(column, column)), one.DenominatorDegrees,
              std::copysign(std::sqrt(one.F), estimate), one.P, all.F, all.NumeratorDegrees,
              all.DenominatorDegrees, all.P, figure.Discovery[t]})
        {
          fields.push_back(ExactText(number));
        }
        text += CsvLine(fields);
      });
  return text;
}

// Standard deviations between patients, of slopes, and within; the correlation of the first two.
std::vector<double> VariancesOf(const MixedFit& fit)
{
  const double between = std::sqrt(fit.SubjectCovariance(0, 0));
  const double slope = std::sqrt(fit.SubjectCovariance(1, 1));
  const double correlation = between * slope > 0.0 ? fit.SubjectCovariance(1, 0) / (between * slope)
                                                   : std::numeric_limits<double>::quiet_NaN();
  return {between, slope, correlation, std::sqrt(fit.ResidualVariance)};
}

std::string VarianceComponentTable(const RepeatedEffects& effects)
{
  std::string text = CsvLine({"figure", "sd_between", "sd_slope", "correlation", "sd_within",
                              "singular", "reml_criterion"});
  for (const std::vector<RepeatedFigure>* figures : {&effects.Figures, &effects.Modes})
  {
    for (const RepeatedFigure& figure : *figures)
    {
      std::vector<std::string> fields{figure.Name};
      for (const double number : VariancesOf(figure.Fit))
      {
        fields.push_back(std::isnan(number) ? std::string() : ExactText(number));
      }
      fields.emplace_back(figure.Fit.IsSingular ? "1" : "0");
      fields.push_back(ExactText(figure.Fit.Criterion));
      text += CsvLine(fields);
    }
  }
  return text;
}

std::string PointTermTable(const RepeatedEffects& effects)
{
  std::string text =
      CsvLine({"term", "columns", "cases", "patients", "least_p", "least_q", "discovery_mm2",
               "largest_mm", "largest_unit", "singular_points", "variance_inflation"});
  for (const RepeatedTerm& term : effects.Terms)
  {
    text +=
        CsvLine({term.Term.Name, std::to_string(term.Term.Count),
                 std::to_string(effects.Design.Cases.size()), std::to_string(effects.PatientCount),
                 ExactText(term.P.minCoeff()), ExactText(term.Discovery.minCoeff()),
                 ExactText(SignificantArea(effects.Surface, term.Discovery)),
                 ExactText(term.LargestMillimeters()), term.UnitText(),
                 std::to_string(static_cast<int>(effects.Singular.sum())),
                 ExactText(VarianceInflation(effects.Design, term.Term))});
  }
  return text;
}

vtkSmartPointer<vtkPolyData> RepeatedSurface(const RepeatedEffects& effects)
{
  auto surface = MeanSurface(effects.Surface);
  for (const RepeatedTerm& term : effects.Terms)
  {
    AddDisplacementMaps(surface, term);
    const std::string& name = term.Term.Name;
    AddPointMap(surface, name + (term.Term.Count == 1 ? " t" : " root F"), term.Statistic);
    AddPointMap(surface, name + " p", term.P);
    AddPointMap(surface, name + " q", term.Discovery);
  }
  AddPointMap(surface, "sd between patients (mm)", effects.BetweenPatients);
  if (!effects.Columns.Time.empty())
  {
    AddPointMap(surface, "sd of slopes (mm)", effects.Slopes);
  }
  AddPointMap(surface, "sd within patients (mm)", effects.WithinPatients);
  AddPointMap(surface, "singular", effects.Singular);
  return surface;
}

std::string RepeatedHeading(const RepeatedEffects& effects)
{
  return effects.Formula.Text() + ", " + effects.RandomText() + "; " +
         std::to_string(effects.Design.Cases.size()) + " cases of " +
         std::to_string(effects.PatientCount) + " patients, " +
         std::to_string(effects.SeveralCount) + " with several";
}

// The least false-discovery rate of a term; 1 without figures.
double LeastRate(const std::vector<RepeatedFigure>& figures, std::size_t term)
{
  double least = 1.0;
  for (const RepeatedFigure& figure : figures)
  {
    least = std::min(least, figure.Discovery[term]);
  }
  return least;
}

ReportTable FigureTable(const RepeatedEffects& effects)
{
  ReportTable table({"Figure", "Effect", "estimate", "standard error", "df", "p", "q of the term"});
  ForEachRow(
      effects,
      [&](const RepeatedFigure& figure, const DesignTerm&, std::size_t t, Eigen::Index column)
      {
        const FixedTest one = MixedModel::Test(figure.Fit, column, 1);
        table.Text(figure.Name)
            .Text(effects.Design.Columns[static_cast<std::size_t>(column)])
            .Value(SignificantText(figure.Fit.Coefficients[column], 3))
            .Value(SignificantText(std::sqrt(figure.Fit.Covariance(column, column)), 3))
            .Value(SignificantText(one.DenominatorDegrees, 3))
            .Value(SignificantText(one.P, 2))
            .Value(SignificantText(figure.Discovery[t], 2));
      });
  return table;
}

ReportTable DeviationTable(const RepeatedEffects& effects)
{
  ReportTable table({"Figure", "sd between", "sd of slopes", "correlation", "sd within", "fit"});
  for (const std::vector<RepeatedFigure>* figures : {&effects.Figures, &effects.Modes})
  {
    for (const RepeatedFigure& figure : *figures)
    {
      table.Text(figure.Name);
      for (const double number : VariancesOf(figure.Fit))
      {
        std::isnan(number) ? table.Nothing() : table.Value(SignificantText(number, 3));
      }
      table.Text(figure.Fit.IsSingular ? "singular" : "");
    }
  }
  return table;
}
} // namespace

std::string RepeatedEffectText(const RepeatedEffects& effects)
{
  const auto right = [](const std::string& text, std::size_t width)
  { return std::string(width - std::min(width - 1, text.size()), ' ') + text; };
  std::string table = RepeatedHeading(effects) +
                      "\nterm                 q, figures    q, modes  q, surface  largest, mm\n";
  for (std::size_t t = 0; t < effects.Terms.size(); ++t)
  {
    const RepeatedTerm& term = effects.Terms[t];
    std::string name = Printable(term.Term.Name);
    name.resize(std::max<std::size_t>(name.size(), 20), ' ');
    table += name + right(SignificantText(LeastRate(effects.Figures, t), 3), 11) +
             right(SignificantText(LeastRate(effects.Modes, t), 3), 12) +
             right(SignificantText(term.Discovery.minCoeff(), 3), 12) +
             right(FixedText(term.LargestMillimeters(), 2), 13) + " " + term.UnitText() + "\n";
  }
  return table + effects.SingularText() + "\n";
}

std::string RepeatedEffectMethods(const RepeatedEffects& effects)
{
  return "Several cases of a patient were related to covariates by linear mixed models, " +
         RepeatedHeading(effects) +
         ", of figures, of the scores of the first modes, and of the displacement along the "
         "mean\xE2\x80\x99s normal at " +
         std::to_string(effects.Surface.Points.size()) +
         " points each, by restricted maximum likelihood (Patterson and Thompson 1971; profiled as "
         "by Bates and others 2015). Each term was tested given all others, with covariances and "
         "degrees of freedom of Kenward and Roger (1997). False-discovery rates are those of "
         "Benjamini and Hochberg among figures, modes and points. " +
         effects.SingularText() + ".";
}

void AddRepeatedEffects(ReportPage& page, const RepeatedEffects& effects)
{
  page.Section("Repeated scans")
      .Text("Linear mixed model " + RepeatedHeading(effects) +
            ". Least false-discovery rates (q) of each term; in the images red is outward, blue "
            "inward; what is pale is not significant (q at the point, 0.05). " +
            effects.SingularText() + ".");
  ReportTable terms({"Term", "q, figures", "q, modes", "q, surface", "largest, mm"});
  for (std::size_t t = 0; t < effects.Terms.size(); ++t)
  {
    const RepeatedTerm& term = effects.Terms[t];
    terms.Text(term.Term.Name)
        .Value(SignificantText(LeastRate(effects.Figures, t), 2))
        .Value(SignificantText(LeastRate(effects.Modes, t), 2))
        .Value(SignificantText(term.Discovery.minCoeff(), 2))
        .Value(FixedText(term.LargestMillimeters(), 2) + " " + term.UnitText());
  }
  page.Table(terms).Table(FigureTable(effects)).Table(DeviationTable(effects));
  for (const RepeatedTerm& term : effects.Terms)
  {
    AddDisplacementFigures(page, term, term.Discovery, effects.Surface);
  }
  AddDesignNotes(page, effects.Design);
}

void WriteRepeatedEffects(const CohortGroup& group, const RepeatedEffects& effects,
                          const std::filesystem::path& folder)
{
  WriteWholeFile(folder / "repeated.csv", CoefficientTable(effects));
  WriteWholeFile(folder / "repeated_variances.csv", VarianceComponentTable(effects));
  WriteWholeFile(folder / "effects.csv", PointTermTable(effects));
  WriteWholeFile(folder / "design.csv", DesignTable(group, effects.Design));
  WriteSurface(folder / "effects.vtp", RepeatedSurface(effects));
}
} // namespace palpate
