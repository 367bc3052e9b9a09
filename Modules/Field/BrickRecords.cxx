#include "BrickRecords.h"

#include "CellSet.h"

#include <algorithm>
#include <cstring>

namespace palpate
{
namespace
{
constexpr std::uint64_t SurfaceBit = 1;

std::uint64_t ChannelBit(int channel) noexcept
{
  return std::uint64_t{2} << channel;
}

// What a record begins with.
struct Header
{
  std::uint64_t Parts = 0;
  MaterialSet Inside = 0;
};

Header HeaderOf(const std::byte* record) noexcept
{
  Header header;
  std::memcpy(&header, record, sizeof(header));
  return header;
}
} // namespace

RecordLayout::RecordLayout(const ScalarField& field)
{
  const auto add = [this](std::size_t bytes)
  {
    const std::size_t at = this->Size;
    this->Size += (bytes + Line - 1) / Line * Line;
    return at;
  };
  add(Line);
  add(field.Directory().SurfaceBytes());
  for (int channel = 0; channel < field.ChannelCount(); ++channel)
  {
    this->Channels.push_back(add(field.Channel(channel).BlockBytes()));
  }
}

void RecordLayout::Write(const ScalarField& field, std::size_t brick,
                         std::byte* record) const noexcept
{
  Header header;
  const BrickDirectory& directory = field.Directory();
  const BrickDirectory::Entry entry = directory[brick];
  header.Inside = entry.Leap > 0 ? entry.Word : 0;
  if (entry.Leap == 0)
  {
    header.Parts |= SurfaceBit;
    std::memcpy(record + this->SurfaceAt(), directory.SurfaceData() + entry.Word,
                directory.SurfaceBytes());
  }
  for (int c = 0; c < field.ChannelCount(); ++c)
  {
    const BrickedChannel& channel = field.Channel(c);
    const std::uint32_t block = channel.SlotOf(brick).Block;
    if (block != BrickedChannel::NotStored)
    {
      header.Parts |= ChannelBit(c);
      std::memcpy(record + this->ChannelAt(c), channel.BlockAt(block), channel.BlockBytes());
    }
  }
  std::memcpy(record, &header, sizeof(header));
}

bool RecordLayout::HasSurface(const std::byte* record) const noexcept
{
  return (HeaderOf(record).Parts & SurfaceBit) != 0;
}

MaterialSet RecordLayout::InsideOf(const std::byte* record) const noexcept
{
  return HeaderOf(record).Inside;
}

bool RecordLayout::HasChannel(const std::byte* record, int channel) const noexcept
{
  return (HeaderOf(record).Parts & ChannelBit(channel)) != 0;
}

RecordsInMemory::RecordsInMemory(const ScalarField& field) : RecordBytes(0)
{
  const RecordLayout layout(field);
  this->RecordBytes = layout.Bytes();
  const auto take = [this](const std::byte* record)
  {
    this->Records.insert(this->Records.end(), record, record + this->RecordBytes);
    return Status::Success();
  };
  static_cast<void>(ForEachRecord(field, layout, take));
}

Status RecordsInMemory::Read(std::uint32_t number, std::byte* record)
{
  if ((std::size_t{number} + 1) * this->RecordBytes > this->Records.size())
  {
    return Status::Failure("There is no record " + std::to_string(number) + " of a brick.");
  }
  std::copy_n(this->Records.data() + std::size_t{number} * this->RecordBytes, this->RecordBytes,
              record);
  return Status::Success();
}
} // namespace palpate
