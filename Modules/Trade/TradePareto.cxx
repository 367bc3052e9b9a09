#include "TradePareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
std::vector<std::size_t> ParetoFront(const std::vector<std::pair<double, double>>& points)
{
  std::vector<std::size_t> order;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    if (std::isfinite(points[p].first) && std::isfinite(points[p].second))
    {
      order.push_back(p);
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [&points](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t p : order)
  {
    // Equal points do not dominate each other.
    if (points[p].second < least || (!front.empty() && points[p] == points[front.back()]))
    {
      front.push_back(p);
      least = points[p].second;
    }
  }
  return front;
}
} // namespace palpate
