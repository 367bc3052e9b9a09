#include "ReplayBar.h"

#include "PlotsPanel.h"
#include "TouchPanel.h"
#include "TouchRecorder.h"
#include "WindowTest.h"

#include "vtkMatrix4x4.h"

#include <QKeyEvent>

namespace palpate::replay_bar_test
{
namespace
{
constexpr std::size_t Count = 12000; // ticks, a millisecond apart

// A window, and a recording whose tool moves along x at 10 mm/s and is in contact in the second
// half.
class ReplayBarTest : public test::WindowTest
{
protected:
  // Replays run in real time; no test waits for their end.
  ReplayBarTest() { this->Time = std::make_unique<SteadyClock>(); }
  std::filesystem::path Write()
  {
    const auto file = this->Phantom.Folder / "recorded.touch";
    RecordedSession session;
    session.Device.MaximumForce = 9.0;
    TouchRecorder recorder;
    EXPECT_TRUE(recorder.Start(file.string(), session).IsOk());
    for (std::size_t n = 0; n < Count; ++n)
    {
      TouchState tick;
      tick.Tick.Number = n;
      tick.Tick.Started = 1'000'000 * static_cast<std::int64_t>(n);
      tick.HasSample = true;
      tick.ProbeWorld.X = 0.01 * static_cast<double>(n);
      tick.ProxyWorld = tick.ProbeWorld;
      tick.Structure = n < Count / 2 ? -1 : 0;
      tick.ForceWorld.Y = n < Count / 2 ? 0.0 : 2.0;
      EXPECT_TRUE(recorder.Take(tick).IsOk());
    }
    EXPECT_TRUE(recorder.Finish().IsOk());
    return file;
  }
  void OpenRecording()
  {
    this->Opened = QStringList(QString::fromStdString(this->Write().string()));
    this->Action("Open a recording")->trigger();
    WaitUntil([this] { return this->Study->IsReplaying() || !this->Messages().empty(); });
    ASSERT_TRUE(this->Study->IsReplaying()) << this->Messages();
  }
  double X() const { return this->Window->Contents().Probe()->GetProbeMatrix()->GetElement(0, 3); }
  StudyReplay& Replay() const { return *this->Study->Current().Replay(); }
  template <typename Widget>
  Widget* Find(const char* name) const
  {
    return this->Window->findChild<Widget*>(name);
  }
};

TEST_F(ReplayBarTest, IsVisibleWhileRecordingIsOpen)
{
  auto* bar = this->Window->findChild<ReplayBar*>();
  EXPECT_FALSE(bar->isVisible());
  this->OpenRecording();
  EXPECT_TRUE(bar->isVisible());
  EXPECT_TRUE(this->Window->Contents().Probe()->GetVisibility());
  EXPECT_TRUE(this->Window->findChild<TouchPanel*>()->RecordingWords().contains("recorded.touch"));
  this->Button("replay-close")->click();
  EXPECT_FALSE(bar->isVisible());
  EXPECT_FALSE(this->Window->Contents().Probe()->GetVisibility());
  EXPECT_TRUE(this->Window->findChild<TouchPanel*>()->RecordingWords().isEmpty());
}

TEST_F(ReplayBarTest, ViewsAndPlotsFollowTheSlider)
{
  this->OpenRecording();
  auto* slider = this->Find<QSlider>("replay-slider");
  slider->setValue(3000);
  WaitUntil([this] { return std::abs(this->X() - 30.0) < 1e-9; });
  EXPECT_FALSE(this->Window->Contents().Probe()->GetInContact());
  const StripChart& force = this->Window->findChild<PlotsPanel*>()->Force();
  EXPECT_EQ(force.Largest(), 0.0);
  slider->setValue(9000);
  WaitUntil([this] { return std::abs(this->X() - 90.0) < 1e-9; });
  EXPECT_TRUE(this->Window->Contents().Probe()->GetInContact());
  EXPECT_EQ(this->Window->Contents().Probe()->GetForce()[1], 2.0);
  EXPECT_EQ(force.Largest(), 2.0);
  // The seconds before the current time, regardless of jumps between two times.
  EXPECT_LE(force.Count(), 5001U);
  EXPECT_EQ(this->Find<QLabel>("replay-time")->text(), "0:09.000 / 0:11.999");
}

TEST_F(ReplayBarTest, PlaysAndPauses)
{
  this->OpenRecording();
  this->Replay().SetSpeed(5.0);
  this->Action("Play the replay")->trigger();
  EXPECT_TRUE(this->Replay().IsPlaying());
  EXPECT_EQ(this->Button("replay-play")->text(), "Pause");
  WaitUntil([this] { return this->X() > 5.0; });
  EXPECT_GT(this->Find<QSlider>("replay-slider")->value(), 0);
  this->Button("replay-play")->click();
  EXPECT_FALSE(this->Replay().IsPlaying());
  // To the end, where the replay stops.
  this->Replay().SetSpeed(StudyReplay::LargestSpeed);
  this->Button("replay-play")->click();
  WaitUntil([this] { return this->Button("replay-play")->text() == "Play"; });
  EXPECT_NEAR(this->X(), 0.01 * (Count - 1), 1e-9);
}

TEST_F(ReplayBarTest, TouchEndsReplay)
{
  this->OpenPhantom();
  this->Window->Messages()->Clear(); // on structures that cannot be modelled
  this->OpenRecording();
  EXPECT_EQ(this->Button("start-touch")->text(), "Close the replay and touch");
  this->Button("start-touch")->click();
  WaitUntil([this] { return this->Study->IsTouching() || this->Study->IsReplaying(); });
  EXPECT_TRUE(this->Study->IsTouching()) << this->Messages();
  EXPECT_FALSE(this->Window->findChild<ReplayBar*>()->isVisible());
}

TEST_F(ReplayBarTest, TicksAreExported)
{
  EXPECT_FALSE(this->Action("Export every tick")->isEnabled());
  this->OpenRecording();
  const auto ticks = this->Phantom.Folder / "ticks.csv";
  this->SavedTo = QString::fromStdString(ticks.string());
  this->Action("Export every tick")->trigger();
  WaitUntil([&] { return std::filesystem::exists(ticks); });
  this->SavedTo = "/nowhere/ticks.csv";
  this->Action("Export every tick")->trigger();
  WaitUntil([this] { return !this->Messages().empty(); });
  EXPECT_NE(this->Messages().find("/nowhere/ticks.csv"), std::string::npos) << this->Messages();
}

// More often than twice: each try meets another turn of the timer that looks for problems.
TEST_F(ReplayBarTest, ReplayThatFailsTellsItsMessageEachTime)
{
  this->Opened = QStringList("/nowhere/session.touch");
  for (int n = 0; n < 4; ++n)
  {
    this->Action("Open a recording")->trigger();
    WaitUntil([this]
              { return this->Messages().find("/nowhere/session.touch") != std::string::npos; });
    this->Button("close")->click();
  }
}

TEST_F(ReplayBarTest, ExportThatFailsTellsItsMessageEachTime)
{
  this->OpenRecording();
  this->SavedTo = "/nowhere/ticks.csv";
  for (int n = 0; n < 4; ++n)
  {
    this->Action("Export every tick")->trigger();
    WaitUntil([this] { return this->Messages().find("/nowhere/ticks.csv") != std::string::npos; });
    this->Button("close")->click();
  }
}

TEST_F(ReplayBarTest, RecordingIsListedAmongRecentFiles)
{
  this->OpenRecording();
  EXPECT_TRUE(QSettings().value("recent").toStringList().first().endsWith("recorded.touch"));
}

TEST_F(ReplayBarTest, OnlyARecordingReplacesTheOpenOne)
{
  this->OpenRecording();
  const auto foreign = this->Phantom.Folder / "none.touch";
  test::WriteAll(foreign, "no recording");
  this->Study->OpenFiles({foreign});
  WaitUntil([this] { return !this->Messages().empty(); });
  EXPECT_TRUE(this->Study->IsReplaying());
  const auto second = this->Phantom.Folder / "second.touch";
  std::filesystem::copy(this->Study->Current().Replay()->File(), second);
  this->Study->OpenFiles({second});
  WaitUntil([&] { return this->Study->Current().Replay()->File() == second; });
  WaitUntil(
      [] { return QSettings().value("recent").toStringList().first().endsWith("second.touch"); });
  EXPECT_TRUE(this->Study->IsReplaying());
}

TEST_F(ReplayBarTest, RejectsForeignFileEachTime)
{
  const auto file = this->Phantom.Folder / "none.touch";
  test::WriteAll(file, "no recording");
  for (int n = 0; n < 2; ++n)
  {
    this->Window->Messages()->Clear();
    this->Study->OpenFiles({file});
    WaitUntil([this] { return !this->Messages().empty(); });
    EXPECT_EQ(this->Messages(),
              file.string() + " is not a touch recording of version 3, 4, 5 or 6.");
  }
  EXPECT_FALSE(this->Study->IsReplaying());
}
} // namespace
} // namespace palpate::replay_bar_test
