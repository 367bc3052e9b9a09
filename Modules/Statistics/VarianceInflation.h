#pragma once

#include "LinearDesign.h"

#include <string>
#include <vector>

namespace palpate
{
/// By what factor the other terms of a design inflate the variance of a term's coefficients: 1 if
/// they are uncorrelated with it. Of a factor with several columns the generalised inflation per
/// column (Fox and Monette, J. Am. Stat. Assoc. 87, 1992: GVIF^(1/columns)). An interaction has 1:
/// it is correlated with its parts by construction. Columns that belong to no term do not count.
double VarianceInflation(const LinearDesign& design, const DesignTerm& term);

/// A note for each tested term with an inflation above 5, with the term that it is most correlated
/// with: such effects cannot be told apart, whatever the table shows.
std::vector<std::string> InflationNotes(const LinearDesign& design);
} // namespace palpate
