#include "ScalarField.h"

namespace palpate
{
namespace
{
void AddCells(const CellSet& cells, const std::array<int, 3>& corner,
              std::vector<std::array<int, 3>>& found)
{
  for (int k = 0; k < BrickLayout::Cells; ++k)
  {
    const std::uint64_t layer = cells[static_cast<std::size_t>(k)];
    for (int cell = 0; cell < BrickLayout::Cells * BrickLayout::Cells; ++cell)
    {
      if ((layer >> cell & 1) != 0)
      {
        found.push_back({corner[0] + cell % BrickLayout::Cells,
                         corner[1] + cell / BrickLayout::Cells, corner[2] + k});
      }
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
          AddCells(this->BrickEntries.Surface(entry).Cells,
                   {BrickLayout::Cells * i, BrickLayout::Cells * j, BrickLayout::Cells * k}, cells);
        }
      }
    }
  }
  return cells;
}
} // namespace palpate
