#include "LinearDesign.h"

#include "DecimalText.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

namespace palpate
{
namespace
{
using Transform = FormulaVariable::Transform;

// What R takes for a dependent column, relative to its length.
constexpr double SmallestIndependence = 1e-7;
constexpr std::size_t MostLevels = 100;
constexpr std::size_t MostNamed = 5;
constexpr std::size_t FewestCases = 3;

/// Columns of one variable, with the texts that follow its name: none for numbers, levels of a
/// factor.
struct CodedVariable
{
  Eigen::MatrixXd Columns;
  std::vector<std::string> Suffixes;
  bool IsNumeric = true;
};

std::string Listed(const std::vector<std::string>& names)
{
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < MostNamed; ++i)
  {
    text += (i == 0 ? "" : ", ") + names[i];
  }
  return names.size() > MostNamed
             ? text + " and " + std::to_string(names.size() - MostNamed) + " more"
             : text;
}

Status CheckColumns(const CovariateTable& table, const ModelFormula& formula)
{
  for (const std::string& name : formula.Columns())
  {
    if (table.Find(name) == nullptr)
    {
      std::vector<std::string> known;
      for (const Covariate& column : table.Columns())
      {
        known.push_back(column.Name());
      }
      return Status::Failure("the covariates have no column " + name + "; they have " +
                             (known.empty() ? "none" : Listed(known)));
    }
  }
  return Status::Success();
}

void KeepCompleteCases(const CovariateTable& table, const std::vector<std::string>& columns,
                       LinearDesign& design)
{
  std::set<std::string> lacking;
  for (std::size_t row = 0; row < table.Cases().size(); ++row)
  {
    bool isComplete = true;
    for (const std::string& name : columns)
    {
      if (table.Find(name)->IsMissing(row))
      {
        isComplete = false;
        lacking.insert(name);
      }
    }
    (isComplete ? design.Cases : design.Omitted).push_back(row);
  }
  design.Lacking.assign(lacking.begin(), lacking.end());
}

double Transformed(const FormulaVariable& variable, double value)
{
  switch (variable.Function)
  {
  case Transform::Log:
    return std::log(value);
  case Transform::Log2:
    return std::log2(value);
  case Transform::Log10:
    return std::log10(value);
  case Transform::Sqrt:
    return std::sqrt(value);
  case Transform::Exp:
    return std::exp(value);
  case Transform::Power:
    return std::pow(value, variable.Exponent);
  default:
    return value;
  }
}

Status CodeNumbers(const CovariateTable& table, const FormulaVariable& variable,
                   const std::vector<std::size_t>& cases, CodedVariable& coded)
{
  const Covariate& column = *table.Find(variable.Column);
  coded.Columns.resize(static_cast<Eigen::Index>(cases.size()), 1);
  coded.Suffixes = {""};
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    const double value = Transformed(variable, column.Number(cases[i]));
    if (!std::isfinite(value))
    {
      return Status::Failure(variable.Text() + " is not finite for case " +
                             table.Cases()[cases[i]] + ", whose " + variable.Column + " is " +
                             column.Texts()[cases[i]]);
    }
    coded.Columns(static_cast<Eigen::Index>(i), 0) = value;
  }
  return Status::Success();
}

Status CheckLevels(const CovariateTable& table, const Covariate& column,
                   const std::vector<std::size_t>& cases, const std::set<std::string>& levels)
{
  if (levels.size() < 2)
  {
    return Status::Failure(column.Name() + " has one value only, " +
                           (levels.empty() ? "" : *levels.begin()) + ", in the " +
                           std::to_string(cases.size()) +
                           " complete cases; leave it out or add cases of another group");
  }
  if (levels.size() > MostLevels || levels.size() == cases.size())
  {
    const std::size_t word = column.FirstTextRow();
    return Status::Failure(column.Name() + " has " + std::to_string(levels.size()) +
                           " categories in " + std::to_string(cases.size()) + " cases" +
                           (word < column.Texts().size()
                                ? "; it is no column of numbers since case " + table.Cases()[word] +
                                      " has " + column.Texts()[word]
                                : ""));
  }
  return Status::Success();
}

Status CodeFactor(const CovariateTable& table, const FormulaVariable& variable,
                  const std::map<std::string, std::string>& references, LinearDesign& design,
                  CodedVariable& coded)
{
  const Covariate& column = *table.Find(variable.Column);
  std::set<std::string> levels;
  for (const std::size_t row : design.Cases)
  {
    levels.insert(column.Texts()[row]);
  }
  if (Status status = CheckLevels(table, column, design.Cases, levels); !status.IsOk())
  {
    return status;
  }
  const auto wanted = references.find(variable.Column);
  const std::string reference = wanted == references.end() ? *levels.begin() : wanted->second;
  if (levels.erase(reference) == 0)
  {
    return Status::Failure("no case has the reference " + reference + " of " + variable.Column +
                           "; it has " + Listed({levels.begin(), levels.end()}));
  }
  design.References[variable.Column] = reference;
  coded.IsNumeric = false;
  coded.Suffixes.assign(levels.begin(), levels.end());
  coded.Columns.resize(static_cast<Eigen::Index>(design.Cases.size()),
                       static_cast<Eigen::Index>(levels.size()));
  for (std::size_t i = 0; i < design.Cases.size(); ++i)
  {
    for (std::size_t k = 0; k < coded.Suffixes.size(); ++k)
    {
      coded.Columns(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          column.Texts()[design.Cases[i]] == coded.Suffixes[k] ? 1.0 : 0.0;
    }
  }
  return Status::Success();
}

Status CodeVariable(const CovariateTable& table, const FormulaVariable& variable,
                    const std::map<std::string, std::string>& references, LinearDesign& design,
                    CodedVariable& coded)
{
  const Covariate& column = *table.Find(variable.Column);
  if (variable.Function == Transform::Factor ||
      (variable.Function == Transform::None && !column.IsNumeric()))
  {
    return CodeFactor(table, variable, references, design, coded);
  }
  if (!column.IsNumeric())
  {
    const std::size_t row = column.FirstTextRow();
    return Status::Failure(variable.Text() + " needs numbers, but case " + table.Cases()[row] +
                           " has " + column.Texts()[row]);
  }
  return CodeNumbers(table, variable, design.Cases, coded);
}

// Levels of the first variable change fastest, as in R.
CodedVariable Product(const CodedVariable& one, const std::string& name, const CodedVariable& next,
                      const std::string& nextName)
{
  CodedVariable product;
  product.IsNumeric = one.IsNumeric && next.IsNumeric;
  product.Columns.resize(one.Columns.rows(), one.Columns.cols() * next.Columns.cols());
  Eigen::Index column = 0;
  for (Eigen::Index j = 0; j < next.Columns.cols(); ++j)
  {
    for (Eigen::Index i = 0; i < one.Columns.cols(); ++i)
    {
      product.Columns.col(column++) = one.Columns.col(i).cwiseProduct(next.Columns.col(j));
      std::string& suffix = product.Suffixes.emplace_back(name);
      suffix.append(one.Suffixes[static_cast<std::size_t>(i)]).append(":").append(nextName);
      suffix.append(next.Suffixes[static_cast<std::size_t>(j)]);
    }
  }
  return product;
}

double DeviationOf(const Eigen::VectorXd& values)
{
  return values.size() < 2 ? 0.0
                           : std::sqrt((values.array() - values.mean()).square().sum() /
                                       static_cast<double>(values.size() - 1));
}

void AppendTerm(const ModelFormula::Term& term, const CodedVariable& coded, LinearDesign& design)
{
  DesignTerm added;
  added.Name = TextOf(term);
  added.First = design.Matrix.cols();
  added.Count = coded.Columns.cols();
  added.IsInteraction = term.size() > 1;
  added.IsNumeric = coded.IsNumeric && term.size() == 1;
  added.Deviation = added.IsNumeric ? DeviationOf(coded.Columns.col(0)) : 0.0;
  design.Matrix.conservativeResize(Eigen::NoChange, added.First + added.Count);
  design.Matrix.rightCols(added.Count) = coded.Columns;
  for (const std::string& suffix : coded.Suffixes)
  {
    design.Columns.push_back(term.size() == 1 ? added.Name + suffix : suffix);
  }
  design.Terms.push_back(added);
}

bool Holds(const ModelFormula::Term& whole, const ModelFormula::Term& part)
{
  return std::all_of(part.begin(), part.end(),
                     [&](const FormulaVariable& variable)
                     {
                       return std::any_of(whole.begin(), whole.end(),
                                          [&](const FormulaVariable& one)
                                          { return one.Text() == variable.Text(); });
                     });
}

// Every part of an interaction has to be a term of its own; such parts are not tested.
Status MarkParts(const ModelFormula& formula, LinearDesign& design)
{
  const std::vector<ModelFormula::Term>& terms = formula.Terms();
  for (const ModelFormula::Term& whole : terms)
  {
    std::size_t parts = 0;
    for (std::size_t i = 0; i < terms.size(); ++i)
    {
      if (terms[i].size() < whole.size() && Holds(whole, terms[i]))
      {
        design.Terms[i].IsTested = false;
        parts += terms[i].size() + 1 == whole.size() ? 1 : 0;
      }
    }
    if (whole.size() > 1 && parts != whole.size())
    {
      std::string product = TextOf(whole);
      std::replace(product.begin(), product.end(), ':', '*');
      return Status::Failure(TextOf(whole) + " needs its parts as terms of their own; write " +
                             product);
    }
  }
  return Status::Success();
}

Status CheckRank(const LinearDesign& design)
{
  const Eigen::MatrixXd& matrix = design.Matrix;
  Eigen::MatrixXd basis(matrix.rows(), 0);
  for (Eigen::Index column = 0; column < matrix.cols(); ++column)
  {
    Eigen::VectorXd rest = matrix.col(column);
    const double length = rest.norm();
    for (int pass = 0; pass < 2; ++pass) // the second removes what rounding left
    {
      rest -= basis * (basis.transpose() * rest);
    }
    if (!(rest.norm() > SmallestIndependence * length))
    {
      const std::string& name = design.Columns[static_cast<std::size_t>(column)];
      return Status::Failure(
          basis.cols() == 1
              ? name + " has the same value in all " + std::to_string(matrix.rows()) +
                    " complete cases"
              : name + " is a combination of columns before it (" +
                    Listed({design.Columns.begin() + 1, design.Columns.begin() + column}) +
                    ") in the complete cases; leave one of them out");
    }
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols(1) = rest.normalized();
  }
  return Status::Success();
}
} // namespace

std::string LinearDesign::OmissionText() const
{
  return this->Omitted.empty()
             ? std::string()
             : std::to_string(this->Omitted.size()) + " of " +
                   std::to_string(this->Omitted.size() + this->Cases.size()) +
                   " cases lack a value of " + Listed(this->Lacking) + " and are omitted";
}

Status ParseReferences(const std::vector<std::string>& texts,
                       std::map<std::string, std::string>& references)
{
  for (const std::string& text : texts)
  {
    const std::size_t split = text.find('=');
    if (split == std::string::npos)
    {
      return Status::Failure("the reference " + text + " is not COLUMN=LEVEL");
    }
    references[text.substr(0, split)] = text.substr(split + 1);
  }
  return Status::Success();
}

Status MakeLinearDesign(const CovariateTable& table, const ModelFormula& formula,
                        const std::map<std::string, std::string>& references, LinearDesign& design,
                        const std::vector<std::string>& needed)
{
  design = LinearDesign();
  if (Status status = CheckColumns(table, formula); !status.IsOk())
  {
    return status;
  }
  std::vector<std::string> columns = formula.Columns();
  columns.insert(columns.end(), needed.begin(), needed.end());
  KeepCompleteCases(table, columns, design);
  if (design.Cases.size() < FewestCases)
  {
    return Status::Failure("only " + std::to_string(design.Cases.size()) +
                           " cases have a value of each of " + Listed(columns) +
                           "; a linear model needs at least 3");
  }
  design.Matrix = Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(design.Cases.size()), 1);
  design.Columns = {"(Intercept)"};
  for (const ModelFormula::Term& term : formula.Terms())
  {
    CodedVariable coded;
    for (std::size_t i = 0; i < term.size(); ++i)
    {
      CodedVariable next;
      if (Status status = CodeVariable(table, term[i], references, design, next); !status.IsOk())
      {
        return status;
      }
      coded = i == 0 ? next : Product(coded, i == 1 ? term[0].Text() : "", next, term[i].Text());
    }
    AppendTerm(term, coded, design);
    if (design.Matrix.cols() >= design.Matrix.rows())
    {
      return Status::Failure("the " + std::to_string(design.Matrix.rows()) +
                             " complete cases are too few for the " +
                             std::to_string(design.Matrix.cols()) + " columns up to " +
                             design.Terms.back().Name + "; use fewer covariates or more cases");
    }
  }
  if (Status status = MarkParts(formula, design); !status.IsOk())
  {
    return status;
  }
  return CheckRank(design);
}

LinearDesign WithColumns(LinearDesign design, const Eigen::MatrixXd& values,
                         const std::vector<std::string>& names)
{
  design.Matrix.conservativeResize(Eigen::NoChange, design.Matrix.cols() + values.cols());
  design.Matrix.rightCols(values.cols()) = values;
  design.Columns.insert(design.Columns.end(), names.begin(), names.end());
  return design;
}
} // namespace palpate
