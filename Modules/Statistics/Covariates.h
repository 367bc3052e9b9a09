#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace palpate
{
/// One column of a table of covariates: numbers, or categories if a known value is not a number.
/// Empty, NA, N/A, NaN, null, ? and the errors of spreadsheets, which begin with a hash, count as
/// missing, in any case of letters.
class Covariate
{
public:
  Covariate(std::string name, std::vector<std::string> texts);

  const std::string& Name() const noexcept { return this->Title; }
  const std::vector<std::string>& Texts() const noexcept { return this->Values; }
  bool IsNumeric() const noexcept { return this->FirstWord == this->Values.size(); }
  bool IsMissing(std::size_t row) const noexcept { return this->Missing[row]; }
  /// NaN where missing; of numeric columns.
  double Number(std::size_t row) const { return this->Numbers[row]; }
  /// A number that looks like a code for a missing value: -9, -99, … or 9999, … far from all
  /// others, which are at least 0. NaN if there is none.
  double LikelyMissingCode() const;
  /// The row of the first value that is not a number, which makes the column categorical.
  std::size_t FirstTextRow() const noexcept { return this->FirstWord; }

private:
  std::string Title;
  std::vector<std::string> Values;
  std::vector<double> Numbers;
  std::vector<bool> Missing;
  std::size_t FirstWord;
};

/// Covariates of cases, one value of each per case.
class CovariateTable
{
public:
  explicit CovariateTable(std::vector<std::string> cases) : Names(std::move(cases)) {}

  const std::vector<std::string>& Cases() const noexcept { return this->Names; }
  const std::vector<Covariate>& Columns() const noexcept { return this->Content; }
  /// One text per case. A column that exists remains.
  void Add(const std::string& name, std::vector<std::string> texts);
  const Covariate* Find(const std::string& name) const;

private:
  std::vector<std::string> Names;
  std::vector<Covariate> Content;
};
} // namespace palpate
