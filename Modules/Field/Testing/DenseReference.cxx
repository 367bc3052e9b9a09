#include "DenseReference.h"

#include <algorithm>
#include <cmath>

namespace palpate::test
{
namespace
{
int Mirrored(int node, int nodes)
{
  return node < 0 ? -node : node > nodes - 1 ? 2 * (nodes - 1) - node : node;
}
} // namespace

DenseReference::DenseReference(const std::array<int, 3>& size, const std::vector<double>& samples,
                               FieldInterpolation interpolation)
    : Size(size), Interpolation(interpolation), Nodes(samples.begin(), samples.end())
{
  if (interpolation == FieldInterpolation::Trilinear)
  {
    return;
  }
  const auto row = static_cast<std::size_t>(size[0]);
  const std::size_t slice = row * static_cast<std::size_t>(size[1]);
  for (std::size_t first = 0; first < this->Nodes.size(); ++first)
  {
    if (first % row == 0)
    {
      this->SolveLine(first, 1, size[0]);
    }
  }
  for (std::size_t first = 0; first < this->Nodes.size(); ++first)
  {
    if (first % slice < row)
    {
      this->SolveLine(first, row, size[1]);
    }
  }
  for (std::size_t first = 0; first < slice; ++first)
  {
    this->SolveLine(first, slice, size[2]);
  }
}

// (c[n-1] + 4 c[n] + c[n+1]) / 6 = s[n], mirrored at the ends, by elimination.
void DenseReference::SolveLine(std::size_t first, std::size_t stride, int length)
{
  const auto count = static_cast<std::size_t>(length);
  std::vector<Real> upper(count);
  std::vector<Real> right(count);
  for (std::size_t n = 0; n < count; ++n)
  {
    const Real lower = n == 0 ? 0 : n + 1 == count ? 2 : 1;
    const Real above = n == 0 ? 2 : n + 1 == count ? 0 : 1;
    const Real pivot = 4 - (n > 0 ? lower * upper[n - 1] : 0);
    upper[n] = above / pivot;
    const Real sample = 6 * this->Nodes[first + n * stride];
    right[n] = (sample - (n > 0 ? lower * right[n - 1] : 0)) / pivot;
  }
  for (std::size_t n = count; n-- > 0;)
  {
    right[n] -= n + 1 < count ? upper[n] * right[n + 1] : 0;
    this->Nodes[first + n * stride] = right[n];
  }
}

DenseReference::Weights DenseReference::WeightsAt(Real position, int nodes) const
{
  const int cell = std::clamp(static_cast<int>(std::floor(position)), 0, nodes - 2);
  const Real u = position - cell;
  if (this->Interpolation == FieldInterpolation::Trilinear)
  {
    return {cell, 2, {1 - u, u}, {-1, 1}};
  }
  const Real v = 1 - u;
  return {cell - 1,
          4,
          {v * v * v / 6, (3 * u * u * u - 6 * u * u + 4) / 6, (3 * v * v * v - 6 * v * v + 4) / 6,
           u * u * u / 6},
          {-v * v / 2, (3 * u * u - 4 * u) / 2, (4 * v - 3 * v * v) / 2, u * u / 2}};
}

DenseReference::Real DenseReference::Node(int i, int j, int k) const
{
  const auto at = (static_cast<std::size_t>(Mirrored(k, this->Size[2])) *
                       static_cast<std::size_t>(this->Size[1]) +
                   static_cast<std::size_t>(Mirrored(j, this->Size[1]))) *
                      static_cast<std::size_t>(this->Size[0]) +
                  static_cast<std::size_t>(Mirrored(i, this->Size[0]));
  return this->Nodes[at];
}

DenseReference::Real DenseReference::Sum(const std::array<Weights, 3>& weights, int slopeAxis) const
{
  const auto weight = [&weights, slopeAxis](int axis, int n)
  {
    const Weights& w = weights[static_cast<std::size_t>(axis)];
    return axis == slopeAxis ? w.Slope[n] : w.Value[n];
  };
  Real sum = 0;
  for (int k = 0; k < weights[2].Count; ++k)
  {
    for (int j = 0; j < weights[1].Count; ++j)
    {
      for (int i = 0; i < weights[0].Count; ++i)
      {
        sum += weight(0, i) * weight(1, j) * weight(2, k) *
               this->Node(weights[0].First + i, weights[1].First + j, weights[2].First + k);
      }
    }
  }
  return sum;
}

DenseReference::Real DenseReference::Value(const Point& p) const
{
  return this->Sum({this->WeightsAt(p[0], this->Size[0]), this->WeightsAt(p[1], this->Size[1]),
                    this->WeightsAt(p[2], this->Size[2])},
                   -1);
}

DenseReference::Point DenseReference::Gradient(const Point& p) const
{
  const std::array<Weights, 3> weights{this->WeightsAt(p[0], this->Size[0]),
                                       this->WeightsAt(p[1], this->Size[1]),
                                       this->WeightsAt(p[2], this->Size[2])};
  return {this->Sum(weights, 0), this->Sum(weights, 1), this->Sum(weights, 2)};
}
} // namespace palpate::test
