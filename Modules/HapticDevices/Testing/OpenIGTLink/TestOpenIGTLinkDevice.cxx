#include "OpenIGTLinkDevice.h"

#include "DeviceContract.h"
#include "IgtlReceived.h"
#include "IgtlTransform.h"
#include "IsSoon.h"
#include "ManualClock.h"
#include "ReadingPeer.h"
#include "SteadyClock.h"
#include "TouchState.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <igtlClientSocket.h>
#include <igtlSensorMessage.h>
#include <igtlServerSocket.h>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace palpate::openigtlink_device_test
{
namespace
{
using Milliseconds = std::chrono::milliseconds;

// Whether it becomes true within five seconds.
bool Becomes(const std::function<bool()>& isTrue)
{
  return test::IsSoon(isTrue, std::chrono::seconds(5));
}

// A device that listens on this machine, and a peer made of the protocol's own library.
class OpenIGTLinkDeviceTest : public testing::Test
{
protected:
  void SetUp() override
  {
    IgtlPeer peer;
    peer.Port = 0;
    this->Device = std::make_unique<OpenIGTLinkDevice>(this->Time, peer);
    const Status status = this->Device->Open();
    ASSERT_TRUE(status.IsOk()) << status.Message();
    this->Peer = igtl::ClientSocket::New();
    ASSERT_EQ(this->Peer->ConnectToServer("127.0.0.1", this->Device->Port()), 0);
    this->Peer->SetReceiveTimeout(2000);
  }
  void Send(const Vector3& place)
  {
    const auto message = test::IgtlTransform("Stylus", place);
    ASSERT_EQ(this->Peer->Send(message->GetPackPointer(), message->GetPackSize()), 1);
  }
  // Sends a pose, and waits for it.
  void MoveTo(const Vector3& place)
  {
    this->Send(place);
    ASSERT_TRUE(Becomes(
        [&]
        {
          return this->Device->Read(this->Sample) &&
                 Vector3(this->Sample.Position).isApprox(place) &&
                 this->Device->State() == DeviceState::Ready;
        }));
  }
  // The next force that arrives; not finite if none does.
  Vector3 NextForce()
  {
    igtl::MessageHeader::Pointer header = igtl::MessageHeader::New();
    header->InitPack();
    if (this->Peer->Receive(header->GetPackPointer(), header->GetPackSize()) !=
        header->GetPackSize())
    {
      return Vector3::Constant(std::nan(""));
    }
    header->Unpack();
    EXPECT_STREQ(header->GetDeviceType(), "SENSOR");
    igtl::SensorMessage::Pointer sensor = igtl::SensorMessage::New();
    sensor->SetMessageHeader(header);
    sensor->AllocatePack();
    this->Peer->Receive(sensor->GetPackBodyPointer(), sensor->GetPackBodySize());
    EXPECT_NE(sensor->Unpack(1) & igtl::MessageHeader::UNPACK_BODY, 0);
    return {sensor->GetValue(0), sensor->GetValue(1), sensor->GetValue(2)};
  }

  SteadyClock Time;
  std::unique_ptr<OpenIGTLinkDevice> Device;
  igtl::ClientSocket::Pointer Peer;
  DeviceSample Sample;
};

TEST_F(OpenIGTLinkDeviceTest, IsHomingUntilTheFirstPose)
{
  EXPECT_EQ(this->Device->State(), DeviceState::Homing);
  EXPECT_NE(this->Device->Guidance().find(std::to_string(this->Device->Port())), std::string::npos);
  EXPECT_TRUE(this->Device->Read(this->Sample));
  EXPECT_TRUE(this->Device->Apply(Vector3(1.0, 0.0, 0.0)));
  EXPECT_EQ(this->NextForce(), Vector3::Zero());
  this->MoveTo(Vector3(3.0, 4.0, 5.0));
  EXPECT_EQ(this->Device->Guidance(), "");
}

TEST_F(OpenIGTLinkDeviceTest, EveryPoseHasANumberAndATime)
{
  this->MoveTo(Vector3(1.0, 0.0, 0.0));
  const DeviceSample first = this->Sample;
  this->MoveTo(Vector3(2.0, 0.0, 0.0));
  EXPECT_GT(this->Sample.Sequence, first.Sequence);
  EXPECT_GT(this->Sample.Time, first.Time);
}

TEST_F(OpenIGTLinkDeviceTest, ForceReachesThePeerClamped)
{
  this->MoveTo(Vector3::Zero());
  ASSERT_TRUE(this->Device->Apply(Vector3(0.5, -1.0, 0.25)));
  EXPECT_EQ(this->NextForce(), Vector3(0.5, -1.0, 0.25));
  // On a slow machine the peer may have been behind.
  ASSERT_TRUE(Becomes([&] { return this->Device->Apply(Vector3(30.0, 40.0, 0.0)); }));
  Vector3 force = this->NextForce();
  while (force.isZero(0.0)) // the first one lapsed on a slow machine
  {
    force = this->NextForce();
  }
  EXPECT_TRUE(force.isApprox(Vector3(3.0, 4.0, 0.0))) << force.transpose();
  ASSERT_TRUE(Becomes([&] { return this->Device->Apply(Vector3::Constant(std::nan(""))); }));
  EXPECT_EQ(this->NextForce(), Vector3::Zero());
}

TEST_F(OpenIGTLinkDeviceTest, ForceThatIsNotRenewedBecomesZero)
{
  this->MoveTo(Vector3::Zero());
  ASSERT_TRUE(this->Device->Apply(Vector3(1.0, 0.0, 0.0)));
  Vector3 force = this->NextForce();
  // On a slow machine it may lapse before it is sent.
  force = force.isZero(0.0) ? force : this->NextForce();
  EXPECT_EQ(force, Vector3::Zero());
}

TEST_F(OpenIGTLinkDeviceTest, ClosingSendsZeroFirst)
{
  this->MoveTo(Vector3::Zero());
  ASSERT_TRUE(this->Device->Apply(Vector3(1.0, 0.0, 0.0)));
  Vector3 force = this->NextForce();
  this->Device->Close();
  force = force.isZero(0.0) ? force : this->NextForce();
  EXPECT_EQ(force, Vector3::Zero());
  EXPECT_FALSE(this->NextForce().allFinite()) << "nothing comes after it";
}

TEST_F(OpenIGTLinkDeviceTest, PeerThatGoesAwayIsAnError)
{
  this->MoveTo(Vector3::Zero());
  this->Peer->CloseSocket();
  ASSERT_TRUE(Becomes([&] { return this->Device->State() == DeviceState::Error; }));
  EXPECT_FALSE(this->Device->Read(this->Sample));
  EXPECT_FALSE(this->Device->Apply(Vector3::Zero()));
  EXPECT_NE(this->Device->Problem().find("closed the connection"), std::string::npos);
  this->Device->Close();
  EXPECT_TRUE(this->Device->Open().IsOk()) << "it can be opened again";
}

TEST_F(OpenIGTLinkDeviceTest, ForceEndsWhenBytesCannotBeUnderstood)
{
  this->MoveTo(Vector3::Zero());
  ASSERT_TRUE(this->Device->Apply(Vector3(1.0, 0.0, 0.0)));
  Vector3 force = this->NextForce();
  const std::string noise(200, '?');
  this->Peer->Send(noise.data(), static_cast<int>(noise.size()));
  ASSERT_TRUE(Becomes([&] { return this->Device->State() == DeviceState::Error; }));
  force = force.isZero(0.0) ? force : this->NextForce();
  EXPECT_EQ(force, Vector3::Zero());
  EXPECT_NE(this->Device->Problem().find("not OpenIGTLink"), std::string::npos);
}

TEST_F(OpenIGTLinkDeviceTest, PeerIsToldPlacesAndContacts)
{
  this->MoveTo(Vector3::Zero());
  TouchState state;
  state.HasSample = true;
  state.State = DeviceState::Ready;
  state.ProbeWorld = Vector3(1.0, 2.0, 3.0);
  state.ProxyWorld = Vector3(1.0, 2.0, 4.0);
  state.Structure = 1;
  this->Device->Show(state);
  EXPECT_EQ(test::IgtlReceived(*this->Peer).Name, "Probe");
  const test::IgtlReceived proxy(*this->Peer);
  EXPECT_EQ(proxy.Name, "Proxy");
  EXPECT_EQ(proxy.Place(), Vector3(-1.0, -2.0, 4.0)) << "RAS";
  EXPECT_EQ(test::IgtlReceived(*this->Peer).Name, "ContactForce");
  const test::IgtlReceived event(*this->Peer);
  EXPECT_EQ(event.Name, "Event");
  EXPECT_TRUE(event.Says("contact with structure 2"));
}

TEST_F(OpenIGTLinkDeviceTest, PeerThatReadsNothingDelaysNothing)
{
  this->MoveTo(Vector3::Zero());
  for (int i = 1; i <= 3000; ++i)
  {
    static_cast<void>(this->Device->Apply(Vector3(1e-3 * i, 0.0, 0.0)));
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
  this->MoveTo(Vector3(7.0, 0.0, 0.0));
}

// A device whose forces count calls of Apply: call n is n times a milli-newton. What the peer
// receives, in order, and the newest call when it did.
class ForcesInTime : public testing::Test
{
protected:
  struct Arrival
  {
    double Force;
    int Call;
    bool IsZero() const { return this->Force == 0.0; }
    int Age() const { return this->Call - static_cast<int>(std::lround(1e3 * this->Force)); }
  };

  void Connect(int buffer)
  {
    IgtlPeer peer;
    peer.Port = 0;
    this->Device = std::make_unique<OpenIGTLinkDevice>(this->Time, peer);
    ASSERT_TRUE(this->Device->Open().IsOk());
    this->Peer = std::make_unique<test::ReadingPeer>(this->Device->Port(), buffer);
    ASSERT_TRUE(this->Peer->IsConnected);
    this->Peer->SendPose(Vector3::Zero());
    ASSERT_TRUE(Becomes([&] { return this->Device->State() == DeviceState::Ready; }));
  }
  // A tick of about a millisecond, in which the peer reads at most `most` messages.
  void Tick(std::size_t most)
  {
    ++this->Calls;
    this->IsTaken = this->Device->Apply(Vector3(1e-3 * this->Calls, 0.0, 0.0));
    std::this_thread::sleep_for(Milliseconds(1));
    for (const double force : this->Peer->Read(most, 0))
    {
      this->Arrivals.push_back({force, this->Calls});
    }
  }
  void Tick(int count, std::size_t most)
  {
    for (int i = 0; i < count; ++i)
    {
      this->Tick(most);
    }
  }
  bool ReadsForcesAgain()
  {
    const std::size_t before = this->Arrivals.size();
    return Becomes(
        [&]
        {
          this->Tick(Everything);
          return this->IsTaken && this->Arrivals.size() > before &&
                 !this->Arrivals.back().IsZero() && this->Arrivals.back().Age() < Late;
        });
  }

  int OldestForce() const
  {
    int oldest = 0;
    for (const Arrival& one : this->Arrivals)
    {
      oldest = one.IsZero() ? oldest : std::max(oldest, one.Age());
    }
    return oldest;
  }

  static constexpr std::size_t Everything = 1000;
  static constexpr int Late =
      50; // ticks: 30 ms until a peer is behind, and those of a busy machine
  SteadyClock Time;
  std::unique_ptr<OpenIGTLinkDevice> Device;
  std::unique_ptr<test::ReadingPeer> Peer;
  std::vector<Arrival> Arrivals;
  int Calls = 0;
  bool IsTaken = false;
};
TEST_F(ForcesInTime, PeerThatReadsInTimeGetsNewForces)
{
  this->Connect(0);
  this->Tick(200, Everything);
  EXPECT_TRUE(this->ReadsForcesAgain());
  EXPECT_LE(this->OldestForce(), Late);
}

TEST_F(ForcesInTime, SlowPeerThatConfirmsGetsNoOldForce)
{
  this->Connect(0);
  this->Peer->Confirms = true;
  this->Tick(100, Everything);
  constexpr int Slowness = 5;
  for (int i = 0; i < 200; ++i)
  {
    this->Tick(Slowness - 1, 0);
    this->Tick(1);
  }
  constexpr int OnTheirWay = static_cast<int>(OpenIGTLinkDevice::MostOnTheirWay);
  EXPECT_LE(this->OldestForce(), Slowness * OnTheirWay + Late);
  EXPECT_TRUE(this->ReadsForcesAgain());
}

TEST_F(ForcesInTime, PeerThatStallsGetsZeroBeforeNewForces)
{
  this->Connect(0);
  this->Peer->Confirms = true;
  this->Tick(100, Everything);
  this->Arrivals.clear();
  this->Tick(300, 0);
  EXPECT_FALSE(this->IsTaken) << "Apply says what is not sent";
  EXPECT_NE(this->Device->ConnectionReport().find("forces were not sent"), std::string::npos);
  ASSERT_TRUE(this->ReadsForcesAgain());
  const auto zero = std::find_if(this->Arrivals.begin(), this->Arrivals.end(),
                                 [](const Arrival& one) { return one.IsZero(); });
  EXPECT_LE(zero - this->Arrivals.begin(),
            static_cast<std::ptrdiff_t>(OpenIGTLinkDevice::MostOnTheirWay))
      << "what the peer's system had when it stalled";
  this->Arrivals.erase(this->Arrivals.begin(), zero);
  EXPECT_LE(this->OldestForce(), Late);
}

TEST_F(ForcesInTime, PeerThatConfirmsMoreThanWasSentGetsForces)
{
  this->Connect(0);
  for (int i = 0; i < 100; ++i)
  {
    this->Peer->Confirm();
  }
  this->Tick(20, Everything);
  EXPECT_TRUE(this->ReadsForcesAgain());
}

// No byte leaves while the system's buffer is full, as with a lost cable.
TEST_F(ForcesInTime, ConnectionThatTakesNothingGetsZeroBeforeNewForces)
{
  constexpr int SmallBuffer = 2048;
  this->Connect(SmallBuffer);
  this->Tick(100, Everything);
  this->Arrivals.clear();
  ASSERT_TRUE(Becomes(
      [&]
      {
        this->Tick(50, 0);
        return !this->IsTaken;
      }));
  const int lost = this->Calls;
  this->Tick(200, 0);
  ASSERT_TRUE(this->ReadsForcesAgain());
  const auto fresh = std::find_if(this->Arrivals.begin(), this->Arrivals.end(),
                                  [&](const Arrival& one) { return one.Call - one.Age() > lost; });
  ASSERT_NE(fresh, this->Arrivals.begin());
  EXPECT_TRUE(std::prev(fresh)->IsZero());
  this->Arrivals.erase(this->Arrivals.begin(), fresh);
  EXPECT_LE(this->OldestForce(), Late);
}

// Time stands still but for the test.
class ForcesInStillTime : public testing::Test
{
protected:
  void Connect(int buffer)
  {
    IgtlPeer local;
    local.Port = 0;
    this->Device = std::make_unique<OpenIGTLinkDevice>(this->Time, local);
    ASSERT_TRUE(this->Device->Open().IsOk());
    this->Peer = std::make_unique<test::ReadingPeer>(this->Device->Port(), buffer);
    this->Pass(0);
  }
  // The device looks at what the peer sent, and sends what there is, before this returns: between
  // two poses.
  void Pass(std::int64_t nanoseconds)
  {
    this->Time.Advance(nanoseconds);
    for (int i = 0; i < 2; ++i)
    {
      DeviceSample before;
      this->Device->Read(before);
      this->Peer->SendPose(Vector3::Zero());
      ASSERT_TRUE(Becomes(
          [&]
          {
            DeviceSample now;
            return this->Device->Read(now) && now.Sequence > before.Sequence;
          }));
    }
  }
  bool Apply(double force) { return this->Device->Apply(Vector3(force, 0.0, 0.0)); }

  static constexpr std::int64_t Millisecond = 1'000'000; // ns
  ManualClock Time;
  std::unique_ptr<OpenIGTLinkDevice> Device;
  std::unique_ptr<test::ReadingPeer> Peer;
};

TEST_F(ForcesInStillTime, ForceLastsTwentyMilliseconds)
{
  this->Connect(0);
  ASSERT_TRUE(this->Apply(1.0));
  EXPECT_EQ(this->Peer->Read(1, 2000), std::vector<double>{1.0});
  this->Pass(20 * Millisecond);
  EXPECT_TRUE(this->Peer->Read(1, 0).empty());
  this->Pass(1);
  EXPECT_EQ(this->Peer->Read(1, 2000), std::vector<double>{0.0});
}

TEST_F(ForcesInStillTime, PeerThatConfirmsTooLateGetsZeroInsteadOfANewForce)
{
  this->Connect(0);
  for (const double force : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6})
  {
    ASSERT_TRUE(this->Apply(force));
    EXPECT_EQ(this->Peer->Read(1, 2000), std::vector<double>{force});
    if (force == 0.1)
    {
      this->Peer->Confirm();
      this->Pass(0);
    }
  }
  // Five that are not confirmed leave no room for the seventh.
  this->Pass(30 * Millisecond);
  ASSERT_TRUE(this->Apply(0.7));
  this->Pass(1);
  EXPECT_FALSE(this->Apply(0.8));
  EXPECT_TRUE(this->Peer->Read(1, 0).empty());
  for (int i = 0; i < 4; ++i)
  {
    this->Peer->Confirm();
  }
  this->Pass(0);
  EXPECT_EQ(this->Peer->Read(1, 2000), std::vector<double>{0.0});
}

// Its buffer full, a system confirms nothing any more.
TEST_F(ForcesInStillTime, FewForcesWaitForAConnectionThatTakesNothing)
{
  this->Connect(2048);
  for (int i = 1; i <= 200; ++i)
  {
    ASSERT_TRUE(this->Apply(1e-3 * i));
    this->Pass(0);
  }
  const std::size_t arrived = this->Peer->Waiting();
  const std::size_t sent = this->Peer->Read(1000, 500).size();
  EXPECT_LT(sent, 200U);
  EXPECT_LE(sent * test::ReadingPeer::ForceBytes,
            arrived + OpenIGTLinkDevice::MostOnTheirWay * test::ReadingPeer::ForceBytes);
}

TEST(OpenIGTLinkDevice, KeepsTheContractOfDevices)
{
  SteadyClock time;
  IgtlPeer peer;
  peer.Port = 0;
  OpenIGTLinkDevice device(time, peer);
  igtl::ClientSocket::Pointer socket;
  const auto sendPose = [&]
  {
    if (device.State() == DeviceState::Homing)
    {
      socket = igtl::ClientSocket::New();
      socket->ConnectToServer("127.0.0.1", device.Port());
    }
    const auto message = test::IgtlTransform("Stylus", Vector3::Zero());
    const std::int64_t before = time.Now();
    socket->Send(message->GetPackPointer(), message->GetPackSize());
    DeviceSample sample;
    Becomes(
        [&] {
          return device.State() == DeviceState::Ready && device.Read(sample) &&
                 sample.Time > before;
        });
  };
  test::ExpectDeviceContract(device, sendPose);
}

TEST(OpenIGTLinkDevice, ConnectsToAPeerThatListens)
{
  SteadyClock time;
  igtl::ServerSocket::Pointer server = igtl::ServerSocket::New();
  ASSERT_EQ(server->CreateServer(0), 0);
  IgtlPeer peer;
  peer.Host = "127.0.0.1";
  peer.Port = server->GetServerPort();
  OpenIGTLinkDevice device(time, peer);
  ASSERT_TRUE(device.Open().IsOk());
  const igtl::ClientSocket::Pointer socket = server->WaitForConnection(2000);
  ASSERT_TRUE(socket.IsNotNull());
  const auto message = test::IgtlTransform("Stylus", Vector3(1.0, 2.0, 3.0));
  socket->Send(message->GetPackPointer(), message->GetPackSize());
  DeviceSample sample;
  EXPECT_TRUE(Becomes([&] { return device.State() == DeviceState::Ready; }));
  ASSERT_TRUE(device.Read(sample));
  EXPECT_EQ(Vector3(sample.Position), Vector3(1.0, 2.0, 3.0));
}

TEST(OpenIGTLinkDevice, MissingPeerIsNamed)
{
  SteadyClock time;
  IgtlPeer peer;
  peer.Host = "127.0.0.1";
  peer.Port = 1; // reserved
  OpenIGTLinkDevice device(time, peer);
  const Status status = device.Open();
  ASSERT_FALSE(status.IsOk());
  EXPECT_NE(status.Message().find("127.0.0.1 does not answer on port 1"), std::string::npos)
      << status.Message();
  EXPECT_EQ(device.State(), DeviceState::Closed);
}

TEST(OpenIGTLinkDevice, ArgumentsNameAPeer)
{
  IgtlPeer peer;
  ASSERT_TRUE(ParseIgtlPeer("", peer).IsOk());
  EXPECT_EQ(peer.Port, 18944);
  EXPECT_EQ(peer.Host, "");
  ASSERT_TRUE(ParseIgtlPeer("tracker.local:4000/Stylus", peer).IsOk());
  EXPECT_EQ(peer.Host, "tracker.local");
  EXPECT_EQ(peer.Port, 4000);
  EXPECT_EQ(peer.Name, "Stylus");
  for (const char* wrong : {"0", "65536", "host:", "a", "host:4000x"})
  {
    const bool isDefault = std::string(wrong) == "host:";
    EXPECT_EQ(ParseIgtlPeer(wrong, peer).IsOk(), isDefault) << wrong;
  }
}
} // namespace
} // namespace palpate::openigtlink_device_test
