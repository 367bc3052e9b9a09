#include "FieldNodes.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
class NodeCopy
{
public:
  NodeCopy(const ScalarField& field, int channel)
      : Layout(field.Layout()), Channel(field.Channel(channel)), Nodes(field.Grid().NodeCount())
  {
  }

  // Copies the nodes of a brick's cells; at the upper border also the last nodes.
  void CopyBrick(int i, int j, int k)
  {
    const BrickedChannel::Slot& slot = this->Channel.SlotOf(this->Layout.Number(i, j, k));
    const std::array<int, 3> first{i * this->Layout.Cells, j * this->Layout.Cells,
                                   k * this->Layout.Cells};
    std::array<int, 3> count{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      count[axis] = std::min(this->Layout.Cells + 1, this->Layout.Nodes[axis] - first[axis]);
    }
    const int side = this->Layout.Side;
    const int apron = this->Layout.Apron();
    for (int c = 0; c < count[2]; ++c)
    {
      for (int b = 0; b < count[1]; ++b)
      {
        const auto row = static_cast<std::size_t>(first[2] + c) *
                             static_cast<std::size_t>(this->Layout.Nodes[1]) +
                         static_cast<std::size_t>(first[1] + b);
        float* const to = &this->Nodes[row * static_cast<std::size_t>(this->Layout.Nodes[0]) +
                                       static_cast<std::size_t>(first[0])];
        for (int a = 0; a < count[0]; ++a)
        {
          double value = static_cast<double>(slot.Constant);
          if (slot.Block != BrickedChannel::NotStored)
          {
            const int node = ((c + apron) * side + b + apron) * side + a + apron;
            this->Channel.Load<1>(slot.Block, node, &value);
          }
          to[a] = static_cast<float>(value);
        }
      }
    }
  }

  std::vector<float> Take() { return std::move(this->Nodes); }

private:
  const BrickLayout& Layout;
  const BrickedChannel& Channel;
  std::vector<float> Nodes;
};
} // namespace

std::vector<float> NodesOf(const ScalarField& field, int channel)
{
  NodeCopy copy(field, channel);
  const std::array<int, 3>& bricks = field.Layout().Bricks;
  // Stored bricks come last, so that nodes shared with other bricks get their values.
  for (const bool isStored : {false, true})
  {
    for (int k = 0; k < bricks[2]; ++k)
    {
      for (int j = 0; j < bricks[1]; ++j)
      {
        for (int i = 0; i < bricks[0]; ++i)
        {
          const std::size_t number = field.Layout().Number(i, j, k);
          if ((field.Channel(channel).SlotOf(number).Block != BrickedChannel::NotStored) ==
              isStored)
          {
            copy.CopyBrick(i, j, k);
          }
        }
      }
    }
  }
  return copy.Take();
}
} // namespace palpate
