#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// For one material and every brick: whether it fills the brick, is absent, or has a surface there,
/// and then the block of nodes in its first condition's channel. One look-up per inside test.
class MaterialMap
{
public:
  static constexpr std::uint32_t Absent = ~std::uint32_t{0};
  static constexpr std::uint32_t Filled = Absent - 1;

  explicit MaterialMap(std::size_t bricks) : Codes(bricks, Absent) {}

  void Set(std::size_t brick, std::uint32_t code) { this->Codes[brick] = code; }
  /// Absent, Filled, or the number of a block.
  std::uint32_t operator[](std::size_t brick) const noexcept { return this->Codes[brick]; }
  const std::uint32_t* Data() const noexcept { return this->Codes.data(); }
  std::size_t Bytes() const noexcept { return this->Codes.size() * sizeof(std::uint32_t); }

private:
  std::vector<std::uint32_t> Codes;
};
} // namespace palpate
