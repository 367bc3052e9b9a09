#include "FalconTestBed.h"
#include "LibusbFalconFinder.h"
#include "Unprivileged.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace palpate::libusb_falcon_finder_test
{
namespace
{
using test::FalconDescriptors;
using test::FalconTestBed;
using test::UsbfsFalcon;
using test::VirtualFalcon;

FalconDescriptors WithSerial(const std::string& serial)
{
  FalconDescriptors descriptors;
  descriptors.Serial = serial;
  return descriptors;
}

class LibusbFalconFinderTest : public testing::Test
{
protected:
  void SetUp() override
  {
    // Not skipped: a missing wrapper must not look like success.
    ASSERT_TRUE(FalconTestBed::IsPossible()) << "umockdev is not preloaded: use umockdev-wrapper";
  }

  std::vector<FalconListing> List()
  {
    std::vector<FalconListing> listings;
    const Status status = this->Finder.List(listings);
    EXPECT_TRUE(status.IsOk()) << status.Message();
    return listings;
  }

  Status Open(const std::string& which)
  {
    EXPECT_TRUE(this->Finder.MakeLink(which, this->Link).IsOk());
    return this->Link->Open();
  }

  VirtualFalcon FirstModel;
  UsbfsFalcon First{FirstModel};
  VirtualFalcon SecondModel;
  UsbfsFalcon Second{SecondModel, WithSerial("VF000002")};
  FalconTestBed Bed;
  LibusbFalconFinder Finder;
  std::unique_ptr<FalconLink> Link;
};

TEST_F(LibusbFalconFinderTest, EmptyBusHasNone)
{
  EXPECT_TRUE(this->List().empty());
  EXPECT_EQ(this->Open("").Message(),
            "There is no Falcon on USB (0403:cb48): plug in its cable and its power supply.");
}

TEST_F(LibusbFalconFinderTest, ListsArrivingAndLeavingFalcons)
{
  for (int n = 0; n < 3; ++n)
  {
    this->Bed.Plug(this->First, 2);
    const std::vector<FalconListing> listings = this->List();
    ASSERT_EQ(listings.size(), 1U);
    EXPECT_EQ(listings[0].BusPath, "1-2");
    EXPECT_EQ(listings[0].Serial, "VF000001");
    EXPECT_EQ(listings[0].Obstacle, "");
    this->Bed.Unplug(2);
    EXPECT_TRUE(this->List().empty());
  }
}

TEST_F(LibusbFalconFinderTest, ChoosesByPortOrSerial)
{
  this->Bed.Plug(this->Second, 3);
  this->Bed.Plug(this->First, 1);
  ASSERT_EQ(this->List().size(), 2U);
  EXPECT_EQ(this->List()[0].BusPath, "1-1");
  for (const char* which : {"1-3", "VF000002"})
  {
    ASSERT_TRUE(this->Open(which).IsOk());
    ASSERT_TRUE(this->Link->Control(FtdiRequest::DataTerminalReady(true)).IsOk());
    const auto isReady = [](VirtualFalcon& falcon) { return falcon.Chip().DataTerminalReady(); };
    EXPECT_TRUE(this->Second.WithFalcon(isReady)) << which;
    EXPECT_FALSE(this->First.WithFalcon(isReady)) << which;
    ASSERT_TRUE(this->Link->Control(FtdiRequest::DataTerminalReady(false)).IsOk());
  }
  EXPECT_FALSE(this->Open("1-7").IsOk());
  EXPECT_NE(this->Open("1-7").Message().find("1-7"), std::string::npos);
}

TEST_F(LibusbFalconFinderTest, UsesFirstAvailable)
{
  this->Bed.Plug(this->First, 1);
  this->Bed.Plug(this->Second, 2);
  std::unique_ptr<FalconLink> other;
  ASSERT_TRUE(this->Finder.MakeLink("", other).IsOk());
  ASSERT_TRUE(other->Open().IsOk());
  EXPECT_TRUE(this->Open("").IsOk());
  std::unique_ptr<FalconLink> third;
  ASSERT_TRUE(this->Finder.MakeLink("", third).IsOk());
  EXPECT_EQ(third->Open().Message(),
            "The Falcon at USB 1-1 is used by another program: close that first.");
}

TEST_F(LibusbFalconFinderTest, ReportsUserWithoutClaiming)
{
  this->Bed.Plug(this->First, 1);
  this->Bed.ShowDriver(1, "usbfs");
  EXPECT_EQ(this->List().at(0).Obstacle,
            "The Falcon at USB 1-1 is used by another program: close that first.");
}

TEST_F(LibusbFalconFinderTest, ReportsDriverThatKeepsDevice)
{
  this->Bed.Plug(this->First, 1);
  this->Bed.ShowDriver(1, "ftdi_sio");
  EXPECT_EQ(this->List().at(0).Obstacle, "") << "opening the device detaches it";
  std::unique_ptr<FalconLink> other;
  ASSERT_TRUE(this->Finder.MakeLink("", other).IsOk());
  ASSERT_TRUE(other->Open().IsOk());
  EXPECT_EQ(this->Open("").Message(),
            "The Falcon at USB 1-1 is held by the kernel's driver ftdi_sio, which does not let go: "
            "unload it by 'sudo modprobe -r ftdi_sio'.");
}

TEST_F(LibusbFalconFinderTest, ReportsMissingPermission)
{
  if (geteuid() == 0)
  {
    test::RunAgainUnprivileged();
    return;
  }
  this->Bed.Plug(this->First, 1);
  this->Bed.Forbid(1, true);
  const std::string message =
      "The Falcon at USB 1-1 may not be used by this user: install its udev rule by 'sudo "
      "Utilities/install-udev-rule.sh', then unplug it and plug it in again.";
  EXPECT_EQ(this->List().at(0).Obstacle, message);
  EXPECT_EQ(this->Open("").Message(), message);
}

TEST_F(LibusbFalconFinderTest, ReopensAfterUnplugging)
{
  this->Bed.Plug(this->First, 1);
  ASSERT_TRUE(this->Open("1-1").IsOk());
  for (int n = 0; n < 3; ++n)
  {
    this->Bed.Unplug(1);
    for (int patience = 0; !this->Link->IsGone() && patience < 10000; ++patience)
    {
      usleep(1000);
    }
    EXPECT_TRUE(this->Link->IsGone());
    this->Link->Close();
    EXPECT_FALSE(this->Link->Open().IsOk());
    this->Bed.Plug(this->First, 1);
    const Status status = this->Link->Open();
    ASSERT_TRUE(status.IsOk()) << status.Message();
    EXPECT_TRUE(this->Link->Control(FtdiRequest::Baud(2)).IsOk());
  }
}
} // namespace
} // namespace palpate::libusb_falcon_finder_test
