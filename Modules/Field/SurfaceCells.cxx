#include "SurfaceCells.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace palpate
{
namespace
{
constexpr int LongestSide = 11;
constexpr int Cells = BrickLayout::Cells;

// Bit i of the row: the condition holds at node i.
unsigned RowBits(const double* row, int side, const FieldCondition& condition)
{
  unsigned bits = 0;
  for (int i = 0; i < side; ++i)
  {
    const bool holds =
        condition.Sense == FieldSense::AtLeast ? row[i] >= condition.Iso : row[i] <= condition.Iso;
    bits |= static_cast<unsigned>(holds) << i;
  }
  return bits;
}

// Rows of one slice of nodes, joined over the windows of cells along i and j: bit 8 j + i.
struct SliceBits
{
  std::uint64_t Any = 0;
  std::uint64_t All = 0;

  SliceBits() = default;
  SliceBits(const double* slice, const BrickLayout& layout, const FieldCondition& condition)
  {
    unsigned any[LongestSide] = {};
    unsigned all[LongestSide] = {};
    for (int j = 0; j < layout.Side; ++j)
    {
      const unsigned bits = RowBits(slice + j * layout.Side, layout.Side, condition);
      any[j] = bits;
      all[j] = bits;
      for (int step = 1; step < layout.Window; ++step)
      {
        any[j] |= bits >> step;
        all[j] &= bits >> step;
      }
    }
    for (int j = 0; j < Cells; ++j)
    {
      unsigned someRow = 0;
      unsigned everyRow = 0xFF;
      for (int step = 0; step < layout.Window; ++step)
      {
        someRow |= any[j + step];
        everyRow &= all[j + step];
      }
      this->Any |= static_cast<std::uint64_t>(someRow & 0xFF) << (Cells * j);
      this->All |= static_cast<std::uint64_t>(everyRow) << (Cells * j);
    }
  }
};

// Four B-spline coefficients to the four Bernstein coefficients of the piece that they make.
void ToBernstein(double* first, int stride)
{
  const double a = first[0];
  const double b = first[stride];
  const double c = first[2 * stride];
  const double d = first[3 * stride];
  constexpr double Sixth = 1.0 / 6.0;
  first[0] = Sixth * (a + 4.0 * b + c);
  first[stride] = Sixth * (4.0 * b + 2.0 * c);
  first[2 * stride] = Sixth * (2.0 * b + 4.0 * c);
  first[3 * stride] = Sixth * (b + 4.0 * c + d);
}

// How far a condition holds in a cell, at least and at most, but for rounding.
struct CellRange
{
  double Lowest = std::numeric_limits<double>::infinity();
  double Highest = -std::numeric_limits<double>::infinity();

  CellRange(const double* firstNode, int side, const FieldCondition& condition)
  {
    constexpr int Window = 4;
    double values[Window * Window * Window];
    double largest = 0.0;
    const double sign = condition.Sign();
    for (int n = 0; n < Window * Window * Window; ++n)
    {
      const double node = firstNode[((n >> 4) * side + (n >> 2 & 3)) * side + (n & 3)];
      values[n] = sign * (node - condition.Iso);
      largest = std::max(largest, std::abs(values[n]));
    }
    for (int line = 0; line < Window * Window; ++line)
    {
      ToBernstein(values + 4 * line, 1);
    }
    for (int line = 0; line < Window * Window; ++line)
    {
      ToBernstein(values + 16 * (line >> 2) + (line & 3), 4);
    }
    for (int line = 0; line < Window * Window; ++line)
    {
      ToBernstein(values + line, 16);
    }
    constexpr double Rounding = 1e-12; // of values as rays compute them, with much to spare
    const auto [low, high] = std::minmax_element(std::begin(values), std::end(values));
    this->Lowest = *low - Rounding * largest;
    this->Highest = *high + Rounding * largest;
  }
};
} // namespace

ConditionCells ClassifyCells(const double* nodes, const BrickLayout& layout,
                             const FieldCondition& condition)
{
  SliceBits slices[LongestSide];
  for (int k = 0; k < layout.Side; ++k)
  {
    slices[k] = SliceBits(nodes + k * layout.Side * layout.Side, layout, condition);
  }
  ConditionCells cells = UniformCells(true);
  for (int k = 0; k < Cells; ++k)
  {
    const auto word = static_cast<std::size_t>(k);
    cells.Any[word] = 0;
    for (int step = 0; step < layout.Window; ++step)
    {
      cells.Any[word] |= slices[k + step].Any;
      cells.All[word] &= slices[k + step].All;
    }
  }
  return cells;
}

void TightenBSplineCells(const double* nodes, const BrickLayout& layout,
                         const FieldCondition& condition, ConditionCells& cells)
{
  for (int cell = 0; cell < Cells * Cells * Cells; ++cell)
  {
    const int k = cell / (Cells * Cells);
    const auto word = static_cast<std::size_t>(k);
    const std::uint64_t bit = std::uint64_t{1} << (cell % (Cells * Cells));
    if ((cells.Any[word] & ~cells.All[word] & bit) == 0)
    {
      continue;
    }
    const int first = layout.FirstNodeOfCell(cell % Cells, cell / Cells % Cells, k);
    const CellRange range(nodes + first, layout.Side, condition);
    cells.Any[word] &= range.Highest < 0.0 ? ~bit : ~std::uint64_t{0};
    cells.All[word] |= range.Lowest >= 0.0 ? bit : 0;
  }
}

ConditionCells UniformCells(bool holds)
{
  ConditionCells cells{};
  cells.Any.fill(holds ? ~std::uint64_t{0} : 0);
  cells.All = cells.Any;
  return cells;
}
} // namespace palpate
