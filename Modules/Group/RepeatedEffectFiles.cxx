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
#include <iterator>

namespace palpate
{
namespace
{
/// Rows of texts under a head.
using TextRows = std::vector<std::vector<std::string>>;
using NumberText = std::function<std::string(double)>;

std::string CsvOf(const TextRows& rows)
{
  std::string text;
  for (const std::vector<std::string>& row : rows)
  {
    text += CsvLine(row);
  }
  return text;
}

ReportTable PageTableOf(const TextRows& rows, const std::vector<std::size_t>& columns)
{
  const auto chosen = [&](const std::vector<std::string>& row)
  {
    std::vector<std::string> cells;
    for (const std::size_t column : columns)
    {
      cells.push_back(row[column]);
    }
    return cells;
  };
  ReportTable table(chosen(rows.front()));
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    for (const std::string& cell : chosen(rows[i]))
    {
      ParseNumber(cell) ? table.Value(cell) : table.Text(cell);
    }
  }
  return table;
}

void Append(const std::vector<double>& numbers, const NumberText& format,
            std::vector<std::string>& row)
{
  std::transform(numbers.begin(), numbers.end(), std::back_inserter(row),
                 [&](double number)
                 { return std::isnan(number) ? std::string() : format(number); });
}

std::vector<RepeatedFigure> AllFigures(const RepeatedEffects& effects)
{
  std::vector<RepeatedFigure> all = effects.Figures;
  all.insert(all.end(), effects.Modes.begin(), effects.Modes.end());
  return all;
}

TextRows CoefficientRows(const RepeatedEffects& effects, const NumberText& format)
{
  TextRows rows{{"figure", "term", "column", "estimate", "standard_error", "degrees", "t", "p",
                 "term_f", "term_df1", "term_df2", "term_p", "term_q"}};
  for (const RepeatedFigure& figure : AllFigures(effects))
  {
    for (std::size_t t = 0; t < effects.Terms.size(); ++t)
    {
      const DesignTerm& term = effects.Terms[t].Term;
      const FixedTest& all = figure.Tests[t];
      for (Eigen::Index k = term.First; k < term.First + term.Count; ++k)
      {
        const FixedTest one = MixedModel::Test(figure.Fit, k, 1);
        const double estimate = figure.Fit.Coefficients[k];
        rows.push_back(
            {figure.Name, term.Name, effects.Design.Columns[static_cast<std::size_t>(k)]});
        Append({estimate, std::sqrt(figure.Fit.Covariance(k, k)), one.DenominatorDegrees,
                std::copysign(std::sqrt(one.F), estimate), one.P, all.F, all.NumeratorDegrees,
                all.DenominatorDegrees, all.P, figure.Discovery[t]},
               format, rows.back());
      }
    }
  }
  return rows;
}

// The correlation is empty if it is not defined.
TextRows VarianceRows(const RepeatedEffects& effects, const NumberText& format)
{
  TextRows rows{{"figure", "sd_between", "sd_slope", "correlation", "sd_within", "singular",
                 "reml_criterion"}};
  for (const RepeatedFigure& figure : AllFigures(effects))
  {
    const MixedFit& fit = figure.Fit;
    const double between = std::sqrt(fit.SubjectCovariance(0, 0));
    const double slope = std::sqrt(fit.SubjectCovariance(1, 1));
    rows.push_back({figure.Name});
    Append({between, slope, fit.SubjectCovariance(1, 0) / (between * slope),
            std::sqrt(fit.ResidualVariance)},
           format, rows.back());
    rows.back().emplace_back(fit.IsSingular ? "yes" : "no");
    Append({fit.Criterion}, format, rows.back());
  }
  return rows;
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

// Least false-discovery rates of the terms, and the largest displacement.
TextRows TermRows(const RepeatedEffects& effects)
{
  TextRows rows{{"term", "q, figures", "q, modes", "q, surface", "largest, mm"}};
  for (std::size_t t = 0; t < effects.Terms.size(); ++t)
  {
    const RepeatedTerm& term = effects.Terms[t];
    rows.push_back({term.Term.Name, SignificantText(LeastRate(effects.Figures, t), 3),
                    SignificantText(LeastRate(effects.Modes, t), 3),
                    SignificantText(term.Discovery.minCoeff(), 3),
                    FixedText(term.LargestMillimeters(), 2) + " " + term.UnitText()});
  }
  return rows;
}
} // namespace

std::string RepeatedEffectText(const RepeatedEffects& effects)
{
  std::string table = RepeatedHeading(effects) + "\n";
  for (const std::vector<std::string>& row : TermRows(effects))
  {
    std::string line = Printable(row.front());
    for (std::size_t k = 1; k < row.size(); ++k)
    {
      line.resize(std::max(line.size() + 2, 20 + 12 * (k - 1)), ' ');
      line += row[k];
    }
    table += line + "\n";
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
  const auto shortText = [](double number) { return SignificantText(number, 3); };
  page.Table(PageTableOf(TermRows(effects), {0, 1, 2, 3, 4}))
      .Table(PageTableOf(CoefficientRows(effects, shortText), {0, 2, 3, 4, 5, 7, 12}))
      .Table(PageTableOf(VarianceRows(effects, shortText), {0, 1, 2, 3, 4, 5}));
  for (const RepeatedTerm& term : effects.Terms)
  {
    AddDisplacementFigures(page, term, term.Discovery, effects.Surface);
  }
  AddDesignNotes(page, effects.Design);
}

void WriteRepeatedEffects(const CohortGroup& group, const RepeatedEffects& effects,
                          const std::filesystem::path& folder)
{
  const auto exact = [](double number) { return ExactText(number); };
  WriteWholeFile(folder / "repeated.csv", CsvOf(CoefficientRows(effects, exact)));
  WriteWholeFile(folder / "repeated_variances.csv", CsvOf(VarianceRows(effects, exact)));
  WriteWholeFile(folder / "effects.csv", PointTermTable(effects));
  WriteWholeFile(folder / "design.csv", DesignTable(group, effects.Design));
  WriteSurface(folder / "effects.vtp", RepeatedSurface(effects));
}
} // namespace palpate
