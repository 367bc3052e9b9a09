#include "ScalarField.h"

namespace palpate
{
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
} // namespace palpate
