#include "TouchRecording.h"

#include "RecordedSession.h"
#include "TemporaryFolder.h"
#include "TouchRecordingFormat.h"

#include <fstream>
#include <limits>
#include <random>

namespace palpate::touch_recording_test
{
namespace
{
class TouchRecordingFile : public testing::Test
{
protected:
  void SetUp() override
  {
    test::RecordSession(this->Path, 400);
    std::ifstream file(this->Path, std::ios::binary);
    this->Bytes.assign(std::istreambuf_iterator<char>(file), {});
  }
  // Writes the bytes and reads them as a recording.
  Status ReadBytes()
  {
    std::ofstream(this->Path, std::ios::binary | std::ios::trunc) << this->Bytes;
    return ReadTouchRecording(this->Path, this->Recording);
  }

  // The bytes of 400 ticks as an older version has them: without the last words of session and
  // tick.
  void MakeOlder(char version, std::size_t sessionWords, std::size_t tickWords)
  {
    const std::size_t tick = 8 * TouchRecordingFormat::TickWords;
    const std::size_t first = this->Bytes.size() - 400 * tick;
    std::string old = this->Bytes.substr(0, TouchRecordingFormat::MagicSize + 8 * sessionWords);
    for (std::size_t at = first; at < this->Bytes.size(); at += tick)
    {
      old += this->Bytes.substr(at, 8 * tickWords);
    }
    old[24] = version;
    this->Bytes = old;
  }
  // Whose words that the older version lacks are as they were made.
  void ExpectTicksOf(const TouchRecording& newest)
  {
    ASSERT_TRUE(this->ReadBytes().IsOk());
    ASSERT_EQ(this->Recording.Ticks.size(), newest.Ticks.size());
    for (std::size_t n = 0; n < newest.Ticks.size(); ++n)
    {
      ASSERT_EQ(TouchRecordingFormat::Encode(this->Recording.Ticks[n]),
                TouchRecordingFormat::Encode(newest.Ticks[n]));
    }
  }

  test::TemporaryFolder Folder;
  std::string Path = (Folder / "session.touch").string();
  std::string Bytes;
  TouchRecording Recording;
};

TEST(TouchRecordingFormat, TicksRoundTripBitForBit)
{
  std::mt19937_64 random(5);
  for (int n = 0; n < 1000; ++n)
  {
    TouchRecordingFormat::TickRecord words{};
    for (std::uint64_t& word : words)
    {
      word = random();
    }
    words[5] &= 0xffff;      // sixteen flags
    words[6] %= 5;           // states
    words[7] %= 10;          // faults
    words[16] &= 0xffffffff; // buttons
    words[31] %= 1'000'000;  // structure
    words[34] %= 5;          // commands
    TouchState state;
    ASSERT_TRUE(TouchRecordingFormat::Decode(words, state));
    ASSERT_EQ(TouchRecordingFormat::Encode(state), words);
  }
}

TEST(TouchRecordingFormat, SessionKeepsSampleRate)
{
  RecordedSession session;
  session.Device.Rate = 1000.0;
  session.Device.LongestGap = 0.008;
  RecordedSession read;
  ASSERT_TRUE(TouchRecordingFormat::Decode(TouchRecordingFormat::Encode(session), read));
  EXPECT_EQ(read.Device.LeastRate(), session.Device.LeastRate());
}

TEST(TouchRecordingFormat, SessionKeepsWhetherThereAreMotors)
{
  for (const bool hasMotors : {true, false})
  {
    RecordedSession session;
    session.Device.HasMotors = hasMotors;
    RecordedSession read;
    ASSERT_TRUE(TouchRecordingFormat::Decode(TouchRecordingFormat::Encode(session), read));
    EXPECT_EQ(read.Device.HasMotors, hasMotors);
  }
}

TEST(TouchRecordingFormat, RejectsInvalidTick)
{
  const TouchRecordingFormat::TickRecord good = TouchRecordingFormat::Encode(TouchState());
  TouchState state;
  ASSERT_TRUE(TouchRecordingFormat::Decode(good, state));
  const std::pair<std::size_t, std::uint64_t> bad[] = {
      {5, 0x10000}, {6, 5}, {7, 11}, {16, std::uint64_t{1} << 32}, {31, std::uint64_t{1} << 40},
      {34, 5}};
  for (const auto& [word, value] : bad)
  {
    TouchRecordingFormat::TickRecord words = good;
    words[word] = value;
    EXPECT_FALSE(TouchRecordingFormat::Decode(words, state)) << word;
  }
}

TEST_F(TouchRecordingFile, HoldsAllTicksAndSession)
{
  ASSERT_TRUE(ReadTouchRecording(this->Path, this->Recording).IsOk());
  ASSERT_EQ(this->Recording.Ticks.size(), 400u);
  EXPECT_EQ(this->Recording.Session.Settings.Rate, 1000.0);
  EXPECT_EQ(this->Recording.Session.Device.MaximumForce, 8.0);
  // 3.3 ms after tick 99, which was 1 ms before tick 100 was due.
  EXPECT_EQ(this->Recording.Ticks[100].Tick.SkippedPeriods, 2u);
  EXPECT_EQ(this->Recording.Ticks[205].Safety.Fault, SafetyFault::NonFinitePosition);
  EXPECT_TRUE(this->Recording.Ticks[210].WasRearmed);
  EXPECT_EQ(this->Recording.Ticks[399].Scene, 2u);
  EXPECT_EQ(this->Folder.EntryCount(), 1u); // nothing temporary is left
}

TEST_F(TouchRecordingFile, TruncatedFileKeepsWholeTicks)
{
  constexpr std::size_t Tick = 8 * TouchRecordingFormat::TickWords;
  const std::string whole = this->Bytes;
  const std::size_t head = whole.size() - 400 * Tick;
  for (std::size_t cut = 1; cut < whole.size(); cut += 97)
  {
    this->Bytes = whole.substr(0, whole.size() - cut);
    this->Recording = TouchRecording();
    ASSERT_EQ(this->ReadBytes().IsOk(), this->Bytes.size() >= head) << cut;
    if (this->Bytes.size() >= head)
    {
      ASSERT_EQ(this->Recording.Ticks.size(), (this->Bytes.size() - head) / Tick);
      ASSERT_EQ(this->Recording.WasCutOff, (this->Bytes.size() - head) % Tick != 0);
    }
  }
}

TEST_F(TouchRecordingFile, RejectsOtherFormatOrVersion)
{
  for (const char version : {'1', '2', '7'})
  {
    this->Bytes[24] = version;
    EXPECT_EQ(this->ReadBytes().Message(),
              this->Path + " is not a touch recording of version 3, 4, 5 or 6.");
  }
  this->Bytes = "";
  EXPECT_FALSE(this->ReadBytes().IsOk());
  EXPECT_EQ(ReadTouchRecording(this->Path + "x", this->Recording).Message(),
            this->Path + "x cannot be read.");
}

// Version 3 has a number in the upper bits of each tick's flags.
TEST_F(TouchRecordingFile, ReadsVersion3WithoutItsUpperFlags)
{
  ASSERT_TRUE(this->ReadBytes().IsOk());
  const TouchRecording newest = this->Recording;
  const std::size_t tick = 8 * TouchRecordingFormat::TickWords;
  const std::size_t first = this->Bytes.size() - newest.Ticks.size() * tick;
  for (std::size_t at = first; at < this->Bytes.size(); at += tick)
  {
    this->Bytes[at + 8 * TouchRecordingFormat::FlagsWord + 6] = 1;
    this->Bytes[at + 8 * TouchRecordingFormat::FlagsWord + 7] = 2;
  }
  EXPECT_FALSE(this->ReadBytes().IsOk()) << "newer versions have no such flags";
  this->MakeOlder('3', TouchRecordingFormat::SessionWords4, TouchRecordingFormat::TickWords3);
  this->ExpectTicksOf(newest);
}

// Version 4 does not tell whether there are motors; then no fault ended by itself.
TEST_F(TouchRecordingFile, DevicesOfVersion4HaveMotors)
{
  const std::size_t head =
      TouchRecordingFormat::MagicSize + 8 * TouchRecordingFormat::SessionWords4;
  this->Bytes[head] = 0;
  ASSERT_TRUE(this->ReadBytes().IsOk());
  const TouchRecording newest = this->Recording;
  EXPECT_FALSE(newest.Session.Device.HasMotors);
  this->MakeOlder('4', TouchRecordingFormat::SessionWords4, TouchRecordingFormat::TickWords5);
  this->ExpectTicksOf(newest);
  EXPECT_TRUE(this->Recording.Session.Device.HasMotors);
}

TEST_F(TouchRecordingFile, DevicesOfVersion5ShowNoTorque)
{
  ASSERT_TRUE(this->ReadBytes().IsOk());
  const TouchRecording newest = this->Recording;
  this->MakeOlder('5', TouchRecordingFormat::SessionWords5, TouchRecordingFormat::TickWords5);
  this->ExpectTicksOf(newest);
  EXPECT_EQ(this->Recording.Session.Device.MaximumTorque, 0.0);
}

TEST_F(TouchRecordingFile, ThatLacksATickIsRefused)
{
  const std::size_t tick = 8 * TouchRecordingFormat::TickWords;
  this->Bytes.erase(this->Bytes.size() - 2 * tick, tick);
  EXPECT_NE(this->ReadBytes().Message().find("lacks ticks"), std::string::npos);
  EXPECT_TRUE(this->Recording.Ticks.empty());
}

} // namespace
} // namespace palpate::touch_recording_test
