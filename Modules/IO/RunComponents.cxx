#include "RunComponents.h"

#include <numeric>

namespace palpate
{
namespace
{
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count) : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), std::size_t{0});
  }

  std::size_t Root(std::size_t i)
  {
    while (this->Parents[i] != i)
    {
      this->Parents[i] = this->Parents[this->Parents[i]];
      i = this->Parents[i];
    }
    return i;
  }

  // The smaller root stays, so that a component's root is its first run.
  void Join(std::size_t a, std::size_t b)
  {
    a = this->Root(a);
    b = this->Root(b);
    this->Parents[a < b ? b : a] = a < b ? a : b;
  }

private:
  std::vector<std::size_t> Parents;
};

// Joins the runs of two rows that overlap when each is widened by `reach` in all.
void JoinRows(const RunSet& set, std::size_t rowA, std::size_t rowB, int reach, DisjointSets& sets)
{
  std::size_t a = set.RowStarts[rowA];
  std::size_t b = set.RowStarts[rowB];
  while (a < set.RowStarts[rowA + 1] && b < set.RowStarts[rowB + 1])
  {
    const RowRun& runA = set.Runs[a];
    const RowRun& runB = set.Runs[b];
    if (runA.First < runB.End + reach && runB.First < runA.End + reach)
    {
      sets.Join(a, b);
    }
    (runA.End < runB.End ? a : b) += 1;
  }
}
} // namespace

std::vector<int> LabelRunComponents(const RunSet& set, Neighborhood neighborhood)
{
  DisjointSets sets(set.Runs.size());
  const bool all = neighborhood == Neighborhood::FacesEdgesCorners;
  const int reach = all ? 1 : 0;
  for (int z = 0; z < set.Slices; ++z)
  {
    for (int y = 0; y < set.RowsPerSlice; ++y)
    {
      const auto row = static_cast<std::size_t>(z) * static_cast<std::size_t>(set.RowsPerSlice) +
                       static_cast<std::size_t>(y);
      if (y > 0)
      {
        JoinRows(set, row, row - 1, reach, sets);
      }
      for (int dy = all ? -1 : 0; z > 0 && dy <= (all ? 1 : 0); ++dy)
      {
        if (y + dy >= 0 && y + dy < set.RowsPerSlice)
        {
          const auto below = static_cast<std::ptrdiff_t>(row) - set.RowsPerSlice + dy;
          JoinRows(set, row, static_cast<std::size_t>(below), reach, sets);
        }
      }
    }
  }
  std::vector<int> components(set.Runs.size());
  int next = 0;
  for (std::size_t run = 0; run < components.size(); ++run)
  {
    const std::size_t root = sets.Root(run);
    components[run] = root == run ? next++ : components[root];
  }
  return components;
}
} // namespace palpate
