// A folder of 200 masks, of which one in five cannot be used: each of these has a line, and the
// others go on.
#include "CommandRun.h"
#include "ImageWriter.h"
#include "LabelImages.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace palpate::cli_mask_folder_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

constexpr int Count = 200;
constexpr std::size_t Good = 160;

enum class MaskOf
{
  Nothing, // no image
  OtherGrid,
  NoVoxels,
  HalfAFile,
  Ball
};

MaskOf KindOf(int mask)
{
  const int n = mask % 20;
  return n == 3    ? MaskOf::Nothing
         : n == 7  ? MaskOf::OtherGrid
         : n == 11 ? MaskOf::NoVoxels
         : n == 15 ? MaskOf::HalfAFile
                   : MaskOf::Ball;
}

class CliMaskFolder : public testing::Test
{
protected:
  static std::string NameOf(int mask) { return "organ" + std::to_string(1000 + mask); }

  // Once for all tests, which only read it.
  static void SetUpTestSuite()
  {
    Folder = std::make_unique<TemporaryFolder>();
    const std::filesystem::path masks = *Folder / "masks";
    std::filesystem::create_directory(masks);
    for (int mask = 0; mask < Count; ++mask)
    {
      const std::filesystem::path file = masks / (NameOf(mask) + ".nii.gz");
      if (KindOf(mask) == MaskOf::Nothing)
      {
        WriteAll(file, "no image");
        continue;
      }
      WriteBall(mask, file);
      if (KindOf(mask) == MaskOf::HalfAFile)
      {
        std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
      }
    }
  }

  // In a cell of its own, of 6 x 6 x 6.
  static void WriteBall(int mask, const std::filesystem::path& file)
  {
    LabelGrid grid;
    const int layers = KindOf(mask) == MaskOf::OtherGrid ? 30 : 48;
    grid.Size = {{48, 48, layers}};
    const std::array<double, 3> middle{mask % 6 * 8 + 3.5, mask / 6 % 6 * 8 + 3.5,
                                       mask / 36 % 6 * 8 + 3.5};
    const double radius = KindOf(mask) == MaskOf::NoVoxels ? -1.0 : 2.8;
    WriteImage(file,
               MakeLabelImage(grid,
                              [&](double x, double y, double z)
                              {
                                const double height =
                                    layers == 48 ? z - middle[2] : z - std::fmod(middle[2], 30.0);
                                return std::hypot(x - middle[0], y - middle[1], height) < radius;
                              }));
  }

  // Every mask that cannot be used has a line in the messages; no other one has.
  static void ExpectOneLineEach(const CommandRun& run)
  {
    EXPECT_EQ(run.Code, 1) << run.Errors.substr(0, 500);
    for (int mask = 0; mask < Count; ++mask)
    {
      std::istringstream lines(run.Errors);
      int count = 0;
      for (std::string line; std::getline(lines, line);)
      {
        count += line.find(NameOf(mask)) != std::string::npos ? 1 : 0;
      }
      EXPECT_EQ(count, KindOf(mask) == MaskOf::Ball ? 0 : 1) << NameOf(mask);
    }
  }

  static void TearDownTestSuite() { Folder.reset(); }

  static inline std::unique_ptr<TemporaryFolder> Folder;
};

TEST_F(CliMaskFolder, InfoNamesEachBadMask)
{
  const CommandRun run = RunPalpate({"info", "masks", "--json"}, Folder->Path());
  ExpectOneLineEach(run);
  std::istringstream lines(run.Output);
  std::size_t bad = 0;
  Json last;
  for (std::string line; std::getline(lines, line);)
  {
    last = Json::parse(line);
    bad += last.at("status") == "bad-input" ? 1 : 0;
  }
  EXPECT_EQ(bad, Count - Good);
  EXPECT_EQ(last.at("labels").size(), Good);
}

// Of four names alone, for time: a model takes a tenth of a second.
TEST_F(CliMaskFolder, FitModelsTheOthers)
{
  const std::string some = NameOf(0) + "," + NameOf(1) + "," + NameOf(100) + "," + NameOf(199);
  const CommandRun run = RunPalpate({"fit", "masks", "--label", some, "--degree", "1", "--model",
                                     "radial", "--frequency", "4", "--json"},
                                    Folder->Path());
  ExpectOneLineEach(run);
  std::istringstream lines(run.Output);
  std::size_t fitted = 0;
  for (std::string line; std::getline(lines, line);)
  {
    fitted += Json::parse(line).at("status") == "fitted" ? 1 : 0;
  }
  EXPECT_EQ(fitted, 4U);
}

TEST_F(CliMaskFolder, RelateMeasuresTheOthers)
{
  const CommandRun run = RunPalpate({"relate", "masks", "--of", NameOf(0), "--contact", "0.5",
                                     "--margin", "1", "--definition", "ibsi", "--json"},
                                    Folder->Path());
  ExpectOneLineEach(run);
  const Json found = Json::parse(run.Output);
  EXPECT_EQ(found.at("organs").size(), static_cast<std::size_t>(Count));
  EXPECT_EQ(found.at("pairs").size(), Good - 1);
  for (const Json& organ : found.at("organs"))
  {
    const int mask = std::stoi(organ.at("name").get<std::string>().substr(5)) - 1000;
    EXPECT_EQ(organ.at("status"), KindOf(mask) == MaskOf::Ball ? "measured" : "refused") << organ;
  }
}
} // namespace
} // namespace palpate::cli_mask_folder_test
