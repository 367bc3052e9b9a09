#include "BrickedChannel.h"

#include <algorithm>

namespace palpate
{
BrickedChannel::BrickedChannel(const BrickLayout& layout, ScalarType stored)
    : Slots(layout.BrickCount()), Type(stored), Side(static_cast<std::size_t>(layout.Side)),
      BlockNodes(layout.NodesOfBrick()), Stride(0)
{
  switch (stored)
  {
  case ScalarType::Int8:
    this->Blocks.emplace<CacheLineVector<std::int8_t>>();
    break;
  case ScalarType::UInt8:
    this->Blocks.emplace<CacheLineVector<std::uint8_t>>();
    break;
  case ScalarType::Int16:
    this->Blocks.emplace<CacheLineVector<std::int16_t>>();
    break;
  case ScalarType::UInt16:
    this->Blocks.emplace<CacheLineVector<std::uint16_t>>();
    break;
  case ScalarType::Float32:
    this->Blocks.emplace<CacheLineVector<float>>();
    break;
  default:
    this->Blocks.emplace<CacheLineVector<double>>();
    break;
  }
  std::visit(
      [this](const auto& blocks)
      {
        constexpr std::size_t Line = 64;
        const std::size_t inLine = Line / sizeof(blocks[0]);
        this->Stride = (this->BlockNodes + inLine - 1) / inLine * inLine;
      },
      this->Blocks);
}

BrickedChannel::BrickedChannel(const BrickLayout& layout, ScalarType stored, const void* blocks,
                               std::size_t stride)
    : BrickedChannel(layout, stored)
{
  this->Data = blocks;
  this->Stride = stride;
}

void BrickedChannel::SetBlock(std::size_t brick, std::uint32_t block)
{
  std::uint32_t& held = this->Slots[brick].Block;
  this->Count += block == NotStored ? 0 : 1;
  this->Count -= held == NotStored ? 0 : 1;
  held = block;
}

void BrickedChannel::Reserve(std::size_t blocks)
{
  std::visit(
      [this, blocks](auto& numbers)
      {
        numbers.resize(blocks * this->Stride);
        this->Data = numbers.data();
      },
      this->Blocks);
}

void BrickedChannel::Store(std::size_t brick, const double* nodes)
{
  std::visit(
      [this, nodes](auto& numbers)
      {
        using T = typename std::decay_t<decltype(numbers)>::value_type;
        std::transform(nodes, nodes + this->BlockNodes, &numbers[this->Count * this->Stride],
                       [](double node) { return static_cast<T>(node); });
      },
      this->Blocks);
  this->Slots[brick].Block = static_cast<std::uint32_t>(this->Count++);
}

std::size_t BrickedChannel::Bytes() const noexcept
{
  const std::size_t blocks = std::visit(
      [](const auto& numbers) { return numbers.size() * sizeof(numbers[0]); }, this->Blocks);
  return blocks + this->Slots.size() * sizeof(Slot);
}
} // namespace palpate
