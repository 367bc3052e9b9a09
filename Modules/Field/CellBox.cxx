#include "CellBox.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr int Cells = BrickLayout::Cells;

// The cells first..last of a row of a brick, as bits.
std::uint64_t RowBits(int first, int last) noexcept
{
  return (std::uint64_t{0xFF} >> (Cells - 1 - (last - first))) << first;
}

// Bit 8 j + i for the cells of both ranges.
std::uint64_t SliceBits(int firstI, int lastI, int firstJ, int lastJ) noexcept
{
  constexpr std::uint64_t EveryRow = 0x0101010101010101;
  const std::uint64_t rows = EveryRow >> (Cells * (Cells - 1 - (lastJ - firstJ)));
  return (rows * RowBits(firstI, lastI)) << (Cells * firstJ);
}

// Whether a brick has nothing in the part of the box that lies in it.
bool IsFreeBrick(const ScalarField& field, const CellBox& box, const int* brick) noexcept
{
  const BrickDirectory::Entry& entry =
      field.Directory()[field.Layout().Number(brick[0], brick[1], brick[2])];
  if (entry.Leap > 0)
  {
    return entry.Word == 0;
  }
  int first[3];
  int last[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    first[axis] = std::max(box.First[axis] - Cells * brick[axis], 0);
    last[axis] = std::min(box.Last[axis] - Cells * brick[axis], Cells - 1);
  }
  const CellSet& cells = field.Directory().Surface(entry).Cells;
  const std::uint64_t slice = SliceBits(first[0], last[0], first[1], last[1]);
  bool isFree = true;
  for (int k = first[2]; k <= last[2]; ++k)
  {
    isFree = isFree && (cells[static_cast<std::size_t>(k)] & slice) == 0;
  }
  return isFree;
}
} // namespace

bool CellBox::IsIn(const BrickLayout& layout) const noexcept
{
  bool isIn = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int cells = layout.Nodes[static_cast<std::size_t>(axis)] - 1;
    isIn = isIn && this->First[axis] >= 0 && this->Last[axis] < cells;
  }
  return isIn;
}

bool CellBox::IsFree(const ScalarField& field) const noexcept
{
  constexpr int Shift = BrickLayout::Shift;
  bool isFree = true;
  int brick[3];
  for (brick[2] = this->First[2] >> Shift; brick[2] <= this->Last[2] >> Shift; ++brick[2])
  {
    for (brick[1] = this->First[1] >> Shift; brick[1] <= this->Last[1] >> Shift; ++brick[1])
    {
      for (brick[0] = this->First[0] >> Shift; brick[0] <= this->Last[0] >> Shift; ++brick[0])
      {
        isFree = isFree && IsFreeBrick(field, *this, brick);
      }
    }
  }
  return isFree;
}
} // namespace palpate
