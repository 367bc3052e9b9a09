#pragma once

#include "BrickRecords.h"

#include <array>
#include <cstdint>
#include <vector>

namespace palpate
{
/// What is known of every brick of a field without its record: which materials fill it, a value for
/// each channel, and where its record is. Some 8 bytes a brick of one channel.
class FieldSurvey
{
public:
  static constexpr std::uint32_t NoRecord = ~std::uint32_t{0};

  /// Of a field all of whose bricks are there.
  explicit FieldSurvey(const ScalarField& whole);

  const FieldGrid& Grid() const noexcept { return this->NodeGrid; }
  const BrickLayout& Layout() const noexcept { return this->Bricks; }
  const RecordLayout& Records() const noexcept { return this->Record; }
  const std::vector<FieldMaterial>& Materials() const noexcept { return this->Conditions; }
  const std::vector<ScalarType>& StoredTypes() const noexcept { return this->Types; }
  FieldInterpolation Interpolation() const noexcept { return this->Method; }

  std::uint32_t RecordOf(std::size_t brick) const noexcept
  {
    return this->IsStored[brick] ? this->Words[brick] : NoRecord;
  }
  /// Of a brick without a record.
  MaterialSet InsideOf(std::size_t brick) const noexcept { return this->Words[brick]; }
  float ConstantOf(int channel, std::size_t brick) const noexcept
  {
    return this->Constants[static_cast<std::size_t>(channel)][brick];
  }
  std::size_t RecordCount() const noexcept { return this->Count; }
  /// Of the bricks of a box.
  std::size_t RecordCount(const BrickBox& box) const noexcept;
  std::size_t Bytes() const noexcept;

private:
  FieldGrid NodeGrid;
  FieldInterpolation Method;
  BrickLayout Bricks;
  RecordLayout Record;
  std::vector<FieldMaterial> Conditions;
  std::vector<ScalarType> Types;
  std::vector<bool> IsStored;
  std::vector<std::uint32_t> Words; ///< the record's number, or the materials inside
  std::vector<std::vector<float>> Constants;
  std::size_t Count = 0;
};
} // namespace palpate
