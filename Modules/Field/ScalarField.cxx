#include "ScalarField.h"

namespace palpate
{
namespace
{
void AddCells(const StoredSurface& surface, int shift, const std::array<int, 3>& corner,
              std::vector<std::array<int, 3>>& found)
{
  const int mask = (1 << shift) - 1;
  for (int cell = 0; cell < 1 << (3 * shift); ++cell)
  {
    if (surface.HasCell(cell))
    {
      found.push_back({corner[0] + (cell & mask), corner[1] + (cell >> shift & mask),
                       corner[2] + (cell >> (2 * shift))});
    }
  }
}
} // namespace

FieldMemory ScalarField::Memory() const noexcept
{
  FieldMemory memory;
  memory.Bricks = this->Bricks.BrickCount();
  memory.SurfaceBricks = this->BrickEntries.SurfaceCount();
  memory.Bytes = sizeof(*this) + this->BrickEntries.Bytes() +
                 this->Materials.size() * sizeof(FieldMaterial) +
                 this->Channels.size() * sizeof(BrickedChannel);
  for (const MaterialMap& map : this->Maps)
  {
    memory.Bytes += sizeof(MaterialMap) + map.Bytes();
  }
  for (const BrickedChannel& channel : this->Channels)
  {
    memory.StoredBlocks += channel.BlockCount();
    memory.Bytes += channel.Bytes();
  }
  return memory;
}

std::vector<std::array<int, 3>> ScalarField::SurfaceCells() const
{
  std::vector<std::array<int, 3>> cells;
  const auto& count = this->Bricks.Bricks;
  for (int k = 0; k < count[2]; ++k)
  {
    for (int j = 0; j < count[1]; ++j)
    {
      for (int i = 0; i < count[0]; ++i)
      {
        const BrickDirectory::Entry& entry = this->BrickEntries[this->Bricks.Number(i, j, k)];
        if (entry.Leap == 0)
        {
          const int side = this->Bricks.Cells;
          AddCells(this->BrickEntries.Surface(entry), this->Bricks.Shift,
                   {side * i, side * j, side * k}, cells);
        }
      }
    }
  }
  return cells;
}
} // namespace palpate
