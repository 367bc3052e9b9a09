#pragma once

#include "BrickDirectory.h"
#include "BrickedChannel.h"
#include "FieldGrid.h"
#include "FieldMaterial.h"
#include "MaterialMap.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// What a field occupies.
struct FieldMemory
{
  std::size_t Bricks = 0;        ///< of the grid
  std::size_t SurfaceBricks = 0; ///< through which a surface passes
  std::size_t StoredBlocks = 0;  ///< bricks whose nodes are stored, over all channels
  std::size_t Bytes = 0;
};

/// One or several channels on one grid, of which only the bricks are stored through which the
/// surface of a material passes, and a margin around them. Immutable once FieldBuilder has made it,
/// so any number of threads may query it. FieldSampler and RayCaster ask it for values and hits.
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
  ScalarField() = default;

  FieldGrid NodeGrid;
  FieldInterpolation Method = FieldInterpolation::Trilinear;
  BrickLayout Bricks;
  BrickDirectory BrickEntries;
  std::vector<FieldMaterial> Materials;
  std::vector<MaterialMap> Maps;
  std::vector<BrickedChannel> Channels;
};
} // namespace palpate
