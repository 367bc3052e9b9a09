#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

namespace palpate
{
/// Cache-aligned memory for a fixed number of brick records, at stable addresses. The system
/// commits pages when they are first written: an unused record costs address space, but no memory.
class BrickMemory
{
public:
  BrickMemory(std::size_t records, std::size_t recordBytes)
      : Room(records), Stride(recordBytes),
        Bytes(static_cast<std::byte*>(::operator new(records* recordBytes, Line)))
  {
  }

  std::size_t Count() const noexcept { return this->Room; }
  std::byte* Record(std::uint32_t slot) noexcept { return this->Bytes.get() + slot * this->Stride; }
  const std::byte* Record(std::uint32_t slot) const noexcept
  {
    return this->Bytes.get() + slot * this->Stride;
  }
  const std::byte* Data() const noexcept { return this->Bytes.get(); }

private:
  static constexpr std::align_val_t Line{64};
  struct Deleter
  {
    void operator()(std::byte* bytes) const noexcept { ::operator delete(bytes, Line); }
  };

  std::size_t Room;
  std::size_t Stride;
  std::unique_ptr<std::byte, Deleter> Bytes;
};
} // namespace palpate
