#include "RunComponents.h"

#include "DisjointSets.h"

#include <algorithm>
#include <tuple>

namespace palpate
{
namespace
{
// Joins the runs of two rows that overlap when each is widened by `reach` in total.
void JoinRows(const RunSet& set, std::size_t rowA, std::size_t rowB, int reach, DisjointSets& sets)
{
  std::size_t a = set.Rows()[rowA].Start;
  std::size_t b = set.Rows()[rowB].Start;
  while (a < set.RowEnd(rowA) && b < set.RowEnd(rowB))
  {
    const RowRun& runA = set.Runs()[a];
    const RowRun& runB = set.Runs()[b];
    if (runA.First < runB.End + reach && runB.First < runA.End + reach)
    {
      sets.Join(a, b);
    }
    (runA.End < runB.End ? a : b) += 1;
  }
}

// Joins each row with the one at this offset before it.
void JoinWithRows(const RunSet& set, int dy, int dz, int reach, DisjointSets& sets)
{
  RowCursor cursor(set);
  for (std::size_t row = 0; row < set.Rows().size(); ++row)
  {
    const std::size_t other = cursor.Find(set.Rows()[row].Y + dy, set.Rows()[row].Z + dz);
    if (other < set.Rows().size())
    {
      JoinRows(set, row, other, reach, sets);
    }
  }
}

// The gaps between the runs of each row. Voxels outside a row's first and last run are connected to
// the image's border.
RunSet GapsOf(const RunSet& set)
{
  RunSet gaps;
  for (std::size_t row = 0; row < set.Rows().size(); ++row)
  {
    for (std::size_t run = set.Rows()[row].Start + 1; run < set.RowEnd(row); ++run)
    {
      gaps.Add({set.Runs()[run - 1].End, set.Runs()[run].First}, set.Rows()[row].Y,
               set.Rows()[row].Z);
    }
  }
  return gaps;
}

// Sets the size of gap components to zero if they touch the outside of the row at this offset.
void RemoveOpen(const RunSet& set, const RunSet& gaps, const std::vector<int>& components, int dy,
                int dz, std::vector<long long>& sizes)
{
  RowCursor cursor(set);
  for (std::size_t row = 0; row < gaps.Rows().size(); ++row)
  {
    const std::size_t other = cursor.Find(gaps.Rows()[row].Y + dy, gaps.Rows()[row].Z + dz);
    const bool isFree = other == set.Rows().size();
    for (std::size_t gap = gaps.Rows()[row].Start; gap < gaps.RowEnd(row); ++gap)
    {
      if (isFree || gaps.Runs()[gap].First <= set.Runs()[set.Rows()[other].Start].First ||
          gaps.Runs()[gap].End >= set.Runs()[set.RowEnd(other) - 1].End)
      {
        sizes[static_cast<std::size_t>(components[gap])] = 0;
      }
    }
  }
}
} // namespace

void RunSet::Add(const RowRun& run, int y, int z)
{
  if (this->AllRows.empty() || this->AllRows.back().Y != y || this->AllRows.back().Z != z)
  {
    this->AllRows.push_back({y, z, this->AllRuns.size()});
  }
  this->AllRuns.push_back(run);
}

std::size_t RowCursor::Find(int y, int z)
{
  const std::vector<RunSet::Row>& rows = this->Set->Rows();
  while (this->Place < rows.size() &&
         std::tie(rows[this->Place].Z, rows[this->Place].Y) < std::tie(z, y))
  {
    ++this->Place;
  }
  const bool isThere =
      this->Place < rows.size() && rows[this->Place].Y == y && rows[this->Place].Z == z;
  return isThere ? this->Place : rows.size();
}

std::vector<int> LabelRunComponents(const RunSet& set, Neighborhood neighborhood)
{
  DisjointSets sets(set.Runs().size()); // a component's root is its first run
  const bool all = neighborhood == Neighborhood::FacesEdgesCorners;
  const int reach = all ? 1 : 0;
  JoinWithRows(set, -1, 0, reach, sets);
  for (int dy = -reach; dy <= reach; ++dy)
  {
    JoinWithRows(set, dy, -1, reach, sets);
  }
  std::vector<int> components(set.Runs().size());
  int next = 0;
  for (std::size_t run = 0; run < components.size(); ++run)
  {
    const std::size_t root = sets.Root(run);
    components[run] = root == run ? next++ : components[root];
  }
  return components;
}

std::vector<long long> ComponentVoxels(const RunSet& set, const std::vector<int>& components)
{
  std::vector<long long> sizes;
  for (std::size_t run = 0; run < components.size(); ++run)
  {
    const auto component = static_cast<std::size_t>(components[run]);
    sizes.resize(std::max(sizes.size(), component + 1), 0);
    sizes[component] += set.Runs()[run].End - set.Runs()[run].First;
  }
  return sizes;
}

RunGaps FindCavities(const RunSet& set)
{
  RunGaps gaps{GapsOf(set), {}, {}};
  gaps.Components = LabelRunComponents(gaps.Set, Neighborhood::FacesEdgesCorners);
  gaps.CavityVoxels = ComponentVoxels(gaps.Set, gaps.Components);
  for (int dz = -1; dz <= 1; ++dz)
  {
    for (int dy = -1; dy <= 1; ++dy)
    {
      if (dy != 0 || dz != 0)
      {
        RemoveOpen(set, gaps.Set, gaps.Components, dy, dz, gaps.CavityVoxels);
      }
    }
  }
  return gaps;
}
} // namespace palpate
