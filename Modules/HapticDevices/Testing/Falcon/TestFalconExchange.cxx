#include "FalconExchange.h"

#include "ManualClock.h"
#include "VirtualFalconLink.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace palpate::falcon_exchange_test
{
namespace
{
using test::VirtualFalconAnswer;

constexpr std::int64_t Period = 1'000'000; // ns

// A running Falcon with a swinging hand, and the driver's side of the protocol.
class FalconExchangeTest : public testing::Test
{
protected:
  FalconExchangeTest()
  {
    this->Falcon.Mechanism().Settings.IsRigid = true;
    this->Falcon.Mechanism().Settings.Path = [](double t)
    { return Vector3(25.0 * std::sin(9.0 * t), 20.0 * std::sin(7.0 * t), 125.0); };
    this->Falcon.StartLoaded();
    EXPECT_TRUE(this->Cable.Open().IsOk());
    EXPECT_TRUE(this->Cable.Control(FtdiRequest::Baud(2)).IsOk());
    EXPECT_TRUE(this->Cable.Control(FtdiRequest::LatencyTimer(1)).IsOk());
    this->Wire.Restart(this->Time.Now());
  }

  // One tick; returns whether a reply was accepted.
  bool Tick()
  {
    this->Time.Advance(Period);
    const bool isNew = this->Wire.Receive(this->Time.Now(), this->Reply);
    EXPECT_NE(this->Wire.Send({{}, true, FalconLight::None}, this->Time.Now()),
              FalconDelivery::Gone);
    if (isNew)
    {
      ++this->Believed;
      this->WorstError = std::max(this->WorstError, this->Error());
    }
    return isNew;
  }

  void Run(int ticks)
  {
    for (int n = 0; n < ticks; ++n)
    {
      this->Tick();
    }
  }

  // Error of the newest reply relative to the hand's position, in counts.
  int Error()
  {
    const auto counters = this->Falcon.Mechanism().Counters();
    int largest = 0;
    for (std::size_t leg = 0; leg < 3; ++leg)
    {
      largest = std::max(largest, std::abs(counters[leg] - this->Reply.Counts[leg]));
    }
    return largest;
  }

  // Corrupts every n-th answer.
  void Spoil(std::function<void(VirtualFalconAnswer&)> how, std::uint64_t every = 10)
  {
    this->Falcon.Faults.Spoil = [how = std::move(how), every](VirtualFalconAnswer& answer)
    {
      if (answer.Number % every == every - 1)
      {
        how(answer);
      }
    };
  }

  // 0.23 m/s are 6 counts per millisecond, and replies are up to two old.
  static constexpr int UsualError = 20;

  ManualClock Time{1'000'000'000};
  test::VirtualFalcon Falcon;
  test::VirtualFalconLink Cable{Falcon, Time};
  FalconExchange Wire{Cable};
  FalconReply Reply;
  int Believed = 0;
  int WorstError = 0;
};

TEST_F(FalconExchangeTest, EveryTickHasReply)
{
  this->Run(5000);
  const FalconStatistics& s = this->Wire.Statistics();
  EXPECT_EQ(s.Requests, 5000U);
  EXPECT_GE(s.Replies, 4997U); // the last ones are outstanding
  EXPECT_GE(this->Believed, 4990);
  EXPECT_EQ(s.Lost + s.Unasked + s.Implausible - 1, 0U) << "except the first, unconfirmed reply";
  EXPECT_EQ(s.SkippedBytes, 0U);
  EXPECT_LT(this->WorstError, UsualError);
}

TEST_F(FalconExchangeTest, CountsLostReplies)
{
  this->Spoil([](VirtualFalconAnswer& answer) { answer.Bytes.clear(); });
  this->Run(5000);
  EXPECT_NEAR(static_cast<double>(this->Wire.Statistics().Lost), 500.0, 5.0);
  EXPECT_GE(this->Believed, 4400);
  EXPECT_LT(this->WorstError, UsualError);
}

TEST_F(FalconExchangeTest, CountsShortReplies)
{
  std::mt19937_64 random(51);
  this->Spoil(
      [&random](VirtualFalconAnswer& answer)
      {
        answer.Bytes.erase(answer.Bytes.begin() +
                           static_cast<std::ptrdiff_t>(random() % answer.Bytes.size()));
      });
  this->Run(5000);
  EXPECT_NEAR(static_cast<double>(this->Wire.Statistics().Lost), 500.0, 5.0);
  EXPECT_NEAR(static_cast<double>(this->Wire.Statistics().SkippedBytes), 500.0 * 15.0, 30.0);
  EXPECT_LT(this->WorstError, UsualError);
}

TEST_F(FalconExchangeTest, CorruptedRepliesDoNotMoveGrip)
{
  std::mt19937_64 random(52);
  this->Spoil([&random](VirtualFalconAnswer& answer)
              { answer.Bytes[random() % 16] ^= static_cast<std::uint8_t>(1U << (random() % 8)); },
              7);
  this->Run(20000);
  const FalconStatistics& s = this->Wire.Statistics();
  EXPECT_GT(s.Implausible + s.Lost, 1000U);
  EXPECT_GE(this->Believed, 17000 - 200);
  // A changed lowest nibble passes if it is within the tolerance of 12 counts.
  EXPECT_LT(this->WorstError, UsualError + 12);
}

TEST_F(FalconExchangeTest, CountsDuplicateReplies)
{
  this->Spoil(
      [](VirtualFalconAnswer& answer)
      {
        const auto once = answer.Bytes;
        answer.Bytes.insert(answer.Bytes.end(), once.begin(), once.end());
      });
  this->Run(5000);
  EXPECT_EQ(this->Wire.Statistics().Lost, 0U);
  EXPECT_GE(this->Wire.Statistics().Replies, 5490U);
  EXPECT_LT(this->WorstError, UsualError);
}

TEST_F(FalconExchangeTest, LateRepliesDoNotMoveGrip)
{
  this->Spoil([](VirtualFalconAnswer& answer) { answer.Delay += 12'000'000; }, 50);
  this->Run(5000);
  EXPECT_GE(this->Believed, 3000);
  // They arrive twelve milliseconds late, followed by more.
  EXPECT_LT(this->WorstError, 14 * 6 + UsualError);
}

TEST_F(FalconExchangeTest, RecoversAfterSilence)
{
  this->Run(100);
  this->Spoil([](VirtualFalconAnswer& answer) { answer.Bytes.clear(); }, 1);
  this->Run(200);
  const std::uint64_t requests = this->Wire.Statistics().Requests;
  EXPECT_LT(requests, 100U + 200U / 8U * FalconExchange::MostOwed + 8U);
  EXPECT_GT(requests, 100U + 20U);
  EXPECT_GT(this->Wire.Silence(this->Time.Now()), 190 * Period);
  this->Falcon.Faults.Spoil = nullptr;
  this->Run(20);
  EXPECT_TRUE(this->Tick());
  EXPECT_LT(this->Wire.Silence(this->Time.Now()), 2 * Period);
}

TEST_F(FalconExchangeTest, FullQueueIsSilence)
{
  this->Run(10);
  this->Cable.HoldsWrites = true;
  this->Run(50);
  EXPECT_GT(this->Wire.Silence(this->Time.Now()), 40 * Period);
  this->Cable.HoldsWrites = false;
  this->Run(20);
  EXPECT_TRUE(this->Tick());
  EXPECT_LT(this->Wire.Silence(this->Time.Now()), 2 * Period);
}

TEST_F(FalconExchangeTest, SendsNothingToMissingDevice)
{
  this->Run(10);
  this->Falcon.Unplug(this->Time.Now());
  EXPECT_EQ(this->Wire.Send({}, this->Time.Now()), FalconDelivery::Gone);
}
} // namespace
} // namespace palpate::falcon_exchange_test
