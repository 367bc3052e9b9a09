#pragma once

#include "BrickDirectory.h"
#include "BrickedChannel.h"
#include "FieldGrid.h"
#include "FieldMaterial.h"
#include "MaterialMap.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace palpate
{
class RecordLayout;

/// What a field occupies.
struct FieldMemory
{
  std::size_t Bricks = 0;        ///< of the grid
  std::size_t SurfaceBricks = 0; ///< through which a surface passes
  std::size_t StoredBlocks = 0;  ///< bricks whose nodes are stored, over all channels
  std::size_t Bytes = 0;
};

/// One or several channels on one grid, of which only the bricks are stored through which the
/// surface of a material passes, and a margin around them. Immutable once it is made, so any number
/// of threads may query it. FieldSampler and RayCaster ask it for values and hits.
class ScalarField
{
public:
  const FieldGrid& Grid() const noexcept { return this->NodeGrid; }
  FieldInterpolation Interpolation() const noexcept { return this->Method; }
  int ChannelCount() const noexcept { return static_cast<int>(this->Channels.size()); }
  int MaterialCount() const noexcept { return static_cast<int>(this->Materials.size()); }
  const FieldMaterial& Material(int material) const noexcept
  {
    return this->Materials[static_cast<std::size_t>(material)];
  }
  FieldMemory Memory() const noexcept;
  /// The cells through which surfaces may pass, by their lowest nodes. Allocates: not for a tick.
  std::vector<std::array<int, 3>> SurfaceCells() const;

  /// Whether anything but one value a channel is kept of a brick.
  bool HasStored(std::size_t brick) const noexcept;

  const BrickLayout& Layout() const noexcept { return this->Bricks; }
  const BrickDirectory& Directory() const noexcept { return this->BrickEntries; }
  const MaterialMap& Map(int material) const noexcept
  {
    return this->Maps[static_cast<std::size_t>(material)];
  }
  const BrickedChannel& Channel(int channel) const noexcept
  {
    return this->Channels[static_cast<std::size_t>(channel)];
  }

private:
  friend class FieldBuild;
  friend class EditedField;
  ScalarField() = default;

  /// Of a brick without a surface.
  void SetInside(std::size_t brick, MaterialSet inside);
  /// Once its blocks are there: which of them inside tests of its materials look at.
  void MapSurface(std::size_t brick, const StoredSurface& surface);
  /// Grid, layout and materials alone.
  ScalarField WithoutBricks() const;
  /// Instead of blocks and surfaces of its own: records that somebody else keeps. Layout and
  /// materials are there.
  void UseRecords(const RecordLayout& layout, const std::byte* records);
  /// A brick's record, in slot `slot` of them.
  void PlaceRecord(std::size_t brick, std::uint32_t slot, const RecordLayout& layout,
                   const std::byte* record);

  FieldGrid NodeGrid;
  FieldInterpolation Method = FieldInterpolation::Trilinear;
  BrickLayout Bricks;
  BrickDirectory BrickEntries;
  std::vector<FieldMaterial> Materials;
  std::vector<MaterialMap> Maps;
  std::vector<BrickedChannel> Channels;
};
} // namespace palpate
