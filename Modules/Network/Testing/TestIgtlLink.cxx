#include "IgtlLink.h"

#include "IgtlMessages.h"
#include "IgtlPackedImage.h"
#include "IgtlReceived.h"
#include "IgtlStream.h"
#include "IsSoon.h"

#include <chrono>
#include <cstring>
#include <functional>
#include <gtest/gtest.h>
#include <igtlClientSocket.h>
#include <igtlPolyDataMessage.h>
#include <igtlServerSocket.h>
#include <igtl_header.h>

namespace palpate::igtl_link_test
{
namespace
{
using Bytes = std::vector<std::uint8_t>;

// Whether it becomes true within five seconds.
bool LinkBecomes(const std::function<bool()>& isTrue)
{
  return test::IsSoon(isTrue, std::chrono::seconds(5));
}

IndexedMesh Tetrahedron()
{
  return {{Vector3(1.0, 2.0, 3.0), Vector3(5.0, 2.0, 3.0), Vector3(1.0, 7.0, 3.0),
           Vector3(1.0, 2.0, 9.0)},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

// A link that listens on this machine, and peers made of the protocol's own library.
class IgtlLinkTest : public testing::Test
{
protected:
  void SetUp() override
  {
    IgtlPeer anyPort;
    anyPort.Port = 0;
    const Status status = this->Link.Open(anyPort);
    ASSERT_TRUE(status.IsOk()) << status.Message();
  }
  igtl::ClientSocket::Pointer Connected() const
  {
    igtl::ClientSocket::Pointer peer = igtl::ClientSocket::New();
    EXPECT_EQ(peer->ConnectToServer("127.0.0.1", this->Link.Port()), 0);
    peer->SetReceiveTimeout(3000);
    return peer;
  }
  static void Send(igtl::ClientSocket& peer, const Bytes& bytes)
  {
    ASSERT_EQ(peer.Send(bytes.data(), bytes.size()), 1);
  }
  std::optional<IgtlImage> NextImage()
  {
    std::optional<IgtlImage> image;
    LinkBecomes([&] { return (image = this->Link.TakeImage()).has_value(); });
    return image;
  }
  // The corners of the surface that arrives next.
  static std::vector<Vector3> NextSurface(igtl::ClientSocket& peer)
  {
    igtl::MessageHeader::Pointer header = igtl::MessageHeader::New();
    header->InitPack();
    if (peer.Receive(header->GetPackPointer(), header->GetPackSize()) != header->GetPackSize())
    {
      return {};
    }
    header->Unpack();
    EXPECT_STREQ(header->GetDeviceType(), "POLYDATA");
    igtl::PolyDataMessage::Pointer message = igtl::PolyDataMessage::New();
    message->SetMessageHeader(header);
    message->AllocatePack();
    peer.Receive(message->GetPackBodyPointer(), message->GetPackBodySize());
    EXPECT_NE(message->Unpack(1) & igtl::MessageHeader::UNPACK_BODY, 0);
    EXPECT_EQ(message->GetPolygons()->GetNumberOfCells(), 4U);
    std::vector<Vector3> points;
    for (int i = 0; i < message->GetPoints()->GetNumberOfPoints(); ++i)
    {
      igtlFloat32 point[3];
      message->GetPoints()->GetPoint(static_cast<unsigned>(i), point);
      points.emplace_back(point[0], point[1], point[2]);
    }
    return points;
  }
  bool Reports(const std::string& part)
  {
    return LinkBecomes(
        [&]
        {
          const std::vector<std::string> problems = this->Link.TakeProblems();
          return std::any_of(problems.begin(), problems.end(),
                             [&](const std::string& problem)
                             { return problem.find(part) != std::string::npos; });
        });
  }

  IgtlLink Link;
};

TEST_F(IgtlLinkTest, ImagesArriveInTheirOrder)
{
  const auto peer = this->Connected();
  for (int width = 2; width < 9; ++width)
  {
    Send(*peer, test::IgtlPackedImage({width, 3, 2}));
  }
  for (int width = 2; width < 9; ++width)
  {
    const std::optional<IgtlImage> image = this->NextImage();
    ASSERT_TRUE(image.has_value()) << width;
    EXPECT_EQ(image->Size[0], width);
  }
}

TEST_F(IgtlLinkTest, EveryPeerGetsEveryModelInRas)
{
  this->Link.Offer({IgtlSurfaceMessage("first", Tetrahedron())});
  for (int round = 0; round < 2; ++round)
  {
    const auto peer = this->Connected();
    const std::vector<Vector3> points = NextSurface(*peer);
    ASSERT_EQ(points.size(), 4U);
    EXPECT_EQ(points[2], Vector3(-1.0, -7.0, 3.0));
    peer->CloseSocket();
    ASSERT_TRUE(LinkBecomes([&] { return !this->Link.HasPeer(); }));
  }
}

TEST_F(IgtlLinkTest, ModelOfferedLaterIsSentToo)
{
  const auto peer = this->Connected();
  ASSERT_TRUE(LinkBecomes([&] { return this->Link.HasPeer(); }));
  this->Link.Offer({IgtlSurfaceMessage("late", Tetrahedron())});
  EXPECT_FALSE(this->Link.IsAllSent());
  EXPECT_EQ(NextSurface(*peer).size(), 4U);
  EXPECT_TRUE(LinkBecomes([&] { return this->Link.IsAllSent(); }));
}

TEST_F(IgtlLinkTest, PeerThatDiesInAnImageLeavesNone)
{
  auto peer = this->Connected();
  Bytes half = test::IgtlPackedImage({90, 90, 20});
  half.resize(half.size() / 2);
  Send(*peer, half);
  peer->CloseSocket();
  EXPECT_TRUE(this->Reports("gone"));
  EXPECT_FALSE(this->Link.TakeImage().has_value());
  // The next peer begins afresh.
  peer = this->Connected();
  Send(*peer, test::IgtlPackedImage({5, 3, 2}));
  EXPECT_TRUE(this->NextImage().has_value());
}

TEST_F(IgtlLinkTest, DamagedImageIsReportedAndTheNextIsTaken)
{
  const auto peer = this->Connected();
  Bytes damaged = test::IgtlPackedImage({5, 3, 2});
  damaged.back() ^= 1U;
  Send(*peer, damaged);
  EXPECT_TRUE(this->Reports("damaged"));
  Send(*peer, test::IgtlPackedImage({6, 3, 2}));
  const std::optional<IgtlImage> image = this->NextImage();
  ASSERT_TRUE(image.has_value());
  EXPECT_EQ(image->Size[0], 6);
}

// Only the header is sent, so a limit that is checked later would not be told.
TEST_F(IgtlLinkTest, ImageThatIsTooLongIsNamedWhenItBegins)
{
  const auto peer = this->Connected();
  igtl_header header;
  const Bytes image = test::IgtlPackedImage({5, 3, 2});
  std::memcpy(&header, image.data(), sizeof header);
  igtl_header_convert_byte_order(&header);
  header.body_size = IgtlLink::MostImageBytes + 1;
  igtl_header_convert_byte_order(&header);
  Bytes claim(sizeof header);
  std::memcpy(claim.data(), &header, sizeof header);
  Send(*peer, claim);
  EXPECT_TRUE(this->Reports("longer than 1 GiB"));
}

// What is not taken stays with the peer: the link keeps some images, and the systems some bytes.
TEST_F(IgtlLinkTest, PeerWaitsWhileNobodyTakesItsImages)
{
  constexpr int Offered = 60;
  const Bytes image = test::IgtlPackedImage({128, 128, 64}); // 2 MB
  IgtlStream peer;
  ASSERT_TRUE(peer.Connect("127.0.0.1", this->Link.Port()).IsOk());
  std::size_t sent = 0;
  const auto sendsMore = [&]
  {
    const std::ptrdiff_t count =
        peer.Send(image.data() + sent % image.size(), image.size() - sent % image.size());
    sent += count > 0 ? static_cast<std::size_t>(count) : 0;
    return count != 0;
  };
  while (sent < Offered * image.size() && test::IsSoon(sendsMore, std::chrono::seconds(1)))
  {
  }
  EXPECT_LT(sent, Offered / 2 * image.size());
}

TEST_F(IgtlLinkTest, NoiseEndsThePeer)
{
  const auto peer = this->Connected();
  Send(*peer, Bytes(200, 0xA5));
  EXPECT_TRUE(this->Reports("not OpenIGTLink"));
  EXPECT_FALSE(this->Link.HasEnded()) << "one that listens goes on";
}

TEST(IgtlLink, ConnectsToAProgramThatWaits)
{
  igtl::ServerSocket::Pointer server = igtl::ServerSocket::New();
  int port = 23456;
  while (server->CreateServer(port) != 0)
  {
    ASSERT_LT(++port, 24000);
  }
  IgtlLink link;
  IgtlPeer peer;
  peer.Host = "127.0.0.1";
  peer.Port = port;
  const Status status = link.Open(peer);
  ASSERT_TRUE(status.IsOk()) << status.Message();
  igtl::ClientSocket::Pointer other = server->WaitForConnection(3000);
  ASSERT_TRUE(other.IsNotNull());
  other->CloseSocket();
  EXPECT_TRUE(LinkBecomes([&] { return link.HasEnded(); }));
}

IgtlTouch Pressing()
{
  IgtlTouch touch;
  touch.ProbeWorld = Vector3(1.0, 2.0, 3.0);
  touch.ProxyWorld = Vector3(1.0, 2.0, 4.0);
  touch.ForceWorld = Vector3(0.25, 0.5, 2.0);
  touch.Structure = 1;
  touch.Tick = 7;
  return touch;
}

TEST_F(IgtlLinkTest, TouchIsToldInRas)
{
  const auto peer = this->Connected();
  this->Link.Show(Pressing());
  const test::IgtlReceived probe(*peer);
  EXPECT_EQ(probe.Name, "Probe");
  EXPECT_EQ(probe.Place(), Vector3(-1.0, -2.0, 3.0));
  const test::IgtlReceived proxy(*peer);
  EXPECT_EQ(proxy.Name, "Proxy");
  EXPECT_EQ(proxy.Place(), Vector3(-1.0, -2.0, 4.0));
  const test::IgtlReceived force(*peer);
  EXPECT_EQ(force.Name, "ContactForce");
  EXPECT_EQ(force.Values(), Vector3(-0.25, -0.5, 2.0));
  EXPECT_TRUE(test::IgtlReceived(*peer).Says("contact with structure 2"));
}

TEST_F(IgtlLinkTest, EndOfATouchIsAForceOfZero)
{
  const auto peer = this->Connected();
  this->Link.Show(Pressing());
  while (test::IgtlReceived(*peer).Name != "Event")
  {
  }
  this->Link.EndTouch();
  EXPECT_EQ(test::IgtlReceived(*peer).Name, "Probe");
  EXPECT_EQ(test::IgtlReceived(*peer).Name, "Proxy");
  EXPECT_EQ(test::IgtlReceived(*peer).Values(), Vector3::Zero());
  EXPECT_TRUE(test::IgtlReceived(*peer).Says("contact ends"));
  EXPECT_TRUE(test::IgtlReceived(*peer).Says("forces are off: the touch has ended"));
}

TEST_F(IgtlLinkTest, PeerThatConnectsDuringATouchIsToldOfItAndGetsTheModels)
{
  this->Link.Offer({IgtlSurfaceMessage("organ", Tetrahedron())});
  this->Link.Show(Pressing());
  const auto peer = this->Connected();
  for (const char* name : {"Probe", "Proxy", "ContactForce", "Event", "organ"})
  {
    EXPECT_EQ(test::IgtlReceived(*peer).Name, name);
  }
  EXPECT_TRUE(LinkBecomes([&] { return this->Link.IsAllSent(); }));
}

// A connection takes some 3 MB; the messages of all ticks would be ten times as much.
TEST_F(IgtlLinkTest, PeerThatDoesNotReadGetsTheNewestTickAfterwards)
{
  const auto peer = this->Connected();
  IgtlTouch touch = Pressing();
  ASSERT_TRUE(LinkBecomes([&] { return this->Link.HasPeer(); }));
  for (; touch.Tick < 100000; ++touch.Tick)
  {
    touch.ProbeWorld.Z = static_cast<double>(touch.Tick);
    this->Link.Show(touch);
  }
  double last = 0.0;
  int received = 0;
  while (last < 99999.0)
  {
    const test::IgtlReceived message(*peer);
    ASSERT_FALSE(message.Name.empty());
    last = message.Name == "Probe" ? message.Place().z() : last;
    ++received;
  }
  EXPECT_LT(received, 50000);
}
} // namespace
} // namespace palpate::igtl_link_test
