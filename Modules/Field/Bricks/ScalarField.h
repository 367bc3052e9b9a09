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

/// One or several channels on one grid. Only bricks through which the surface of a material passes
/// are stored, unless more are asked for. Immutable once built, so any number of threads may query
/// it. FieldSampler and RayCaster read values and hits.
class ScalarField
{
public:
  const FieldGrid& Grid() const noexcept { return this->NodeGrid; }
  FieldInterpolation Interpolation() const noexcept { return this->Method; }
  /// Standard deviation (voxels) by which the label that it was made from was smoothed; 0: none.
  double Smoothing() const noexcept { return this->LabelSmoothing; }
  int ChannelCount() const noexcept { return static_cast<int>(this->Channels.size()); }
  int MaterialCount() const noexcept { return static_cast<int>(this->Materials.size()); }
  const FieldMaterial& Material(int material) const noexcept
  {
    return this->Materials[static_cast<std::size_t>(material)];
  }
  std::size_t Bytes() const noexcept;
  /// The cells through which surfaces may pass, by their lowest nodes. Allocates: not for the servo
  /// thread.
  std::vector<std::array<int, 3>> SurfaceCells() const;

  /// Whether a brick is stored as more than one value per channel.
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

  /// For a brick without a surface.
  void SetInside(std::size_t brick, MaterialSet inside);
  /// Once its blocks are stored: sets the blocks that inside tests of its materials read.
  void MapSurface(std::size_t brick, const StoredSurface& surface);
  /// A field without surfaces and blocks, but with the constants and insides of this one, that will
  /// use records that the caller owns.
  ScalarField WithRecords(const RecordLayout& layout, const std::byte* records) const;
  /// Sets the record, in slot `slot`, of a brick.
  void PlaceRecord(std::size_t brick, std::uint32_t slot, const RecordLayout& layout,
                   const std::byte* record);

  FieldGrid NodeGrid;
  FieldInterpolation Method = FieldInterpolation::Trilinear;
  double LabelSmoothing = 0.0;
  BrickLayout Bricks;
  BrickDirectory BrickEntries;
  std::vector<FieldMaterial> Materials;
  std::vector<MaterialMap> Maps;
  std::vector<BrickedChannel> Channels;
};
} // namespace palpate
