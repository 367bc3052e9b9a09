#include "HandleRepair.h"

#include "DistanceTransform.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace palpate
{
namespace
{
// The field plus the signed distance from the object's boundary in the grid: the field alone may be
// clamped, and would not tell where a thick handle is thinnest.
ShapeField DepthOf(const ShapeField& field, const std::vector<unsigned char>& inside)
{
  VoxelMask nodes;
  nodes.Size = field.Grid.Size;
  nodes.Spacing.fill(field.Grid.Spacing);
  nodes.Inside = inside;
  ShapeField depth{field.Grid, SignedDistance(nodes, DistanceDomain::Space, 0.0)};
  std::transform(depth.Values.begin(), depth.Values.end(), field.Values.begin(),
                 depth.Values.begin(), std::plus<float>());
  return depth;
}

// What the outside cannot take when it grows from the grid's border: membranes across holes.
std::vector<NodeList> MembranesOf(const ShapeField& depth, const std::vector<unsigned char>& inside)
{
  HomotopicGrowth outside(depth, -1.0f);
  const std::array<int, 3>& size = depth.Grid.Size;
  NodeList first;
  std::size_t node = 0;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i, ++node)
      {
        const int layer = std::min({i, j, k, size[0] - 1 - i, size[1] - 1 - j, size[2] - 1 - k});
        if (layer == 0)
        {
          outside.Put(node);
        }
        else if (inside[node] == 0)
        {
          outside.Allow(node);
          if (layer == 1)
          {
            first.push_back(node);
          }
        }
      }
    }
  }
  outside.Grow(first);
  std::vector<unsigned char> marks(inside.size(), 0);
  return ConnectedParts(outside.Left(), OffsetsOf(depth.Grid), marks);
}

// Cuts and fills in one order of growth.
class HandleRepairer
{
public:
  HandleRepairer(const ShapeField& field, const std::vector<unsigned char>& inside,
                 const ShapeField& order, double gap)
      : Field(&field), Inside(&inside), Order(&order), Gap(gap),
        CutWeight(std::max(1.0, gap / field.Grid.Spacing)), Ball(order, 1.0f)
  {
  }

  void Run(const std::vector<NodeList>& membranes)
  {
    this->GrowBall();
    this->AddMembranes(membranes);
  }

  // Of all changed nodes.
  double Cost() const { return this->Cost(this->Ball.Left()) + this->Cost(this->Filled()); }

  HandleRepair Finish()
  {
    this->OpenWalls(this->Ball.Left());
    return {this->Ball.Left(), this->Filled()};
  }

private:
  void GrowBall()
  {
    std::size_t deepest = 0;
    for (std::size_t node = 0; node < this->Inside->size(); ++node)
    {
      if ((*this->Inside)[node] != 0)
      {
        this->Ball.Allow(node);
        deepest = this->Order->Values[node] > this->Order->Values[deepest] ? node : deepest;
      }
    }
    this->Ball.Put(deepest);
    NodeList around;
    for (const std::ptrdiff_t step : OffsetsOf(this->Field->Grid))
    {
      around.push_back(deepest + static_cast<std::size_t>(step));
    }
    this->Ball.Grow(around);
  }

  NodeList Filled() const
  {
    NodeList filled;
    for (std::size_t node = 0; node < this->Inside->size(); ++node)
    {
      if ((*this->Inside)[node] == 0 && this->Ball.Contains(node))
      {
        filled.push_back(node);
      }
    }
    return filled;
  }

  double Cost(std::size_t node) const
  {
    const double depth = std::abs(static_cast<double>(this->Field->Values[node]));
    const double weight = (*this->Inside)[node] != 0 ? this->CutWeight : 1.0;
    return weight * (depth + 0.25 * this->Field->Grid.Spacing);
  }

  double Cost(const NodeList& nodes) const
  {
    double sum = 0.0;
    for (const std::size_t node : nodes)
    {
      sum += this->Cost(node);
    }
    return sum;
  }

  void AddMembranes(const std::vector<NodeList>& membranes)
  {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t n = 0; n < membranes.size(); ++n)
    {
      order.emplace_back(this->Cost(membranes[n]), n);
    }
    std::sort(order.begin(), order.end());
    for (const auto& entry : order)
    {
      this->AddIfCheaper(membranes[entry.second]);
    }
  }

  void AddIfCheaper(const NodeList& membrane)
  {
    const NodeList taken = this->Ball.Try(membrane);
    double change = 0.0;
    for (const std::size_t node : taken)
    {
      change += (*this->Inside)[node] != 0 ? -this->Cost(node) : this->Cost(node);
    }
    if (change < 0.0)
    {
      NodeList rest;
      std::copy_if(membrane.begin(), membrane.end(), std::back_inserter(rest),
                   [this](std::size_t node) { return !this->Ball.Contains(node); });
      this->Ball.Forbid(rest);
      return;
    }
    this->Ball.Undo(membrane, taken);
  }

  // Takes nodes within half a gap of the walls out of the ball, the nearest first.
  void OpenWalls(const NodeList& walls)
  {
    const double spacing = this->Field->Grid.Spacing;
    const double radius = 0.5 * (this->Gap - spacing) / spacing + 1.0; // a wall's side is at one
    if (!(this->Gap > spacing))
    {
      return;
    }
    for (const auto& [distance, node] : this->NodesAround(walls, radius))
    {
      if (this->Ball.Contains(node) && (*this->Inside)[node] != 0 && this->Ball.RemoveSimple(node))
      {
        this->Ball.Allow(node);
      }
    }
  }

  // Nodes within `radius` (in steps) of others, by squared distance.
  std::vector<std::pair<int, std::size_t>> NodesAround(const NodeList& walls, double radius) const
  {
    const ShapeGrid& grid = this->Field->Grid;
    const int reach = static_cast<int>(std::min(radius, 64.0));
    std::vector<std::pair<int, std::size_t>> around;
    for (const std::size_t wall : walls)
    {
      const std::array<int, 3> at = grid.Index(wall);
      for (int k = std::max(at[2] - reach, 1); k <= std::min(at[2] + reach, grid.Size[2] - 2); ++k)
      {
        for (int j = std::max(at[1] - reach, 1); j <= std::min(at[1] + reach, grid.Size[1] - 2);
             ++j)
        {
          for (int i = std::max(at[0] - reach, 1); i <= std::min(at[0] + reach, grid.Size[0] - 2);
               ++i)
          {
            const int square =
                (i - at[0]) * (i - at[0]) + (j - at[1]) * (j - at[1]) + (k - at[2]) * (k - at[2]);
            if (square > 0 && square <= radius * radius)
            {
              around.emplace_back(square, grid.Offset(i, j, k));
            }
          }
        }
      }
    }
    std::sort(around.begin(), around.end());
    return around;
  }

  const ShapeField* Field;
  const std::vector<unsigned char>* Inside;
  const ShapeField* Order;
  double Gap;
  double CutWeight;
  HomotopicGrowth Ball;
};
} // namespace

std::vector<NodeList> ConnectedParts(const NodeList& nodes, const KuhnOffsets& steps,
                                     std::vector<unsigned char>& marks)
{
  for (const std::size_t node : nodes)
  {
    marks[node] = 1;
  }
  std::vector<NodeList> parts;
  for (const std::size_t node : nodes)
  {
    if (marks[node] == 0)
    {
      continue;
    }
    marks[node] = 0;
    parts.push_back({node});
    for (std::size_t next = 0; next < parts.back().size(); ++next)
    {
      for (const std::ptrdiff_t step : steps)
      {
        const std::size_t neighbor = parts.back()[next] + static_cast<std::size_t>(step);
        if (marks[neighbor] != 0)
        {
          marks[neighbor] = 0;
          parts.back().push_back(neighbor);
        }
      }
    }
  }
  return parts;
}

HandleRepair RepairHandles(const ShapeField& field, const std::vector<unsigned char>& inside,
                           double gap)
{
  const ShapeField depth = DepthOf(field, inside);
  const std::vector<NodeList> membranes = MembranesOf(depth, inside);
  HandleRepairer byDepth(field, inside, depth, gap);
  byDepth.Run(membranes);
  HandleRepairer byField(field, inside, field, gap);
  byField.Run(membranes);
  return (byField.Cost() < byDepth.Cost() ? byField : byDepth).Finish();
}
} // namespace palpate
