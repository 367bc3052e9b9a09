#pragma once

#include "ScalarField.h"
#include "Status.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
/// How all that a field stores of one brick lies in one piece of memory, a record: which of its
/// parts are there, the surface that passes it, then a block of nodes for each channel, each part
/// on a cache line of its own. Records of a field are of one size.
class RecordLayout
{
public:
  RecordLayout() = default;
  explicit RecordLayout(const ScalarField& field);
  /// Of a field with channels of these types.
  RecordLayout(const BrickLayout& bricks, const std::vector<ScalarType>& types);

  /// A multiple of a cache line.
  std::size_t Bytes() const noexcept { return this->Size; }
  /// Of the surface's words.
  std::size_t SurfaceAt() const noexcept { return Line; }
  std::size_t ChannelAt(int channel) const noexcept
  {
    return this->Channels[static_cast<std::size_t>(channel)];
  }

  const std::vector<ScalarType>& Types() const noexcept { return this->ChannelTypes; }

  /// Fills a record with what a field stores of a brick, converted to this layout's types.
  void Write(const ScalarField& field, std::size_t brick, std::byte* record) const noexcept;
  bool HasSurface(const std::byte* record) const noexcept;
  /// Materials whose surfaces pass the brick, and those that fill it.
  MaterialSet MaterialsOf(const std::byte* record) const noexcept;
  MaterialSet InsideOf(const std::byte* record) const noexcept;
  bool HasChannel(const std::byte* record, int channel) const noexcept;
  /// Another surface in place of the one that passes, or none where its cells are none.
  void SetSurface(const SurfaceBrick& surface, std::byte* record) const noexcept;

private:
  static constexpr std::size_t Line = 64;
  StoredSurface SurfaceOf(const std::byte* record) const noexcept;

  std::size_t Size = 0;
  std::size_t CellWords = 0;
  std::vector<ScalarType> ChannelTypes;
  std::vector<std::size_t> Channels;
};

/// Where the records of a field lie while they are not in use. One thread reads them.
class BrickSource
{
public:
  virtual ~BrickSource() = default;
  BrickSource(const BrickSource&) = delete;
  BrickSource& operator=(const BrickSource&) = delete;

  /// Copies record `number`, counted from 0.
  virtual Status Read(std::uint32_t number, std::byte* record) = 0;
  /// In memory.
  virtual std::size_t Bytes() const noexcept { return 0; }

protected:
  BrickSource() = default;
};

/// The records of a field in the order of its bricks: of those of which it stores anything.
/// `take(record)` is given each; it answers what to refuse with.
template <typename Take>
Status ForEachRecord(const ScalarField& field, const RecordLayout& layout, const Take& take)
{
  std::vector<std::byte> record(layout.Bytes());
  for (std::size_t brick = 0; brick < field.Layout().BrickCount(); ++brick)
  {
    if (field.HasStored(brick))
    {
      layout.Write(field, brick, record.data());
      if (Status status = take(record.data()); !status.IsOk())
      {
        return status;
      }
    }
  }
  return Status::Success();
}

/// Records in memory.
class RecordsInMemory final : public BrickSource
{
public:
  explicit RecordsInMemory(const ScalarField& field);

  Status Read(std::uint32_t number, std::byte* record) override;
  std::size_t Bytes() const noexcept override { return this->Records.size(); }

private:
  std::size_t RecordBytes;
  std::vector<std::byte> Records;
};
} // namespace palpate
