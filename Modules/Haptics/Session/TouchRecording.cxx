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

bool ReadSession(std::istream& file, bool hasMotorsWord, RecordedSession& session)
{
  SessionRecord record{};
  record.back() = 1; // motors
  return ReadWords(file, record, hasMotorsWord ? SessionWords : SessionWords4) &&
         Decode(record, session);
}

Status ReadTicks(const std::string& path, std::istream& file, bool isVersion3,
                 std::vector<TouchState>& ticks)
{
  TickRecord record{};
  while (ReadWords(file, record, isVersion3 ? TickWords3 : TickWords))
  {
    record[FlagsWord] &= isVersion3 ? ~SkippedFlags3 : ~std::uint64_t{0};
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
  TouchRecording read;
  const bool isKnown = magic == Magic || magic == Magic4 || magic == Magic3;
  if (!isKnown || !ReadSession(file, magic == Magic, read.Session))
  {
    return Status::Failure(path + " is not a touch recording of version 3, 4 or 5.");
  }
  Status status = ReadTicks(path, file, magic == Magic3, read.Ticks);
  if (status.IsOk())
  {
    read.WasCutOff = file.gcount() > 0;
    recording = std::move(read);
  }
  return status;
}
} // namespace palpate
