#include "IgtlPackedImage.h"
#include "IgtlReceived.h"
#include "IgtlStream.h"
#include "StartedCommand.h"
#include "SyntheticFiles.h"
#include "VolumeFile.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <igtlClientSocket.h>
#include <igtlPolyDataMessage.h>
#include <igtlServerSocket.h>
#include <set>

namespace palpate::cli_link_test
{
namespace
{
using namespace palpate::test;

// A program that waits for palpate, made of the protocol's own library.
class WaitingPeer
{
public:
  WaitingPeer()
  {
    while (this->Server->CreateServer(this->Port) != 0)
    {
      ++this->Port;
    }
  }
  std::string Address() const { return "localhost:" + std::to_string(this->Port); }
  void Meet()
  {
    this->Socket = this->Server->WaitForConnection(60000);
    ASSERT_TRUE(this->Socket.IsNotNull());
    this->Socket->SetReceiveTimeout(60000);
  }
  void SendImage(std::array<int, 3> size) const
  {
    const std::vector<std::uint8_t> image = IgtlPackedImage(size);
    ASSERT_EQ(this->Socket->Send(image.data(), image.size()), 1);
  }

  igtl::ClientSocket::Pointer Socket;

private:
  igtl::ServerSocket::Pointer Server = igtl::ServerSocket::New();
  int Port = 20000 + static_cast<int>(getpid()) % 10000;
};

TEST(CliLink, ImagesOfAnEarlierCallAreKept)
{
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "in");
  std::ofstream(folder / "in/image-1.nrrd") << "earlier";
  WaitingPeer peer;
  StartedCommand link(PALPATE_PROGRAM, {"link", peer.Address(), "--output", "in", "--images", "1"},
                      folder.Path());
  peer.Meet();
  peer.SendImage({5, 4, 3});
  const CommandRun run = link.Finish();
  EXPECT_EQ(run.Output, "in/image-2.nrrd: 5 x 4 x 3 voxels\n");
  EXPECT_EQ(std::filesystem::file_size(folder / "in/image-1.nrrd"), 7U);
}

TEST(CliLink, ImageOfAPeerIsAFileOnItsGrid)
{
  const TemporaryFolder folder;
  WaitingPeer peer;
  StartedCommand link(PALPATE_PROGRAM, {"link", peer.Address(), "--output", "in", "--images", "1"},
                      folder.Path());
  peer.Meet();
  peer.SendImage({5, 4, 3});
  const CommandRun run = link.Finish();
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(run.Output, "in/image-1.nrrd: 5 x 4 x 3 voxels\n");
  const Volume volume = ReadVolume(folder / "in/image-1.nrrd");
  EXPECT_EQ(volume.Image->GetDimensions()[0], 5);
  EXPECT_NEAR(volume.Image->GetSpacing()[1], 1.5, 1e-6); // single precision
  // The centre of the grid is where the sender said, in LPS.
  double center[3];
  volume.Image->TransformContinuousIndexToPhysicalPoint(2.0, 1.5, 1.0, center);
  EXPECT_NEAR(center[0], -10.0, 1e-5);
  EXPECT_NEAR(center[1], -20.0, 1e-5);
  EXPECT_NEAR(center[2], -30.0, 1e-5);
}

TEST(CliLink, ImageOfOneSliceIsNamedAndLeavesNoFile)
{
  const TemporaryFolder folder;
  WaitingPeer peer;
  StartedCommand link(PALPATE_PROGRAM, {"link", peer.Address(), "--output", "in", "--images", "1"},
                      folder.Path());
  peer.Meet();
  for (const int slices : {1, 1, 2})
  {
    peer.SendImage({5, 4, slices});
  }
  const CommandRun run = link.Finish();
  EXPECT_EQ(run.Code, 0);
  const std::size_t first = run.Errors.find("two-dimensional");
  EXPECT_NE(first, std::string::npos) << run.Errors;
  EXPECT_EQ(run.Errors.find("two-dimensional", first + 1), std::string::npos) << "told once";
  EXPECT_EQ(run.Output, "in/image-1.nrrd: 5 x 4 x 2 voxels\n");
}

// Each image has 120 bytes of voxels.
TEST(CliLink, EndsWithOneMessageWhereTheTotalIsReached)
{
  const TemporaryFolder folder;
  WaitingPeer peer;
  StartedCommand link(PALPATE_PROGRAM,
                      {"link", peer.Address(), "--output", "in", "--gigabytes", "1e-6"},
                      folder.Path());
  peer.Meet();
  for (int image = 0; image < 12; ++image)
  {
    peer.SendImage({5, 4, 3});
  }
  const CommandRun run = link.Finish();
  EXPECT_EQ(run.Code, 1);
  const std::size_t first = run.Errors.find("more than 1e-06 GB");
  EXPECT_NE(first, std::string::npos) << run.Errors;
  EXPECT_EQ(run.Errors.find("more than", first + 1), std::string::npos) << run.Errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "in/image-8.nrrd"));
  EXPECT_FALSE(std::filesystem::exists(folder / "in/image-9.nrrd"));
}

TEST(CliLink, TakesNoMoreImagesThanAskedFor)
{
  const TemporaryFolder folder;
  WaitingPeer peer;
  StartedCommand link(PALPATE_PROGRAM, {"link", peer.Address(), "--output", "in", "--images", "2"},
                      folder.Path());
  peer.Meet();
  for (int image = 0; image < 6; ++image)
  {
    peer.SendImage({5, 4, 3});
  }
  EXPECT_EQ(link.Finish().Code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "in/image-3.nrrd"));
}

TEST(CliLink, PeerGetsTheModelUntilTheProgramIsInterrupted)
{
  const TemporaryFolder folder;
  WriteNearlyASphere(folder / "gland.json");
  WaitingPeer peer;
  StartedCommand link(PALPATE_PROGRAM, {"link", peer.Address(), "gland.json", "--frequency", "3"},
                      folder.Path());
  peer.Meet();
  igtl::MessageHeader::Pointer header = igtl::MessageHeader::New();
  header->InitPack();
  ASSERT_EQ(peer.Socket->Receive(header->GetPackPointer(), header->GetPackSize()),
            header->GetPackSize());
  header->Unpack();
  EXPECT_STREQ(header->GetDeviceName(), "Palpate model 1") << "no name of a file";
  igtl::PolyDataMessage::Pointer message = igtl::PolyDataMessage::New();
  message->SetMessageHeader(header);
  message->AllocatePack();
  peer.Socket->Receive(message->GetPackBodyPointer(), message->GetPackBodySize());
  ASSERT_NE(message->Unpack(1) & igtl::MessageHeader::UNPACK_BODY, 0);
  EXPECT_EQ(message->GetPolygons()->GetNumberOfCells(), 180U);
  link.Send(SIGINT);
  EXPECT_EQ(link.Finish().Code, 130);
}

TEST(CliLink, WaitsForOneProgramAfterTheOther)
{
  const TemporaryFolder folder;
  const int port = 30000 + static_cast<int>(getpid()) % 10000;
  StartedCommand link(PALPATE_PROGRAM,
                      {"link", std::to_string(port), "--output", "in", "--images", "2"},
                      folder.Path());
  const std::vector<std::uint8_t> image = IgtlPackedImage({5, 4, 3});
  for (int round = 0; round < 2; ++round)
  {
    IgtlStream peer;
    ASSERT_TRUE(IsSoon([&] { return peer.Connect("127.0.0.1", port).IsOk(); }));
    ASSERT_EQ(peer.Send(image.data(), image.size()), static_cast<std::ptrdiff_t>(image.size()));
  }
  EXPECT_EQ(link.Finish().Code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "in/image-2.nrrd"));
}

// A machine that stalls delays the servo, which then rests and goes on: that is said, and no fault
// of a link.
void ExpectItWentThrough(const CommandRun& run)
{
  const bool wasDelayed =
      run.Errors.find("The servo was delayed for too long: touching goes on by itself") !=
      std::string::npos;
  EXPECT_EQ(run.Code, wasDelayed ? 1 : 0) << run.Errors;
}

TEST(CliLink, TouchIsShownToThePeerAndEndsWithoutForce)
{
  const TemporaryFolder folder;
  WriteNearlyASphere(folder / "gland.json");
  WaitingPeer peer;
  StartedCommand touch(
      PALPATE_PROGRAM,
      {"touch", "gland.json", "--real-time", "--seconds", "1", "--igtl", peer.Address()},
      folder.Path());
  peer.Meet();
  std::set<std::string> names;
  bool isPressed = false;
  Vector3 force = Vector3::Zero();
  std::string event;
  for (;;)
  {
    const IgtlReceived message(*peer.Socket);
    if (message.Name.empty())
    {
      break;
    }
    names.insert(message.Kind + " " + message.Name);
    force = message.Name == "ContactForce" ? message.Values() : force;
    isPressed = isPressed || !force.isZero(0.0);
    event = message.Says("the touch has ended") ? "ended" : event;
  }
  ExpectItWentThrough(touch.Finish());
  EXPECT_EQ(names, (std::set<std::string>{"POLYDATA Palpate model 1", "SENSOR ContactForce",
                                          "STRING Event", "TRANSFORM Probe", "TRANSFORM Proxy"}));
  EXPECT_TRUE(isPressed);
  EXPECT_EQ(force, Vector3::Zero());
  EXPECT_EQ(event, "ended");
}

TEST(CliLink, TouchGoesOnWithoutAPeer)
{
  const TemporaryFolder folder;
  WriteNearlyASphere(folder / "gland.json");
  const int port = 10000 + static_cast<int>(getpid()) % 10000;
  const CommandRun run = RunPalpate(
      {"touch", "gland.json", "--real-time", "--seconds", "0.2", "--igtl", std::to_string(port)},
      folder.Path());
  ExpectItWentThrough(run);
}

TEST(CliLink, BadCallsAreOneMessage)
{
  const TemporaryFolder folder;
  WriteNearlyASphere(folder / "gland.json");
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{"link", "18944"},
        {"link", "99999", "--output", "in"},
        {"link", "18944", "absent.json"},
        {"link", "localhost:1", "--output", "in"},
        {"touch", "gland.json", "--igtl", "18944"},
        {"touch", "gland.json", "--real-time", "--igtl", "99999"},
        {"touch", "gland.json", "--real-time", "--igtl", "localhost:1"}})
  {
    const CommandRun run = RunPalpate(call, folder.Path());
    EXPECT_EQ(run.Code, 2) << run.Errors;
    EXPECT_EQ(run.Errors.find('\n'), run.Errors.size() - 1) << run.Errors;
  }
}
} // namespace
} // namespace palpate::cli_link_test
