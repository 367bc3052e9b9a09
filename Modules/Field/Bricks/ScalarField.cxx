#include "ScalarField.h"

#include "BrickRecords.h"

namespace palpate
{
namespace
{
void AddCells(const StoredSurface& surface, const std::array<int, 3>& corner,
              std::vector<std::array<int, 3>>& found)
{
  constexpr int Shift = BrickLayout::Shift;
  constexpr int Mask = BrickLayout::Cells - 1;
  for (int cell = 0; cell < 1 << (3 * Shift); ++cell)
  {
    if (surface.HasCell(cell))
    {
      found.push_back({corner[0] + (cell & Mask), corner[1] + (cell >> Shift & Mask),
                       corner[2] + (cell >> (2 * Shift))});
    }
  }
}
} // namespace

std::size_t ScalarField::Bytes() const noexcept
{
  std::size_t bytes =
      sizeof(*this) + this->BrickEntries.Bytes() + this->Materials.size() * sizeof(FieldMaterial);
  for (const MaterialMap& map : this->Maps)
  {
    bytes += sizeof(MaterialMap) + map.Bytes();
  }
  for (const BrickedChannel& channel : this->Channels)
  {
    bytes += sizeof(BrickedChannel) + channel.Bytes();
  }
  return bytes;
}

void ScalarField::SetInside(std::size_t brick, MaterialSet inside)
{
  this->BrickEntries.SetInside(brick, inside);
  for (int m = 0; m < this->MaterialCount(); ++m)
  {
    this->Maps[static_cast<std::size_t>(m)].Set(brick, Contains(inside, m) ? MaterialMap::Filled
                                                                           : MaterialMap::Absent);
  }
}

void ScalarField::MapSurface(std::size_t brick, const StoredSurface& surface)
{
  for (int m = 0; m < this->MaterialCount(); ++m)
  {
    const int channel = this->Material(m).Conditions[0].Channel;
    const std::uint32_t elsewhere =
        Contains(surface.Inside(), m) ? MaterialMap::Filled : MaterialMap::Absent;
    this->Maps[static_cast<std::size_t>(m)].Set(
        brick,
        Contains(surface.Materials(), m) ? this->Channel(channel).SlotOf(brick).Block : elsewhere);
  }
}

ScalarField ScalarField::WithRecords(const RecordLayout& layout, const std::byte* records) const
{
  ScalarField field;
  field.NodeGrid = this->NodeGrid;
  field.Method = this->Method;
  field.LabelSmoothing = this->LabelSmoothing;
  field.Bricks = this->Bricks;
  field.Materials = this->Materials;
  field.BrickEntries = BrickDirectory(this->Bricks);
  field.BrickEntries.UseSurfaces(reinterpret_cast<const std::uint64_t*>(records));
  field.Maps.assign(this->Materials.size(), MaterialMap(this->Bricks.BrickCount()));
  for (std::size_t c = 0; c < layout.Types().size(); ++c)
  {
    const ScalarType type = layout.Types()[c];
    field.Channels.emplace_back(this->Bricks, type, records + layout.ChannelAt(static_cast<int>(c)),
                                layout.Bytes() / BytesOf(type));
  }
  for (std::size_t brick = 0; brick < this->Bricks.BrickCount(); ++brick)
  {
    for (std::size_t c = 0; c < field.Channels.size(); ++c)
    {
      field.Channels[c].SetConstant(brick, this->Channels[c].SlotOf(brick).Constant);
    }
    const BrickDirectory::Entry& entry = this->BrickEntries[brick];
    if (!entry.HasSurface())
    {
      field.SetInside(brick, entry.Word);
    }
  }
  return field;
}

void ScalarField::PlaceRecord(std::size_t brick, std::uint32_t slot, const RecordLayout& layout,
                              const std::byte* record)
{
  for (int c = 0; c < this->ChannelCount(); ++c)
  {
    this->Channels[static_cast<std::size_t>(c)].SetBlock(
        brick, layout.HasChannel(record, c) ? slot : BrickedChannel::NotStored);
  }
  if (!layout.HasSurface(record))
  {
    this->SetInside(brick, layout.InsideOf(record));
    return;
  }
  const std::size_t at = slot * layout.Bytes() + layout.SurfaceAt();
  this->BrickEntries.SetSurface(brick, at / sizeof(std::uint64_t));
  this->MapSurface(brick, this->BrickEntries.Surface(this->BrickEntries[brick]));
}

bool ScalarField::HasStored(std::size_t brick) const noexcept
{
  bool hasStored = this->BrickEntries[brick].Leap == 0;
  for (const BrickedChannel& channel : this->Channels)
  {
    hasStored = hasStored || channel.SlotOf(brick).Block != BrickedChannel::NotStored;
  }
  return hasStored;
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
          constexpr int side = BrickLayout::Cells;
          AddCells(this->BrickEntries.Surface(entry), {side * i, side * j, side * k}, cells);
        }
      }
    }
  }
  return cells;
}
} // namespace palpate
