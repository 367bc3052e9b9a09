#include "NestedDissection.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>

namespace palpate
{
namespace
{
// Nodes whose coordinate is the value.
struct Cut
{
  std::size_t Coordinate = 0;
  int Value = 0;
  std::int64_t Cost = std::numeric_limits<std::int64_t>::max();
};

// Few nodes in the cut, and halves of similar size.
Cut BestCut(const std::vector<StarMesh::Place>& places, const int* begin, const int* end)
{
  Cut best;
  for (std::size_t c = 0; c < StarMesh::Place().size(); ++c)
  {
    const auto at = [&](int node) { return places[static_cast<std::size_t>(node)][c]; };
    const auto [least, most] =
        std::minmax_element(begin, end, [&](int a, int b) { return at(a) < at(b); });
    const int first = at(*least);
    std::vector<std::int64_t> counts(static_cast<std::size_t>(at(*most) - first) + 1, 0);
    std::for_each(begin, end,
                  [&](int node) { ++counts[static_cast<std::size_t>(at(node) - first)]; });
    std::int64_t before = counts.front();
    for (std::size_t value = 1; value + 1 < counts.size(); ++value)
    {
      const std::int64_t after = (end - begin) - before - counts[value];
      const std::int64_t cost = counts[value] * std::max(before, after);
      if (cost < best.Cost)
      {
        best = {c, first + static_cast<int>(value), cost};
      }
      before += counts[value];
    }
  }
  return best;
}
} // namespace

NestedDissection::NestedDissection(const std::vector<StarMesh::Place>& places)
    : Nodes(places.size())
{
  std::iota(this->Nodes.begin(), this->Nodes.end(), 0);
  if (!places.empty())
  {
    this->Split(places, 0, static_cast<int>(places.size()));
  }
}

// Returns the index of the last part.
int NestedDissection::Split(const std::vector<StarMesh::Place>& places, int first, int end)
{
  constexpr int Few = 40; // smaller fronts take more time by their number than they save
  int* const from = this->Nodes.data() + first;
  int* const to = this->Nodes.data() + end;
  const Cut cut = end - first > Few ? BestCut(places, from, to) : Cut();
  Part part{first, end - first, {None, None}};
  if (cut.Cost < std::numeric_limits<std::int64_t>::max())
  {
    const auto side = [&](int node)
    { return places[static_cast<std::size_t>(node)][cut.Coordinate] - cut.Value; };
    int* const second = std::stable_partition(from, to, [&](int node) { return side(node) < 0; });
    int* const between =
        std::stable_partition(second, to, [&](int node) { return side(node) > 0; });
    const int middle = first + static_cast<int>(second - from);
    part.First = first + static_cast<int>(between - from);
    part.Count = end - part.First;
    part.Before[0] = this->Split(places, first, middle);
    part.Before[1] = this->Split(places, middle, part.First);
  }
  this->Tree.push_back(part);
  return static_cast<int>(this->Tree.size()) - 1;
}
} // namespace palpate
