#include "BoxHierarchy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace palpate
{
namespace
{
constexpr std::size_t LeafSize = 4;

// An infinite box has no centre; any point will do.
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
    std::vector<Vector3> centers(boxes.size());
    std::transform(boxes.begin(), boxes.end(), centers.begin(), CenterOf);
    this->Tree.reserve(boxes.size());
    this->Build(boxes, centers, 0, boxes.size());
    this->Tree.shrink_to_fit();
  }
}

void BoxHierarchy::Build(const std::vector<Eigen::AlignedBox3d>& boxes,
                         const std::vector<Vector3>& centers, std::size_t begin, std::size_t end)
{
  Node node;
  Eigen::AlignedBox3d spread; // of the centres
  for (std::size_t i = begin; i < end; ++i)
  {
    node.Box.extend(boxes[this->Numbers[i]]);
    spread.extend(centers[this->Numbers[i]]);
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
  spread.sizes().maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [this](std::size_t i)
  { return this->Numbers.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end),
                   [&centers, axis](std::uint32_t one, std::uint32_t other)
                   { return centers[one][axis] < centers[other][axis]; });
  this->Build(boxes, centers, begin, middle);
  this->Tree[number].Second = static_cast<std::int32_t>(this->Tree.size());
  this->Build(boxes, centers, middle, end);
}
} // namespace palpate
