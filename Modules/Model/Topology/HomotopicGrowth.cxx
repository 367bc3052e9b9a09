#include "HomotopicGrowth.h"

#include <algorithm>
#include <queue>
#include <utility>

namespace palpate
{
namespace
{
// First in, first out within each level; the highest level first.
class LevelQueue
{
public:
  LevelQueue(const ShapeField& field, float sign) : Values(field.Values.data()), Levels(Count)
  {
    float highest = 0.0f;
    for (const float value : field.Values)
    {
      highest = std::max(highest, sign * value);
    }
    this->Scale = highest > 0.0f ? sign * (Count - 1) / highest : 0.0f;
  }

  void Push(std::size_t node)
  {
    const float level = std::clamp(this->Values[node] * this->Scale, 0.0f, Count - 1.0f);
    const auto at = static_cast<std::size_t>(level);
    this->Levels[at].Nodes.push_back(node);
    this->Top = std::max(this->Top, at);
  }

  bool Pop(std::size_t& node)
  {
    while (this->Levels[this->Top].IsEmpty())
    {
      this->Levels[this->Top] = {};
      if (this->Top == 0)
      {
        return false;
      }
      --this->Top;
    }
    node = this->Levels[this->Top].Next();
    return true;
  }

private:
  static constexpr int Count = 1024;
  struct Level
  {
    NodeList Nodes;
    std::size_t First = 0;

    bool IsEmpty() const { return this->First == this->Nodes.size(); }
    std::size_t Next() { return this->Nodes[this->First++]; }
  };

  const float* Values;
  float Scale = 0.0f;
  std::vector<Level> Levels;
  std::size_t Top = 0;
};

// In exact order; equal values by offset.
class ExactQueue
{
public:
  ExactQueue(const ShapeField& field, float sign) : Values(field.Values.data()), Sign(sign) {}

  void Push(std::size_t node) { this->Heap.emplace(this->Sign * this->Values[node], node); }

  bool Pop(std::size_t& node)
  {
    if (this->Heap.empty())
    {
      return false;
    }
    node = this->Heap.top().second;
    this->Heap.pop();
    return true;
  }

private:
  const float* Values;
  float Sign;
  std::priority_queue<std::pair<float, std::size_t>> Heap;
};
} // namespace

HomotopicGrowth::HomotopicGrowth(const ShapeField& field, float sign)
    : Field(&field), Sign(sign), Steps(OffsetsOf(field.Grid)), Simple(&SimpleNodes::Get()),
      State(field.Values.size(), 0)
{
}

unsigned HomotopicGrowth::NeighborsInSet(std::size_t node) const
{
  const unsigned char* state = &this->State[node];
  unsigned neighbors = 0;
  for (std::size_t n = 0; n < this->Steps.size(); ++n)
  {
    neighbors |= static_cast<unsigned>(state[this->Steps[n]] & InSet) << n;
  }
  return neighbors;
}

template <typename Queue>
void HomotopicGrowth::Enqueue(std::size_t node, Queue& queue)
{
  if ((this->State[node] & (InSet | Allowed | Queued)) == Allowed)
  {
    this->State[node] |= Queued;
    queue.Push(node);
  }
}

template <typename Queue>
bool HomotopicGrowth::Take(std::size_t node, Queue& queue)
{
  this->State[node] &= static_cast<unsigned char>(~Queued);
  if (!this->Simple->Contains(this->NeighborsInSet(node)))
  {
    return false;
  }
  this->State[node] |= InSet;
  for (const std::ptrdiff_t step : this->Steps)
  {
    this->Enqueue(node + static_cast<std::size_t>(step), queue);
  }
  return true;
}

NodeList HomotopicGrowth::Left() const
{
  NodeList left;
  for (std::size_t node = 0; node < this->State.size(); ++node)
  {
    if (this->IsLeft(node))
    {
      left.push_back(node);
    }
  }
  return left;
}

void HomotopicGrowth::Grow(const NodeList& first)
{
  LevelQueue queue(*this->Field, this->Sign);
  for (const std::size_t node : first)
  {
    this->Enqueue(node, queue);
  }
  for (std::size_t node = 0; queue.Pop(node);)
  {
    this->Take(node, queue);
  }
}

NodeList HomotopicGrowth::Try(const NodeList& extra)
{
  ExactQueue queue(*this->Field, this->Sign);
  for (const std::size_t node : extra)
  {
    this->Allow(node);
    this->Enqueue(node, queue);
  }
  NodeList taken;
  for (std::size_t node = 0; queue.Pop(node);)
  {
    if (this->Take(node, queue))
    {
      taken.push_back(node);
    }
  }
  return taken;
}

void HomotopicGrowth::Undo(const NodeList& extra, const NodeList& taken)
{
  for (const std::size_t node : taken)
  {
    this->State[node] = Allowed;
  }
  this->Forbid(extra);
}

void HomotopicGrowth::Forbid(const NodeList& nodes)
{
  for (const std::size_t node : nodes)
  {
    this->State[node] &= static_cast<unsigned char>(~Allowed);
  }
}
} // namespace palpate
