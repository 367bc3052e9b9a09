#pragma once

#include "ScalarField.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
/// How all that a field stores of one brick lies in one piece of memory, a record: which of its
/// parts are there, the surface that passes it, then a block of nodes for each channel, each part
/// on a cache line of its own. Records of a field are of one size.
class RecordLayout
{
public:
  RecordLayout() = default;
  explicit RecordLayout(const ScalarField& field);
  /// Of a field with channels of these types.
  RecordLayout(const BrickLayout& bricks, const std::vector<ScalarType>& types);

  /// A multiple of a cache line.
  std::size_t Bytes() const noexcept { return this->Size; }
  /// Of the surface's words.
  std::size_t SurfaceAt() const noexcept { return Line; }
  std::size_t ChannelAt(int channel) const noexcept
  {
    return this->Channels[static_cast<std::size_t>(channel)];
  }

  const std::vector<ScalarType>& Types() const noexcept { return this->ChannelTypes; }

  /// Fills a record with what a field stores of a brick, converted to this layout's types.
  void Write(const ScalarField& field, std::size_t brick, std::byte* record) const noexcept;
  bool HasSurface(const std::byte* record) const noexcept;
  /// Materials whose surfaces pass the brick, and those that fill it.
  MaterialSet MaterialsOf(const std::byte* record) const noexcept;
  MaterialSet InsideOf(const std::byte* record) const noexcept;
  bool HasChannel(const std::byte* record, int channel) const noexcept;
  /// Another surface in place of the one that passes, or none where its cells are none.
  void SetSurface(const SurfaceBrick& surface, std::byte* record) const noexcept;

private:
  static constexpr std::size_t Line = 64;
  StoredSurface SurfaceOf(const std::byte* record) const noexcept;

  std::size_t Size = 0;
  std::vector<ScalarType> ChannelTypes;
  std::vector<std::size_t> Channels;
};
} // namespace palpate
