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

// Header of a record.
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

// Converts a block's nodes to another type.
void Convert(const BrickedChannel& channel, std::uint32_t block, std::size_t nodes, ScalarType type,
             std::byte* target)
{
  const auto to = [&](const auto* from)
  {
    VisitScalars(target, type,
                 [&](const auto* typed)
                 {
                   using T = std::decay_t<decltype(*typed)>;
                   std::transform(from, from + nodes, reinterpret_cast<T*>(target),
                                  [](auto value) { return static_cast<T>(value); });
                 });
  };
  VisitScalars(channel.BlockAt(block), channel.StoredType(), to);
}

std::vector<ScalarType> TypesOf(const ScalarField& field)
{
  std::vector<ScalarType> types;
  types.reserve(static_cast<std::size_t>(field.ChannelCount()));
  for (int channel = 0; channel < field.ChannelCount(); ++channel)
  {
    types.push_back(field.Channel(channel).StoredType());
  }
  return types;
}
} // namespace

RecordLayout::RecordLayout(const ScalarField& field) : RecordLayout(field.Layout(), TypesOf(field))
{
}

RecordLayout::RecordLayout(const BrickLayout& bricks, const std::vector<ScalarType>& types)
    : ChannelTypes(types)
{
  const auto add = [this](std::size_t bytes)
  {
    const std::size_t at = this->Size;
    this->Size += (bytes + Line - 1) / Line * Line;
    return at;
  };
  add(Line);
  add((CellSet::WordCount + 1) * sizeof(std::uint64_t));
  for (const ScalarType type : types)
  {
    this->Channels.push_back(add(bricks.NodesOfBrick() * BytesOf(type)));
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
                BrickDirectory::SurfaceBytes);
  }
  for (int c = 0; c < field.ChannelCount(); ++c)
  {
    const BrickedChannel& channel = field.Channel(c);
    const std::uint32_t block = channel.SlotOf(brick).Block;
    if (block != BrickedChannel::NotStored)
    {
      header.Parts |= ChannelBit(c);
      Convert(channel, block, field.Layout().NodesOfBrick(),
              this->ChannelTypes[static_cast<std::size_t>(c)], record + this->ChannelAt(c));
    }
  }
  std::memcpy(record, &header, sizeof(header));
}

bool RecordLayout::HasSurface(const std::byte* record) const noexcept
{
  return (HeaderOf(record).Parts & SurfaceBit) != 0;
}

StoredSurface RecordLayout::SurfaceOf(const std::byte* record) const noexcept
{
  return StoredSurface(reinterpret_cast<const std::uint64_t*>(record + this->SurfaceAt()));
}

MaterialSet RecordLayout::MaterialsOf(const std::byte* record) const noexcept
{
  return this->HasSurface(record) ? this->SurfaceOf(record).Materials() : 0;
}

MaterialSet RecordLayout::InsideOf(const std::byte* record) const noexcept
{
  return this->HasSurface(record) ? this->SurfaceOf(record).Inside() : HeaderOf(record).Inside;
}

bool RecordLayout::HasChannel(const std::byte* record, int channel) const noexcept
{
  return (HeaderOf(record).Parts & ChannelBit(channel)) != 0;
}

void RecordLayout::SetSurface(const SurfaceBrick& surface, std::byte* record) const noexcept
{
  Header header = HeaderOf(record);
  const bool hasSurface = surface.Materials != 0;
  header.Parts = hasSurface ? header.Parts | SurfaceBit : header.Parts & ~SurfaceBit;
  header.Inside = hasSurface ? 0 : surface.Inside;
  std::memcpy(record, &header, sizeof(header));
  if (hasSurface)
  {
    std::array<std::uint64_t, CellSet::WordCount + 1> words{};
    std::copy(surface.Cells.Words.begin(), surface.Cells.Words.end(), words.begin());
    words.back() = surface.Sets();
    std::memcpy(record + this->SurfaceAt(), words.data(), sizeof(words));
  }
}
} // namespace palpate
