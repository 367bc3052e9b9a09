#include "OpenIGTLinkDevice.h"

#include "DeviceContract.h"
#include "IgtlReceived.h"
#include "IgtlTransform.h"
#include "IsSoon.h"
#include "SteadyClock.h"
#include "TouchState.h"

#include <chrono>
#include <functional>
#include <gtest/gtest.h>
#include <igtlClientSocket.h>
#include <igtlSensorMessage.h>
#include <igtlServerSocket.h>
#include <memory>
#include <thread>

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
  ASSERT_TRUE(this->Device->Apply(Vector3(30.0, 40.0, 0.0)));
  Vector3 force = this->NextForce();
  while (force.isZero(0.0)) // the first one lapsed on a slow machine
  {
    force = this->NextForce();
  }
  EXPECT_TRUE(force.isApprox(Vector3(3.0, 4.0, 0.0))) << force.transpose();
  ASSERT_TRUE(this->Device->Apply(Vector3::Constant(std::nan(""))));
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
    ASSERT_TRUE(this->Device->Apply(Vector3(1e-3 * i, 0.0, 0.0)));
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
  this->MoveTo(Vector3(7.0, 0.0, 0.0));
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
