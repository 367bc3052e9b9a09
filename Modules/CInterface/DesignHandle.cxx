#include "DesignHandle.h"

#include "ErrorText.h"
#include "InputError.h"
#include "LinearModel.h"
#include "MixedModel.h"
#include "ModelHandle.h"
#include "MultivariateTest.h"
#include "NormalDisplacement.h"
#include "OrderedTasks.h"
#include "PermutationTest.h"
#include "ProcessorCount.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Saturates.
std::size_t ProductOf(std::size_t a, std::size_t b)
{
  return b > 0 && a > SIZE_MAX / b ? SIZE_MAX : a * b;
}

// The numbers of `count` outcomes for each case of a design, which may be missing.
std::size_t SizeOf(const palpate_design* design, std::size_t count)
{
  return design != nullptr ? ProductOf(design->GivenCases, count) : count;
}

// Throws if a text is missing, which the caller's guard tells.
std::vector<std::string> TextsOf(const char* const* texts, std::size_t count, const char* name)
{
  if (std::find(texts, texts + count, nullptr) != texts + count)
  {
    throw InputError(std::string("a text of '") + name + "' is NULL");
  }
  return {texts, texts + count};
}

// Of the kept cases. Throws what the caller's guard tells.
Eigen::MatrixXd OutcomesOf(const palpate_design* design, const double* outcomes, std::size_t count)
{
  if (count == 0)
  {
    throw InputError("there are no outcomes");
  }
  Eigen::MatrixXd kept(static_cast<Eigen::Index>(design->Design.Cases.size()),
                       static_cast<Eigen::Index>(count));
  Eigen::Index row = 0;
  for (const std::size_t given : design->Design.Cases)
  {
    kept.row(row++) = Eigen::Map<const Eigen::RowVectorXd>(outcomes + given * count,
                                                           static_cast<Eigen::Index>(count));
  }
  if (!kept.allFinite())
  {
    throw InputError("an outcome of a case with all covariates is not finite");
  }
  return kept;
}

const DesignTerm& TermOf(const palpate_design* design, std::size_t term)
{
  if (term >= design->Design.Terms.size())
  {
    throw InputError("the design has no term of that number");
  }
  return design->Design.Terms[term];
}

void CopyRows(const Eigen::MatrixXd& values, double* rows)
{
  Eigen::Map<RowMajor>(rows, values.rows(), values.cols()) = values;
}

void CopyVector(const Eigen::VectorXd& values, double* numbers)
{
  if (numbers != nullptr)
  {
    std::copy(values.data(), values.data() + values.size(), numbers);
  }
}

// Of the kept cases. Throws what the caller's guard tells.
MixedModel MixedModelOf(const palpate_design* design, const int32_t* subjects, const double* times)
{
  std::map<int32_t, Eigen::Index> numbers;
  std::vector<Eigen::Index> subject;
  Eigen::VectorXd time(times != nullptr ? static_cast<Eigen::Index>(design->Design.Cases.size())
                                        : 0);
  for (const std::size_t given : design->Design.Cases)
  {
    const auto row = static_cast<Eigen::Index>(subject.size());
    subject.push_back(
        numbers.emplace(subjects[given], static_cast<Eigen::Index>(numbers.size())).first->second);
    if (times != nullptr)
    {
      time[row] = times[given];
    }
  }
  if (!time.allFinite())
  {
    throw InputError("the time of a case with all covariates is not finite");
  }
  MixedModel model;
  if (const Status status = MixedModel::Make(design->Design.Matrix, subject, time, model);
      !status.IsOk())
  {
    throw InputError(status.Message());
  }
  return model;
}

// Writes what was found in the outcome k of `count`.
void TakeMixedFit(const LinearDesign& design, const MixedFit& fit, double confidence, std::size_t k,
                  std::size_t count, const palpate_mixed& to)
{
  const auto put = [&](double* rows, std::size_t row, double value)
  {
    if (rows != nullptr)
    {
      rows[row * count + k] = value;
    }
  };
  for (std::size_t c = 0; c < design.Columns.size(); ++c)
  {
    const auto column = static_cast<Eigen::Index>(c);
    put(to.coefficients, c, fit.Coefficients[column]);
    put(to.errors, c, std::sqrt(fit.Covariance(column, column)));
    put(to.half_widths, c, MixedModel::ConfidenceWidth(fit, column, confidence));
  }
  for (std::size_t t = 0; t < design.Terms.size(); ++t)
  {
    const FixedTest test = MixedModel::Test(fit, design.Terms[t].First, design.Terms[t].Count);
    put(to.f, t, test.F);
    put(to.numerator_degrees, t, test.NumeratorDegrees);
    put(to.denominator_degrees, t, test.DenominatorDegrees);
    put(to.p, t, test.P);
  }
  put(to.criterion, 0, fit.Criterion);
  put(to.residual_variance, 0, fit.ResidualVariance);
  put(to.subject_covariance, 0, fit.SubjectCovariance(0, 0));
  put(to.subject_covariance, 1, fit.SubjectCovariance(0, 1));
  put(to.subject_covariance, 2, fit.SubjectCovariance(1, 1));
  put(to.is_singular, 0, fit.IsSingular ? 1.0 : 0.0);
}

SurfaceGraph GraphOf(std::size_t count, const double* areas, const int32_t* triangles,
                     std::size_t triangleCount)
{
  SurfaceGraph graph;
  graph.Areas.assign(areas, areas + count);
  if (!std::all_of(graph.Areas.begin(), graph.Areas.end(),
                   [](double area) { return std::isfinite(area) && area >= 0.0; }))
  {
    throw InputError("an area is negative or not finite");
  }
  std::set<std::pair<int, int>> edges;
  for (std::size_t i = 0; i < 3 * triangleCount; ++i)
  {
    const int32_t from = triangles[i];
    const int32_t to = triangles[i % 3 == 2 ? i - 2 : i + 1];
    if (from < 0 || static_cast<std::size_t>(from) >= count)
    {
      throw InputError("a triangle has a corner that is no point");
    }
    edges.insert(std::minmax(from, to));
  }
  graph.Edges.assign(edges.begin(), edges.end());
  return graph;
}
} // namespace
} // namespace palpate

using namespace palpate;

palpate_design* palpate_design_create(const char* formula, size_t case_count, size_t column_count,
                                      const char* const* names, const char* const* values,
                                      size_t reference_count, const char* const* references,
                                      palpate_error* error)
{
  return Guarded(
      error,
      {{formula, "formula"},
       {names, "names", column_count},
       {values, "values", ProductOf(case_count, column_count)},
       {references, "references", reference_count}},
      [&]() -> palpate_design*
      {
        if (case_count > MostElements)
        {
          SetError(error, "there are too many cases");
          return nullptr;
        }
        std::vector<std::string> cases;
        for (std::size_t i = 0; i < case_count; ++i)
        {
          cases.push_back(std::to_string(i));
        }
        CovariateTable table(cases);
        const std::vector<std::string> columns = TextsOf(names, column_count, "names");
        for (std::size_t k = 0; k < column_count; ++k)
        {
          table.Add(columns[k], TextsOf(values + k * case_count, case_count, "values"));
        }
        palpate_design made;
        made.GivenCases = case_count;
        ModelFormula parsed;
        std::map<std::string, std::string> levels;
        if (Told(ModelFormula::Parse(formula, parsed), error) == 0 ||
            Told(ParseReferences(TextsOf(references, reference_count, "references"), levels),
                 error) == 0 ||
            Told(MakeLinearDesign(table, parsed, levels, made.Design), error) == 0)
        {
          return nullptr;
        }
        return new palpate_design(std::move(made));
      });
}

void palpate_design_free(palpate_design* design)
{
  delete design;
}

size_t palpate_design_case_count(const palpate_design* design)
{
  return design != nullptr ? design->Design.Cases.size() : 0;
}

size_t palpate_design_column_count(const palpate_design* design)
{
  return design != nullptr ? design->Design.Columns.size() : 0;
}

size_t palpate_design_term_count(const palpate_design* design)
{
  return design != nullptr ? design->Design.Terms.size() : 0;
}

const char* palpate_design_column_name(const palpate_design* design, size_t column)
{
  return design != nullptr && column < design->Design.Columns.size()
             ? design->Design.Columns[column].c_str()
             : nullptr;
}

int palpate_design_term(const palpate_design* design, size_t term, palpate_term* found)
{
  if (design == nullptr || found == nullptr || term >= design->Design.Terms.size())
  {
    return 0;
  }
  const DesignTerm& one = design->Design.Terms[term];
  *found = {one.Name.c_str(), static_cast<std::size_t>(one.First),
            static_cast<std::size_t>(one.Count), one.IsTested ? 1 : 0};
  return 1;
}

void palpate_design_matrix(const palpate_design* design, size_t* cases, double* matrix)
{
  if (!AreGiven({{design, "design"}, {cases, "cases"}, {matrix, "matrix"}}, nullptr))
  {
    return;
  }
  std::copy(design->Design.Cases.begin(), design->Design.Cases.end(), cases);
  CopyRows(design->Design.Matrix, matrix);
}

int palpate_design_fit(const palpate_design* design, const double* outcomes, size_t outcome_count,
                       double confidence, double* coefficients, double* errors, double* half_widths,
                       palpate_error* error)
{
  return Guarded(error,
                 {{design, "design"},
                  {outcomes, "outcomes", SizeOf(design, outcome_count)},
                  {coefficients, "coefficients"},
                  {errors, "errors"},
                  {half_widths, "half_widths"}},
                 [&]
                 {
                   if (!(confidence > 0.0 && confidence < 1.0))
                   {
                     SetError(error, "the confidence is not between 0 and 1");
                     return 0;
                   }
                   const LinearModel model =
                       FitLinearModel(design->Design, OutcomesOf(design, outcomes, outcome_count));
                   CopyRows(model.Coefficients, coefficients);
                   CopyRows(model.StandardErrors, errors);
                   CopyRows(model.ConfidenceWidths(confidence), half_widths);
                   return 1;
                 });
}

int palpate_design_fit_mixed(const palpate_design* design, const int32_t* subjects,
                             const double* times, const double* outcomes, size_t outcome_count,
                             double confidence, const palpate_mixed* results, palpate_error* error)
{
  return Guarded(
      error,
      {{design, "design"},
       {subjects, "subjects"},
       {outcomes, "outcomes", SizeOf(design, outcome_count)},
       {results, "results"}},
      [&]
      {
        if (!(confidence > 0.0 && confidence < 1.0))
        {
          SetError(error, "the confidence is not between 0 and 1");
          return 0;
        }
        const Eigen::MatrixXd kept = OutcomesOf(design, outcomes, outcome_count);
        const MixedModel model = MixedModelOf(design, subjects, times);
        OrderedTasks<MixedFit> fits(outcome_count, ProcessorCount(),
                                    [&](std::size_t k)
                                    { return model.Fit(kept.col(static_cast<Eigen::Index>(k))); });
        for (std::size_t k = 0; k < outcome_count; ++k)
        {
          TakeMixedFit(design->Design, fits.Next(), confidence, k, outcome_count, *results);
        }
        return 1;
      });
}

int palpate_design_test(const palpate_design* design, size_t term, const double* outcomes,
                        size_t outcome_count, double* f, double* p, double* partial_r2,
                        palpate_error* error)
{
  return Guarded(error, {{design, "design"}, {outcomes, "outcomes", SizeOf(design, outcome_count)}},
                 [&]
                 {
                   const Eigen::MatrixXd kept = OutcomesOf(design, outcomes, outcome_count);
                   const TermTest test = TestTerm(design->Design, TermOf(design, term),
                                                  FitLinearModel(design->Design, kept), kept);
                   CopyVector(test.F, f);
                   CopyVector(test.P, p);
                   CopyVector(test.PartialR2, partial_r2);
                   return 1;
                 });
}

int palpate_design_test_together(const palpate_design* design, size_t term, const double* outcomes,
                                 size_t outcome_count, palpate_multivariate* found,
                                 palpate_error* error)
{
  return Guarded(
      error,
      {{design, "design"}, {outcomes, "outcomes", SizeOf(design, outcome_count)}, {found, "found"}},
      [&]
      {
        MultivariateTest test;
        const Eigen::MatrixXd kept = OutcomesOf(design, outcomes, outcome_count);
        if (Told(TestTogether(design->Design, TermOf(design, term), kept, test), error) == 0)
        {
          return 0;
        }
        const auto copy = [](const MultivariateStatistic& one) -> palpate_statistic {
          return {one.Value, one.F, one.NumeratorDegrees, one.DenominatorDegrees, one.P};
        };
        *found = {copy(test.Pillai), copy(test.Wilks), copy(test.HotellingLawley), copy(test.Roy)};
        return 1;
      });
}

int palpate_design_permute(const palpate_design* design, size_t term, const double* outcomes,
                           size_t point_count, const double* areas, const int32_t* triangles,
                           size_t triangle_count, int permutations, uint64_t seed,
                           double* statistic, double* p, double* family_p, double* enhanced_p,
                           double* whole_f, double* whole_p, palpate_error* error)
{
  return Guarded(error,
                 {{design, "design"},
                  {outcomes, "outcomes", SizeOf(design, point_count)},
                  {areas, "areas", point_count},
                  {triangles, "triangles", triangle_count},
                  {whole_f, "whole_f"},
                  {whole_p, "whole_p"}},
                 [&]
                 {
                   if (permutations < 1 || permutations > 10000000)
                   {
                     SetError(error, "permutations are not between 1 and 10,000,000");
                     return 0;
                   }
                   PermutationSettings settings;
                   settings.Count = permutations;
                   settings.Seed = seed;
                   PermutationTest test;
                   const Status status = TestByPermutation(
                       FindEffectSpace(design->Design, TermOf(design, term)),
                       OutcomesOf(design, outcomes, point_count),
                       GraphOf(point_count, areas, triangles, triangle_count), settings, {}, test);
                   if (Told(status, error) == 0)
                   {
                     return 0;
                   }
                   CopyVector(test.Statistic, statistic);
                   CopyVector(test.P, p);
                   CopyVector(test.FamilyP, family_p);
                   CopyVector(test.EnhancedP, enhanced_p);
                   *whole_f = test.WholeF;
                   *whole_p = test.WholeP;
                   return 1;
                 });
}

int palpate_model_displacement(const palpate_model* model, int frequency, double* points,
                               double* normals, double* areas, int32_t* triangles,
                               double* per_coefficient, palpate_error* error)
{
  return Guarded(error,
                 {{model, "model"},
                  {points, "points"},
                  {normals, "normals"},
                  {areas, "areas"},
                  {triangles, "triangles"},
                  {per_coefficient, "per_coefficient"}},
                 [&]
                 {
                   if (frequency < 1 || frequency > 100)
                   {
                     SetError(error, "the frequency is not between 1 and 100");
                     return 0;
                   }
                   const NormalDisplacement found =
                       FindNormalDisplacement(model->Document.Surface, frequency);
                   for (std::size_t i = 0; i < found.Points.size(); ++i)
                   {
                     Copy(found.Points[i], points + 3 * i);
                     Copy(found.Normals[i], normals + 3 * i);
                   }
                   std::copy(found.Areas.begin(), found.Areas.end(), areas);
                   for (const std::array<int, 3>& corners : found.Triangles)
                   {
                     triangles = std::copy(corners.begin(), corners.end(), triangles);
                   }
                   CopyRows(found.PerCoefficient, per_coefficient);
                   return 1;
                 });
}
