#pragma once

#include "BrickMemory.h"
#include "BrickRecords.h"
#include "ScalarField.h"
#include "Status.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
/// A whole field whose bricks change, and immutable versions of it. A version costs only the bricks
/// that changed since some earlier one that nobody uses any more: that one is brought up to date
/// and given out again. So there are as many directories as versions were in use at once, and one
/// more, and a brick's record is written again once no version has it. One thread edits and makes
/// versions; they may be used and destroyed by any, also after the field itself.
class EditedField
{
public:
  /// Begins as `whole`, whose stored bricks are copied; `types` are those in which channels are
  /// kept from now on. Refuses too little memory.
  static Status Make(const ScalarField& whole, const std::vector<ScalarType>& types,
                     std::unique_ptr<EditedField>& edited);
  ~EditedField();

  /// As it is now; of the editing thread.
  const ScalarField& Newest() const noexcept;
  const RecordLayout& Records() const noexcept;
  /// The record of a brick as it was in the beginning, and as it is now; nullptr where none is
  /// kept.
  const std::byte* OriginalOf(std::size_t brick) const noexcept;
  const std::byte* RecordOf(std::size_t brick) const noexcept;

  /// A copy of a brick's record to be written, which Put then puts in its place; the brick has a
  /// record. nullptr where there is no room, because too many versions are in use.
  std::byte* Copy(std::size_t brick);
  /// The copy made last, of brick (i, j, k).
  void Put(const std::array<int, 3>& brick);
  /// The brick's record as it was in the beginning.
  void Restore(const std::array<int, 3>& brick);

  /// The field as it is now: the same object as before where nothing has changed. Refuses too
  /// little memory.
  Status MakeVersion(std::shared_ptr<const ScalarField>& version);

  std::size_t VersionsAtOnce() const noexcept;
  /// Of records in use, or that were, and of directories.
  std::size_t Bytes() const noexcept;

private:
  class Shelf;
  explicit EditedField(std::shared_ptr<Shelf> shelf);

  std::shared_ptr<Shelf> Kept; // versions that outlive this keep it too
  std::shared_ptr<const ScalarField> Last;
};
} // namespace palpate
