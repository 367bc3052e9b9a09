#pragma once

#include "BrickMemory.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
/// Room for so many records of bricks, at addresses that stay. Who makes versions of a field writes
/// records; versions hold what they use, from whatever thread, and a record that is held is never
/// written again.
class BrickPool
{
public:
  BrickPool(std::size_t records, std::size_t recordBytes)
      : Memory(records, recordBytes), Holds(records)
  {
  }

  std::size_t Count() const noexcept { return this->Holds.size(); }
  std::byte* Record(std::uint32_t slot) noexcept { return this->Memory.Record(slot); }
  const std::byte* Data() const noexcept { return this->Memory.Data(); }
  std::size_t RecordBytes() const noexcept { return this->Memory.RecordBytes(); }
  bool IsHeld(std::uint32_t slot) const noexcept
  {
    return this->Holds[slot].load(std::memory_order_acquire) != 0;
  }

private:
  friend class BrickHold;

  BrickMemory Memory;
  std::vector<std::atomic<std::uint32_t>> Holds;
};

/// Records that one version uses, for as long as it lives.
class BrickHold
{
public:
  BrickHold(std::shared_ptr<BrickPool> pool, std::vector<std::uint32_t> slots)
      : Pool(std::move(pool)), Slots(std::move(slots))
  {
    for (const std::uint32_t slot : this->Slots)
    {
      this->Pool->Holds[slot].fetch_add(1, std::memory_order_relaxed);
    }
  }
  ~BrickHold()
  {
    for (const std::uint32_t slot : this->Slots)
    {
      this->Pool->Holds[slot].fetch_sub(1, std::memory_order_release);
    }
  }
  BrickHold(const BrickHold&) = delete;
  BrickHold& operator=(const BrickHold&) = delete;

  std::size_t Bytes() const noexcept { return this->Slots.size() * this->Pool->RecordBytes(); }

private:
  std::shared_ptr<BrickPool> Pool;
  std::vector<std::uint32_t> Slots;
};
} // namespace palpate
