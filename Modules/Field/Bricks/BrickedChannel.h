#pragma once

#include "BrickLayout.h"
#include "CacheLineVector.h"
#include "ScalarType.h"

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

namespace palpate
{
/// One channel of a field: for every brick either a copy of its nodes or one value. A copy starts
/// on a cache line, and its type holds the channel's samples exactly.
class BrickedChannel
{
public:
  static constexpr std::uint32_t NotStored = ~std::uint32_t{0};
  struct Slot
  {
    std::uint32_t Block = NotStored;
    float Constant =
        0.0f; ///< near the brick's values; exact if all are the same and representable as float
  };

  /// `stored` is a type of at most 16 bits, Float32 or Float64.
  BrickedChannel(const BrickLayout& layout, ScalarType stored);
  /// Refers to blocks that the caller owns, `stride` elements from block to block.
  BrickedChannel(const BrickLayout& layout, ScalarType stored, const void* blocks,
                 std::size_t stride);
  BrickedChannel(BrickedChannel&&) = default;
  BrickedChannel& operator=(BrickedChannel&&) = default;

  void SetConstant(std::size_t brick, float value) { this->Slots[brick].Constant = value; }
  /// Allocates so many blocks; then each is stored once.
  void Reserve(std::size_t blocks);
  void Store(std::size_t brick, const double* nodes);
  /// For blocks that the caller owns; NotStored if the brick has none.
  void SetBlock(std::size_t brick, std::uint32_t block);

  const Slot& SlotOf(std::size_t brick) const noexcept { return this->Slots[brick]; }
  ScalarType StoredType() const noexcept { return this->Type; }
  /// The blocks' elements, and their number from block to block.
  const void* BlockData() const noexcept { return this->Data; }
  std::size_t BlockStride() const noexcept { return this->Stride; }
  std::size_t BlockCount() const noexcept { return this->Count; }
  const std::byte* BlockAt(std::uint32_t block) const noexcept
  {
    return static_cast<const std::byte*>(this->Data) + block * this->Stride * BytesOf(this->Type);
  }
  /// Without blocks that the caller owns.
  std::size_t Bytes() const noexcept;

  /// Copies Window^3 nodes of a block, starting at `first`, i fastest.
  template <int Window>
  void Load(std::uint32_t block, int first, double* nodes) const noexcept
  {
    const std::size_t offset = block * this->Stride + static_cast<std::size_t>(first);
    switch (this->Type)
    {
    case ScalarType::Int8:
      return LoadFrom<Window>(static_cast<const std::int8_t*>(this->Data) + offset, this->Side,
                              nodes);
    case ScalarType::UInt8:
      return LoadFrom<Window>(static_cast<const std::uint8_t*>(this->Data) + offset, this->Side,
                              nodes);
    case ScalarType::Int16:
      return LoadFrom<Window>(static_cast<const std::int16_t*>(this->Data) + offset, this->Side,
                              nodes);
    case ScalarType::UInt16:
      return LoadFrom<Window>(static_cast<const std::uint16_t*>(this->Data) + offset, this->Side,
                              nodes);
    case ScalarType::Float32:
      return LoadFrom<Window>(static_cast<const float*>(this->Data) + offset, this->Side, nodes);
    default:
      return LoadFrom<Window>(static_cast<const double*>(this->Data) + offset, this->Side, nodes);
    }
  }

private:
  template <int Window, typename T>
  static void LoadFrom(const T* from, std::size_t side, double* nodes) noexcept
  {
    for (std::size_t k = 0; k < Window; ++k)
    {
      for (std::size_t j = 0; j < Window; ++j)
      {
        for (std::size_t i = 0; i < Window; ++i)
        {
          *nodes++ = static_cast<double>(from[(k * side + j) * side + i]);
        }
      }
    }
  }

  std::vector<Slot> Slots;
  ScalarType Type;
  std::size_t Side; ///< nodes of a block along an axis
  std::size_t BlockNodes;
  std::size_t Stride; ///< elements from block to block
  std::size_t Count = 0;
  std::variant<CacheLineVector<std::int8_t>, CacheLineVector<std::uint8_t>,
               CacheLineVector<std::int16_t>, CacheLineVector<std::uint16_t>,
               CacheLineVector<float>, CacheLineVector<double>>
      Blocks;
  const void* Data = nullptr; ///< of Blocks, so that queries need no std::visit; or the caller's
};
} // namespace palpate
