#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace palpate
{
/// The numbers of cells that a ClearanceProof has to work at, each with what it lacks (mm). Memory
/// is fixed.
template <std::size_t Capacity>
class OpenCells
{
public:
  void Clear() noexcept { this->Size = 0; }
  std::size_t Count() const noexcept { return this->Size; }
  std::size_t operator[](std::size_t i) const noexcept { return this->Cells[i] & IndexBits; }

  /// Of a cell that lacks nothing (<= 0) too, which is left out.
  [[gnu::always_inline]] void Add(std::size_t index, double lacks) noexcept
  {
    std::uint64_t bits;
    std::memcpy(&bits, &lacks, sizeof bits);
    this->Cells[this->Size] = (bits & ~IndexBits) | index;
    this->Size += lacks > 0.0 ? 1 : 0;
  }

  /// Those that lack most come first, or last, in classes of a quarter of an octave: an exact order
  /// takes three times as long. All that lack little are one class.
  void Sort(bool isMostLast) noexcept
  {
    const auto begin = this->Cells.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(this->Size);
    const std::uint64_t most = this->Size > 0 ? *std::max_element(begin, end) : 0;
    const auto classOf = [&](std::uint64_t cell)
    {
      const std::uint64_t below = (most >> BitsInClass) - (cell >> BitsInClass);
      const std::size_t number = std::min<std::size_t>(below, Classes - 1);
      return isMostLast ? Classes - 1 - number : number;
    };
    std::array<std::size_t, Classes + 1> next{};
    for (auto cell = begin; cell != end; ++cell)
    {
      ++next[classOf(*cell) + 1];
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    const auto unsortedEnd = std::copy(begin, end, this->Unsorted.begin());
    for (auto cell = this->Unsorted.begin(); cell != unsortedEnd; ++cell)
    {
      this->Cells[next[classOf(*cell)]++] = *cell;
    }
  }

private:
  // Positive numbers are in the order of their bits, the last of which hold the cell's number.
  static constexpr std::uint64_t IndexBits = 0xffff;
  static_assert(Capacity <= IndexBits);
  static constexpr int BitsInClass = 50; // of the 52 of the fraction
  static constexpr std::size_t Classes = 32;

  std::array<std::uint64_t, Capacity + 1> Cells; // and one that may be left out
  std::array<std::uint64_t, Capacity> Unsorted;
  std::size_t Size = 0;
};
} // namespace palpate
