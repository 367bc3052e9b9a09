#include "PartBridge.h"

#include "KuhnNeighborhood.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace palpate
{
namespace
{
constexpr unsigned char Other = 1;
constexpr unsigned char Start = 2;
constexpr double Radius = 1.8; // in spacings

bool IsBorder(const ShapeGrid& grid, const std::array<int, 3>& at)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (at[axis] == 0 || at[axis] == grid.Size[axis] - 1)
    {
      return true;
    }
  }
  return false;
}

class BridgeSearch
{
public:
  BridgeSearch(const ShapeField& field, const std::vector<unsigned char>& marks)
      : Field(&field), Marks(&marks), Steps(OffsetsOf(field.Grid)),
        Costs(marks.size(), std::numeric_limits<float>::infinity()), Parents(marks.size(), 0)
  {
    for (int n = 0; n < KuhnNeighbors; ++n)
    {
      const std::array<int, 3> step = KuhnStep(n);
      this->Lengths[static_cast<std::size_t>(n)] =
          static_cast<float>(std::sqrt(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]));
    }
  }

  // The last node of the cheapest path, or the number of nodes if there is none.
  std::size_t Run()
  {
    for (std::size_t node = 0; node < this->Marks->size(); ++node)
    {
      if ((*this->Marks)[node] == Start)
      {
        this->Costs[node] = 0.0f;
        this->Spread(node);
      }
    }
    while (!this->Queue.empty())
    {
      const auto [cost, node] = this->Queue.top();
      this->Queue.pop();
      if ((*this->Marks)[node] == Other)
      {
        return node;
      }
      if (cost == this->Costs[node])
      {
        this->Spread(node);
      }
    }
    return this->Marks->size();
  }

  PartBridge PathTo(std::size_t last) const
  {
    PartBridge bridge;
    bridge.To = last;
    std::size_t node = this->Parents[last];
    for (; (*this->Marks)[node] != Start; node = this->Parents[node])
    {
      this->AddSphere(node, bridge.Nodes);
    }
    bridge.From = node;
    std::sort(bridge.Nodes.begin(), bridge.Nodes.end());
    bridge.Nodes.erase(std::unique(bridge.Nodes.begin(), bridge.Nodes.end()), bridge.Nodes.end());
    return bridge;
  }

private:
  void Spread(std::size_t node)
  {
    for (std::size_t n = 0; n < this->Steps.size(); ++n)
    {
      const std::size_t next = node + static_cast<std::size_t>(this->Steps[n]);
      if ((*this->Marks)[next] == Start ||
          IsBorder(this->Field->Grid, this->Field->Grid.Index(next)))
      {
        continue;
      }
      const double outside = std::max(0.0, -static_cast<double>(this->Field->Values[next]));
      const float cost =
          this->Costs[node] +
          this->Lengths[n] * static_cast<float>(1.0 + outside / this->Field->Grid.Spacing);
      if (cost < this->Costs[next])
      {
        this->Costs[next] = cost;
        this->Parents[next] = node;
        this->Queue.emplace(cost, next);
      }
    }
  }

  void AddSphere(std::size_t node, NodeList& nodes) const
  {
    const ShapeGrid& grid = this->Field->Grid;
    const std::array<int, 3> centre = grid.Index(node);
    for (int k = -1; k <= 1; ++k)
    {
      for (int j = -1; j <= 1; ++j)
      {
        for (int i = -1; i <= 1; ++i)
        {
          const std::array<int, 3> at{centre[0] + i, centre[1] + j, centre[2] + k};
          const std::size_t offset = grid.Offset(at[0], at[1], at[2]);
          if (i * i + j * j + k * k <= Radius * Radius && !IsBorder(grid, at) &&
              (*this->Marks)[offset] == 0)
          {
            nodes.push_back(offset);
          }
        }
      }
    }
  }

  using Entry = std::pair<float, std::size_t>;

  const ShapeField* Field;
  const std::vector<unsigned char>* Marks;
  KuhnOffsets Steps;
  std::array<float, KuhnNeighbors> Lengths{};
  std::vector<float> Costs;
  std::vector<std::size_t> Parents;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Queue;
};
} // namespace

PartBridge FindBridge(const ShapeField& field, const std::vector<unsigned char>& marks)
{
  BridgeSearch search(field, marks);
  const std::size_t last = search.Run();
  return last < marks.size() ? search.PathTo(last) : PartBridge{};
}
} // namespace palpate
