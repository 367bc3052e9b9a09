#include "FalconFirmware.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <utility>

namespace palpate
{
namespace
{
constexpr unsigned Key = 0x08AA;
constexpr std::size_t ReservedWords = 8;
constexpr std::size_t AddressWords = 2;
constexpr unsigned LargestAddress = 0x3FFFFF; // 22 bits

// Reads consecutive words; reading past the end sets a sticky error.
class Words
{
public:
  explicit Words(const std::vector<std::uint8_t>& bytes) : Bytes(bytes) {}

  unsigned Next()
  {
    this->Missing = this->Missing || this->Place + 2 > this->Bytes.size();
    const std::size_t at = this->Place;
    this->Place += 2;
    return this->Missing ? 0U : this->Bytes[at] | static_cast<unsigned>(this->Bytes[at + 1]) << 8U;
  }
  unsigned NextAddress()
  {
    const unsigned high = this->Next();
    return high << 16U | this->Next();
  }
  void Skip(std::size_t count) { this->Place += 2 * count; }
  bool IsMissing() const { return this->Missing; }
  bool IsAtEnd() const { return this->Place == this->Bytes.size(); }

private:
  const std::vector<std::uint8_t>& Bytes;
  std::size_t Place = 0;
  bool Missing = false;
};

// Error of a stream; null if it is valid.
const char* FaultOf(const std::vector<std::uint8_t>& bytes)
{
  Words words(bytes);
  if (words.Next() != Key)
  {
    return "does not begin with the key 0x08AA";
  }
  for (std::size_t i = 0; i < ReservedWords; ++i)
  {
    if (words.Next() != 0)
    {
      return "has reserved words that are not 0";
    }
  }
  if (words.NextAddress() > LargestAddress)
  {
    return "starts at an address that the processor does not have";
  }
  int blocks = 0;
  for (unsigned size = words.Next(); size != 0; size = words.Next())
  {
    ++blocks;
    const unsigned destination = words.NextAddress();
    if (destination > LargestAddress || size - 1 > LargestAddress - destination)
    {
      return "loads to an address that the processor does not have";
    }
    words.Skip(size);
  }
  if (words.IsMissing())
  {
    return "ends too early";
  }
  if (!words.IsAtEnd())
  {
    return "goes on after its end";
  }
  return blocks == 0 ? "loads nothing" : nullptr;
}
} // namespace

Status FalconFirmware::Parse(std::vector<std::uint8_t> bytes, const std::string& name,
                             FalconFirmware& firmware)
{
  const char* const fault =
      bytes.size() > LargestSize ? "is larger than the processor's memory" : FaultOf(bytes);
  if (fault != nullptr)
  {
    return Status::Failure(name + " is not a Falcon's firmware: it " + fault + ".");
  }
  firmware.Label = name;
  firmware.Image = std::move(bytes);
  return Status::Success();
}

Status FalconFirmware::Read(const std::string& path, FalconFirmware& firmware)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    return Status::Failure(path + ", the Falcon's firmware, cannot be opened.");
  }
  std::vector<char> content(LargestSize + 1);
  stream.read(content.data(), static_cast<std::streamsize>(content.size()));
  if (stream.bad() || stream.gcount() == 0)
  {
    return Status::Failure(path + ", the Falcon's firmware, cannot be read.");
  }
  return Parse({content.begin(), content.begin() + stream.gcount()}, path, firmware);
}

std::string FalconFirmware::PathOf(const std::string& chosen)
{
  const char* const named = chosen.empty() ? std::getenv("PALPATE_FALCON_FIRMWARE") : nullptr;
  return named != nullptr ? named : chosen;
}
} // namespace palpate
