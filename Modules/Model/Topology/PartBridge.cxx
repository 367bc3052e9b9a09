#include "PartBridge.h"

#include "MassAround.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr unsigned char Other = 1;
constexpr unsigned char Start = 2;
constexpr double Radius = 1.8; // in spacings
// A step through a place with nothing around it costs this much more than one inside; and how far
// around, in spacings. With it the bridge stays at one place under noise, on another grid and
// mirrored (of the one of 164 peripheral zones that has distant parts).
constexpr float Emptiness = 15.0f;
constexpr double MassWidth = 20.0;

ShapeField MassOf(const ShapeGrid& grid, std::vector<unsigned char> marks)
{
  std::transform(marks.begin(), marks.end(), marks.begin(),
                 [](unsigned char mark) { return static_cast<unsigned char>(mark != 0 ? 1 : 0); });
  return MassAround(grid, marks, MassWidth);
}

// 1 for nodes of a grid's outermost layer.
std::vector<unsigned char> BorderOf(const ShapeGrid& grid)
{
  std::vector<unsigned char> border(grid.NodeCount(), 0);
  std::size_t node = 0;
  for (int k = 0; k < grid.Size[2]; ++k)
  {
    for (int j = 0; j < grid.Size[1]; ++j)
    {
      const bool isFace = k == 0 || j == 0 || k + 1 == grid.Size[2] || j + 1 == grid.Size[1];
      for (int i = 0; i < grid.Size[0]; ++i, ++node)
      {
        border[node] = isFace || i == 0 || i + 1 == grid.Size[0] ? 1 : 0;
      }
    }
  }
  return border;
}
} // namespace

BridgeSearch::BridgeSearch(const ShapeField& field, const std::vector<unsigned char>& marks)
    : Field(&field), Marks(&marks), Mass(MassOf(field.Grid, marks)), Steps(OffsetsOf(field.Grid)),
      IsBlocked(BorderOf(field.Grid)), Costs(marks.size(), std::numeric_limits<float>::infinity()),
      Parents(marks.size(), 0)
{
  for (int n = 0; n < KuhnNeighbors; ++n)
  {
    const std::array<int, 3> step = KuhnStep(n);
    this->Lengths[static_cast<std::size_t>(n)] =
        static_cast<float>(std::sqrt(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]));
  }
}

PartBridge BridgeSearch::Next()
{
  this->AddStarts();
  const std::size_t last = this->FindOther();
  return last < this->Marks->size() ? this->PathTo(last) : PartBridge{};
}

// Starts from nodes that were marked since the last search.
void BridgeSearch::AddStarts()
{
  for (std::size_t node = 0; node < this->Marks->size(); ++node)
  {
    if ((*this->Marks)[node] == Start && this->Costs[node] != 0.0f)
    {
      this->Costs[node] = 0.0f;
      this->Spread(node);
    }
  }
}

void BridgeSearch::Spread(std::size_t node)
{
  for (std::size_t n = 0; n < this->Steps.size(); ++n)
  {
    const std::size_t next = node + static_cast<std::size_t>(this->Steps[n]);
    if ((*this->Marks)[next] == Start || this->IsBlocked[next] != 0)
    {
      continue;
    }
    const float outside = std::max(0.0f, -this->Field->Values[next]);
    const float share = 1.0f + outside / static_cast<float>(this->Field->Grid.Spacing) +
                        Emptiness * (1.0f - this->Mass.Values[next]);
    const float cost = this->Costs[node] + this->Lengths[n] * share;
    if (cost < this->Costs[next])
    {
      this->Costs[next] = cost;
      this->Parents[next] = node;
      this->Queue.emplace(cost, next);
    }
  }
}

// The last node of the cheapest path, or the number of nodes if there is none.
std::size_t BridgeSearch::FindOther()
{
  while (!this->Queue.empty())
  {
    const auto [cost, node] = this->Queue.top();
    this->Queue.pop();
    if (cost == this->Costs[node] && (*this->Marks)[node] == Other)
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

PartBridge BridgeSearch::PathTo(std::size_t last) const
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

void BridgeSearch::AddSphere(std::size_t node, NodeList& nodes) const
{
  const ShapeGrid& grid = this->Field->Grid;
  const std::array<int, 3> centre = grid.Index(node);
  for (int k = -1; k <= 1; ++k)
  {
    for (int j = -1; j <= 1; ++j)
    {
      for (int i = -1; i <= 1; ++i)
      {
        const std::size_t offset = grid.Offset(centre[0] + i, centre[1] + j, centre[2] + k);
        if (i * i + j * j + k * k <= Radius * Radius && this->IsBlocked[offset] == 0 &&
            (*this->Marks)[offset] == 0)
        {
          nodes.push_back(offset);
        }
      }
    }
  }
}
} // namespace palpate
