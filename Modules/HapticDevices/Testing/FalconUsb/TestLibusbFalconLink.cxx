#include "AllocationCounter.h"
#include "ShimmedFalcon.h"

#include <filesystem>

namespace palpate::libusb_falcon_link_test
{
namespace
{
using test::Bytes;
using test::EnterLoader;
using test::Eventually;
using test::ImageHead;
using test::ReceiveBytes;
using test::SendBytes;
using test::ShimmedFalcon;
using test::UsbfsFalcon;
using test::VirtualFalcon;

class LibusbFalconLinkTest : public testing::Test, protected ShimmedFalcon
{
protected:
  void OpenLink()
  {
    const Status status = this->Link.Open();
    ASSERT_TRUE(status.IsOk()) << status.Message();
  }

  // A closed link leaves nothing behind on the bus.
  void ExpectNothingLeft()
  {
    EXPECT_EQ(this->Bus.FileCount(), 0U);
    EXPECT_EQ(this->Bus.WaitingCount(), 0U);
  }

  // Closing cancels within a second whatever the device does; the rest is margin for a busy
  // machine.
  void ExpectBoundedClose()
  {
    const auto start = std::chrono::steady_clock::now();
    this->Link.Close();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(4));
    this->ExpectNothingLeft();
  }
};

std::size_t OpenDescriptors()
{
  const std::filesystem::directory_iterator first("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(first, std::filesystem::directory_iterator()));
}

TEST_F(LibusbFalconLinkTest, ClosedLinkCarriesNothing)
{
  std::uint8_t byte = 0;
  EXPECT_FALSE(this->Link.Send(&byte, 1));
  EXPECT_EQ(this->Link.Receive(&byte, 1), 0U);
  EXPECT_FALSE(this->Link.ClearToSend());
  EXPECT_FALSE(this->Link.IsGone());
  EXPECT_FALSE(this->Link.Control(FtdiRequest::PurgeIn()).IsOk());
  this->Link.Close();
}

TEST_F(LibusbFalconLinkTest, RequestsSetChip)
{
  this->OpenLink();
  EXPECT_TRUE(this->Link.Control(FtdiRequest::DataTerminalReady(true)).IsOk());
  EXPECT_TRUE(this->Link.Control(FtdiRequest::Baud(2)).IsOk());
  this->Bus.WithFalcon(
      [](VirtualFalcon& falcon)
      {
        EXPECT_TRUE(falcon.Chip().DataTerminalReady());
        EXPECT_EQ(falcon.Chip().Baud(), 1.5e6);
      });
  EXPECT_TRUE(this->Link.Control(FtdiRequest::DataTerminalReady(false)).IsOk());
  this->Bus.WithFalcon([](VirtualFalcon& falcon)
                       { EXPECT_FALSE(falcon.Chip().DataTerminalReady()); });
}

TEST_F(LibusbFalconLinkTest, ReportsRefusedRequest)
{
  this->Bus.WithFalcon([](VirtualFalcon& falcon) { falcon.Faults.StalledRequest = 9; });
  this->OpenLink();
  EXPECT_EQ(this->Link.Control(FtdiRequest::LatencyTimer(1)).Message(),
            "The Falcon's serial chip refuses request 9.");
  EXPECT_TRUE(this->Link.Control(FtdiRequest::Baud(2)).IsOk()) << "others must still work";
}

TEST_F(LibusbFalconLinkTest, EchoIsCompleteAndInOrder)
{
  constexpr std::size_t Count = 8192; // far more than is in flight at once
  this->OpenLink();
  ASSERT_NO_FATAL_FAILURE(EnterLoader(this->Link));
  Bytes image = ImageHead(Count / 2);
  for (std::size_t n = 0; n < Count; ++n)
  {
    image.push_back(static_cast<std::uint8_t>(n * 31 + n / 251));
  }
  Bytes echo;
  // Less than a packet, a packet, more than a packet, and the whole queue.
  const std::array<std::size_t, 4> pieces{7, 62, 130, 512};
  for (std::size_t start = 0, n = 0; start < image.size(); ++n)
  {
    const std::size_t count = std::min(pieces.at(n % pieces.size()), image.size() - start);
    ASSERT_TRUE(Eventually([&] { return this->Link.Send(image.data() + start, count); }));
    const Bytes part = ReceiveBytes(this->Link, count);
    echo.insert(echo.end(), part.begin(), part.end());
    start += count;
  }
  EXPECT_EQ(echo, image);
}

TEST_F(LibusbFalconLinkTest, ClearToSendFollowsChip)
{
  this->OpenLink();
  EXPECT_FALSE(this->Link.ClearToSend());
  ASSERT_NO_FATAL_FAILURE(EnterLoader(this->Link));
  EXPECT_TRUE(Eventually([this] { return this->Link.ClearToSend(); }));
}

TEST_F(LibusbFalconLinkTest, PurgeDiscardsReceivedBytes)
{
  this->OpenLink();
  ASSERT_NO_FATAL_FAILURE(EnterLoader(this->Link));
  ASSERT_TRUE(SendBytes(this->Link, {0xaa, 0x08}));
  // Both arrive in one packet, so the second one is there too.
  ASSERT_EQ(ReceiveBytes(this->Link, 1), Bytes{0xaa});
  ASSERT_TRUE(this->Link.Control(FtdiRequest::PurgeIn()).IsOk());
  ASSERT_TRUE(SendBytes(this->Link, {0x00}));
  EXPECT_EQ(ReceiveBytes(this->Link, 1), Bytes{0x00});
}

TEST_F(LibusbFalconLinkTest, QueueIsBoundedAndTakesAllOrNothing)
{
  const Bytes many(512, 0x55);
  const Bytes two(2, 0x66);
  this->OpenLink();
  this->Bus.HoldWrites(true);
  EXPECT_FALSE(this->Link.Send(many.data(), 513));
  EXPECT_TRUE(SendBytes(this->Link, Bytes(511, 0x55)));
  EXPECT_FALSE(SendBytes(this->Link, two));
  EXPECT_TRUE(SendBytes(this->Link, {0x66}));
  this->Bus.HoldWrites(false);
  EXPECT_TRUE(Eventually([&] { return SendBytes(this->Link, many); }));
}

TEST_F(LibusbFalconLinkTest, GivesUpAtWriteDeadline)
{
  this->OpenLink();
  this->Bus.HoldWrites(true);
  ASSERT_TRUE(SendBytes(this->Link, {0x55}));
  EXPECT_EQ(this->Link.Control(FtdiRequest::Baud(2)).Message(),
            "The Falcon takes no data: unplug it, plug it in and open it again.");
  EXPECT_TRUE(this->Link.IsGone());
  EXPECT_FALSE(SendBytes(this->Link, {0x55}));
  this->ExpectBoundedClose();
}

TEST_F(LibusbFalconLinkTest, SurvivesBurstOfFailedReads)
{
  this->OpenLink();
  ASSERT_NO_FATAL_FAILURE(EnterLoader(this->Link));
  this->Bus.FailReads(20);
  ASSERT_TRUE(SendBytes(this->Link, ImageHead(10)));
  EXPECT_EQ(ReceiveBytes(this->Link, ImageHead(10).size()), ImageHead(10));
  EXPECT_FALSE(this->Link.IsGone());
}

TEST_F(LibusbFalconLinkTest, GivesUpIfEveryReadFails)
{
  this->OpenLink();
  this->Bus.FailReads(1'000'000);
  EXPECT_TRUE(Eventually([this] { return this->Link.IsGone(); }));
  EXPECT_EQ(this->Link.Control(FtdiRequest::Baud(2)).Message(),
            "Nothing but errors comes from the Falcon: try another cable or another USB socket.");
  this->ExpectBoundedClose();
}

TEST_F(LibusbFalconLinkTest, ReportsUnpluggingAndReopens)
{
  for (const auto how : {UsbfsFalcon::Unplugging::AbortsReads, UsbfsFalcon::Unplugging::RefusesNext,
                         UsbfsFalcon::Unplugging::AbortsReads})
  {
    this->OpenLink();
    ASSERT_NO_FATAL_FAILURE(EnterLoader(this->Link));
    EXPECT_FALSE(this->Link.IsGone());
    this->Bus.Unplug(how);
    EXPECT_TRUE(Eventually([this] { return this->Link.IsGone(); }));
    EXPECT_FALSE(SendBytes(this->Link, {0x41}));
    EXPECT_EQ(this->Link.Control(FtdiRequest::Baud(2)).Message(),
              "The Falcon was unplugged: plug it in and open it again.");
    this->ExpectBoundedClose();
    EXPECT_EQ(this->Link.Open().Message(), "There is no Falcon: plug it in.");
    this->Bus.Plug();
  }
  this->OpenLink();
  ASSERT_NO_FATAL_FAILURE(EnterLoader(this->Link));
}

TEST_F(LibusbFalconLinkTest, UnpluggingNeverHangsOrLeaks)
{
  for (int n = 0; n < 40; ++n)
  {
    this->OpenLink();
    std::thread cable(
        [this, n]
        {
          std::this_thread::sleep_for(std::chrono::microseconds(100 * n));
          this->Bus.Unplug(n % 2 == 0 ? UsbfsFalcon::Unplugging::AbortsReads
                                      : UsbfsFalcon::Unplugging::RefusesNext);
        });
    const Bytes packet(16, 0x55);
    EXPECT_TRUE(Eventually(
        [&]
        {
          SendBytes(this->Link, packet);
          static_cast<void>(this->Link.Control(FtdiRequest::LatencyTimer(1)).IsOk());
          return this->Link.IsGone();
        }));
    cable.join();
    this->Link.Close();
    this->ExpectNothingLeft();
    this->Bus.Plug();
  }
}

TEST_F(LibusbFalconLinkTest, CloseFlushesSentBytes)
{
  this->OpenLink();
  ASSERT_NO_FATAL_FAILURE(EnterLoader(this->Link));
  ASSERT_TRUE(this->Link.Control(FtdiRequest::LatencyTimer(1)).IsOk());
  this->Bus.HoldWrites(true);
  ASSERT_TRUE(SendBytes(this->Link, ImageHead(100)));
  std::thread owner([this] { this->ExpectBoundedClose(); });
  // Closing has begun when reads are not submitted again; only the write is waiting.
  EXPECT_TRUE(Eventually([this] { return this->Bus.WaitingCount() <= 1; }));
  this->Bus.HoldWrites(false);
  owner.join();
  EXPECT_TRUE(Eventually(
      [this]
      {
        return this->Bus.WithFalcon(
            [](VirtualFalcon& falcon)
            {
              const auto now = std::chrono::steady_clock::now().time_since_epoch();
              falcon.NextDue(std::chrono::nanoseconds(now).count()); // the wire is slower
              return falcon.Board().Image().size() == ImageHead(100).size();
            });
      }));
}

TEST_F(LibusbFalconLinkTest, CloseWhileBusyCancelsTransfers)
{
  this->OpenLink();
  this->Bus.HoldWrites(true);
  ASSERT_TRUE(SendBytes(this->Link, Bytes(512, 0x55)));
  this->ExpectBoundedClose();
  this->Bus.HoldWrites(false);
  this->OpenLink();
  ASSERT_NO_FATAL_FAILURE(EnterLoader(this->Link));
}

TEST_F(LibusbFalconLinkTest, CloseEndsIfKernelReturnsNothing)
{
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "libusb leaks what the kernel never gives back";
#endif
  this->OpenLink();
  this->Bus.KeepDiscarded(true);
  this->Bus.HoldWrites(true);
  ASSERT_TRUE(SendBytes(this->Link, {0x55}));
  this->ExpectBoundedClose();
}

TEST_F(LibusbFalconLinkTest, RepeatedOpenAndCloseLeaksNothing)
{
  this->OpenLink();
  this->Link.Close();
  const std::size_t before = OpenDescriptors();
  for (int n = 0; n < 200; ++n)
  {
    this->OpenLink();
    EXPECT_FALSE(this->Link.Open().IsOk()) << "an open link must not open again";
    ASSERT_TRUE(this->Link.Control(FtdiRequest::Baud(2)).IsOk()) << n;
    this->Link.Close();
  }
  EXPECT_EQ(OpenDescriptors(), before);
  this->ExpectNothingLeft();
}

TEST_F(LibusbFalconLinkTest, ReportsDeviceInUse)
{
  this->OpenLink();
  LibusbFalconLink second([this] { return this->Node.Open(); });
  EXPECT_EQ(second.Open().Message(), "The Falcon is used by another program: close that first.");
  EXPECT_EQ(this->Bus.FileCount(), 1U);
  this->Link.Close();
  EXPECT_TRUE(second.Open().IsOk());
}

TEST_F(LibusbFalconLinkTest, DetachesKernelDriver)
{
  this->Bus.BindDriver("ftdi_sio");
  this->OpenLink();
  ASSERT_NO_FATAL_FAILURE(EnterLoader(this->Link));
}

TEST_F(LibusbFalconLinkTest, SendAndReceiveDoNotAllocate)
{
  this->OpenLink();
  ASSERT_NO_FATAL_FAILURE(EnterLoader(this->Link));
  const Bytes head = ImageHead(30);
  Bytes echo(head.size());
  const std::size_t before = test::AllocationCount();
  ASSERT_TRUE(this->Link.Send(head.data(), head.size()));
  std::size_t count = 0;
  while (count < head.size() && !this->Link.IsGone())
  {
    count += this->Link.Receive(echo.data() + count, echo.size() - count);
  }
  EXPECT_EQ(test::AllocationCount(), before);
  EXPECT_EQ(echo, head);
}

TEST_F(LibusbFalconLinkTest, OwnerMayControlWhileServoSends)
{
  constexpr unsigned Words = 600;
  this->OpenLink();
  ASSERT_NO_FATAL_FAILURE(EnterLoader(this->Link));
  Bytes image = ImageHead(Words);
  image.resize(image.size() + std::size_t{2} * Words, 0x77);
  Bytes echo(image.size());
  std::thread servo(
      [&]
      {
        std::size_t sent = 0;
        std::size_t received = 0;
        EXPECT_TRUE(Eventually(
            [&]
            {
              const std::size_t next = std::min<std::size_t>(16, image.size() - sent);
              sent += this->Link.Send(image.data() + sent, next) ? next : 0;
              received += this->Link.Receive(echo.data() + received, echo.size() - received);
              return received == image.size();
            }));
      });
  for (unsigned n = 0; n < 20; ++n)
  {
    EXPECT_TRUE(this->Link.Control(FtdiRequest::LatencyTimer(1 + n % 3)).IsOk());
  }
  servo.join();
  EXPECT_EQ(echo, image);
}
} // namespace
} // namespace palpate::libusb_falcon_link_test
