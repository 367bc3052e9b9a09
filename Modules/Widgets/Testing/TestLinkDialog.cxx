// Images from and surfaces to a peer made of OpenIGTLink's own library.
#include "LinkDialog.h"

#include "IgtlPackedImage.h"
#include "IgtlReceived.h"
#include "WindowTest.h"

#include <QPointer>

#include <algorithm>
#include <array>
#include <igtlClientSocket.h>
#include <igtlMessageHeader.h>
#include <igtlServerSocket.h>

namespace palpate::link_dialog_test
{
namespace
{
class LinkDialogTest : public test::WindowTest
{
protected:
  void SetUp() override
  {
    test::WindowTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    while (this->Server->CreateServer(this->Port) != 0)
    {
      ++this->Port;
    }
    this->Action("Link with other programs...")->trigger();
    this->Dialog = this->Window->findChild<LinkDialog*>();
    ASSERT_NE(this->Dialog, nullptr);
    this->Dialog->findChild<QLineEdit*>("link-folder")
        ->setText(QString::fromStdString((this->Phantom.Folder / "in").string()));
  }
  QPushButton* Switch() const { return this->Dialog->findChild<QPushButton*>("link-switch"); }
  QString State() const { return this->Dialog->findChild<QLabel*>("link-state")->text(); }
  void TypeAddress(const QString& address)
  {
    this->Dialog->findChild<QLineEdit*>("link-address")->setText(address);
  }
  // Connected to the test's peer.
  void Connect()
  {
    this->TypeAddress(QString("localhost:%1").arg(this->Port));
    this->Switch()->click();
    this->Peer = this->Server->WaitForConnection(60000);
    ASSERT_TRUE(this->Peer.IsNotNull());
    this->Peer->SetReceiveTimeout(60000);
    WaitUntil([this] { return this->State().startsWith("Connected"); });
  }
  void SendImage() const
  {
    const std::vector<std::uint8_t> image = test::IgtlPackedImage({6, 5, 4});
    ASSERT_EQ(this->Peer->Send(image.data(), image.size()), 1);
  }
  // The name of the surface that arrives next.
  std::string NextSurface() const
  {
    const test::IgtlReceived message(*this->Peer);
    EXPECT_EQ(message.Kind, "POLYDATA");
    return message.Name;
  }

  QPointer<LinkDialog> Dialog;
  igtl::ServerSocket::Pointer Server = igtl::ServerSocket::New();
  int Port = 40000 + static_cast<int>(getpid()) % 10000;
  igtl::ClientSocket::Pointer Peer;
};

TEST_F(LinkDialogTest, ReceivedImageIsOpenedAndKept)
{
  this->Connect();
  this->SendImage();
  WaitUntil(
      [this]
      {
        const auto volume = this->Study->Current().Pipeline().Newest<Volume>(SceneStep::Volume);
        return volume != nullptr && volume->Image->GetDimensions()[0] == 6;
      });
  EXPECT_TRUE(std::filesystem::exists(this->Phantom.Folder / "in/image-1.nrrd"));
  EXPECT_TRUE(this->State().contains("1 images received")) << this->State().toStdString();
}

TEST_F(LinkDialogTest, FormerImagesAreNotOverwritten)
{
  std::filesystem::create_directories(this->Phantom.Folder / "in");
  std::filesystem::copy_file(this->VolumeFile(), this->Phantom.Folder / "in/image-1.nrrd");
  const auto size = std::filesystem::file_size(this->Phantom.Folder / "in/image-1.nrrd");
  this->Connect();
  this->SendImage();
  WaitUntil([this] { return std::filesystem::exists(this->Phantom.Folder / "in/image-2.nrrd"); });
  EXPECT_EQ(std::filesystem::file_size(this->Phantom.Folder / "in/image-1.nrrd"), size);
}

TEST_F(LinkDialogTest, DisplayedSurfacesAreSentWithoutTheirNames)
{
  this->OpenPhantom();
  this->Connect();
  EXPECT_EQ(this->NextSurface(), "Palpate model 1");
  EXPECT_EQ(this->NextSurface(), "Palpate model 2");
}

TEST_F(LinkDialogTest, TouchIsShownUntilItEnds)
{
  this->OpenPhantom();
  this->Connect();
  this->Settle();
  this->BeginTouch();
  // The window sends while its events are processed, so nothing may wait here.
  this->Peer->SetReceiveTimeout(1);
  std::string received;
  const auto isTold = [&](const char* text)
  {
    std::array<char, 4096> bytes;
    const int count = static_cast<int>(this->Peer->Receive(bytes.data(), bytes.size(), 0));
    received.append(bytes.data(), static_cast<std::size_t>(std::max(count, 0)));
    return received.find(text) != std::string::npos;
  };
  WaitUntil([&] { return isTold("ContactForce"); });
  this->Study->StopTouch();
  WaitUntil([&] { return isTold("the touch has ended"); });
}

TEST_F(LinkDialogTest, PeerThatLeavesIsToldAndTheLinkEnds)
{
  this->Connect();
  this->Peer->CloseSocket();
  WaitUntil([this] { return !this->Switch()->isChecked(); });
  EXPECT_TRUE(this->State().contains("gone")) << this->State().toStdString();
  EXPECT_EQ(this->Switch()->text(), "Start");
}

TEST_F(LinkDialogTest, BadAddressStaysOffWithTheReason)
{
  this->TypeAddress("99999");
  this->Switch()->click();
  EXPECT_FALSE(this->Switch()->isChecked());
  EXPECT_TRUE(this->State().contains("99999")) << this->State().toStdString();
}

TEST_F(LinkDialogTest, ClosingEndsTheConnection)
{
  this->Connect();
  this->Dialog->close();
  char byte = 0;
  EXPECT_LE(this->Peer->Receive(&byte, 1), 0);
}
} // namespace
} // namespace palpate::link_dialog_test
