#pragma once

#include "CohortGroup.h"
#include "Covariates.h"

#include <QString>

#include <vector>

namespace palpate
{
/// A column of numbers, one per case of a group; NaN where unknown.
struct CohortColumn
{
  QString Name;
  std::vector<double> Values;
};

/// Volume, Dice and scores of the first modes (in standard deviations), then the covariates;
/// categories become the number of their level, in order.
std::vector<CohortColumn> ColumnsOf(const CohortGroup& group, const CovariateTable* covariates);
} // namespace palpate
