#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// An OpenIGTLink message without its headers and metadata.
struct IgtlMessage
{
  std::string Type; ///< TRANSFORM, IMAGE, ...
  std::string Name; ///< the sender's name of what it tells about
  std::vector<std::uint8_t> Content;
};

/// Finds messages in a stream of OpenIGTLink, of which it may get any number of bytes at a time.
/// Those of other types and those that are too long are skipped without being kept; so are damaged
/// ones (CRC, lengths). No more memory is used than bytes have arrived. Source: OpenIGTLink
/// protocol 1 to 3, header, extended header and metadata.
class IgtlParser
{
public:
  struct Kind
  {
    std::string Type;
    std::uint64_t MostBytes; ///< of a body, with extended header and metadata
  };

  explicit IgtlParser(std::vector<Kind> wanted) : Wanted(std::move(wanted)) {}

  /// Returns false if what arrives cannot be OpenIGTLink: nothing after it can be understood.
  bool Take(const std::uint8_t* bytes, std::size_t count);
  /// The oldest message that is complete; none if there is none.
  std::optional<IgtlMessage> Next();
  std::uint64_t Damaged() const noexcept { return this->DamagedCount; }
  /// Messages of wanted types that are too long, counted when their header has arrived.
  std::uint64_t TooLong() const noexcept { return this->TooLongCount; }

private:
  bool BeginMessage();
  void EndMessage();

  std::vector<Kind> Wanted;
  std::vector<std::uint8_t> Header;
  std::vector<std::uint8_t> Body;
  std::uint64_t BodyLeft = 0; ///< bytes still to come
  bool HasHeader = false;
  bool IsKept = false;
  std::deque<IgtlMessage> Complete;
  std::uint64_t DamagedCount = 0;
  std::uint64_t TooLongCount = 0;
};
} // namespace palpate
