#include "TouchRecording.h"

#include "TouchRecordingFormat.h"

#include <algorithm>
#include <array>
#include <cstdint>
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

struct Version
{
  const char* Begins;
  std::size_t SessionCount;
  std::size_t TickCount;
  std::uint64_t SkippedFlags;
};
constexpr std::array<Version, 4> Versions{{{Magic, SessionWords, TickWords, 0},
                                           {Magic5, SessionWords5, TickWords5, 0},
                                           {Magic4, SessionWords4, TickWords5, 0},
                                           {Magic3, SessionWords4, TickWords3, SkippedFlags3}}};

// What an older version does not have is as in a state that was just made; all devices have motors.
bool ReadSession(std::istream& file, const Version& version, RecordedSession& session)
{
  SessionRecord record = Encode(RecordedSession());
  return ReadWords(file, record, version.SessionCount) && Decode(record, session);
}

Status ReadTicks(const std::string& path, std::istream& file, const Version& version,
                 std::vector<TouchState>& ticks)
{
  TickRecord record = Encode(TouchState());
  while (ReadWords(file, record, version.TickCount))
  {
    record[FlagsWord] &= ~version.SkippedFlags;
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
  const auto* const version =
      std::find_if(Versions.begin(), Versions.end(),
                   [&](const Version& known) { return magic == known.Begins; });
  if (version == Versions.end() || !ReadSession(file, *version, read.Session))
  {
    return Status::Failure(path + " is not a touch recording of version 3, 4, 5 or 6.");
  }
  Status status = ReadTicks(path, file, *version, read.Ticks);
  if (status.IsOk())
  {
    read.WasCutOff = file.gcount() > 0;
    read.HasTorques = version == Versions.begin();
    recording = std::move(read);
  }
  return status;
}
} // namespace palpate
