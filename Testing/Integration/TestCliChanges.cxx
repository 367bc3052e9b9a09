#include "CommandRun.h"
#include "JsonLines.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::cli_changes_test
{
namespace
{
using namespace palpate::test;

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// A ring becomes a ball only if its handle is cut; every command that fits it says so.
TEST(CliChanges, OfARingAreSaidByEveryCommand)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "masks");
  WriteTorus(folder / "masks" / "ring.nii.gz");
  const std::string said = "1 handle cut, ";
  const CommandRun fit =
      RunPalpate({"fit", "masks", "--output", "out", "--jobs", "1"}, folder.Path());
  ASSERT_EQ(fit.Code, 0) << fit.Errors;
  EXPECT_TRUE(Has(fit.Output, said)) << fit.Output;
  const std::string table = ReadAll(folder / "out" / "cohort.csv");
  EXPECT_TRUE(Has(table, "is modelled with " + said)) << table;

  const std::string warning = "ring is modelled with " + said;
  const CommandRun touch = RunPalpate({"touch", "masks/ring.nii.gz", "--representation",
                                       "harmonics", "--seconds", "0.2", "--output", "felt"},
                                      folder.Path());
  EXPECT_EQ(touch.Code, 0) << touch.Errors;
  EXPECT_TRUE(Has(touch.Errors, "is modelled with " + said)) << touch.Errors;
  WriteAll(folder / "ring.scene.json",
           R"({"format": "palpate-scene", "structures": [{"file": "masks/ring.nii.gz",
               "label": "1", "name": "ring", "representation": "harmonics"}]})");
  const CommandRun scene = RunPalpate({"scene", "explain", "ring.scene.json"}, folder.Path());
  EXPECT_EQ(scene.Code, 0) << scene.Errors;
  EXPECT_TRUE(Has(scene.Errors, warning)) << scene.Errors;
}

// Left and right in one label: refused as one, a model each on request.
TEST(CliChanges, EachComponentIsAModel)
{
  const TemporaryFolder folder;
  WriteBothSides(folder / "a.nii.gz");
  const CommandRun one = RunPalpate({"fit", "a.nii.gz", "--degree", "4"}, folder.Path());
  EXPECT_EQ(one.Code, 1);
  EXPECT_TRUE(Has(one.Errors, "--component each")) << one.Errors;
  const CommandRun each = RunPalpate(
      {"fit", "a.nii.gz", "--degree", "4", "--component", "each", "--output", "out", "--json"},
      folder.Path());
  ASSERT_EQ(each.Code, 0) << each.Errors;
  const auto results = Lines(each.Output);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].at("name"), "right");
  EXPECT_EQ(results[1].at("name"), "left");
  for (const char* side : {"right", "left"})
  {
    EXPECT_TRUE(
        std::filesystem::exists(folder / "out" / (std::string("a_1_") + side) / "model.json"))
        << side;
  }
  EXPECT_EQ(
      RunPalpate({"mesh", "a.nii.gz", "--component", "each", "--output", "a.stl"}, folder.Path())
          .Code,
      2);
}
} // namespace
} // namespace palpate::cli_changes_test
