// The guard process on a virtual bus: a board that pushes, and no process left to stop it.
#include "FalconGuard.h"

#include "FalconBoot.h"
#include "FalconPackets.h"
#include "FalconTestBed.h"
#include "LibusbFalconLink.h"
#include "ShimmedFalcon.h"

#include <chrono>
#include <csignal>
#include <memory>
#include <sys/wait.h>
#include <unistd.h>

namespace palpate::falcon_guard_test
{
namespace
{
using test::Eventually;
using test::FalconTestBed;
using test::UsbfsFalcon;
using test::VirtualFalcon;

class FalconGuardTest : public testing::Test
{
protected:
  static constexpr int Port = 2;

  void SetUp() override
  {
    // Not skipped: a missing wrapper must not look like success.
    ASSERT_TRUE(FalconTestBed::IsPossible()) << "umockdev is not preloaded: use umockdev-wrapper";
    this->Model.StartLoaded();
    this->Bed.Plug(this->Bus, Port);
    LibusbFalconLink link(BusPath);
    ASSERT_TRUE(link.Open().IsOk());
    for (const FtdiRequest& request : FalconBoot::RunMode())
    {
      ASSERT_TRUE(link.Control(request).IsOk());
    }
    ASSERT_TRUE(Push(link));
    ASSERT_TRUE(Eventually([this] { return this->HasTorque(); }));
  }

  static bool Push(LibusbFalconLink& link)
  {
    FalconRequest push;
    push.Motors = {500, 500, 500};
    const FalconPacket packet = Encoded(push);
    return link.Send(packet.data(), packet.size());
  }
  bool HasTorque()
  {
    return this->Bus.WithFalcon(
        [](VirtualFalcon& falcon)
        {
          const auto now = std::chrono::steady_clock::now().time_since_epoch();
          falcon.NextDue(std::chrono::nanoseconds(now).count());
          return falcon.Board().Motors() != std::array<std::int16_t, 3>{};
        });
  }

  const std::string BusPath = "1-" + std::to_string(Port);
  VirtualFalcon Model;
  UsbfsFalcon Bus{Model};
  FalconTestBed Bed;
};

TEST_F(FalconGuardTest, StopsMotorsWhenProcessDies)
{
  const pid_t child = fork();
  if (child == 0)
  {
    FalconGuard guard;
    const bool isStarted = guard.Start(this->BusPath);
    _exit(isStarted ? 0 : 1); // no destructor, as if a signal ends the process
  }
  int status = 1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_EQ(status, 0) << "palpate-falcon-guard was not found";
  EXPECT_TRUE(Eventually([this] { return !this->HasTorque(); }));
  EXPECT_GT(waitpid(-1, &status, 0), 0) << "it must end after its work";
  EXPECT_EQ(status, 0);
}

// Nothing that a killed program has left on the bus may reach the guard.
TEST_F(FalconGuardTest, StopsMotorsOfOneKilledProgramAfterAnother)
{
  for (int n = 0; n < 8; ++n)
  {
    const pid_t child = fork();
    if (child == 0)
    {
      LibusbFalconLink link(this->BusPath);
      const bool isPushing = link.Open().IsOk() && this->Push(link);
      pause();
      _exit(isPushing ? 0 : 1); // not reached
    }
    EXPECT_TRUE(Eventually([this] { return this->Bus.WaitingCount() > 0 && this->HasTorque(); }));
    kill(child, SIGKILL);
    int status = 1;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    this->Bus.ReleaseClaims();
    EXPECT_TRUE(Eventually([this] { return !this->HasTorque(); }));
    EXPECT_GT(waitpid(-1, &status, 0), 0);
    EXPECT_EQ(status, 0);
  }
}

TEST_F(FalconGuardTest, StopsMotorsAfterReturnToBus)
{
  this->Bed.Unplug(Port, VirtualFalcon::Supply::Kept);
  FalconGuard guard;
  ASSERT_TRUE(guard.Start(this->BusPath));
  guard.Call();
  ASSERT_TRUE(this->HasTorque());
  this->Bed.Plug(this->Bus, Port);
  EXPECT_TRUE(Eventually([this] { return !this->HasTorque(); }));
  guard.Dismiss();
}

TEST_F(FalconGuardTest, IgnoresClosedDevice)
{
  FalconGuard guard;
  ASSERT_TRUE(guard.Start(this->BusPath));
  const std::size_t before = this->Model.Board().Received().size();
  guard.Dismiss(); // returns once the process has ended
  EXPECT_TRUE(this->HasTorque());
  EXPECT_EQ(this->Model.Board().Received().size(), before);
}

// An open, armed link that has sent a torque.
class FalconGuardOfLink : public FalconGuardTest
{
protected:
  void SetUp() override
  {
    ASSERT_NO_FATAL_FAILURE(this->FalconGuardTest::SetUp());
    this->Link = std::make_unique<LibusbFalconLink>(this->BusPath);
    ASSERT_TRUE(this->Link->Open().IsOk());
    const FalconPacket stop = Encoded(FalconRequest());
    this->Link->ArmStop(stop.data(), stop.size());
    // Without a later word, the silence would stop the motors.
    this->Bus.HoldWrites(true);
    ASSERT_TRUE(this->HasTorque());
  }
  void PullTheCable()
  {
    this->Bed.Unplug(Port, VirtualFalcon::Supply::Kept);
    ASSERT_TRUE(Eventually([this] { return this->Link->IsGone(); }));
  }
  void ExpectStop(const char* fault)
  {
    EXPECT_TRUE(this->HasTorque());
    const auto start = std::chrono::steady_clock::now();
    this->Bus.HoldWrites(false);
    EXPECT_TRUE(Eventually([this] { return !this->HasTorque(); }));
    const std::chrono::duration<double, std::milli> passed =
        std::chrono::steady_clock::now() - start;
    RecordProperty("front", "virtual bus");
    RecordProperty("fault", fault);
    RecordProperty("milliseconds", std::to_string(passed.count()));
    // The guard must have ended before the test bed does.
    this->Link.reset();
    while (waitpid(-1, nullptr, 0) > 0)
    {
    }
  }

  std::unique_ptr<LibusbFalconLink> Link;
};

TEST_F(FalconGuardOfLink, StopsReturnedDeviceAfterLinkEnded)
{
  ASSERT_NO_FATAL_FAILURE(this->PullTheCable());
  this->Link->Close(); // as its device does before it ends
  this->Link.reset();
  this->Bed.Plug(this->Bus, Port);
  this->ExpectStop("Closed without a cable, from its return");
}

TEST_F(FalconGuardOfLink, LetsOtherLinkOpenReturnedDevice)
{
  this->Bus.HoldWrites(false);
  for (int n = 0; n < 5; ++n)
  {
    ASSERT_NO_FATAL_FAILURE(this->PullTheCable());
    this->Link->Close();
    this->Link = std::make_unique<LibusbFalconLink>(this->BusPath);
    this->Bed.Plug(this->Bus, Port);
    const Status status = this->Link->Open();
    EXPECT_TRUE(status.IsOk()) << status.Message();
  }
}

TEST_F(FalconGuardOfLink, StopsBlockedDeviceAfterLinkEnded)
{
  ASSERT_TRUE(this->Link->SendStop());
  this->Link.reset();
  this->ExpectStop("Closed with a full queue, from when it moves again");
}

TEST_F(FalconGuardOfLink, StopsDeviceThatFailedBeforeLeavingBus)
{
  this->Bus.FailReads(40);
  ASSERT_TRUE(Eventually([this] { return this->Link->IsGone(); }));
  ASSERT_NO_FATAL_FAILURE(this->PullTheCable());
  this->Bed.Plug(this->Bus, Port);
  this->ExpectStop("Hub reset after errors, from its return");
}

TEST_F(FalconGuardOfLink, StopsDeviceAfterFailedOpen)
{
  ASSERT_NO_FATAL_FAILURE(this->PullTheCable());
  this->Link->Close();
  EXPECT_FALSE(this->Link->Open().IsOk());
  this->Bed.Plug(this->Bus, Port);
  this->ExpectStop("Opened in vain without a cable, from its return");
}

TEST_F(FalconGuardTest, AllowsReopenWhileCalled)
{
  LibusbFalconLink link(this->BusPath);
  ASSERT_TRUE(link.Open().IsOk());
  EXPECT_EQ(link.Caution(), "");
  this->Bed.Unplug(Port, VirtualFalcon::Supply::Kept);
  ASSERT_TRUE(Eventually([&link] { return link.IsGone(); }));
  link.Close();
  this->Bed.Plug(this->Bus, Port);
  const Status status = link.Open();
  EXPECT_TRUE(status.IsOk()) << status.Message();
}
} // namespace
} // namespace palpate::falcon_guard_test
