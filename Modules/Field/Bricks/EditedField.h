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
/// A field whose bricks can be edited, and immutable versions of it. A version costs only the
/// bricks that changed since an earlier version that is no longer in use: that one is updated and
/// reused. So there are as many directories as versions were in use at once, plus one, and a
/// brick's record is rewritten once no version uses it. One thread edits and makes versions; any
/// thread may use and destroy them, even after the EditedField itself.
class EditedField
{
public:
  /// Starts as `whole`, whose stored bricks are copied; `types` are the storage types of the
  /// channels from now on. Fails if memory is insufficient.
  static Status Make(const ScalarField& whole, const std::vector<ScalarType>& types,
                     std::unique_ptr<EditedField>& edited);
  ~EditedField();

  /// Current state; editing thread only.
  const ScalarField& Newest() const noexcept;
  const RecordLayout& Records() const noexcept;
  /// The initial and the current record of a brick; nullptr if it has none.
  const std::byte* OriginalOf(std::size_t brick) const noexcept;
  const std::byte* RecordOf(std::size_t brick) const noexcept;

  /// A writable copy of a brick's record, which Put then makes the current one; the brick must have
  /// a record. Returns nullptr if no record is free because too many versions are in use.
  std::byte* Copy(std::size_t brick);
  /// Makes the last copy the current record of brick (i, j, k).
  void Put(const std::array<int, 3>& brick);
  /// Restores the brick's initial record.
  void Restore(const std::array<int, 3>& brick);

  /// The current field; returns the previous object if nothing has changed. Fails if memory is
  /// insufficient.
  Status MakeVersion(std::shared_ptr<const ScalarField>& version);

  /// Of all records ever used, and of directories.
  std::size_t Bytes() const noexcept;

private:
  class Shelf;
  explicit EditedField(std::shared_ptr<Shelf> shelf);

  std::shared_ptr<Shelf> Kept; // shared with versions, which may outlive this
  std::shared_ptr<const ScalarField> Last;
};
} // namespace palpate
