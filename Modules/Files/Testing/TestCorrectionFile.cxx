#include "CorrectionFile.h"

#include "JsonText.h"
#include "MessageOf.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include <functional>
#include <gtest/gtest.h>

namespace palpate::correction_file_test
{
namespace
{
using test::TemporaryFolder;
using Json = nlohmann::json;

std::shared_ptr<const BrushStroke::Path> PathOf(BrushStroke::Path path)
{
  return std::make_shared<const BrushStroke::Path>(std::move(path));
}

std::shared_ptr<const std::vector<IndexRun>> RunsFor(std::vector<IndexRun> runs)
{
  return std::make_shared<const std::vector<IndexRun>>(std::move(runs));
}

std::vector<CorrectionStep> AllSteps()
{
  return {SurfacePull{Vector3(0.1, 2.0, -3.0), 4.5, {}, 6.0, 0.0},
          SurfacePull{Vector3(1.0, 2.0, 3.0), 0.0, Vector3(2.0, 2.0, 1.0 / 3.0), 5.0, 11.0},
          IslandRemoval{},
          CavityFilling{},
          SurfaceSmoothing{1.25},
          PlaneCut{Vector3(7.0, 8.0, 9.0), Vector3(0.0, -1.0, 0.5)},
          BrushStroke{PathOf({Vector3(0.1, 2.0, 1.0 / 3.0), Vector3(4.0, 5.0, 6.0)}), 2.5,
                      Vector3(0.0, 0.6, 0.8), false},
          BrushStroke{PathOf({Vector3(0.1, 2.0, 1.0 / 3.0)}), 3.0, {}, true},
          VoxelEdit{RunsFor({{{1, 2, 3}, 4}, {{5, 6, 7}, 8}}), false},
          VoxelEdit{RunsFor({{{0, 0, 0}, 1}}), true},
          SliceCopy{1, 12, 11},
          SliceFilling{2, 3, 9}};
}

class CorrectionFile : public testing::Test
{
protected:
  std::string Refusal(const std::function<void(Json&)>& change) const
  {
    WriteCorrections(AllSteps(), this->File);
    Json json = ReadJson(this->File, 1U << 20U, "");
    change(json);
    WriteWholeFile(this->File, json.dump());
    return test::MessageOf([this] { ReadCorrections(this->File); });
  }

  TemporaryFolder Folder;
  std::filesystem::path File = this->Folder / "corrections.json";
};

testing::AssertionResult Says(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos ? testing::AssertionSuccess()
                                              : testing::AssertionFailure() << text;
}

TEST_F(CorrectionFile, ReturnsToTheBit)
{
  WriteCorrections(AllSteps(), this->File);
  const std::vector<CorrectionStep> read = ReadCorrections(this->File);
  EXPECT_EQ(CorrectionJson(read), CorrectionJson(AllSteps()));
  ASSERT_EQ(read.size(), 12U);
  EXPECT_EQ(read, AllSteps());
  const auto& pull = std::get<SurfacePull>(read[1]);
  EXPECT_EQ(pull.TargetWorld, Vector3(2.0, 2.0, 1.0 / 3.0));
  EXPECT_EQ(pull.SecondWidth, 11.0);
  EXPECT_EQ(std::get<SurfacePull>(read[0]).Displacement, 4.5);
  EXPECT_FALSE(std::get<SurfacePull>(read[0]).TargetWorld);
  EXPECT_TRUE(std::holds_alternative<IslandRemoval>(read[2]));
  EXPECT_TRUE(std::holds_alternative<CavityFilling>(read[3]));
  EXPECT_EQ(std::get<SurfaceSmoothing>(read[4]).Deviation, 1.25);
  EXPECT_EQ(std::get<PlaneCut>(read[5]).Normal, Vector3(0.0, -1.0, 0.5));
}

TEST_F(CorrectionFile, RefusesWhatIsNone)
{
  EXPECT_TRUE(Says(this->Refusal([](Json& json) { json = 3; }), "is not a list"));
  EXPECT_TRUE(Says(this->Refusal([](Json& json) { json["version"] = 2; }), "another version"));
  EXPECT_TRUE(Says(this->Refusal([](Json& json) { json.erase("steps"); }), "no list \"steps\""));
  EXPECT_TRUE(
      Says(this->Refusal([](Json& json) { json["steps"][2]["do"] = "dab"; }), "is no pull"));
  EXPECT_TRUE(Says(this->Refusal([](Json& json) { json["steps"][2] = 1; }), "without \"do\""));
  EXPECT_TRUE(
      Says(this->Refusal([](Json& json) { json["steps"][0].erase("width_mm"); }), "width_mm"));
  EXPECT_TRUE(Says(this->Refusal([](Json& json) { json["steps"][0].erase("displacement_mm"); }),
                   "displacement_mm"));
  EXPECT_TRUE(Says(this->Refusal(
                       [](Json& json) {
                         json["steps"][1]["target_mm"] = {1, 2};
                       }),
                   "target_mm not of 3"));
  EXPECT_TRUE(
      Says(this->Refusal([](Json& json) { json["steps"][5]["normal"][1] = "x"; }), "not a number"));
  const auto says =
      [this](std::size_t step, const char* key, const Json& value, const std::string& part)
  { return Says(this->Refusal([&](Json& json) { json["steps"][step][key] = value; }), part); };
  EXPECT_TRUE(says(6, "path_mm", Json::array({1, 2}), "path_mm that is not of 1"));
  EXPECT_TRUE(says(6, "path_mm", Json::array(), "path_mm that is not of 1"));
  EXPECT_TRUE(says(6, "path_mm", std::vector<int>(30003, 1), "path_mm that is not of 1"));
  EXPECT_TRUE(says(6, "radius_mm", "wide", "no number \"radius_mm\""));
  EXPECT_TRUE(says(6, "slice_normal", Json::array({1, 2}), "slice_normal not of 3"));
  EXPECT_TRUE(says(8, "runs", Json::array({1, 2, 3}), "runs that are not of 4"));
  EXPECT_TRUE(says(8, "runs", Json::array({1, 2, 3, -1}), "in runs that is no index"));
  EXPECT_TRUE(says(8, "runs", Json::array({1, 2, 3.5, 1}), "in runs that is no index"));
  EXPECT_TRUE(says(8, "runs", Json::array({1, 2, 3, 5e9}), "in runs that is no index"));
  EXPECT_TRUE(says(10, "axis", -1, "in axis that is no index"));
  EXPECT_TRUE(says(10, "slices", Json::array({1}), "slices that are not two"));
  EXPECT_TRUE(Says(this->Refusal(
                       [](Json& json)
                       {
                         for (int n = 0; n < 1100; ++n)
                         {
                           json["steps"].push_back({{"do", "fill"}});
                         }
                       }),
                   "more than 1,100"));
}
} // namespace
} // namespace palpate::correction_file_test
