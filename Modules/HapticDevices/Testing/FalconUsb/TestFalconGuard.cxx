// The guard process on a virtual bus: a board that pushes, and nobody who could tell it to stop.
#include "FalconGuard.h"

#include "FalconBoot.h"
#include "FalconPackets.h"
#include "FalconTestBed.h"
#include "LibusbFalconLink.h"
#include "ShimmedFalcon.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace palpate
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
    // Not skipped: a lost wrapper must not look like success.
    ASSERT_TRUE(FalconTestBed::IsPossible()) << "umockdev is not preloaded: use umockdev-wrapper";
    this->Model.StartLoaded();
    this->Bed.Plug(this->Bus, Port);
    LibusbFalconLink link(BusPath);
    ASSERT_TRUE(link.Open().IsOk());
    for (const FtdiRequest& request : FalconBoot::RunMode())
    {
      ASSERT_TRUE(link.Control(request).IsOk());
    }
    FalconRequest push;
    push.Motors = {500, 500, 500};
    const FalconPacket packet = Encoded(push);
    ASSERT_TRUE(link.Send(packet.data(), packet.size()));
    ASSERT_TRUE(Eventually([this] { return this->HasTorque(); }));
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

TEST_F(FalconGuardTest, StopsTheMotorsWhenItsProcessEndsWithoutAWord)
{
  prctl(PR_SET_CHILD_SUBREAPER, 1); // who loses its parent becomes a child of this process
  const pid_t child = fork();
  if (child == 0)
  {
    FalconGuard guard;
    const bool isStarted = guard.Start(this->BusPath);
    _exit(isStarted ? 0 : 1); // no destructor, as where a signal ends a process
  }
  int status = 1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_EQ(status, 0) << "palpate-falcon-guard was not found";
  EXPECT_TRUE(Eventually([this] { return !this->HasTorque(); }));
  EXPECT_GT(waitpid(-1, &status, 0), 0) << "it ends once it has done its work";
  EXPECT_EQ(status, 0);
}

TEST_F(FalconGuardTest, StopsTheMotorsOfADeviceThatLeftTheBusAndIsBack)
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

TEST_F(FalconGuardTest, LeavesADeviceAloneThatWasClosed)
{
  FalconGuard guard;
  ASSERT_TRUE(guard.Start(this->BusPath));
  const std::size_t before = this->Model.Board().Received().size();
  guard.Dismiss(); // returns once the process has ended
  EXPECT_TRUE(this->HasTorque());
  EXPECT_EQ(this->Model.Board().Received().size(), before);
}

TEST_F(FalconGuardTest, LetsADeviceBeOpenedAgainWhileItIsCalled)
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
} // namespace palpate
