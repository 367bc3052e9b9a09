#pragma once

#include "LinearModel.h"
#include "Status.h"

namespace palpate
{
/// A statistic of a multivariate analysis of variance with its approximation by Fisher's
/// distribution.
struct MultivariateStatistic
{
  double Value = 0.0;
  double F = 0.0;
  double NumeratorDegrees = 0.0;
  double DenominatorDegrees = 0.0;
  double P = 1.0;
};

/// All four agree, and are Hotelling's test, for a term of one column.
struct MultivariateTest
{
  MultivariateStatistic Pillai;
  MultivariateStatistic Wilks;
  MultivariateStatistic HotellingLawley;
  MultivariateStatistic Roy; ///< its P is a lower bound
};

/// Tests one term given all others on all outcomes together; F by the usual approximations (Pillai
/// and Hotelling-Lawley: Muller and others; Wilks: Rao 1951), as in R's summary.manova. Fails if
/// the outcomes are more than the free degrees of the residuals or dependent on each other.
Status TestTogether(const LinearDesign& design, const DesignTerm& term,
                    const Eigen::MatrixXd& outcomes, MultivariateTest& test);
} // namespace palpate
