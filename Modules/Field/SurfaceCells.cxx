#include "SurfaceCells.h"

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

ConditionCells UniformCells(bool holds)
{
  ConditionCells cells{};
  cells.Any.fill(holds ? ~std::uint64_t{0} : 0);
  cells.All = cells.Any;
  return cells;
}
} // namespace palpate
