#include "FalconBoot.h"

#include "BootStream.h"
#include "ManualClock.h"
#include "TemporaryFolder.h"
#include "VirtualFalconLink.h"

#include <gtest/gtest.h>

#include <random>

namespace palpate::falcon_boot_test
{
namespace
{
using test::VirtualFalconAnswer;
using Kind = VirtualFalconAnswer::Kind;

// A Falcon that was just plugged in, and a firmware file.
class FalconBootTest : public testing::Test
{
protected:
  FalconBootTest()
  {
    this->Falcon.Mechanism().Settings.IsRigid = true;
    test::WriteAll(this->Path(), {this->Image.begin(), this->Image.end()});
    EXPECT_TRUE(this->Cable.Open().IsOk());
  }
  std::string Path() const { return (this->Folder / "firmware.bin").string(); }
  Status Run() { return this->Boot.Run(this->Path()); }

  // Corrupts answers of a kind, up to and including a given reset of the board.
  void Spoil(Kind kind, std::function<void(VirtualFalconAnswer&)> how, int resets = 1000)
  {
    this->Falcon.Faults.Spoil = [kind, how = std::move(how), resets](VirtualFalconAnswer& answer)
    {
      if (answer.What == kind && answer.Resets <= resets)
      {
        how(answer);
      }
    };
  }
  static void Lose(VirtualFalconAnswer& answer) { answer.Bytes.clear(); }

  void ExpectFailure(const std::string& message)
  {
    const Status status = this->Run();
    EXPECT_FALSE(status.IsOk());
    EXPECT_EQ(status.Message(), message);
  }

  test::TemporaryFolder Folder;
  std::vector<std::uint8_t> Image = test::BootStream();
  ManualClock Time{5'000'000'000};
  test::VirtualFalcon Falcon;
  test::VirtualFalconLink Cable{Falcon, Time};
  FalconBoot Boot{Cable, Time};
};

TEST_F(FalconBootTest, LoadsImageOnceAndFastWithoutFaults)
{
  double rate = 0.0;
  this->Spoil(Kind::Echo,
              [this, &rate](VirtualFalconAnswer&) { rate = this->Falcon.Chip().Baud(); });
  const std::int64_t start = this->Time.Now();
  const Status status = this->Run();
  ASSERT_TRUE(status.IsOk()) << status.Message();
  EXPECT_EQ(this->Falcon.Board().Image(), this->Image);
  EXPECT_EQ(this->Falcon.Board().Now(), test::VirtualFalconBoard::State::Running);
  EXPECT_EQ(this->Falcon.Board().Resets(), 1) << "one attempt";
  EXPECT_GT(rate, 1e5);
  EXPECT_FALSE(this->Falcon.Chip().DataTerminalReady());
  EXPECT_DOUBLE_EQ(this->Falcon.Chip().Baud(), 1.5e6);
  // The search for running firmware takes 300 ms, the loader's stages some tens.
  EXPECT_LT(this->Time.Now() - start, 450'000'000);
}

TEST_F(FalconBootTest, KeepsRunningFirmwareWithoutFile)
{
  this->Falcon.StartLoaded();
  ASSERT_TRUE(this->Boot.Run("").IsOk());
  EXPECT_EQ(this->Falcon.Board().Resets(), 0);
}

TEST_F(FalconBootTest, ThousandFaultyColdStartsSucceed)
{
  int second = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed)
  {
    std::mt19937_64 random(seed);
    test::VirtualFalcon falcon;
    falcon.Mechanism().Settings.IsRigid = true;
    falcon.Faults.RaisesClearToSend = random() % 4 != 0;
    falcon.Faults.FastestUpload = random() % 4 == 0 ? 1e5 : 1e9;
    const int failures = static_cast<int>(random() % 4);
    falcon.Faults.Spoil = [&random, failures](VirtualFalconAnswer& answer)
    {
      const bool isSingle = answer.What != Kind::Echo;
      const std::uint64_t dice = random() % (isSingle ? 4 : 400);
      if (dice == 0 && answer.Resets <= failures)
      {
        answer.Bytes.clear();
      }
      else if (dice == 1 && answer.Resets <= failures)
      {
        answer.Bytes[0] ^= static_cast<std::uint8_t>(1 + random() % 255);
      }
      else if (dice == 2)
      {
        answer.Delay += static_cast<std::int64_t>(random() % 120'000'000);
        answer.Gap += static_cast<std::int64_t>(random() % 5'000'000);
      }
      if (dice == 3 && isSingle)
      {
        answer.Bytes.insert(answer.Bytes.begin(), 0x00);
      }
    };
    ManualClock time;
    test::VirtualFalconLink cable(falcon, time);
    ASSERT_TRUE(cable.Open().IsOk());
    cable.OpenFailures = static_cast<int>(random() % 3);
    FalconBoot boot(cable, time);
    const Status status = boot.Run(this->Path());
    ASSERT_TRUE(status.IsOk()) << "seed " << seed << ": " << status.Message();
    ASSERT_EQ(falcon.Board().Image(), this->Image) << seed;
    second += falcon.Board().Resets() > 1 ? 1 : 0;
  }
  EXPECT_GT(second, 300) << "too few starts needed a retry";
}

TEST_F(FalconBootTest, IgnoresStrayByteBeforeGreeting)
{
  this->Spoil(Kind::Greeting,
              [](VirtualFalconAnswer& answer) { answer.Bytes.insert(answer.Bytes.begin(), 0x00); });
  ASSERT_TRUE(this->Run().IsOk());
  EXPECT_EQ(this->Falcon.Board().Resets(), 1);
}

TEST_F(FalconBootTest, AcceptsFragmentedAnswers)
{
  this->Spoil(Kind::Greeting, [](VirtualFalconAnswer& answer) { answer.Gap = 20'000'000; });
  ASSERT_TRUE(this->Run().IsOk());
  EXPECT_EQ(this->Falcon.Board().Resets(), 1);
}

TEST_F(FalconBootTest, FallsBackToLowerRate)
{
  this->Falcon.Faults.FastestUpload = 1e5;
  ASSERT_TRUE(this->Run().IsOk());
  EXPECT_EQ(this->Falcon.Board().Image(), this->Image);
}

TEST_F(FalconBootTest, RetriesFailedUploadFromReset)
{
  this->Spoil(
      Kind::Echo,
      [](VirtualFalconAnswer& answer) { answer.Bytes[0] ^= answer.Number == 300 ? 1U : 0U; }, 1);
  ASSERT_TRUE(this->Run().IsOk());
  EXPECT_EQ(this->Falcon.Board().Resets(), 2);
}

TEST_F(FalconBootTest, ReportsMissingPower)
{
  this->Falcon.Faults.HasSupply = false;
  this->ExpectFailure("The Falcon's boot loader does not answer: check that its power supply is "
                      "connected, then unplug its USB cable, plug it in and try again.");
}

TEST_F(FalconBootTest, ReportsFailedRateLock)
{
  this->Falcon.Faults.FastestUpload = 0.0;
  this->ExpectFailure("The Falcon's boot loader greets, but does not find the rate at which its "
                      "firmware is sent: unplug it from any hub, plug it in directly and try "
                      "again.");
  EXPECT_EQ(this->Falcon.Board().Resets(), FalconBoot::MostAttempts);
}

TEST_F(FalconBootTest, ReportsChangedByte)
{
  this->Spoil(Kind::Echo, [](VirtualFalconAnswer& answer)
              { answer.Bytes[0] ^= answer.Number == 70 ? 0x80U : 0U; });
  this->ExpectFailure("The Falcon's firmware could not be loaded: byte 70 of " +
                      std::to_string(this->Image.size()) +
                      " came back changed; try another cable or another USB port.");
}

TEST_F(FalconBootTest, ReportsMissingByte)
{
  const std::uint64_t last = this->Image.size() - 1;
  this->Spoil(Kind::Echo,
              [last](VirtualFalconAnswer& answer)
              {
                if (answer.Number == last)
                {
                  Lose(answer);
                }
              });
  this->ExpectFailure("The Falcon's firmware could not be loaded: byte " + std::to_string(last) +
                      " of " + std::to_string(last + 1) +
                      " did not come back; try another cable or another USB port.");
}

TEST_F(FalconBootTest, ReportsFirmwareThatDoesNotRun)
{
  this->Falcon.Faults.StartsFirmware = false;
  this->ExpectFailure(this->Path() + " was loaded and came back unchanged, but does not run: check "
                                     "that it is a Falcon's firmware.");
}

TEST_F(FalconBootTest, ReportsRefusedChipSetting)
{
  this->Falcon.Faults.StalledRequest = 3;
  this->ExpectFailure("The Falcon's serial chip could not be set up: The "
                      "Falcon's serial chip refused a request.");
}

TEST_F(FalconBootTest, ReportsMissingFirmwarePath)
{
  EXPECT_EQ(this->Boot.Run("").Message(),
            "The Falcon has no firmware loaded and none is named: give the path of its firmware "
            "file, which comes with the maker's software, or set PALPATE_FALCON_FIRMWARE to it.");
  EXPECT_EQ(this->Falcon.Board().Resets(), 0);
}

TEST_F(FalconBootTest, RejectsInvalidFileBeforeReset)
{
  test::WriteAll(this->Path(), "nothing");
  EXPECT_FALSE(this->Run().IsOk());
  EXPECT_EQ(this->Falcon.Board().Resets(), 0);
}

TEST_F(FalconBootTest, ReportsUnpluggingAtAnyStep)
{
  for (const Kind kind : {Kind::Greeting, Kind::BaudLock, Kind::Echo, Kind::Run})
  {
    this->Falcon.Plug(this->Time.Now());
    ASSERT_TRUE(this->Cable.Open().IsOk());
    this->Spoil(kind,
                [](VirtualFalconAnswer& answer)
                {
                  answer.Unplugs = true;
                  Lose(answer);
                });
    const std::int64_t start = this->Time.Now();
    const Status status = this->Run();
    EXPECT_EQ(status.Message(), "The Falcon was unplugged while it was being started.");
    EXPECT_LT(this->Time.Now() - start, 1'000'000'000);
  }
}

TEST_F(FalconBootTest, ReportsDeviceInUse)
{
  this->Spoil(Kind::Greeting, Lose);
  this->Cable.IsBusy = true;
  EXPECT_EQ(this->Run().Message(), "Another program uses the Falcon: end it.");
}
} // namespace
} // namespace palpate::falcon_boot_test
