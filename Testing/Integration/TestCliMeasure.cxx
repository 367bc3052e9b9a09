#include "CommandRun.h"
#include "LabelImages.h"
#include "ModelFile.h"
#include "SurfaceFile.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::cli_measure_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

class CliMeasure : public testing::Test
{
protected:
  CliMeasure()
  {
    ModelDocument document; // a sphere of 20 mm
    document.Surface = RadialModel(0, {20.0 * std::sqrt(4.0 * M_PI)}, {5.0, 0.0, 0.0});
    WriteModel(this->Folder / "ball.json", document);
  }
  CommandRun Measure(std::vector<std::string> words) const
  {
    words.insert(words.begin(), "measure");
    return RunPalpate(words, this->Folder.Path());
  }
  Json Results(std::vector<std::string> words) const
  {
    words.emplace_back("--json");
    const CommandRun run = this->Measure(words);
    EXPECT_EQ(run.Code, 0) << run.Errors;
    return run.Code == 0 ? Json::parse(run.Output) : Json();
  }

  TemporaryFolder Folder;
};

TEST_F(CliMeasure, MeasuresAModelOnItself)
{
  const Json found = this->Results(
      {"ball.json", "--from", "25,0,0", "--to", "5,20,0", "--to", "-15,0,0", "--path", "p.vtp"});
  EXPECT_EQ(found["on"], "model");
  ASSERT_EQ(found["distances"].size(), 2u);
  EXPECT_NEAR(found["distances"][0]["along_mm"].get<double>(), 10.0 * M_PI, 1e-4);
  EXPECT_NEAR(found["distances"][0]["straight_mm"].get<double>(), 20.0 * std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(found["distances"][1]["along_mm"].get<double>(), 20.0 * M_PI, 1e-3);
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "p.vtp"));
}

TEST_F(CliMeasure, MapsASurfaceFromAPoint)
{
  this->Results({"ball.json", "--from", "25,0,0", "--map", "map.vtp"});
  const vtkSmartPointer<vtkPolyData> map = ReadSurface(this->Folder / "map.vtp");
  vtkDataArray* lengths = map->GetPointData()->GetArray("DistanceAlongSurface");
  ASSERT_NE(lengths, nullptr);
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); i += 97)
  {
    const double cosine = (map->GetPoint(i)[0] - 5.0) / 20.0;
    EXPECT_NEAR(lengths->GetTuple1(i), 20.0 * std::acos(std::clamp(cosine, -1.0, 1.0)), 0.02);
  }
}

TEST_F(CliMeasure, MeasuresMasksAndSurfaces)
{
  this->Results({"ball.json", "--from", "25,0,0", "--map", "map.vtp"});
  const Json surface = this->Results({"map.vtp", "--from", "25,0,0", "--to", "5,20,0"});
  EXPECT_EQ(surface["on"], "triangles");
  EXPECT_NEAR(surface["distances"][0]["along_mm"].get<double>(), 10.0 * M_PI, 0.02);
  EXPECT_TRUE(surface["distances"][0]["uncertainty_mm"].is_null());

  LabelGrid grid;
  WriteImage(this->Folder / "a.nii.gz",
             MakeLabelImage(grid, [](double x, double y, double z)
                            { return std::hypot(x - 10.0, y - 10.0, z - 10.0) < 7.0; }));
  const Json mask = this->Results({"a.nii.gz", "--from", "17,10,10", "--to", "10,17,10"});
  EXPECT_NEAR(mask["distances"][0]["along_mm"].get<double>(), 3.5 * M_PI, 0.5); // half a voxel
}

TEST_F(CliMeasure, SaysThatAPointIsFarFromTheSurface)
{
  const CommandRun run = this->Measure({"ball.json", "--from", "35,0,0", "--to", "5,20,0"});
  EXPECT_EQ(run.Code, 0);
  EXPECT_NE(run.Errors.find("10.0 mm from the surface"), std::string::npos) << run.Errors;
}

TEST_F(CliMeasure, RefusesWhatCannotBeMeasured)
{
  EXPECT_EQ(this->Measure({"ball.json", "--from", "35,0,0"}).Code, 2);
  EXPECT_EQ(this->Measure({"ball.json", "--from", "35,0", "--to", "1,2,3"}).Code, 2);
  EXPECT_EQ(this->Measure({"ball.json", "--from", "1e30,0,0", "--to", "1,2,3"}).Code, 2);
  EXPECT_EQ(this->Measure({"ball.json", "--label", "3", "--from", "0,0,0"}).Code, 2);
}
} // namespace
} // namespace palpate::cli_measure_test
