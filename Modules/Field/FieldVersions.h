#pragma once

#include "BrickPool.h"
#include "BrickRecords.h"
#include "FieldSurvey.h"
#include "ScalarField.h"
#include "Status.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
/// Makes versions of a field, each of which covers a box of its bricks and has the field's bits
/// there. Their bricks lie in one pool of a fixed size, in which versions share them, so the next
/// version costs only the bricks that are new, and a directory of its box. Bricks that no version
/// uses stay as long as there is room, those longest that were used last. One thread makes
/// versions; they may be used and destroyed by any.
class FieldVersions
{
public:
  /// That a pool takes for each of its records.
  static std::size_t BytesOfRecord(const FieldSurvey& survey) noexcept;

  /// `bytes` is what the pool may occupy. Refuses so little that it holds no brick, a field of more
  /// than 32 channels, and too little memory.
  static Status Make(const std::shared_ptr<const FieldSurvey>& survey,
                     std::unique_ptr<BrickSource> source, std::size_t bytes,
                     std::unique_ptr<FieldVersions>& versions);

  /// Refuses a box that is not in the grid, one whose bricks the pool has no room for beside those
  /// in use, and what the source refuses.
  Status MakeVersion(const BrickBox& box, std::shared_ptr<const ScalarField>& version);

  const FieldSurvey& Survey() const noexcept { return *this->Known; }
  const std::shared_ptr<const FieldSurvey>& SharedSurvey() const noexcept { return this->Known; }
  /// Bricks that the pool has room for, and that lie in it.
  std::size_t Room() const noexcept { return this->Pool->Count(); }
  std::size_t ResidentCount() const noexcept { return this->Used; }
  /// Bricks that were read so far.
  std::uint64_t ReadCount() const noexcept { return this->Reads; }
  /// Of the pool, and what finds bricks in it.
  std::size_t Bytes() const noexcept;

private:
  // What of the pool holds which brick.
  struct Place
  {
    std::uint32_t Record = FieldSurvey::NoRecord;
    std::uint64_t LastVersion = 0; ///< that used it
  };

  FieldVersions(const std::shared_ptr<const FieldSurvey>& survey,
                std::unique_ptr<BrickSource> source, std::size_t records);

  Status Fetch(const BrickBox& box, std::vector<std::uint32_t>& slots);
  Status ReadInto(std::uint32_t slot, std::uint32_t record);
  std::vector<std::uint32_t> SlotsFor(std::size_t count) const;
  void Fill(const BrickBox& box, ScalarField& field) const;

  std::shared_ptr<const FieldSurvey> Known;
  std::unique_ptr<BrickSource> Source;
  std::shared_ptr<BrickPool> Pool;
  std::vector<Place> Places;
  std::vector<std::uint32_t> SlotOfRecord; ///< NoRecord where it is not in the pool
  std::uint64_t VersionCount = 0;
  std::uint64_t Reads = 0;
  std::size_t Used = 0;
};
} // namespace palpate
