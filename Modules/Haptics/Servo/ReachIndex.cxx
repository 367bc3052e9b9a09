#include "ReachIndex.h"

#include <algorithm>

namespace palpate
{
ReachIndex::ReachIndex(const std::vector<Eigen::AlignedBox3d>& boxesWorld)
{
  std::vector<Entry> known;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t i = 0; i < boxesWorld.size(); ++i)
  {
    const Eigen::AlignedBox3d& box = boxesWorld[i];
    if (!box.min().hasNaN() && !box.max().hasNaN())
    {
      known.push_back({box, static_cast<std::uint32_t>(i)});
      boxes.push_back(box);
    }
  }
  this->Hierarchy = BoxHierarchy(boxes);
  this->Entries.reserve(known.size());
  for (const std::uint32_t place : this->Hierarchy.Order())
  {
    this->Entries.push_back(known[place]);
  }
}

std::size_t ReachIndex::Find(const Eigen::AlignedBox3d& boxWorld,
                             std::uint32_t* found) const noexcept
{
  const std::vector<BoxHierarchy::Node>& nodes = this->Hierarchy.Nodes();
  std::int32_t pending[BoxHierarchy::MostPending];
  int pendingCount = 0;
  std::size_t count = 0;
  if (!nodes.empty())
  {
    pending[pendingCount++] = 0;
  }
  while (pendingCount > 0)
  {
    const std::int32_t number = pending[--pendingCount];
    const BoxHierarchy::Node& node = nodes[static_cast<std::size_t>(number)];
    if (!boxWorld.intersects(node.Box))
    {
      continue;
    }
    for (std::int32_t i = node.First; i < node.First + node.Count; ++i)
    {
      const Entry& entry = this->Entries[static_cast<std::size_t>(i)];
      if (boxWorld.intersects(entry.Box))
      {
        found[count++] = entry.Number;
      }
    }
    if (node.Count == 0)
    {
      pending[pendingCount++] = node.Second;
      pending[pendingCount++] = number + 1;
    }
  }
  std::sort(found, found + count);
  return count;
}
} // namespace palpate
