#include "TouchRecording.h"

#include "TouchRecordingFormat.h"

#include <fstream>
#include <utility>

namespace palpate
{
namespace
{
using namespace TouchRecordingFormat;

// Reads the first `count` words of a record, little endian; false at the end of the file, or if it
// ends within them.
template <std::size_t Count>
bool ReadWords(std::istream& file, std::array<std::uint64_t, Count>& words,
               std::size_t count = Count)
{
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__);
  const auto bytes = static_cast<std::streamsize>(count * sizeof(std::uint64_t));
  file.read(reinterpret_cast<char*>(words.data()), bytes);
  return file.gcount() == bytes;
}

Status ReadTicks(const std::string& path, std::istream& file, bool isOld,
                 std::vector<TouchState>& ticks)
{
  TickRecord record{};
  while (ReadWords(file, record, isOld ? TickWords3 : TickWords))
  {
    record[FlagsWord] &= isOld ? ~SkippedFlags3 : ~std::uint64_t{0};
    TouchState state;
    if (!Decode(record, state))
    {
      return Status::Failure(path + " is damaged: its tick " + std::to_string(ticks.size()) +
                             " is invalid.");
    }
    if (state.Tick.Number != ticks.size())
    {
      return Status::Failure(path + " lacks ticks after number " + std::to_string(ticks.size()) +
                             ": the recorder did not keep up with the servo.");
    }
    ticks.push_back(state);
  }
  return Status::Success();
}
} // namespace

Status ReadTouchRecording(const std::string& path, TouchRecording& recording)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    return Status::Failure(path + " cannot be read.");
  }
  std::string magic(MagicSize, ' ');
  file.read(magic.data(), static_cast<std::streamsize>(magic.size()));
  SessionRecord session{};
  TouchRecording read;
  const bool isOld = magic == Magic3;
  if ((magic != Magic && !isOld) || !ReadWords(file, session) || !Decode(session, read.Session))
  {
    return Status::Failure(path + " is not a touch recording of version 3 or 4.");
  }
  Status status = ReadTicks(path, file, isOld, read.Ticks);
  if (status.IsOk())
  {
    read.WasCutOff = file.gcount() > 0;
    recording = std::move(read);
  }
  return status;
}
} // namespace palpate
