#include "FileSizeLimit.h"
#include "RecordedSession.h"
#include "TemporaryFolder.h"
#include "TouchRecordingFormat.h"

#include <chrono>
#include <condition_variable>
#include <gtest/gtest.h>
#include <mutex>
#include <thread>

// Contents of the disk during a recording, and after failures.

namespace palpate::touch_recorder_test
{
namespace
{
constexpr std::size_t TickBytes = 8 * TouchRecordingFormat::TickWords;

/// A recording of empty ticks in a folder of its own.
class TouchRecorderTest : public testing::Test
{
protected:
  Status Start(TouchRecorder& recorder)
  {
    RecordedSession session;
    session.Settings.Rate = 1000.0;
    return recorder.Start(this->Path(), session);
  }
  std::string Path() const { return (this->Folder / "session.touch").string(); }
  /// The first failure, or success.
  static Status Take(TouchRecorder& recorder, std::uint64_t count, std::uint64_t first = 0)
  {
    Status status = Status::Success();
    TouchState state;
    for (std::uint64_t n = first; n < first + count && status.IsOk(); ++n)
    {
      state.Tick.Number = n;
      status = recorder.Take(state);
    }
    return status;
  }
  /// The one file whose name ends with .part.
  std::filesystem::path Part() const
  {
    std::filesystem::path part;
    for (const auto& entry : std::filesystem::directory_iterator(this->Folder.Path()))
    {
      const bool isPart = entry.path().extension() == ".part";
      EXPECT_TRUE(part.empty() || !isPart) << "several parts";
      part = isPart ? entry.path() : part;
    }
    return part;
  }
  static std::size_t TicksIn(const std::filesystem::path& file)
  {
    TouchRecording recording;
    const Status status = ReadTouchRecording(file.string(), recording);
    EXPECT_FALSE(recording.WasCutOff);
    return status.IsOk() ? recording.Ticks.size() : 0;
  }

  test::TemporaryFolder Folder;
};

// As if the program had died: the part is read while it is being written.
TEST_F(TouchRecorderTest, FlushedTicksSurviveProgramDeath)
{
  TouchRecorder recorder;
  ASSERT_TRUE(this->Start(recorder).IsOk());
  ASSERT_TRUE(this->Take(recorder, 1000).IsOk());
  const std::uintmax_t flushed = 768 * TickBytes;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (std::filesystem::file_size(this->Part()) < flushed &&
         std::chrono::steady_clock::now() < end)
  {
    std::this_thread::yield();
  }
  TouchRecording left;
  ASSERT_TRUE(ReadTouchRecording(this->Part().string(), left).IsOk());
  EXPECT_GE(left.Ticks.size(), 768U);
}

TEST_F(TouchRecorderTest, EmptyRecordingLeavesNothing)
{
  {
    TouchRecorder recorder;
    ASSERT_TRUE(this->Start(recorder).IsOk());
    EXPECT_FALSE(recorder.Start((this->Folder / "other").string(), RecordedSession()).IsOk());
    EXPECT_EQ(this->Folder.EntryCount(), 1U);
  }
  EXPECT_EQ(this->Folder.EntryCount(), 0U);
}

TEST_F(TouchRecorderTest, KeepsAbandonedRecordingAsPart)
{
  {
    TouchRecorder recorder;
    ASSERT_TRUE(this->Start(recorder).IsOk());
    ASSERT_TRUE(this->Take(recorder, 300).IsOk());
  }
  EXPECT_EQ(this->Folder.EntryCount(), 1U);
  EXPECT_EQ(this->TicksIn(this->Part()), 300U);
}

TEST_F(TouchRecorderTest, DoesNotFollowPlantedLink)
{
  test::WriteAll(this->Folder / "victim", "untouched");
  std::filesystem::create_symlink("victim", this->Folder / "session.touch.part");
  TouchRecorder recorder;
  ASSERT_TRUE(this->Start(recorder).IsOk());
  ASSERT_TRUE(this->Take(recorder, 10).IsOk());
  ASSERT_TRUE(recorder.Finish().IsOk());
  EXPECT_EQ(test::ReadAll(this->Folder / "victim"), "untouched");
  EXPECT_TRUE(std::filesystem::is_symlink(this->Folder / "session.touch.part"));
  EXPECT_EQ(this->TicksIn(this->Path()), 10U);
}

TEST_F(TouchRecorderTest, ReplacesLinkOfItsNameAndNotTheTarget)
{
  test::WriteAll(this->Folder / "victim", "untouched");
  std::filesystem::create_symlink("victim", this->Path());
  TouchRecorder recorder;
  ASSERT_TRUE(this->Start(recorder).IsOk());
  ASSERT_TRUE(this->Take(recorder, 10).IsOk());
  ASSERT_TRUE(recorder.Finish().IsOk());
  EXPECT_EQ(test::ReadAll(this->Folder / "victim"), "untouched");
  EXPECT_FALSE(std::filesystem::is_symlink(this->Path()));
  EXPECT_EQ(this->TicksIn(this->Path()), 10U);
}

TEST_F(TouchRecorderTest, RefusesSecondRecorderOfSameName)
{
  TouchRecorder first;
  TouchRecorder second;
  ASSERT_TRUE(this->Start(first).IsOk());
  ASSERT_TRUE(this->Take(first, 300).IsOk());
  const std::string message = this->Start(second).Message();
  EXPECT_EQ(message, this->Path() +
                         " is already being recorded; end that session or choose another output.");
  ASSERT_TRUE(this->Take(first, 300, 300).IsOk());
  ASSERT_TRUE(first.Finish().IsOk());
  EXPECT_EQ(this->TicksIn(this->Path()), 600U);
  EXPECT_EQ(this->Folder.EntryCount(), 1U);
  EXPECT_TRUE(this->Start(second).IsOk()) << "the name is free again";
}

TEST_F(TouchRecorderTest, IgnoresPartOfDeadProgram)
{
  test::WriteAll(this->Folder / "session.touch.123.part", "of a program that died");
  TouchRecorder recorder;
  ASSERT_TRUE(this->Start(recorder).IsOk());
  ASSERT_TRUE(this->Take(recorder, 10).IsOk());
  ASSERT_TRUE(recorder.Finish().IsOk());
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "session.touch.123.part"));
}

TEST_F(TouchRecorderTest, RecordersOfDifferentNamesCoexist)
{
  TouchRecorder first;
  TouchRecorder second;
  ASSERT_TRUE(this->Start(first).IsOk());
  ASSERT_TRUE(second.Start((this->Folder / "other.touch").string(), RecordedSession()).IsOk());
  ASSERT_TRUE(this->Take(first, 10).IsOk());
  ASSERT_TRUE(this->Take(second, 20).IsOk());
  ASSERT_TRUE(first.Finish().IsOk());
  ASSERT_TRUE(second.Finish().IsOk());
  EXPECT_EQ(this->TicksIn(this->Path()), 10U);
  EXPECT_EQ(this->TicksIn(this->Folder / "other.touch"), 20U);
}

TEST_F(TouchRecorderTest, FullDiskKeepsWholeTicks)
{
  test::WriteAll(this->Path(), "an earlier recording");
  TouchRecorder recorder;
  ASSERT_TRUE(this->Start(recorder).IsOk());
  Status status = Status::Success();
  {
    const test::FileSizeLimit full(300'000); // within tick 749
    status = this->Take(recorder, 5000);
    status = status.IsOk() ? recorder.Finish() : status;
  }
  ASSERT_FALSE(status.IsOk());
  EXPECT_EQ(this->TicksIn(this->Part()), 749U);
  EXPECT_NE(status.Message().find("0.749 s (749 ticks)"), std::string::npos) << status.Message();
  EXPECT_NE(status.Message().find("File too large"), std::string::npos) << status.Message();
  EXPECT_NE(status.Message().find(this->Part().string()), std::string::npos) << status.Message();
  EXPECT_EQ(test::ReadAll(this->Path()), "an earlier recording");
}

TEST_F(TouchRecorderTest, InitiallyFullDiskLeavesNothing)
{
  const test::FileSizeLimit full(64);
  TouchRecorder recorder;
  ASSERT_TRUE(this->Start(recorder).IsOk());
  Status status = this->Take(recorder, 100);
  status = status.IsOk() ? recorder.Finish() : status;
  EXPECT_EQ(status.Message(),
            this->Path() + " could not be recorded: File too large; choose another output.");
  EXPECT_EQ(this->Folder.EntryCount(), 0U);
}

TEST_F(TouchRecorderTest, LostTicksEndRecordingAndKeepEarlierOnes)
{
  ServoSettings settings;
  settings.RecordedTicks = 10;
  test::SimulatedTouch touch(test::WallScene(0.0, {1.0, 0.0}), SimulatedSettings(), settings);
  TouchRecorder recorder;
  ASSERT_TRUE(recorder.Start(this->Path(), test::SessionOf(touch.Device, settings)).IsOk());
  touch.Tick(15);
  EXPECT_TRUE(recorder.Drain(touch.Loop).IsOk());
  touch.Tick();
  const std::string message = recorder.Drain(touch.Loop).Message();
  EXPECT_NE(message.find("0.010 s (10 ticks): the ticks before number 15 were lost"),
            std::string::npos)
      << message;
  EXPECT_EQ(this->TicksIn(this->Part()), 10U);
}

TEST_F(TouchRecorderTest, RejectsFolderAsTarget)
{
  std::filesystem::create_directory(this->Path());
  TouchRecorder recorder;
  EXPECT_EQ(this->Start(recorder).Message(),
            this->Path() + " cannot be written: it is a folder; choose another output.");
}

TEST_F(TouchRecorderTest, ReportsUnwritablePath)
{
  TouchRecorder recorder;
  EXPECT_FALSE(recorder.Start("/nowhere/session", RecordedSession()).IsOk());
  EXPECT_FALSE(recorder.Finish().IsOk());
  EXPECT_FALSE(this->Take(recorder, 1).IsOk());
}

/// A disk that blocks until it is released.
struct HeldDisk
{
  std::mutex Lock;
  std::condition_variable Changed;
  bool IsHeld = true;
  bool HasReturned = false;
  std::string Content;
  int Syncs = 0;

  void Release()
  {
    const std::lock_guard<std::mutex> lock(this->Lock);
    this->IsHeld = false;
    this->Changed.notify_all();
  }
  void AwaitReturn()
  {
    std::unique_lock<std::mutex> lock(this->Lock);
    this->Changed.wait(lock, [this] { return this->HasReturned; });
  }
  static BackgroundWriter::Target TargetOf(const std::shared_ptr<HeldDisk>& disk)
  {
    const auto write = [disk](std::string_view bytes)
    {
      std::unique_lock<std::mutex> lock(disk->Lock);
      disk->Changed.wait(lock, [&] { return !disk->IsHeld; });
      disk->Content.append(bytes);
      disk->HasReturned = true;
      disk->Changed.notify_all();
      return Status::Success();
    };
    return {write, [disk] { ++disk->Syncs; }};
  }
};

TEST(BackgroundWriter, StallDoesNotBlockCaller)
{
  auto disk = std::make_shared<HeldDisk>();
  BackgroundWriter::Limits limits;
  limits.MostWaiting = 1000;
  limits.Patience = std::chrono::milliseconds(20);
  {
    BackgroundWriter writer(HeldDisk::TargetOf(disk), limits);
    Status status = Status::Success();
    std::size_t appended = 0;
    for (; status.IsOk() && appended < 100; ++appended)
    {
      status = writer.Append(std::string(100, 'x'));
    }
    EXPECT_EQ(status.Message(), "the disk has stalled");
    EXPECT_LT(appended, 100U);
    EXPECT_TRUE(writer.HasStalled());
    EXPECT_EQ(writer.WrittenBytes(), 0U);
    EXPECT_FALSE(writer.Append("more").IsOk());
    EXPECT_FALSE(writer.Finish().IsOk());
  }
  // The thread outlives the writer, and ends when the disk responds.
  disk->Release();
  disk->AwaitReturn();
}

TEST(BackgroundWriter, SlowDiskGetsAllBytesInOrder)
{
  auto disk = std::make_shared<HeldDisk>();
  BackgroundWriter::Limits limits;
  limits.MostWaiting = 64;
  limits.SyncInterval = std::chrono::milliseconds(0);
  BackgroundWriter writer(HeldDisk::TargetOf(disk), limits);
  std::thread later([&disk] { disk->Release(); });
  std::string expected;
  for (int n = 0; n < 1000; ++n)
  {
    ASSERT_TRUE(writer.Append(std::to_string(n)).IsOk());
    expected += std::to_string(n);
  }
  later.join();
  EXPECT_TRUE(writer.Finish().IsOk());
  EXPECT_EQ(disk->Content, expected);
  EXPECT_EQ(writer.WrittenBytes(), expected.size());
  EXPECT_GE(disk->Syncs, 2) << "meanwhile, and at its end";
}
} // namespace
} // namespace palpate::touch_recorder_test
