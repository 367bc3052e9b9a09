#include "FalconFirmware.h"

#include "BootStream.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <string>

namespace palpate::falcon_firmware_test
{
namespace
{
using Bytes = std::vector<std::uint8_t>;

std::string FaultOf(const Bytes& bytes)
{
  FalconFirmware firmware;
  const Status status = FalconFirmware::Parse(bytes, "file", firmware);
  EXPECT_EQ(status.IsOk(), !firmware.Bytes().empty()) << "a refused file must leave nothing";
  return status.Message();
}

TEST(FalconFirmware, RecognisesBootStreams)
{
  for (std::size_t words : {1U, 2U, 100U, 4000U})
  {
    for (std::size_t blocks : {1U, 2U, 5U})
    {
      const Bytes bytes = test::BootStream(words, blocks);
      FalconFirmware firmware;
      ASSERT_TRUE(FalconFirmware::Parse(bytes, "file", firmware).IsOk());
      EXPECT_EQ(firmware.Bytes(), bytes);
    }
  }
}

TEST(FalconFirmware, ReportsEachFault)
{
  const Bytes good = test::BootStream(100, 2);
  const auto changed = [&good](std::size_t place, std::uint8_t value)
  {
    Bytes bytes = good;
    bytes[place] = value;
    return FaultOf(bytes);
  };
  const std::string begin = "file is not a Falcon's firmware: it ";
  EXPECT_EQ(changed(0, 0xAB), begin + "does not begin with the key 0x08AA.");
  EXPECT_EQ(FaultOf({}), begin + "does not begin with the key 0x08AA.");
  EXPECT_EQ(changed(7, 1), begin + "has reserved words that are not 0.");
  EXPECT_EQ(changed(18, 0x40), begin + "starts at an address that the processor does not have.");
  EXPECT_EQ(changed(24, 0x40), begin + "loads to an address that the processor does not have.");
  EXPECT_EQ(changed(22, 0xFF), begin + "ends too early.");
  Bytes longer = good;
  longer.push_back(0);
  EXPECT_EQ(FaultOf(longer), begin + "goes on after its end.");
  EXPECT_EQ(FaultOf(test::BootStream(0)), begin + "loads nothing.");
  EXPECT_EQ(FaultOf(Bytes(FalconFirmware::LargestSize + 1, 0)),
            begin + "is larger than the processor's memory.");
}

TEST(FalconFirmware, RejectsTruncatedFile)
{
  const Bytes good = test::BootStream(150, 3);
  for (std::size_t length = 0; length < good.size(); ++length)
  {
    EXPECT_FALSE(
        FaultOf({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length)}).empty())
        << length;
  }
}

TEST(FalconFirmware, ParserSurvivesRandomBytes)
{
  std::mt19937_64 random(61);
  for (int round = 0; round < 50000; ++round)
  {
    Bytes bytes = test::BootStream(1 + random() % 40, 1 + random() % 3, random());
    for (std::size_t faults = 1 + random() % 4; faults > 0; --faults)
    {
      bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    }
    bytes.resize(bytes.size() - random() % 4);
    FaultOf(bytes);
  }
}

TEST(FalconFirmware, ErrorsNameTheFile)
{
  const test::TemporaryFolder folder;
  const Bytes good = test::BootStream();
  test::WriteAll(folder / "good.bin", {good.begin(), good.end()});
  test::WriteAll(folder / "empty.bin", "");
  test::WriteAll(folder / "text.bin", "Not a firmware");
  FalconFirmware firmware;
  EXPECT_TRUE(FalconFirmware::Read((folder / "good.bin").string(), firmware).IsOk());
  EXPECT_EQ(firmware.Bytes(), good);
  const auto fault = [&folder, &firmware](const std::string& name)
  { return FalconFirmware::Read((folder / name).string(), firmware).Message(); };
  const std::string path = folder.Path().string() + "/";
  EXPECT_EQ(fault("none.bin"), path + "none.bin, the Falcon's firmware, cannot be opened.");
  EXPECT_EQ(fault("empty.bin"), path + "empty.bin, the Falcon's firmware, cannot be read.");
  EXPECT_EQ(fault("text.bin"), path + "text.bin is not a Falcon's firmware: it does not begin with "
                                      "the key 0x08AA.");
  EXPECT_FALSE(FalconFirmware::Read(folder.Path().string(), firmware).IsOk()) << "a folder";
}

TEST(FalconFirmware, ChosenPathOverridesEnvironment)
{
  ASSERT_EQ(setenv("PALPATE_FALCON_FIRMWARE", "/environment", 1), 0);
  EXPECT_EQ(FalconFirmware::PathOf("/chosen"), "/chosen");
  EXPECT_EQ(FalconFirmware::PathOf(""), "/environment");
  ASSERT_EQ(unsetenv("PALPATE_FALCON_FIRMWARE"), 0);
  EXPECT_EQ(FalconFirmware::PathOf(""), "");
}
} // namespace
} // namespace palpate::falcon_firmware_test
