#include "IgtlParser.h"

#include "IgtlHeaderVersion.h"

#include <algorithm>
#include <cstring>
#include <igtl_header.h>
#include <igtl_util.h>

namespace palpate
{
namespace
{
constexpr std::size_t HeaderBytes = IGTL_HEADER_SIZE;
constexpr int NewestVersion = 3;

igtl_header HeaderOf(const std::vector<std::uint8_t>& bytes)
{
  igtl_header header;
  std::memcpy(&header, bytes.data(), HeaderBytes);
  igtl_header_convert_byte_order(&header);
  return header;
}

// Of a field that a zero ends, if there is room for one.
template <std::size_t Size>
std::string TextOf(const char (&field)[Size])
{
  return {field, strnlen(field, Size)};
}

std::uint32_t BigEndian(const std::uint8_t* bytes, int count)
{
  std::uint32_t number = 0;
  for (int i = 0; i < count; ++i)
  {
    number = number << 8 | bytes[i];
  }
  return number;
}

// Leaves the message's own content: version 2 puts an extended header before it, and metadata
// behind it. Returns false if the lengths contradict each other.
bool KeepContent(std::vector<std::uint8_t>& body, int version)
{
  if (version < 2)
  {
    return true;
  }
  constexpr std::size_t LeastExtended = 12;
  if (body.size() < LeastExtended)
  {
    return false;
  }
  const std::uint64_t before = BigEndian(body.data(), 2);
  const std::uint64_t behind =
      std::uint64_t{BigEndian(body.data() + 2, 2)} + BigEndian(body.data() + 4, 4);
  if (before < LeastExtended || before + behind > body.size())
  {
    return false;
  }
  body.resize(body.size() - behind);
  body.erase(body.begin(), body.begin() + static_cast<std::ptrdiff_t>(before));
  return true;
}
} // namespace

bool IgtlParser::Take(const std::uint8_t* bytes, std::size_t count)
{
  while (count > 0)
  {
    const std::size_t wanted =
        this->HasHeader ? static_cast<std::size_t>(std::min<std::uint64_t>(this->BodyLeft, count))
                        : std::min(count, HeaderBytes - this->Header.size());
    if (!this->HasHeader || this->IsKept)
    {
      std::vector<std::uint8_t>& part = this->HasHeader ? this->Body : this->Header;
      part.insert(part.end(), bytes, bytes + wanted);
    }
    bytes += wanted;
    count -= wanted;
    if (this->HasHeader)
    {
      this->BodyLeft -= wanted;
    }
    else if (this->Header.size() == HeaderBytes && !this->BeginMessage())
    {
      return false;
    }
    if (this->HasHeader && this->BodyLeft == 0)
    {
      this->EndMessage();
    }
  }
  return true;
}

bool IgtlParser::BeginMessage()
{
  const igtl_header header = HeaderOf(this->Header);
  const std::string type = TextOf(header.name);
  const bool isName =
      std::all_of(type.begin(), type.end(), [](unsigned char c) { return c >= ' ' && c < 0x7F; });
  const int version = IgtlHeaderVersion(header);
  if (version < 1 || version > NewestVersion || type.empty() || !isName)
  {
    return false;
  }
  this->HasHeader = true;
  this->BodyLeft = header.body_size;
  const auto kind = std::find_if(this->Wanted.begin(), this->Wanted.end(),
                                 [&](const Kind& wanted) { return wanted.Type == type; });
  this->IsKept = kind != this->Wanted.end() && this->BodyLeft <= kind->MostBytes;
  if (kind != this->Wanted.end() && !this->IsKept)
  {
    ++this->TooLongCount;
  }
  return true;
}

void IgtlParser::EndMessage()
{
  if (this->IsKept)
  {
    const igtl_header header = HeaderOf(this->Header);
    const bool isWhole = crc64(this->Body.data(), this->Body.size(), 0) == header.crc;
    if (isWhole && KeepContent(this->Body, IgtlHeaderVersion(header)))
    {
      this->Complete.push_back(
          {TextOf(header.name), TextOf(header.device_name), std::move(this->Body)});
    }
    else
    {
      ++this->DamagedCount;
    }
  }
  this->Header.clear();
  this->Body = {};
  this->HasHeader = false;
}

std::optional<IgtlMessage> IgtlParser::Next()
{
  if (this->Complete.empty())
  {
    return std::nullopt;
  }
  IgtlMessage next = std::move(this->Complete.front());
  this->Complete.pop_front();
  return next;
}
} // namespace palpate
