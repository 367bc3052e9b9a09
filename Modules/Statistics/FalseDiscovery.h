#pragma once

#include <Eigen/Core>

namespace palpate
{
/// The smallest false-discovery rate at which each hypothesis is rejected, from their p-values:
/// Benjamini and Hochberg, J. R. Stat. Soc. B 57 (1995) 289 (R's p.adjust "BH").
Eigen::VectorXd FalseDiscoveryRates(const Eigen::VectorXd& p);
} // namespace palpate
