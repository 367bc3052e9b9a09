#include "CellBox.h"

#include <algorithm>

namespace palpate
{
namespace
{
// Bits of the cells first..last of a row, repeated for a number of rows of a word.
std::uint64_t RowsBits(int first, int last, int rows) noexcept
{
  constexpr std::uint64_t EveryRow = 0x0101010101010101;
  constexpr int Cells = BrickLayout::Cells;
  const std::uint64_t row = (((std::uint64_t{1} << Cells) - 1) >> (Cells - 1 - (last - first)))
                            << first;
  return row * (EveryRow >> (64 - (rows << BrickLayout::Shift)));
}

// Whether the part of the box in a brick contains no surface and no material.
bool IsFreeBrick(const ScalarField& field, const CellBox& box, const int* brick) noexcept
{
  const BrickLayout& layout = field.Layout();
  const BrickDirectory::Entry& entry =
      field.Directory()[layout.Number(brick[0], brick[1], brick[2])];
  if (entry.Leap > 0)
  {
    return entry.Word == 0;
  }
  int first[3];
  int last[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int corner = layout.Cells * brick[axis];
    first[axis] = std::max(box.First[axis] - corner, 0);
    last[axis] = std::min(box.Last[axis] - corner, layout.Cells - 1);
  }
  const StoredSurface surface = field.Directory().Surface(entry);
  const std::uint64_t bits = RowsBits(first[0], last[0], last[1] - first[1] + 1)
                             << (first[1] << layout.Shift);
  bool isFree = true;
  for (int k = first[2]; k <= last[2]; ++k)
  {
    isFree = isFree && (surface.CellWord(static_cast<std::size_t>(k)) & bits) == 0;
  }
  return isFree;
}
} // namespace

bool CellBox::IsIn(const BrickLayout& layout) const noexcept
{
  bool isIn = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    isIn = isIn && this->First[axis] >= 0 && this->Last[axis] <= layout.Nodes[a] - 2;
  }
  return isIn;
}

bool CellBox::IsFree(const ScalarField& field) const noexcept
{
  const int shift = field.Layout().Shift;
  bool isFree = true;
  int brick[3];
  for (brick[2] = this->First[2] >> shift; brick[2] <= this->Last[2] >> shift; ++brick[2])
  {
    for (brick[1] = this->First[1] >> shift; brick[1] <= this->Last[1] >> shift; ++brick[1])
    {
      for (brick[0] = this->First[0] >> shift; brick[0] <= this->Last[0] >> shift; ++brick[0])
      {
        isFree = isFree && IsFreeBrick(field, *this, brick);
      }
    }
  }
  return isFree;
}
} // namespace palpate
