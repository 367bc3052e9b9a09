#include "CommandRun.h"
#include "ModelFile.h"
#include "SegmentationFile.h"
#include "SurfaceFile.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

namespace palpate::cli_correct_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

// Of a ball of 9 mm, label 1, towards one of 4 mm, label 2, that begins 8 mm from it.
constexpr const char* PullToOther = "6.4,6.4,0:12:5";

class CliCorrect : public testing::Test
{
protected:
  void SetUp() override { WriteTwoSpheres(this->Folder / "mask.nii.gz"); }
  CommandRun Run(std::vector<std::string> words) const
  {
    words.insert(words.begin(), "correct");
    return RunPalpate(words, this->Folder.Path());
  }
  Json JsonOf(std::vector<std::string> words) const
  {
    words.emplace_back("--json");
    const CommandRun run = this->Run(words);
    EXPECT_EQ(run.Code, 0) << run.Errors;
    return run.Code == 0 ? Json::parse(run.Output) : Json();
  }
  std::string RefusalOf(const std::vector<std::string>& words, int code = 2) const
  {
    const CommandRun run = this->Run(words);
    EXPECT_EQ(run.Code, code) << run.Errors;
    EXPECT_EQ(run.Output, "");
    return run.Errors;
  }

  TemporaryFolder Folder;
};

testing::AssertionResult Says(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos ? testing::AssertionSuccess()
                                              : testing::AssertionFailure() << text;
}

// Voxels of a structure.
std::set<vtkIdType> VoxelsOf(const Segmentation& segmentation, int label)
{
  const Segment& segment = segmentation.Find(std::to_string(label));
  vtkDataArray* values =
      segmentation.Layers[static_cast<std::size_t>(segment.Layer)]->GetPointData()->GetScalars();
  std::set<vtkIdType> voxels;
  for (vtkIdType at = 0; at < values->GetNumberOfTuples(); ++at)
  {
    if (values->GetComponent(at, 0) == segment.Value)
    {
      voxels.insert(at);
    }
  }
  return voxels;
}

std::size_t SharedBy(const std::set<vtkIdType>& one, const std::set<vtkIdType>& other)
{
  std::size_t shared = 0;
  for (const vtkIdType at : one)
  {
    shared += other.count(at);
  }
  return shared;
}

TEST_F(CliCorrect, PullsStopAtNeighboursAndLeaveTheRest)
{
  const std::string before = ReadAll(this->Folder / "mask.nii.gz");
  const Json found =
      this->JsonOf({"mask.nii.gz", "--label", "1", "--pull", PullToOther, "--output", "out"});
  EXPECT_EQ(ReadAll(this->Folder / "mask.nii.gz"), before);
  const Segmentation start = ReadSegmentation(this->Folder / "mask.nii.gz");
  const Segmentation made = ReadSegmentation(this->Folder / "out/mask.nii.gz");
  EXPECT_EQ(VoxelsOf(made, 2), VoxelsOf(start, 2));
  const std::set<vtkIdType> old = VoxelsOf(start, 1);
  const std::set<vtkIdType> grown = VoxelsOf(made, 1);
  EXPECT_EQ(SharedBy(old, grown), old.size());
  const auto added = static_cast<long long>(grown.size() - old.size());
  EXPECT_GT(added, 100);
  EXPECT_EQ(found.at("voxels_added"), added);
  EXPECT_EQ(found.at("voxels_removed"), 0);
  EXPECT_NEAR(
      found.at("dice").get<double>(),
      2.0 * static_cast<double>(old.size()) / static_cast<double>(old.size() + grown.size()), 1e-9);
  EXPECT_GT(found.at("volume_ml").get<double>(), found.at("volume_start_ml").get<double>());
  EXPECT_NEAR(found.at("distance_max_mm").get<double>(), 10.0, 2.5);
  // Only near the pull.
  vtkImageData* image = made.Layers[0];
  for (const vtkIdType at : grown)
  {
    double point[3];
    image->GetPoint(at, point);
    EXPECT_TRUE(old.count(at) == 1 || point[0] + point[1] > 3.0);
  }
  const auto surface = ReadSurface(this->Folder / "out/change.vtp");
  vtkDataArray* distances = surface->GetPointData()->GetArray("SignedDistance");
  ASSERT_NE(distances, nullptr);
  EXPECT_GT(distances->GetRange()[1], 7.0);
  EXPECT_GT(distances->GetRange()[0], -0.3);
}

TEST_F(CliCorrect, NeighboursAreOverwrittenOrShared)
{
  const std::vector<std::string> words{"mask.nii.gz", "--label", "1", "--pull", PullToOther};
  const auto with = [&](const std::string& policy, const std::string& folder)
  {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"--neighbours", policy, "--output", folder});
    return this->JsonOf(all);
  };
  const Segmentation start = ReadSegmentation(this->Folder / "mask.nii.gz");
  with("overwrite", "over");
  const Segmentation over = ReadSegmentation(this->Folder / "over/mask.nii.gz");
  EXPECT_LT(VoxelsOf(over, 2).size(), VoxelsOf(start, 2).size());
  with("overlap", "shared");
  const Segmentation shared = ReadSegmentation(this->Folder / "shared/mask.seg.nrrd");
  EXPECT_EQ(VoxelsOf(shared, 2), VoxelsOf(start, 2));
  EXPECT_EQ(VoxelsOf(shared, 1), VoxelsOf(over, 1));
  EXPECT_GT(SharedBy(VoxelsOf(shared, 1), VoxelsOf(shared, 2)), 10U);
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "shared/mask.nii.gz"));
}

TEST_F(CliCorrect, StepsAreDoneInTheirOrderAndReplayed)
{
  const Json found = this->JsonOf({"mask.nii.gz", "--label", "1", "--cut", "5,0,0:1,0,0", "--pull",
                                   "-9,0,0:3:4", "--islands", "--smooth", "1", "--fill", "--pull",
                                   "0,-9,0:0,-11,0:5+8", "--output", "out"});
  std::vector<std::string> kinds;
  for (const Json& step : found.at("steps"))
  {
    kinds.push_back(step.at("do"));
  }
  EXPECT_EQ(kinds, (std::vector<std::string>{"cut", "pull", "islands", "smooth", "fill", "pull"}));
  const Json again = this->JsonOf(
      {"mask.nii.gz", "--label", "1", "--steps", "out/corrections.json", "--output", "again"});
  EXPECT_EQ(again.at("steps"), found.at("steps"));
  EXPECT_EQ(VoxelsOf(ReadSegmentation(this->Folder / "out/mask.nii.gz"), 1),
            VoxelsOf(ReadSegmentation(this->Folder / "again/mask.nii.gz"), 1));
}

TEST_F(CliCorrect, StrokesAddAndRemoveTheirVoxels)
{
  const std::string path = "-9,0,0:-13,0,0:4";
  this->JsonOf({"mask.nii.gz", "--label", "1", "--paint=" + path, "--erase", "0,-9,0:3.5",
                "--paint", "12,13,0:3", "--output", "out"});
  const Segmentation start = ReadSegmentation(this->Folder / "mask.nii.gz");
  const Segmentation made = ReadSegmentation(this->Folder / "out/mask.nii.gz");
  EXPECT_EQ(VoxelsOf(made, 2), VoxelsOf(start, 2)) << "strokes stop there, too";
  const std::set<vtkIdType> old = VoxelsOf(start, 1);
  const std::set<vtkIdType> other = VoxelsOf(start, 2);
  const std::set<vtkIdType> now = VoxelsOf(made, 1);
  vtkImageData* image = made.Layers[0];
  for (vtkIdType at = 0; at < image->GetNumberOfPoints(); ++at)
  {
    double p[3];
    image->GetPoint(at, p);
    const double along = std::clamp(p[0], -13.0, -9.0);
    const bool isPainted = std::hypot(p[0] - along, p[1], p[2]) <= 4.0;
    const bool isErased = std::hypot(p[0], p[1] + 9.0, p[2]) <= 3.5;
    const bool isLast = std::hypot(p[0] - 12.0, p[1] - 13.0, p[2]) <= 3.0;
    const bool wanted = ((old.count(at) == 1 || isPainted) && !isErased) || isLast;
    EXPECT_EQ(now.count(at) == 1, wanted && other.count(at) == 0);
  }
}

TEST_F(CliCorrect, AModelIsPulledToATarget)
{
  WriteNearlyASphere(this->Folder / "ball.json"); // 10 mm around (1, 2, 3)
  const Json found = this->JsonOf({"ball.json", "--pull", "11,2,3:13,2,3:5", "--output", "out"});
  EXPECT_TRUE(found.at("label").is_null());
  EXPECT_NEAR(found.at("distance_max_mm").get<double>(), 2.0, 0.15);
  const ModelDocument model = ReadModel(this->Folder / "out/model.json");
  EXPECT_EQ(model.Provenance.Input, "ball.json");
  EXPECT_NEAR(std::get<RadialModel>(model.Surface).Radius(Vector3::UnitX()), 12.0, 0.1);
  EXPECT_NEAR(std::get<RadialModel>(model.Surface).Radius(-Vector3::UnitX()), 10.0, 0.1);
}

TEST_F(CliCorrect, RefusesWithTheWayOut)
{
  WriteNearlyASphere(this->Folder / "ball.json");
  std::filesystem::create_directory(this->Folder / "here");
  std::filesystem::copy(this->Folder / "mask.nii.gz", this->Folder / "here/mask.nii.gz");
  const auto refused = [this](std::vector<std::string> words, const std::string& part)
  { EXPECT_TRUE(Says(this->RefusalOf(words), part)); };
  refused({"mask.nii.gz", "--label", "1"}, "nothing to correct");
  refused({"mask.nii.gz", "--pull", PullToOther}, "--label");
  refused({"mask.nii.gz", "--label", "1", "--pull", "1,2,3"}, "PLACE:MM");
  refused({"mask.nii.gz", "--label", "1", "--pull", "1,2,3:x"}, "no number");
  refused({"mask.nii.gz", "--label", "1", "--pull", "1,2,3:4:0.1"}, "step 1: a pull's width");
  refused({"mask.nii.gz", "--label", "1", "--cut", "1,2,3"}, "POINT:NORMAL");
  refused({"mask.nii.gz", "--label", "1", "--cut", "90,0,0:-1,0,0"}, "no voxels left");
  refused({"mask.nii.gz", "--label", "1", "--fill", "--smooth", "99"}, "step 2");
  refused({"mask.nii.gz", "--label", "1", "--paint", "1,2,3"}, "RADIUS");
  refused({"mask.nii.gz", "--label", "1", "--erase", "1,2,3:x"}, "no number");
  refused({"mask.nii.gz", "--label", "1", "--paint", "1,2,3:99"}, "radius");
  refused({"mask.nii.gz", "--label", "1", "--erase", "0,0,0:30"}, "no voxels left");
  refused({"ball.json", "--smooth", "1"}, "a model can be pulled");
  refused({"ball.json", "--pull", "11,2,3:-12:2"}, "centre");
  // A source is never replaced.
  refused({"here/mask.nii.gz", "--label", "1", "--fill", "--output", "here"}, "here/mask.nii.gz");
  EXPECT_EQ(ReadAll(this->Folder / "here/mask.nii.gz"), ReadAll(this->Folder / "mask.nii.gz"));
}
} // namespace
} // namespace palpate::cli_correct_test
