#include "FalconSearch.h"

#include "BootStream.h"
#include "FalconBoot.h"
#include "ManualClock.h"
#include "TemporaryFolder.h"
#include "VirtualFinder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace palpate::falcon_search_test
{
namespace
{
class FalconSearchTest : public testing::Test
{
protected:
  FalconSearchTest()
  {
    const auto image = test::BootStream();
    test::WriteAll(this->Path, {image.begin(), image.end()});
  }

  FoundDevice Ask(const std::string& firmwarePath = "")
  {
    std::vector<FoundDevice> found;
    const Status status = FindFalcons(this->Finder, this->Time, firmwarePath, found);
    EXPECT_TRUE(status.IsOk()) << status.Message();
    EXPECT_EQ(found.size(), 1U);
    return found.empty() ? FoundDevice() : found.front();
  }

  void Load()
  {
    test::VirtualFalconLink link(this->Finder.Falcon, this->Time);
    ASSERT_TRUE(link.Open().IsOk());
    ASSERT_TRUE(FalconBoot(link, this->Time).Run(this->Path).IsOk());
  }

  test::TemporaryFolder Folder;
  std::string Path = (Folder / "firmware.bin").string();
  ManualClock Time{1'000'000'000};
  test::VirtualFinder Finder{Time};
};

TEST_F(FalconSearchTest, ReportsMissingFalcon)
{
  this->Finder.Listings.clear();
  std::vector<FoundDevice> found;
  EXPECT_EQ(FindFalcons(this->Finder, this->Time, "", found).Message(),
            "There is no Falcon on USB: plug in its cable and its power supply.");
}

TEST_F(FalconSearchTest, ReportsObstacle)
{
  this->Finder.Listings = {{"1-2", "S1", "It is in use."}};
  const FoundDevice found = this->Ask(this->Path);
  EXPECT_EQ(found.Argument, "device=1-2");
  EXPECT_FALSE(found.IsUsable);
  EXPECT_EQ(found.Details, "It is in use. (serial number S1)");
}

TEST_F(FalconSearchTest, FindsUsableFalconWithoutLoadingFirmware)
{
  EXPECT_FALSE(this->Ask().IsUsable);
  EXPECT_NE(this->Ask().Details.find("PALPATE_FALCON_FIRMWARE"), std::string::npos);
  EXPECT_FALSE(this->Ask("/no/such/file").IsUsable);
  EXPECT_TRUE(this->Ask(this->Path).IsUsable);
  EXPECT_NE(this->Ask(this->Path).Details.find("no firmware runs"), std::string::npos);
  EXPECT_TRUE(this->Finder.Falcon.Board().Image().empty());
}

TEST_F(FalconSearchTest, ReportsHomingOfRunningFirmware)
{
  ASSERT_NO_FATAL_FAILURE(this->Load());
  EXPECT_EQ(this->Ask().Details, "its firmware runs; it has to be homed");
  this->Finder.Falcon.Mechanism().Settings.IsRigid = true;
  this->Finder.Falcon.Mechanism().Settings.Path = [](double t)
  { return Vector3(0.0, 0.0, 130.0 - 45.0 * std::cos(4.0 * M_PI * t)); };
  this->Time.Advance(1'000'000'000);
  EXPECT_EQ(this->Ask().Details, "its firmware runs, and it is homed");
  EXPECT_TRUE(this->Ask().IsUsable);
  EXPECT_EQ(this->Finder.Falcon.Board().Motors(), (std::array<std::int16_t, 3>{}));
}

TEST_F(FalconSearchTest, ReportsRefusedRequest)
{
  this->Finder.Falcon.Faults.StalledRequest = 9;
  const FoundDevice found = this->Ask(this->Path);
  EXPECT_FALSE(found.IsUsable);
  EXPECT_FALSE(found.Details.empty());
}
} // namespace
} // namespace palpate::falcon_search_test
