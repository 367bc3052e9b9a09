#include "BrickNodes.h"

#include <algorithm>
#include <limits>

namespace palpate
{
namespace
{
// The node in the grid whose value a node beyond it takes.
int NodeInGrid(int node, int nodes)
{
  if (node == nodes)
  {
    return nodes - 2;
  }
  return node < 0 ? -node : std::min(node, nodes - 1);
}
} // namespace

BrickNodes::BrickNodes(const BrickLayout& layout, const FieldSamples& samples)
    : Layout(layout), Samples(samples), Nodes(layout.NodesOfBrick())
{
}

void BrickNodes::FillIndices(std::size_t axis, int brick)
{
  const int first = brick * this->Layout.Cells - this->Layout.Apron();
  for (int n = 0; n < this->Layout.Side; ++n)
  {
    const int index =
        NodeInGrid(first + n, this->Layout.Nodes[axis]) - this->Samples.StartIndex[axis];
    this->Indices[axis][static_cast<std::size_t>(n)] =
        index >= 0 && index < this->Samples.Size[axis] ? index : -1;
  }
}

// Whether every node has the value outside the samples' box.
bool BrickNodes::IsOutside(int i, int j, int k) const
{
  const std::array<int, 3> brick{i, j, k};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int first = brick[axis] * this->Layout.Cells - 1;
    const int start = this->Samples.StartIndex[axis];
    if (first + this->Layout.Side < start || first >= start + this->Samples.Size[axis])
    {
      return true;
    }
  }
  return false;
}

void BrickNodes::Gather(int i, int j, int k)
{
  if (this->IsOutside(i, j, k))
  {
    std::fill(this->Nodes.begin(), this->Nodes.end(), this->Samples.Outside);
    this->Minimum = this->Samples.Outside;
    this->Maximum = this->Samples.Outside;
    return;
  }
  this->FillIndices(0, i);
  this->FillIndices(1, j);
  this->FillIndices(2, k);
  VisitScalars(this->Samples.Data, this->Samples.Type,
               [this](const auto* data) { this->CopyNodes(data); });
}

template <typename T>
void BrickNodes::CopyNodes(const T* data)
{
  double* target = this->Nodes.data();
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  const auto side = static_cast<std::size_t>(this->Layout.Side);
  for (std::size_t k = 0; k < side; ++k)
  {
    for (std::size_t j = 0; j < side; ++j)
    {
      const bool hasRow = this->Indices[1][j] >= 0 && this->Indices[2][k] >= 0;
      const T* row =
          hasRow ? data + this->Samples.Offset(0, this->Indices[1][j], this->Indices[2][k]) : data;
      for (std::size_t i = 0; i < side; ++i)
      {
        const int at = this->Indices[0][i];
        const double node =
            hasRow && at >= 0 ? static_cast<double>(row[at]) : this->Samples.Outside;
        low = std::min(low, node);
        high = std::max(high, node);
        *target++ = node;
      }
    }
  }
  this->Minimum = low;
  this->Maximum = high;
}
} // namespace palpate
