#include "CohortColumns.h"

#include "CohortPage.h"
#include "ScreenString.h"

#include <iterator>
#include <limits>
#include <set>
#include <string>

namespace palpate
{
namespace
{
constexpr double NotKnown = std::numeric_limits<double>::quiet_NaN();

CohortColumn ColumnOf(const Covariate& covariate)
{
  CohortColumn column{ScreenString(covariate.Name()), {}};
  std::set<std::string> levels;
  for (std::size_t row = 0; row < covariate.Texts().size(); ++row)
  {
    if (!covariate.IsMissing(row))
    {
      levels.insert(covariate.Texts()[row]);
    }
  }
  for (std::size_t row = 0; row < covariate.Texts().size(); ++row)
  {
    const auto level = levels.find(covariate.Texts()[row]);
    column.Values.push_back(covariate.IsNumeric() ? covariate.Number(row)
                            : level == levels.end()
                                ? NotKnown
                                : 1.0 + static_cast<double>(std::distance(levels.begin(), level)));
  }
  return column;
}
} // namespace

std::vector<CohortColumn> ColumnsOf(const CohortGroup& group, const CovariateTable* covariates)
{
  std::vector<CohortColumn> columns{{"Volume, ml", {}}, {"Dice", {}}};
  for (std::size_t row = 0; row < group.Rows.size(); ++row)
  {
    columns[0].Values.push_back(group.Bodies[row].Volume / 1000.0);
    columns[1].Values.push_back(group.Rows[row].Result.Dice);
  }
  for (int mode = 0; mode < ShownModes(group); ++mode)
  {
    CohortColumn column{QString("Mode %1, sd").arg(mode + 1), {}};
    for (Eigen::Index row = 0; row < group.Modes.Scores.rows(); ++row)
    {
      column.Values.push_back(group.Modes.Scores(row, mode) / group.Modes.Deviations[mode]);
    }
    columns.push_back(std::move(column));
  }
  if (covariates != nullptr)
  {
    for (const Covariate& covariate : covariates->Columns())
    {
      columns.push_back(ColumnOf(covariate));
    }
  }
  return columns;
}
} // namespace palpate
