#include "FalseDiscovery.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace palpate
{
Eigen::VectorXd FalseDiscoveryRates(const Eigen::VectorXd& p)
{
  std::vector<Eigen::Index> order(static_cast<std::size_t>(p.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(),
            [&](Eigen::Index a, Eigen::Index b) { return p[a] > p[b]; });
  Eigen::VectorXd rates(p.size());
  double least = 1.0;
  auto rank = static_cast<double>(p.size());
  for (const Eigen::Index i : order)
  {
    least = std::min(least, p[i] * static_cast<double>(p.size()) / rank);
    rates[i] = least;
    rank -= 1.0;
  }
  return rates;
}
} // namespace palpate
