#include "CommandRun.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

namespace palpate::cli_render_test
{
namespace
{
using namespace palpate::test;

// Width and height from a PNG's header.
std::pair<int, int> PngSize(const std::string& bytes)
{
  const auto number = [&bytes](std::size_t at)
  {
    int value = 0;
    for (std::size_t b = 0; b < 4; ++b)
    {
      value = value << 8 | static_cast<unsigned char>(bytes.at(at + b));
    }
    return value;
  };
  return {number(16), number(20)};
}

TEST(CliRender, DrawsSegmentationsModelsAndSlicesTogether)
{
  const TemporaryFolder folder;
  ASSERT_EQ(RunPalpate({"phantom", "--output", "p", "--spacing", "2,2,3"}, folder.Path()).Code, 0);
  const CommandRun run =
      RunPalpate({"render", "p/mask.nii.gz", "p/truth.json", "--volume", "p/volume.nii.gz",
                  "--slices", "axial,coronal", "--opacity", "0.5", "--size", "320x200", "--view",
                  "left", "--output", "picture.png"},
                 folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(PngSize(ReadAll(folder / "picture.png")), (std::pair<int, int>{320, 200}));
}

TEST(CliRender, DrawsIsoValuesAndSegmentationsSubVoxel)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const std::vector<std::vector<std::string>> images{
      {"--volume", "a.nii.gz", "--iso", "0.5,1.5"},
      {"--volume", "a.nii.gz", "--iso", "0.5", "--interpolation", "cubic", "--slices", "axial"},
      {"--volume", "a.nii.gz", "--iso", "0.5", "--within", "a.nii.gz", "--within-label", "2"},
      {"a.nii.gz", "--sub-voxel", "--smoothing", "0"},
      {"a.nii.gz", "--sub-voxel", "--opacity", "0.4", "--volume", "a.nii.gz"},
  };
  for (std::vector<std::string> words : images)
  {
    words.insert(words.begin(), "render");
    words.insert(words.end(), {"--size", "120x100", "--output", "picture.png"});
    const CommandRun run = RunPalpate(words, folder.Path());
    EXPECT_EQ(run.Code, 0) << run.Errors;
    EXPECT_EQ(PngSize(ReadAll(folder / "picture.png")), (std::pair<int, int>{120, 100}));
    std::filesystem::remove(folder / "picture.png");
  }
}

TEST(CliRender, BadInputIsRefusedAndLeavesNothing)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
           {"a.nii.gz", "--output", "x.jpg"},
           {"--output", "x.png"},
           {"missing.vtp", "--output", "x.png"},
           {"a.nii.gz", "--label", "77", "--output", "x.png"},
           {"a.nii.gz", "--array", "Nothing", "--output", "x.png"},
           {"a.nii.gz", "--size", "0x5", "--output", "x.png"},
           {"a.nii.gz", "--background", "mauve", "--output", "x.png"},
           {"a.nii.gz", "--volume", "missing.nrrd", "--output", "x.png"},
           {"a.nii.gz", "--iso", "1", "--output", "x.png"},
           {"--volume", "a.nii.gz", "--iso", "1000", "--output", "x.png"},
           {"--volume", "a.nii.gz", "--iso", "nan", "--output", "x.png"},
           {"--volume", "a.nii.gz", "--iso", "1", "--interpolation", "best", "--output", "x.png"},
           {"--volume", "a.nii.gz", "--within", "a.nii.gz", "--output", "x.png"},
           {"--volume", "a.nii.gz", "--iso", "1", "--within-label", "1", "--output", "x.png"},
           {"--volume", "a.nii.gz", "--iso", "1", "--within", "a.nii.gz", "--within-label", "9",
            "--output", "x.png"},
           {"--volume", "a.nii.gz", "--iso", "1", "--within", "no.nrrd", "--output", "x.png"},
           {"a.nii.gz", "--sub-voxel", "--smoothing", "-1", "--output", "x.png"},
           {"a.nii.gz", "--output", "no/such/folder/x.png"}})
  {
    std::vector<std::string> arguments{"render"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CommandRun run = RunPalpate(arguments, folder.Path());
    EXPECT_EQ(run.Code, 2) << more.front() << ": " << run.Errors;
    EXPECT_EQ(folder.EntryCount(), 1U);
  }
}

TEST(CliDisplay, MissingDisplayGivesFix)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const std::vector<std::string> render{PALPATE_PROGRAM, "render", "a.nii.gz", "--output", "x.png"};
  for (const std::vector<std::string>& display :
       {std::vector<std::string>{"-u", "DISPLAY"}, std::vector<std::string>{"DISPLAY=:98765"}})
  {
    std::vector<std::string> words = display;
    words.insert(words.end(), render.begin(), render.end());
    const CommandRun run = RunCommand("env", words, folder.Path());
    EXPECT_EQ(run.Code, 1) << run.Errors;
    EXPECT_NE(run.Errors.find("xvfb-run -a"), std::string::npos) << run.Errors;
    EXPECT_EQ(folder.EntryCount(), 1U);
  }
}

// The README's example, without OpenGL.
TEST(CliDisplay, FittingNeedsNoDisplay)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run =
      RunCommand("env",
                 {"-u", "DISPLAY", PALPATE_PROGRAM, "fit", "a.nii.gz", "--label", "1", "--degree",
                  "4", "--volume", "a.nii.gz", "--output", "out"},
                 folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_NE(ReadAll(folder / "out/report.html").find("data:image/png"), std::string::npos);
}

TEST(CliRender, FolderOfMasksIsDrawnUpToBadOnes)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "masks");
  WriteEllipsoid(folder / "masks/a.nii.gz", 12.0, 9.0, 8.0);
  WriteEllipsoid(folder / "masks/b.nii.gz", 0.0, 0.0, 0.0); // empty
  WriteAll(folder / "masks/c.nii.gz", "broken");
  const CommandRun run =
      RunPalpate({"render", "masks", "--size", "64x64", "--output", "p.png"}, folder.Path());
  EXPECT_EQ(run.Code, 1) << run.Errors;
  EXPECT_NE(run.Errors.find("b.nii.gz"), std::string::npos) << run.Errors;
  EXPECT_NE(run.Errors.find("c.nii.gz"), std::string::npos) << run.Errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "p.png"));
  std::filesystem::remove(folder / "masks/a.nii.gz");
  EXPECT_EQ(RunPalpate({"render", "masks", "--output", "q.png"}, folder.Path()).Code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "q.png"));
}
} // namespace
} // namespace palpate::cli_render_test
