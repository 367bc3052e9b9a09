#include "StatisticsBinding.h"

#include "Arrays.h"
#include "Call.h"
#include "ModelBinding.h"
#include "Results.h"

#include "palpate.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <pybind11/stl.h>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
namespace py = pybind11;

/// The text of a value: empty for None and for what is not a number.
std::string TextOfValue(const py::handle& value)
{
  const bool isMissing =
      value.is_none() || (PyFloat_Check(value.ptr()) && value.attr("__ne__")(value).cast<bool>());
  return isMissing ? std::string() : py::str(value).cast<std::string>();
}

std::vector<const char*> PointersOf(const std::vector<std::string>& texts)
{
  std::vector<const char*> pointers;
  for (const std::string& text : texts)
  {
    pointers.push_back(text.c_str());
  }
  return pointers;
}

/// Covariates as the C interface takes them.
struct CovariateTexts
{
  std::vector<std::string> Names;
  std::vector<std::string> Values; ///< column after column
  std::size_t Cases = 0;

  explicit CovariateTexts(const py::object& covariates)
  {
    // A mapping of columns, or what has columns like a pandas.DataFrame.
    for (const py::handle name : covariates.attr("keys")())
    {
      const py::object column = covariates.attr("__getitem__")(name);
      const std::size_t before = this->Values.size();
      // As Python's own values: texts of NumPy's would name their types.
      const py::object values = py::hasattr(column, "tolist") ? column.attr("tolist")() : column;
      for (const py::handle value : values)
      {
        this->Values.push_back(TextOfValue(value));
      }
      const std::size_t count = this->Values.size() - before;
      if (!this->Names.empty() && count != this->Cases)
      {
        throw py::value_error("covariates: columns differ in length");
      }
      this->Cases = count;
      this->Names.push_back(py::str(name).cast<std::string>());
    }
  }
};

/// A palpate_design and the number of cases that it was made for.
class BoundLinearModel
{
public:
  BoundLinearModel(const std::string& formula, const py::object& covariates,
                   const py::object& references)
  {
    const CovariateTexts texts(covariates);
    std::vector<std::string> levels;
    if (!references.is_none())
    {
      for (const auto& [column, level] :
           references.cast<std::vector<std::pair<std::string, std::string>>>())
      {
        levels.push_back(column + "=" + level);
      }
    }
    const std::vector<const char*> names = PointersOf(texts.Names);
    const std::vector<const char*> values = PointersOf(texts.Values);
    const std::vector<const char*> reference = PointersOf(levels);
    this->Design.reset(Call(palpate_design_create, formula.c_str(), texts.Cases, names.size(),
                            names.data(), values.data(), reference.size(), reference.data()));
    this->Cases = static_cast<py::ssize_t>(texts.Cases);
  }

  const palpate_design* Get() const { return this->Design.get(); }
  py::ssize_t Columns() const
  {
    return static_cast<py::ssize_t>(palpate_design_column_count(this->Get()));
  }

  std::vector<std::string> ColumnNames() const
  {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < palpate_design_column_count(this->Get()); ++k)
    {
      names.emplace_back(palpate_design_column_name(this->Get(), k));
    }
    return names;
  }
  /// Those that can be tested.
  std::vector<std::string> TermNames() const
  {
    std::vector<std::string> names;
    palpate_term term{};
    for (std::size_t k = 0; palpate_design_term(this->Get(), k, &term) != 0; ++k)
    {
      if (term.is_tested != 0)
      {
        names.emplace_back(term.name);
      }
    }
    return names;
  }
  std::size_t TermCount() const { return palpate_design_term_count(this->Get()); }
  /// Their places among all terms.
  std::vector<std::size_t> TestedTerms() const
  {
    std::vector<std::size_t> places;
    for (const std::string& name : this->TermNames())
    {
      places.push_back(this->TermIndex(name));
    }
    return places;
  }
  std::size_t TermIndex(const std::string& name) const
  {
    palpate_term term{};
    for (std::size_t k = 0; palpate_design_term(this->Get(), k, &term) != 0; ++k)
    {
      if (name == term.name && term.is_tested != 0)
      {
        return k;
      }
    }
    throw py::value_error("the model has no term " + name + " that can be tested");
  }
  std::pair<py::array_t<std::size_t>, Numbers> Matrix() const
  {
    const auto kept = static_cast<py::ssize_t>(palpate_design_case_count(this->Get()));
    py::array_t<std::size_t> cases(kept);
    Numbers matrix({kept, this->Columns()});
    palpate_design_matrix(this->Get(), cases.mutable_data(), matrix.mutable_data());
    return {cases, matrix};
  }
  /// (n, m), or (n,) for one outcome.
  Numbers Outcomes(const py::object& given) const
  {
    Numbers outcomes(RealArray(given, "outcomes"));
    if (outcomes.ndim() < 1 || outcomes.ndim() > 2 || outcomes.shape(0) != this->Cases)
    {
      throw py::value_error("outcomes: the shape is not (" + std::to_string(this->Cases) +
                            ", m): one row per case of the covariates");
    }
    return outcomes.ndim() == 2 ? outcomes
                                : Numbers(outcomes.reshape({this->Cases, py::ssize_t{1}}));
  }

private:
  Owned<palpate_design> Design;
  py::ssize_t Cases = 0;
};

py::object Fit(const BoundLinearModel& model, const py::object& given, double confidence)
{
  const Numbers outcomes = model.Outcomes(given);
  const py::ssize_t count = outcomes.shape(1);
  Numbers coefficients({model.Columns(), count});
  Numbers errors({model.Columns(), count});
  Numbers widths({model.Columns(), count});
  Call(palpate_design_fit, model.Get(), outcomes.data(), static_cast<std::size_t>(count),
       confidence, coefficients.mutable_data(), errors.mutable_data(), widths.mutable_data());
  return Result("Coefficients", coefficients, errors, widths);
}

py::object Test(const BoundLinearModel& model, const std::string& term, const py::object& given)
{
  const Numbers outcomes = model.Outcomes(given);
  const py::ssize_t count = outcomes.shape(1);
  Numbers f(count);
  Numbers p(count);
  Numbers share(count);
  Call(palpate_design_test, model.Get(), model.TermIndex(term), outcomes.data(),
       static_cast<std::size_t>(count), f.mutable_data(), p.mutable_data(), share.mutable_data());
  return Result("TermTest", f, p, share);
}

py::object StatisticFrom(const palpate_statistic& one)
{
  return Result("Statistic", one.value, one.f, one.numerator_degrees, one.denominator_degrees,
                one.p);
}

py::object TestAll(const BoundLinearModel& model, const std::string& term, const py::object& given)
{
  const Numbers outcomes = model.Outcomes(given);
  palpate_multivariate found{};
  Call(palpate_design_test_together, model.Get(), model.TermIndex(term), outcomes.data(),
       static_cast<std::size_t>(outcomes.shape(1)), &found);
  return Result("MultivariateTest", StatisticFrom(found.pillai), StatisticFrom(found.wilks),
                StatisticFrom(found.hotelling_lawley), StatisticFrom(found.roy));
}

py::object Permute(const BoundLinearModel& model, const std::string& term, const py::object& given,
                   const py::object& givenAreas, const py::object& givenTriangles, int permutations,
                   std::uint64_t seed)
{
  const Numbers outcomes = model.Outcomes(given);
  const py::ssize_t count = outcomes.shape(1);
  const Numbers areas(RealArray(givenAreas, "areas"));
  if (areas.ndim() != 1 || areas.shape(0) != count)
  {
    throw py::value_error("areas: the shape is not (" + std::to_string(count) +
                          ",): one per outcome");
  }
  const std::vector<std::int32_t> triangles =
      TrianglesOf(givenTriangles, static_cast<std::size_t>(count));
  Numbers statistic(count);
  Numbers p(count);
  Numbers family(count);
  Numbers enhanced(count);
  double wholeF = 0.0;
  double wholeP = 1.0;
  const std::size_t index = model.TermIndex(term);
  const double* const values = outcomes.data();
  const double* const weights = areas.data();
  double* const results[4] = {statistic.mutable_data(), p.mutable_data(), family.mutable_data(),
                              enhanced.mutable_data()};
  {
    const py::gil_scoped_release others;
    Call(palpate_design_permute, model.Get(), index, values, static_cast<std::size_t>(count),
         weights, triangles.data(), triangles.size() / 3, permutations, seed, results[0],
         results[1], results[2], results[3], &wholeF, &wholeP);
  }
  return Result("PermutationTest", statistic, p, family, enhanced, wholeF, wholeP);
}

/// Subjects of any kind as numbers, one per case.
py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>
NumbersOfSubjects(const py::object& subjects, py::ssize_t cases)
{
  const py::module_ numpy = py::module_::import("numpy");
  const py::object array = numpy.attr("asarray")(subjects);
  const py::tuple shape = array.attr("shape");
  if (shape.size() != 1 || shape[0].cast<py::ssize_t>() != cases)
  {
    throw py::value_error("subjects: the shape is not (" + std::to_string(cases) +
                          ",): one per case of the covariates");
  }
  const py::tuple found = numpy.attr("unique")(array, py::arg("return_inverse") = true);
  return py::object(found[1]);
}

py::object FitMixed(const BoundLinearModel& model, const py::object& given,
                    const py::object& givenSubjects, const py::object& givenTimes,
                    double confidence)
{
  const Numbers outcomes = model.Outcomes(given);
  const py::ssize_t count = outcomes.shape(1);
  const auto subjects = NumbersOfSubjects(givenSubjects, outcomes.shape(0));
  const Numbers times = givenTimes.is_none() ? Numbers(0) : Numbers(RealArray(givenTimes, "times"));
  if (!givenTimes.is_none() && (times.ndim() != 1 || times.shape(0) != outcomes.shape(0)))
  {
    throw py::value_error("times: the shape is not (" + std::to_string(outcomes.shape(0)) +
                          ",): one per case of the covariates");
  }
  const std::vector<std::size_t> terms = model.TestedTerms();
  const auto rows = [count](std::size_t k) {
    return Numbers({static_cast<py::ssize_t>(k), count});
  };
  const std::size_t columns = model.ColumnNames().size();
  Numbers values[3] = {rows(columns), rows(columns), rows(columns)};
  Numbers tests[4] = {rows(model.TermCount()), rows(model.TermCount()), rows(model.TermCount()),
                      rows(model.TermCount())};
  Numbers scalars[2] = {Numbers(count), Numbers(count)};
  Numbers covariance = rows(3);
  Numbers singular(count);
  const palpate_mixed results{
      values[0].mutable_data(),  values[1].mutable_data(),  values[2].mutable_data(),
      tests[0].mutable_data(),   tests[1].mutable_data(),   tests[2].mutable_data(),
      tests[3].mutable_data(),   scalars[0].mutable_data(), scalars[1].mutable_data(),
      covariance.mutable_data(), singular.mutable_data()};
  const double* const time = givenTimes.is_none() ? nullptr : times.data();
  const double* const outcome = outcomes.data();
  const std::int32_t* const subject = subjects.data();
  {
    const py::gil_scoped_release others;
    Call(palpate_design_fit_mixed, model.Get(), subject, time, outcome,
         static_cast<std::size_t>(count), confidence, &results);
  }
  const auto tested = [&](const Numbers& all) { return all.attr("take")(terms, 0); };
  return Result("MixedFit", values[0], values[1], values[2], tested(tests[0]), tested(tests[1]),
                tested(tests[2]), tested(tests[3]), scalars[0], scalars[1], covariance,
                singular.attr("astype")("bool"));
}

using Models = std::vector<const BoundModel*>;

std::vector<const palpate_model*> HandlesOf(const Models& models)
{
  std::vector<const palpate_model*> handles;
  for (const BoundModel* const model : models)
  {
    handles.push_back(model != nullptr ? model->Handle.get() : nullptr);
  }
  return handles;
}

py::object Asymmetry(const Models& left, const std::optional<Models>& right,
                     const std::string& align, int frequency, int flips, std::uint64_t seed)
{
  if (align != "patient" && align != "procrustes")
  {
    throw py::value_error("align is \"patient\" or \"procrustes\"");
  }
  if (right && right->size() != left.size())
  {
    throw py::value_error("right: there are " + std::to_string(right->size()) + " models for " +
                          std::to_string(left.size()) + " left ones");
  }
  const std::vector<const palpate_model*> lefts = HandlesOf(left);
  const std::vector<const palpate_model*> rights = HandlesOf(right.value_or(Models()));
  const py::ssize_t parts = std::max(std::min(frequency, 100), 1);
  const py::ssize_t points = 10 * parts * parts + 2;
  Numbers individuals(static_cast<py::ssize_t>(left.size()));
  Numbers maps[5] = {Numbers(points), Numbers(points), Numbers(points), Numbers(points),
                     Numbers(points)};
  Numbers places({points, py::ssize_t{3}});
  palpate_asymmetry found{};
  found.individuals = individuals.mutable_data();
  found.mean = maps[0].mutable_data();
  found.deviations = maps[1].mutable_data();
  found.statistic = maps[2].mutable_data();
  found.point_p = maps[3].mutable_data();
  found.family_p = maps[4].mutable_data();
  found.points = places.mutable_data();
  {
    const py::gil_scoped_release others;
    Call(palpate_find_asymmetry, lefts.data(), right ? rights.data() : nullptr, lefts.size(),
         align == "procrustes" ? 1 : 0, frequency, flips, seed, &found);
  }
  return Result("Asymmetry", Numbers(3, found.squares), Numbers(3, found.degrees), found.f, found.p,
                individuals, places, maps[0], maps[1], maps[2], maps[3], maps[4]);
}

py::object Displacement(const BoundModel& model, int frequency)
{
  const py::ssize_t parts = std::max(std::min(frequency, 100), 1);
  const py::ssize_t points = 10 * parts * parts + 2;
  Numbers places({points, py::ssize_t{3}});
  Numbers normals({points, py::ssize_t{3}});
  Numbers areas(points);
  py::array_t<std::int32_t> triangles({20 * parts * parts, py::ssize_t{3}});
  const bool isSurface = palpate_model_is_radial(model.Handle.get()) == 0;
  const py::ssize_t degree = palpate_model_degree(model.Handle.get());
  Numbers map({points, (isSurface ? 3 : 1) * (degree + 1) * (degree + 1)});
  Call(palpate_model_displacement, model.Handle.get(), frequency, places.mutable_data(),
       normals.mutable_data(), areas.mutable_data(), triangles.mutable_data(), map.mutable_data());
  return Result("Displacement", places, normals, areas, triangles, map);
}
} // namespace

void BindStatistics(py::module_& module)
{
  py::class_<BoundLinearModel>(
      module, "LinearModel",
      "A linear model of many outcomes on covariates, in R's notation.\n\n"
      "covariates: a mapping of columns, such as a dict or a pandas.DataFrame, with one value "
      "per case; None and NaN are missing, and cases without a value of a used column are left "
      "out; a column with a word is a factor.")
      .def(py::init<const std::string&, const py::object&, const py::object&>(), py::arg("formula"),
           py::arg("covariates"), py::kw_only(), py::arg("references") = py::none(),
           "references: pairs of a factor and its reference level; the first level in order unless "
           "given.")
      .def_property_readonly("columns", &BoundLinearModel::ColumnNames,
                             "Names of the coefficients, as R's.")
      .def_property_readonly("terms", &BoundLinearModel::TermNames,
                             "Names of the terms that can be tested.")
      .def_property_readonly(
          "cases", [](const BoundLinearModel& model) { return model.Matrix().first; },
          "(n,): indices of the cases that are not left out.")
      .def_property_readonly(
          "matrix", [](const BoundLinearModel& model) { return model.Matrix().second; },
          "(n, k): the design, one row for each of these.")
      .def("fit", &Fit, py::arg("outcomes"), py::kw_only(), py::arg("confidence") = 0.95,
           "Least squares. outcomes: (cases, m), rows of all cases that were given. Coefficients "
           "are (k, m).")
      .def("test", &Test, py::arg("term"), py::arg("outcomes"),
           "F-tests of a term given all others, one for each outcome.")
      .def("test_together", &TestAll, py::arg("term"), py::arg("outcomes"),
           "Multivariate analysis of variance of all outcomes together.")
      .def("fit_mixed", &FitMixed, py::arg("outcomes"), py::arg("subjects"), py::kw_only(),
           py::arg("times") = py::none(), py::arg("confidence") = 0.95,
           "A linear mixed model by restricted maximum likelihood, with Kenward and Roger's tests: "
           "a random intercept of each subject and, with times, a slope.\n\n"
           "subjects: who each case is of, in any words or numbers.\n"
           "times: a number for each case.")
      .def("permute", &Permute, py::arg("term"), py::arg("outcomes"), py::arg("areas"),
           py::arg("triangles"), py::kw_only(), py::arg("permutations") = 10000,
           py::arg("seed") = 1,
           "Permutation tests (Freedman and Lane) at the points of a surface. areas: (m,), mm^2; "
           "triangles: (t, 3).");
  module.def(
      "asymmetry", &Asymmetry, py::arg("left"), py::arg("right") = py::none(), py::kw_only(),
      py::arg("align") = "patient", py::arg("frequency") = 16, py::arg("flips") = 10000,
      py::arg("seed") = 1,
      "Procrustes analysis of variance of left against right.\n\n"
      "left: models. right: those of the other side, in the same order, which are mirrored; "
      "without "
      "them each model is compared with its own mirror image.\n"
      "align: \"patient\", the axes as they are, or \"procrustes\", turned to the common mean. "
      "All are moved to the origin.\n"
      "frequency: of the points, whose triangles are those of displacement.\n"
      "flips: random exchanges of sides, for p.");
  module.def(
      "displacement", &Displacement, py::arg("model"), py::kw_only(), py::arg("frequency") = 16,
      "A model's 10 frequency^2 + 2 points, and how far each moves along its normal per mm of each "
      "coefficient: map @ (coefficients of a case - those of the model) is the case's "
      "displacement.");
}
} // namespace palpate
