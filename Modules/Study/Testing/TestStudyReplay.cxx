#include "StudyReplay.h"

#include "InputError.h"
#include "ManualClock.h"
#include "RandomShapes.h"
#include "TemporaryFolder.h"
#include "TouchRecorder.h"
#include "TouchRecording.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::study_replay_test
{
namespace
{
constexpr std::int64_t Second = 1'000'000'000;
constexpr std::int64_t Period = 1'000'000;

// Ticks numbered by their x, 1 to 1.5 ms apart.
std::vector<TouchState> Ticks(std::size_t count)
{
  test::Random random(1120);
  std::vector<TouchState> ticks(count);
  std::int64_t time = 17 * Second;
  for (std::size_t n = 0; n < count; ++n)
  {
    ticks[n].Tick.Number = n;
    ticks[n].Tick.Scheduled = time;
    ticks[n].Tick.Started = time;
    ticks[n].ProbeWorld.X = static_cast<double>(n);
    time += Period + static_cast<std::int64_t>(random() % (Period / 2));
  }
  return ticks;
}

class StudyReplayTest : public testing::Test
{
protected:
  StudyReplay Replay(const std::vector<TouchState>& ticks)
  {
    auto recording = std::make_shared<TouchRecording>();
    recording->Ticks = ticks;
    return {"session.touch", recording, this->Time};
  }
  std::filesystem::path Write(const std::vector<TouchState>& ticks)
  {
    const auto file = this->Folder / "session.touch";
    TouchRecorder recorder;
    EXPECT_TRUE(recorder.Start(file.string(), {}).IsOk());
    for (const TouchState& tick : ticks)
    {
      EXPECT_TRUE(recorder.Take(tick).IsOk());
    }
    EXPECT_TRUE(recorder.Finish().IsOk());
    return file;
  }
  // Reference that searches all ticks.
  static std::size_t Slow(const std::vector<TouchState>& ticks, double seconds)
  {
    std::size_t found = 0;
    for (std::size_t n = 0; n < ticks.size(); ++n)
    {
      const auto began = ticks[n].Tick.Started - ticks.front().Tick.Started;
      found = static_cast<double>(began) <= 1e9 * seconds + 0.5 ? n : found;
    }
    return found;
  }

  const test::TemporaryFolder Folder;
  ManualClock Time{5};
};

TEST_F(StudyReplayTest, PositionHasTheLastStartedTick)
{
  const auto ticks = Ticks(3000);
  StudyReplay replay = this->Replay(ticks);
  EXPECT_EQ(replay.Poll({}).Newest.Tick.Number, 0U);
  test::Random random(7);
  std::uniform_real_distribution<double> uniform(0.0, replay.Duration());
  for (int n = 0; n < 300; ++n)
  {
    const double moment = uniform(random);
    replay.MoveTo(moment);
    EXPECT_EQ(replay.Position(), moment);
    const StudyTouchReading& reading = replay.Poll({});
    EXPECT_EQ(reading.Newest.Tick.Number, Slow(ticks, moment)) << moment;
    EXPECT_EQ(reading.NewTicks.back().Tick.Number, reading.Newest.Tick.Number);
  }
  replay.MoveTo(replay.Duration());
  EXPECT_EQ(replay.Poll({}).Newest.Tick.Number, ticks.size() - 1);
}

TEST_F(StudyReplayTest, PlaysEveryTickOnceAndStopsAtTheEnd)
{
  const auto ticks = Ticks(2000);
  StudyReplay replay = this->Replay(ticks);
  replay.SetSpeed(2.0);
  replay.Play();
  std::vector<TouchState> shown;
  while (replay.IsPlaying())
  {
    const double before = replay.Position();
    const auto& fresh = replay.Poll({}).NewTicks;
    shown.insert(shown.end(), fresh.begin(), fresh.end());
    this->Time.Advance(16 * Period);
    // A few roundings of seconds.
    EXPECT_LE(replay.Position(), before + 2.0 * 0.016 + 1e-12);
  }
  ASSERT_EQ(shown.size(), ticks.size());
  for (std::size_t n = 0; n < shown.size(); ++n)
  {
    EXPECT_EQ(shown[n].Tick.Number, n);
  }
  EXPECT_EQ(replay.Position(), replay.Duration());
  EXPECT_TRUE(replay.Poll({}).NewTicks.empty());
  replay.Play();
  EXPECT_EQ(replay.Position(), 0.0) << "from the beginning";
}

TEST_F(StudyReplayTest, PauseHoldsThePosition)
{
  StudyReplay replay = this->Replay(Ticks(2000));
  replay.Play();
  this->Time.Advance(Second / 2);
  EXPECT_NEAR(replay.Position(), 0.5, 1e-12); // a few roundings
  replay.Pause();
  const double stands = replay.Position();
  this->Time.Advance(Second);
  EXPECT_EQ(replay.Position(), stands);
  replay.SetSpeed(100.0);
  EXPECT_EQ(replay.Position(), stands);
  replay.MoveTo(0.25);
  EXPECT_FALSE(replay.IsPlaying());
  EXPECT_EQ(replay.Position(), 0.25);
}

// For any length of the recording, only the shown ticks are read.
TEST_F(StudyReplayTest, JumpReadsTheSecondsBefore)
{
  const auto ticks = Ticks(20000);
  StudyReplay replay = this->Replay(ticks);
  for (const double moment : {12.0, 3.0, 24.0, 23.0})
  {
    replay.MoveTo(moment);
    const auto& shown = replay.Poll({}).NewTicks;
    const double from = std::max(0.0, moment - StudyReplay::SecondsBefore);
    EXPECT_EQ(shown.front().Tick.Number, Slow(ticks, from)) << moment;
    EXPECT_EQ(shown.back().Tick.Number, Slow(ticks, moment)) << moment;
  }
  // A stall during playing is a jump too.
  replay.Play();
  replay.SetSpeed(StudyReplay::LargestSpeed);
  replay.MoveTo(0.0);
  replay.Poll({});
  this->Time.Advance(Second / 5);
  const auto& shown = replay.Poll({}).NewTicks;
  EXPECT_EQ(shown.front().Tick.Number, Slow(ticks, 20.0 - StudyReplay::SecondsBefore));
}

TEST_F(StudyReplayTest, IdentifiesStructuresByLabel)
{
  auto ticks = Ticks(3);
  ticks[1].Structure = 1;
  ticks[2].Structure = 5;
  StudyReplay replay = this->Replay(ticks);
  EXPECT_EQ(replay.Poll({30, 40}).TouchedId, 0);
  replay.MoveTo(1.6e-3);
  EXPECT_EQ(replay.Poll({30, 40}).TouchedId, 40);
  replay.MoveTo(1.0);
  EXPECT_EQ(replay.Poll({30, 40}).TouchedId, 0) << "not in the study";
}

TEST_F(StudyReplayTest, IgnoresNan)
{
  constexpr double None = std::numeric_limits<double>::quiet_NaN();
  StudyReplay replay = this->Replay(Ticks(100));
  replay.MoveTo(0.05);
  replay.MoveTo(None);
  replay.SetSpeed(None);
  EXPECT_EQ(replay.Position(), 0.05);
  EXPECT_EQ(replay.Speed(), 1.0);
  replay.MoveTo(-1.0);
  EXPECT_EQ(replay.Position(), 0.0);
  replay.MoveTo(1e300);
  EXPECT_EQ(replay.Position(), replay.Duration());
  replay.SetSpeed(-3.0);
  EXPECT_EQ(replay.Speed(), StudyReplay::LeastSpeed);
}

TEST_F(StudyReplayTest, ShowsASingleTick)
{
  StudyReplay replay = this->Replay(Ticks(1));
  EXPECT_EQ(replay.Duration(), 0.0);
  EXPECT_EQ(replay.Poll({}).NewTicks.size(), 1U);
  replay.Play();
  EXPECT_EQ(replay.Poll({}).Newest.Tick.Number, 0U);
  EXPECT_FALSE(replay.IsPlaying());
}

TEST_F(StudyReplayTest, ReadsRecordings)
{
  const auto ticks = Ticks(50);
  const auto read = ReadReplay(this->Write(ticks));
  ASSERT_EQ(read->Ticks.size(), ticks.size());
  EXPECT_EQ(read->Ticks.back().ProbeWorld.X, ticks.back().ProbeWorld.X);
}

TEST_F(StudyReplayTest, RejectsMalformedRecordings)
{
  EXPECT_THROW(static_cast<void>(ReadReplay(this->Folder / "absent.touch")), InputError);
  EXPECT_THROW(static_cast<void>(ReadReplay(this->Write({}))), InputError);
  auto ticks = Ticks(10);
  ticks[5].Tick.Started = ticks[3].Tick.Started;
  try
  {
    static_cast<void>(ReadReplay(this->Write(ticks)));
    ADD_FAILURE();
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("backwards"), std::string::npos) << error.what();
  }
}
} // namespace
} // namespace palpate::study_replay_test
