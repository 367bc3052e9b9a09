#include "DistanceBox.h"

#include "NodeCut.h"

#include <algorithm>

namespace palpate
{
bool DistanceBox::Gather(const RemovedDistances& removed, const NodeBox& box)
{
  this->Box = box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Count[axis] = box.Last[axis] - box.First[axis] + 1;
  }
  const auto count = [this](int around)
  {
    return static_cast<std::size_t>(this->Count[0] + around) *
           static_cast<std::size_t>(this->Count[1] + around) *
           static_cast<std::size_t>(this->Count[2] + around);
  };
  this->Raw.resize(std::max(this->Raw.size(), count(2)));
  this->Corrected.resize(std::max(this->Corrected.size(), count(0)));
  const bool isAny = this->Copy(removed);
  this->ContinueBeyond(removed.Grid().Size());
  this->Correct();
  return isAny;
}

// Returns whether any block is stored.
bool DistanceBox::Copy(const RemovedDistances& removed)
{
  constexpr int Side = RemovedDistances::Side;
  NodeBox nodes;
  NodeBox blocks;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    nodes.First[axis] = std::max(this->Box.First[axis] - 1, 0);
    nodes.Last[axis] = std::min(this->Box.Last[axis] + 1, removed.Grid().Size()[axis] - 1);
    blocks.First[axis] = nodes.First[axis] / Side;
    blocks.Last[axis] = nodes.Last[axis] / Side;
  }
  bool isAny = false;
  for (int k = blocks.First[2]; k <= blocks.Last[2]; ++k)
  {
    for (int j = blocks.First[1]; j <= blocks.Last[1]; ++j)
    {
      for (int i = blocks.First[0]; i <= blocks.Last[0]; ++i)
      {
        const RemovedDistances::Corner corner{Side * i, Side * j, Side * k};
        const float* block = removed.BlockAt(corner);
        isAny = isAny || block != nullptr;
        const NodeBox whole{corner,
                            {corner[0] + Side - 1, corner[1] + Side - 1, corner[2] + Side - 1}};
        this->CopyBlock(block, static_cast<float>(removed.Band()), corner, whole.CommonWith(nodes));
      }
    }
  }
  return isAny;
}

// Copies `nodes` of a block, or one value if it is not stored.
void DistanceBox::CopyBlock(const float* block, float same, const std::array<int, 3>& corner,
                            const NodeBox& nodes)
{
  constexpr int Side = RemovedDistances::Side;
  const std::ptrdiff_t count = nodes.Last[0] - nodes.First[0] + 1;
  for (int k = nodes.First[2]; k <= nodes.Last[2]; ++k)
  {
    for (int j = nodes.First[1]; j <= nodes.Last[1]; ++j)
    {
      float* row =
          &this->Raw[this->RawNumber({nodes.First[0] - this->Box.First[0] + 1,
                                      j - this->Box.First[1] + 1, k - this->Box.First[2] + 1})];
      if (block == nullptr)
      {
        std::fill_n(row, count, same);
        continue;
      }
      const float* from =
          block + ((k - corner[2]) * Side + j - corner[1]) * Side + nodes.First[0] - corner[0];
      count == Side ? std::copy_n(from, Side, row) : std::copy_n(from, count, row);
    }
  }
}

void DistanceBox::ContinueBeyond(const std::array<int, 3>& nodes)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (this->Box.First[axis] == 0)
    {
      this->Continue(axis, false);
    }
    if (this->Box.Last[axis] == nodes[axis] - 1)
    {
      this->Continue(axis, true);
    }
  }
}

// Extrapolates by one node across a face of the box, if nodes of the box need it.
void DistanceBox::Continue(std::size_t axis, bool isUpper)
{
  const std::size_t one = axis == 0 ? 1 : 0;
  const std::size_t two = 3 - axis - one;
  std::array<int, 3> at{};
  for (at[two] = 1; at[two] <= this->Count[two]; ++at[two])
  {
    for (at[one] = 1; at[one] <= this->Count[one]; ++at[one])
    {
      const auto value = [&](int place) -> float&
      {
        std::array<int, 3> node = at;
        node[axis] = isUpper ? this->Count[axis] + 1 - place : place;
        return this->Raw[this->RawNumber(node)];
      };
      value(0) = 2.0f * value(1) - value(2);
    }
  }
}

void DistanceBox::Correct()
{
  const auto alongJ = static_cast<std::ptrdiff_t>(this->Count[0] + 2);
  const std::ptrdiff_t alongK = alongJ * (this->Count[1] + 2);
  float* target = this->Corrected.data();
  for (int k = 1; k <= this->Count[2]; ++k)
  {
    for (int j = 1; j <= this->Count[1]; ++j)
    {
      const float* from = &this->Raw[this->RawNumber({1, j, k})];
      for (std::ptrdiff_t i = 0; i < this->Count[0]; ++i)
      {
        const float neighbours[6] = {from[i - 1],      from[i + 1],      from[i - alongJ],
                                     from[i + alongJ], from[i - alongK], from[i + alongK]};
        target[i] = InterpolatedDistance(from[i], neighbours);
      }
      target += this->Count[0];
    }
  }
}
} // namespace palpate
