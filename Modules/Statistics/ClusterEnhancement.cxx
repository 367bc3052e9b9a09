#include "ClusterEnhancement.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t Unseen = static_cast<std::size_t>(-1);
}

ClusterEnhancement::ClusterEnhancement(std::vector<double> areas,
                                       const std::vector<std::pair<int, int>>& edges)
    : Areas(std::move(areas)), FirstNeighbour(Areas.size() + 1, 0), Neighbours(2 * edges.size())
{
  for (const auto& [one, other] : edges)
  {
    ++this->FirstNeighbour[static_cast<std::size_t>(one) + 1];
    ++this->FirstNeighbour[static_cast<std::size_t>(other) + 1];
  }
  for (std::size_t i = 0; i < this->Areas.size(); ++i)
  {
    this->FirstNeighbour[i + 1] += this->FirstNeighbour[i];
  }
  std::vector<std::size_t> next(this->FirstNeighbour.begin(), this->FirstNeighbour.end() - 1);
  for (const auto& [one, other] : edges)
  {
    this->Neighbours[next[static_cast<std::size_t>(one)]++] = other;
    this->Neighbours[next[static_cast<std::size_t>(other)]++] = one;
  }
}

// Halves the path; a point that skips its parent takes that one's addend too.
std::size_t ClusterEnhancement::RootOf(std::size_t point)
{
  while (this->Parent[point] != point)
  {
    const std::size_t parent = this->Parent[point];
    if (this->Parent[parent] == parent)
    {
      return parent;
    }
    this->Integral[point] += this->Integral[parent];
    this->Parent[point] = this->Parent[parent];
    point = this->Parent[point];
  }
  return point;
}

double ClusterEnhancement::TotalOf(std::size_t point) const
{
  double total = this->Integral[point];
  while (this->Parent[point] != point)
  {
    point = this->Parent[point];
    total += this->Integral[point];
  }
  return total;
}

void ClusterEnhancement::BringTo(std::size_t root, double height)
{
  const double above = this->Height[root];
  this->Integral[root] +=
      std::sqrt(this->Area[root]) * (above * above * above - height * height * height) / 3.0;
  this->Height[root] = height;
}

void ClusterEnhancement::Join(std::size_t one, std::size_t other, double height)
{
  std::size_t large = this->RootOf(one);
  std::size_t small = this->RootOf(other);
  if (large == small)
  {
    return;
  }
  if (this->Area[large] < this->Area[small])
  {
    std::swap(large, small);
  }
  this->BringTo(large, height);
  this->BringTo(small, height);
  this->Parent[small] = large;
  this->Integral[small] -= this->Integral[large];
  this->Area[large] += this->Area[small];
}

void ClusterEnhancement::Enhance(const Eigen::VectorXd& map, Eigen::VectorXd& enhanced)
{
  const std::size_t count = this->Areas.size();
  this->Order.clear();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (map[static_cast<Eigen::Index>(i)] > 0.0)
    {
      this->Order.push_back(static_cast<int>(i));
    }
  }
  std::sort(this->Order.begin(), this->Order.end(), [&](int a, int b) { return map[a] > map[b]; });
  this->Parent.assign(count, Unseen);
  this->Area = this->Areas;
  this->Integral.assign(count, 0.0);
  this->Height.resize(count);
  for (const int added : this->Order)
  {
    const auto point = static_cast<std::size_t>(added);
    this->Parent[point] = point;
    this->Height[point] = map[added];
    for (std::size_t k = this->FirstNeighbour[point]; k < this->FirstNeighbour[point + 1]; ++k)
    {
      const auto neighbour = static_cast<std::size_t>(this->Neighbours[k]);
      if (this->Parent[neighbour] != Unseen)
      {
        this->Join(point, neighbour, map[added]);
      }
    }
  }
  for (const int added : this->Order)
  {
    const auto point = static_cast<std::size_t>(added);
    if (this->Parent[point] == point)
    {
      this->BringTo(point, 0.0);
    }
  }
  enhanced.setZero(map.size());
  for (const int added : this->Order)
  {
    const auto point = static_cast<std::size_t>(added);
    enhanced[added] = this->TotalOf(point);
  }
}
} // namespace palpate
