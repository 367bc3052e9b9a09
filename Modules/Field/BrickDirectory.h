#pragma once

#include "BrickLayout.h"
#include "FieldMaterial.h"

#include <array>
#include <cstdint>
#include <vector>

namespace palpate
{
/// A set of a brick's cells: bit 8 j + i of word k.
using CellSet = std::array<std::uint64_t, BrickLayout::Cells>;

/// A brick through which the surface of a material may pass.
struct SurfaceBrick
{
  CellSet Cells{};           ///< through which a surface may pass; through the others none does
  MaterialSet Materials = 0; ///< whose surfaces they are
  MaterialSet Inside = 0;    ///< materials that fill the brick
};

/// What rays and inside tests ask of a brick before they look at samples.
class BrickDirectory
{
public:
  struct Entry
  {
    std::uint32_t Word = 0; ///< Leap 0: number of the surface brick; else the materials inside
    std::uint32_t Leap = 0; ///< how many bricks away, along the axis where that is most, the next
                            ///< surface brick is; up to 255
  };

  BrickDirectory() = default;
  explicit BrickDirectory(const BrickLayout& layout) : Entries(layout.BrickCount()) {}

  void SetInside(std::size_t brick, MaterialSet inside) { this->Entries[brick] = {inside, 1}; }
  void AddSurface(std::size_t brick, const SurfaceBrick& surface);
  /// Once every brick is set: finds how far rays may leap.
  void FindLeaps(const BrickLayout& layout);

  const Entry& operator[](std::size_t brick) const noexcept { return this->Entries[brick]; }
  const SurfaceBrick& Surface(const Entry& entry) const noexcept
  {
    return this->Surfaces[entry.Word];
  }
  /// For kernels that read many at once.
  const Entry* EntryData() const noexcept { return this->Entries.data(); }
  const SurfaceBrick* SurfaceData() const noexcept { return this->Surfaces.data(); }
  std::size_t SurfaceCount() const noexcept { return this->Surfaces.size(); }
  std::size_t Bytes() const noexcept
  {
    return this->Entries.size() * sizeof(Entry) + this->Surfaces.size() * sizeof(SurfaceBrick);
  }

private:
  std::vector<Entry> Entries;
  std::vector<SurfaceBrick> Surfaces;
};
} // namespace palpate
