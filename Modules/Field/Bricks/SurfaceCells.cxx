#include "SurfaceCells.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace palpate
{
namespace
{
constexpr int LongestSide = BrickLayout::Cells + 3;

// Bit i of the row: the condition holds at node i.
unsigned RowBits(const double* row, int side, const FieldCondition& condition)
{
  const bool isAtLeast = condition.Sense == FieldSense::AtLeast;
  const double iso = condition.Iso;
  unsigned bits = 0;
  for (int i = side - 1; i >= 0; --i)
  {
    const bool holds = isAtLeast ? row[i] >= iso : row[i] <= iso;
    bits = bits << 1 | static_cast<unsigned>(holds);
  }
  return bits;
}

// One slice of nodes, combined over the windows of cells along i and j: the bits of a slice of
// cells in a CellSet.
struct SliceBits
{
  std::uint64_t Any = 0;
  std::uint64_t All = 0;

  SliceBits() = default;
  SliceBits(const double* slice, const BrickLayout& layout, const FieldCondition& condition)
  {
    unsigned any[LongestSide];
    unsigned all[LongestSide];
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
    const unsigned everyCell = (1u << layout.Cells) - 1u;
    for (int j = 0; j < layout.Cells; ++j)
    {
      unsigned someRow = 0;
      unsigned everyRow = everyCell;
      for (int step = 0; step < layout.Window; ++step)
      {
        someRow |= any[j + step];
        everyRow &= all[j + step];
      }
      const int bit = j << layout.Shift;
      this->Any |= static_cast<std::uint64_t>(someRow & everyCell) << bit;
      this->All |= static_cast<std::uint64_t>(everyRow) << bit;
    }
  }
};

// Converts four B-spline coefficients to the four Bernstein coefficients of their segment.
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

// Smallest and largest margin of a condition in a cell, except for rounding.
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
    constexpr double Rounding = 1e-12; // of values as rays compute them, with a wide margin
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
  ConditionCells cells;
  for (int k = 0; k < layout.Cells; ++k)
  {
    std::uint64_t any = 0;
    std::uint64_t all = ~std::uint64_t{0};
    for (int step = 0; step < layout.Window; ++step)
    {
      any |= slices[k + step].Any;
      all &= slices[k + step].All;
    }
    cells.Any.Words[static_cast<std::size_t>(k)] = any;
    cells.All.Words[static_cast<std::size_t>(k)] = all;
  }
  return cells;
}

void TightenBSplineCells(const double* nodes, const BrickLayout& layout,
                         const FieldCondition& condition, ConditionCells& cells)
{
  const int mask = layout.Cells - 1;
  for (int cell = 0; cell < layout.Cells * layout.Cells * layout.Cells; ++cell)
  {
    const auto word = static_cast<std::size_t>(cell >> 6);
    const std::uint64_t bit = std::uint64_t{1} << (cell & 63);
    if ((cells.Any.Words[word] & ~cells.All.Words[word] & bit) == 0)
    {
      continue;
    }
    const int first = layout.FirstNodeOfCell(cell & mask, cell >> layout.Shift & mask,
                                             cell >> (2 * layout.Shift));
    const CellRange range(nodes + first, layout.Side, condition);
    cells.Any.Words[word] &= range.Highest < 0.0 ? ~bit : ~std::uint64_t{0};
    cells.All.Words[word] |= range.Lowest >= 0.0 ? bit : 0;
  }
}

ConditionCells UniformCells(bool holds)
{
  ConditionCells cells;
  cells.Any.Fill(holds);
  cells.All.Fill(holds);
  return cells;
}

void ConditionCells::Restrict(const ConditionCells& more)
{
  for (std::size_t word = 0; word < CellSet::WordCount; ++word)
  {
    this->Any.Words[word] &= more.Any.Words[word];
    this->All.Words[word] &= more.All.Words[word];
  }
}

void AddMaterial(int material, const ConditionCells& cells, const CellSet& inGrid,
                 SurfaceBrick& brick)
{
  std::uint64_t some = 0;
  for (std::size_t word = 0; word < CellSet::WordCount; ++word)
  {
    const std::uint64_t passed =
        cells.Any.Words[word] & ~cells.All.Words[word] & inGrid.Words[word];
    brick.Cells.Words[word] |= passed;
    some |= passed;
  }
  // Neighbouring cells share nodes: without a surface, one cell's answer holds for all.
  const bool isInside = some == 0 && (cells.All.Words[0] & 1u) != 0;
  brick.Materials |= some != 0 ? OnlyMaterial(material) : 0;
  brick.Inside |= isInside ? OnlyMaterial(material) : 0;
}

CellSet CellsInGrid(const BrickLayout& layout, const std::array<int, 3>& brick)
{
  std::array<int, 3> left{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    left[axis] = std::min(layout.Cells, layout.Nodes[axis] - 1 - layout.Cells * brick[axis]);
  }
  const bool isWhole = left[0] + left[1] + left[2] == 3 * layout.Cells;
  CellSet cells;
  cells.Fill(isWhole);
  if (isWhole)
  {
    return cells;
  }
  const std::uint64_t row = (1u << left[0]) - 1u;
  for (int k = 0; k < left[2]; ++k)
  {
    for (int j = 0; j < left[1]; ++j)
    {
      cells.Words[static_cast<std::size_t>(k)] |= row << (j << layout.Shift);
    }
  }
  return cells;
}
} // namespace palpate
