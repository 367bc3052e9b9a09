#include "DeviceTargets.h"

#include "BinaryFields.h"
#include "BootStream.h"
#include "EncoderScreen.h"
#include "FalconCalibration.h"
#include "FalconFirmware.h"
#include "FalconReplyParser.h"
#include "FtdiPackets.h"
#include "Refusal.h"
#include "TextMutator.h"
#include "TouchRecording.h"
#include "TouchRecordingFormat.h"

#include <algorithm>
#include <cstring>

namespace palpate::test
{
namespace
{
using namespace TouchRecordingFormat;

template <std::size_t Count>
void Append(std::string& bytes, const std::array<std::uint64_t, Count>& words)
{
  for (const std::uint64_t word : words)
  {
    for (std::size_t byte = 0; byte < 8; ++byte)
    {
      bytes += static_cast<char>(word >> 8 * byte & 255);
    }
  }
}

std::string RecordingSeed()
{
  constexpr std::uint64_t Ticks = 20;
  std::string bytes(Magic, MagicSize);
  Append(bytes, Encode(RecordedSession()));
  for (std::uint64_t n = 0; n < Ticks; ++n)
  {
    TouchState state;
    state.Tick.Number = n;
    state.HasSample = true;
    Append(bytes, Encode(state));
  }
  return bytes;
}

Mutator RecordingMutator()
{
  std::vector<BinaryField> words = FieldsFrom(MagicSize, SessionWords + 2 * TickWords, 8);
  for (const BinaryField& real : FieldsFrom(MagicSize, SessionWords, 8, BinaryField::Type::Real))
  {
    words.push_back(real);
  }
  return OneOf({FieldMutator(words), FieldMutator(words), MutateBytes});
}

// As sent by an FTDI chip: packets of 64 bytes that begin with two bytes of status.
std::string ReplySeed()
{
  std::string stream;
  for (int reply = 0; reply < 20; ++reply)
  {
    stream += "<" + std::string(14, static_cast<char>('A' + reply % 16)) + ">";
  }
  constexpr std::size_t Payload = FtdiPackets::PacketSize - FtdiPackets::StatusSize;
  std::string bytes;
  for (std::size_t place = 0; place < stream.size(); place += Payload)
  {
    bytes += "\x11\x60" + stream.substr(place, Payload);
  }
  return bytes;
}

// Processes USB transfers of 512 bytes.
void ReadReplies(const std::string& bytes)
{
  constexpr std::size_t Transfer = 512;
  FtdiPackets packets;
  FalconReplyParser parser;
  EncoderScreen screen;
  FalconReply reply;
  std::int64_t time = 0;
  for (std::size_t place = 0; place < bytes.size(); place += Transfer)
  {
    const std::size_t count = std::min(Transfer, bytes.size() - place);
    // Exactly this size, so that AddressSanitizer detects access to the next byte.
    std::vector<std::uint8_t> transfer(count);
    std::memcpy(transfer.data(), bytes.data() + place, count);
    const std::size_t length = packets.Strip(transfer.data(), count, transfer.data());
    for (std::size_t i = 0; i < length; ++i)
    {
      if (parser.Take(transfer[i], reply))
      {
        screen.Believes(reply.Counts, time += 1'000'000);
      }
    }
  }
}

constexpr char CalibrationSeed[] =
    "palpate-falcon-calibration 1\n# measured\nthigh 60\nshin 102.5\nplatform-tangential -25\n"
    "home-angle-1 35\nangle-per-count 0.0364\nhighest-angle 100\ncarried-mass 0.09\n";

std::string FirmwareSeed()
{
  const std::vector<std::uint8_t> stream = BootStream();
  return {stream.begin(), stream.end()};
}

FuzzTarget StatusTarget(const std::string& name, const std::string& fileName, std::string seed,
                        Mutator mutate, Status (*read)(const std::string& path))
{
  return {name, fileName, [text = std::move(seed)] { return std::vector<std::string>{text}; },
          std::move(mutate),
          [fileName, read]
          {
            return FileReader(fileName, [read](const std::filesystem::path& file)
                              { RequireInput(read(file.string())); });
          }};
}
} // namespace

std::vector<FuzzTarget> DeviceTargets()
{
  // Key, reserved words, entry address, and the headers of the first two blocks of the seed.
  std::vector<BinaryField> words = FieldsFrom(0, 16, 2);
  for (const std::size_t block : {std::size_t{22}, std::size_t{22 + 6 + 134}})
  {
    const auto more = FieldsFrom(block, 3, 2);
    words.insert(words.end(), more.begin(), more.end());
  }
  return {StatusTarget("touch-recording", "a.touch", RecordingSeed(), RecordingMutator(),
                       [](const std::string& path)
                       {
                         TouchRecording recording;
                         return ReadTouchRecording(path, recording);
                       }),
          StatusTarget("falcon-firmware", "a.bin", FirmwareSeed(),
                       OneOf({FieldMutator(words), MutateBytes}),
                       [](const std::string& path)
                       {
                         FalconFirmware firmware;
                         return FalconFirmware::Read(path, firmware);
                       }),
          StatusTarget("falcon-calibration", "a.txt", CalibrationSeed,
                       OneOf({TextMutator({}), MutateBytes}),
                       [](const std::string& path)
                       {
                         FalconCalibration calibration;
                         return ReadCalibration(path, calibration);
                       }),
          {"falcon-replies", "a.bin", [] { return std::vector<std::string>{ReplySeed()}; },
           OneOf({TextMutator({{"<", ">", "A", "\x11\x60"}, {{"<", ">"}}, ""}), MutateBytes}),
           [] { return InputReader(ReadReplies); }}};
}
} // namespace palpate::test
