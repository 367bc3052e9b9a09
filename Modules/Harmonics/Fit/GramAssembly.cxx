#include "GramAssembly.h"

#include "SphericalHarmonicBasis.h"

#include <algorithm>
#include <utility>

namespace palpate
{
GramAssembly::GramAssembly(const MomentTables& tables, const moments::Kernel& kernel)
    : Kernel(&kernel)
{
  const auto stride = static_cast<std::size_t>(tables.NodeStride());
  const MomentTables::Block widest = tables.HarmonicsAtNodes(0, 0);
  this->Weights.resize(stride * 4 * static_cast<std::size_t>(2 * tables.Degree() + 1));
  this->Pair.resize(stride * 4);
  this->Products.resize(static_cast<std::size_t>(4 * widest.Rows * widest.Columns));
}

void GramAssembly::FindNodeWeights(const MomentTables& tables, const double* sums,
                                   double scale) noexcept
{
  const int stride = tables.NodeStride();
  const int degree = 2 * tables.Degree();
  std::fill(this->Weights.begin(), this->Weights.end(), 0.0);
  double* weights = this->Weights.data();
  for (int m = 0; m <= degree; ++m, weights += 4 * stride)
  {
    const double* moment = sums + 2 * moments::MomentStart(degree, m);
    for (int k = 0; k <= degree - m; ++k)
    {
      const double* values = tables.NodeValues(m, k);
      double* real = weights + 2 * (k % 2) * stride;
      for (int node = 0; node < stride; ++node)
      {
        real[node] += moment[2 * k] * values[node];
        real[stride + node] += moment[2 * k + 1] * values[node];
      }
    }
    const double* power = tables.InversePowers(m % moments::OrdersPerFamily);
    for (int part = 0; part < 4; ++part)
    {
      for (int node = 0; node < stride; ++node)
      {
        weights[part * stride + node] *= scale * power[node];
      }
    }
  }
}

// Row of node weights of one order: real (part 0) or imaginary part.
const double* GramAssembly::NodeWeights(const MomentTables& tables, int order, int parity,
                                        int part) const noexcept
{
  return this->Weights.data() +
         static_cast<std::ptrdiff_t>(4 * order + 2 * parity + part) * tables.NodeStride();
}

void GramAssembly::FindPairWeights(const MomentTables& tables, int order, int otherOrder,
                                   int parity) noexcept
{
  const int stride = tables.NodeStride();
  const double* sumReal = this->NodeWeights(tables, order + otherOrder, parity, 0);
  const double* sumImaginary = this->NodeWeights(tables, order + otherOrder, parity, 1);
  const double* lessReal = this->NodeWeights(tables, otherOrder - order, parity, 0);
  const double* lessImaginary = this->NodeWeights(tables, otherOrder - order, parity, 1);
  double* pair = this->Pair.data();
  for (int node = 0; node < stride; ++node)
  {
    pair[node] = 0.5 * (lessReal[node] + sumReal[node]);
    pair[stride + node] = 0.5 * (lessReal[node] - sumReal[node]);
    pair[2 * stride + node] = 0.5 * (sumImaginary[node] + lessImaginary[node]);
    pair[3 * stride + node] = 0.5 * (sumImaginary[node] - lessImaginary[node]);
  }
}

void GramAssembly::Scatter(int order, int parity, int rows, int otherOrder, int otherParity,
                           int otherRows, int columns, PackedTriangle& gram) const noexcept
{
  const int lanes = gram.Lanes();
  double* data = gram.Data();
  const auto put = [&gram, data, lanes](int i, int j, double value)
  {
    const int row = std::max(i, j);
    const int column = std::min(i, j);
    data[gram.RowStart(row) + static_cast<std::size_t>(column * lanes)] = value;
  };
  const double* products = this->Products.data();
  const int set = rows * columns;
  for (int i = 0; i < rows; ++i)
  {
    const int l = order + parity + 2 * i;
    const int zonal = l * (l + 1);
    for (int j = 0; j < otherRows; ++j)
    {
      const int k = otherOrder + otherParity + 2 * j;
      const int otherZonal = k * (k + 1);
      const double* at = products + i * columns + j;
      put(zonal + order, otherZonal + otherOrder, at[0]);
      if (otherOrder > 0)
      {
        put(zonal + order, otherZonal - otherOrder, at[2 * set]);
      }
      if (order > 0)
      {
        put(zonal - order, otherZonal - otherOrder, at[set]);
        put(zonal - order, otherZonal + otherOrder, at[3 * set]);
      }
    }
  }
}

void GramAssembly::Assemble(const MomentTables& tables, const double* sums, double scale,
                            PackedTriangle& gram) noexcept
{
  this->FindNodeWeights(tables, sums, scale);
  for (int order = 0; order <= tables.Degree(); ++order)
  {
    for (int other = order; other <= tables.Degree(); ++other)
    {
      for (int product = 0; product <= 1; ++product)
      {
        this->FindPairWeights(tables, order, other, product);
        for (int parity = 0; parity <= 1; ++parity)
        {
          const int otherParity = (product + parity) % 2;
          const MomentTables::Block left = tables.HarmonicsAtNodes(order, parity);
          const MomentTables::Block right = tables.HarmonicsAtNodes(other, otherParity);
          this->Kernel->WeightedProducts(left.ByRow, left.Rows, tables.NodeStride(),
                                         this->Pair.data(), tables.Nodes(), right.ByNode,
                                         right.Columns, this->Products.data());
          this->Scatter(order, parity, left.Rows, other, otherParity, right.Rows, right.Columns,
                        gram);
        }
      }
    }
  }
}
} // namespace palpate
