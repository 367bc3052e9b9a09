#pragma once

#include "CellSet.h"
#include "FieldMaterial.h"

#include <cstdint>
#include <vector>

namespace palpate
{
/// A brick through which the surface of a material may pass.
struct SurfaceBrick
{
  CellSet Cells; ///< cells through which a surface may pass; none passes through the others
  MaterialSet Materials = 0; ///< whose surfaces pass
  MaterialSet Inside = 0;    ///< materials that fill the brick

  /// Materials and Inside as one word, as they are stored.
  std::uint64_t Sets() const noexcept
  {
    return std::uint64_t{this->Inside} << 32 | this->Materials;
  }
};

/// A SurfaceBrick as it is stored: the words of its cell set, then one word for both material sets.
class StoredSurface
{
public:
  explicit StoredSurface(const std::uint64_t* words) noexcept
      : Words(words), Sets(words[CellSet::WordCount])
  {
  }
  bool HasCell(int bit) const noexcept
  {
    return (this->Words[static_cast<std::size_t>(bit) >> 6] >> (bit & 63) & 1u) != 0;
  }
  std::uint64_t CellWord(std::size_t word) const noexcept { return this->Words[word]; }
  MaterialSet Materials() const noexcept { return static_cast<MaterialSet>(this->Sets); }
  MaterialSet Inside() const noexcept { return static_cast<MaterialSet>(this->Sets >> 32); }

private:
  const std::uint64_t* Words;
  std::uint64_t Sets;
};

/// Per-brick data that rays and inside tests read before any samples.
class BrickDirectory
{
public:
  struct Entry
  {
    std::uint32_t Word =
        0; ///< Leap 0: offset of the surface brick in words; else the materials inside
    std::uint32_t Leap = 0; ///< distance to the next surface brick, in bricks along the axis where
                            ///< it is largest; up to 255

    bool HasSurface() const noexcept { return this->Leap == 0; }
  };

  BrickDirectory() = default;
  explicit BrickDirectory(const BrickLayout& layout) : Entries(layout.BrickCount(), Entry{0, 1}) {}

  void SetInside(std::size_t brick, MaterialSet inside) { this->Entries[brick] = {inside, 1}; }
  void AddSurface(std::size_t brick, const SurfaceBrick& surface);
  /// Uses stored surfaces that the caller owns instead; SetSurface gives a brick's offset in words.
  void UseSurfaces(const std::uint64_t* words) { this->SurfaceWords = words; }
  void SetSurface(std::size_t brick, std::size_t word)
  {
    this->Entries[brick] = {static_cast<std::uint32_t>(word), 0};
  }
  /// Once every brick is set: computes the leaps.
  void FindLeaps(const BrickLayout& layout);
  /// For a brick without a surface; at most the distance to the next surface brick.
  void SetLeap(std::size_t brick, std::uint32_t leap) { this->Entries[brick].Leap = leap; }

  const Entry& operator[](std::size_t brick) const noexcept { return this->Entries[brick]; }
  StoredSurface Surface(const Entry& entry) const noexcept
  {
    return StoredSurface(this->SurfaceWords + entry.Word);
  }
  /// Raw data for batch kernels. Surfaces: nullptr if there are none.
  const Entry* EntryData() const noexcept { return this->Entries.data(); }
  const std::uint64_t* SurfaceData() const noexcept { return this->SurfaceWords; }
  /// Of one stored surface.
  static constexpr std::size_t SurfaceBytes = (CellSet::WordCount + 1) * sizeof(std::uint64_t);
  /// Without surfaces that the caller owns.
  std::size_t Bytes() const noexcept
  {
    return this->Entries.size() * sizeof(Entry) + this->Surfaces.size() * sizeof(std::uint64_t);
  }

private:
  std::vector<Entry> Entries;
  std::vector<std::uint64_t> Surfaces;
  const std::uint64_t* SurfaceWords = nullptr; ///< of Surfaces, or the caller's
};
} // namespace palpate
