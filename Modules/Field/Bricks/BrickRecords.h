#pragma once

#include "ScalarField.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
/// Layout of all data of one brick in one block of memory, a record: flags for the parts present,
/// the surface that passes the brick, then a block of nodes for each channel, each part aligned to
/// a cache line. All records of a field have the same size.
class RecordLayout
{
public:
  RecordLayout() = default;
  explicit RecordLayout(const ScalarField& field);
  /// For a field with channels of these types.
  RecordLayout(const BrickLayout& bricks, const std::vector<ScalarType>& types);

  /// A multiple of a cache line.
  std::size_t Bytes() const noexcept { return this->Size; }
  /// Offset of the surface's words.
  std::size_t SurfaceAt() const noexcept { return Line; }
  std::size_t ChannelAt(int channel) const noexcept
  {
    return this->Channels[static_cast<std::size_t>(channel)];
  }

  const std::vector<ScalarType>& Types() const noexcept { return this->ChannelTypes; }

  /// Fills a record with a brick's data, converted to this layout's types.
  void Write(const ScalarField& field, std::size_t brick, std::byte* record) const noexcept;
  bool HasSurface(const std::byte* record) const noexcept;
  /// Materials whose surfaces pass the brick, and materials that fill it.
  MaterialSet MaterialsOf(const std::byte* record) const noexcept;
  MaterialSet InsideOf(const std::byte* record) const noexcept;
  bool HasChannel(const std::byte* record, int channel) const noexcept;
  /// Replaces the surface; an empty set of cells removes it.
  void SetSurface(const SurfaceBrick& surface, std::byte* record) const noexcept;

private:
  static constexpr std::size_t Line = 64;
  StoredSurface SurfaceOf(const std::byte* record) const noexcept;

  std::size_t Size = 0;
  std::vector<ScalarType> ChannelTypes;
  std::vector<std::size_t> Channels;
};
} // namespace palpate
