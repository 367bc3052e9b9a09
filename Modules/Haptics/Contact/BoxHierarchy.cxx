#include "BoxHierarchy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace palpate
{
namespace
{
constexpr std::size_t LeafSize = 4;

// What is infinite has no centre; any will do.
Vector3 CenterOf(const Eigen::AlignedBox3d& box)
{
  const Vector3 center = box.center();
  return center.allFinite() ? center : Vector3::Zero();
}
} // namespace

BoxHierarchy::BoxHierarchy(const std::vector<Eigen::AlignedBox3d>& boxes) : Numbers(boxes.size())
{
  std::iota(this->Numbers.begin(), this->Numbers.end(), 0U);
  if (!boxes.empty())
  {
    this->Tree.reserve(boxes.size());
    this->Build(boxes, 0, boxes.size());
    this->Tree.shrink_to_fit();
  }
}

void BoxHierarchy::Build(const std::vector<Eigen::AlignedBox3d>& boxes, std::size_t begin,
                         std::size_t end)
{
  Node node;
  Eigen::AlignedBox3d centers;
  for (std::size_t i = begin; i < end; ++i)
  {
    const Eigen::AlignedBox3d& box = boxes[this->Numbers[i]];
    node.Box.extend(box);
    centers.extend(CenterOf(box));
  }
  const std::size_t number = this->Tree.size();
  if (end - begin <= LeafSize)
  {
    node.First = static_cast<std::int32_t>(begin);
    node.Count = static_cast<std::int32_t>(end - begin);
    this->Tree.push_back(node);
    return;
  }
  this->Tree.push_back(node);
  Eigen::Index axis = 0;
  centers.sizes().maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [this](std::size_t i)
  { return this->Numbers.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end),
                   [&boxes, axis](std::uint32_t one, std::uint32_t other)
                   { return CenterOf(boxes[one])[axis] < CenterOf(boxes[other])[axis]; });
  this->Build(boxes, begin, middle);
  this->Tree[number].Second = static_cast<std::int32_t>(this->Tree.size());
  this->Build(boxes, middle, end);
}
} // namespace palpate
