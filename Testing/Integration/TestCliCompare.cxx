#include "CommandRun.h"
#include "JsonLines.h"
#include "MeshShapes.h"
#include "SurfaceFile.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"
#include "TestData.h"
#include "TriangleMesh.h"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace palpate::cli_compare_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

// A model of a sphere; its centre is in mm.
void WriteSphere(const std::filesystem::path& path, double radius, const Vector3& center)
{
  ModelDocument document;
  document.Surface = SphericalHarmonicModel(0, {radius * std::sqrt(4.0 * M_PI)}, center);
  WriteModel(path, document);
}

void WriteMesh(const std::filesystem::path& path, const IndexedMesh& mesh)
{
  TriangleMesh triangles;
  triangles.PointsWorld = mesh.Points;
  triangles.Triangles = mesh.Triangles;
  WriteSurface(path, PolyDataOf(triangles));
}

std::vector<Json> Compare(const TemporaryFolder& folder, std::vector<std::string> words,
                          int code = 0)
{
  words.insert(words.begin(), "compare");
  words.emplace_back("--json");
  const CommandRun run = RunPalpate(words, folder.Path());
  EXPECT_EQ(run.Code, code) << run.Errors;
  std::vector<Json> objects;
  std::istringstream lines(run.Output);
  for (std::string line; std::getline(lines, line);)
  {
    objects.push_back(Json::parse(line));
  }
  return objects;
}

TEST(CliCompare, TwoModelsHaveTheirExactDistances)
{
  const TemporaryFolder folder;
  WriteSphere(folder / "a.json", 22.0, {100.0, -50.0, 7.0});
  WriteSphere(folder / "b.json", 20.0, {100.0, -50.0, 7.0});
  const Json pair = Compare(folder, {"a.json", "b.json", "--tolerance", "1.5,2.5"}).at(0);
  EXPECT_NEAR(pair.at("distance").at("both").at("mean_mm").get<double>(), 2.0, 1e-9);
  EXPECT_NEAR(pair.at("distance").at("hausdorff95_mm").get<double>(), 2.0, 1e-9);
  EXPECT_NEAR(pair.at("distance").at("first_to_reference").at("signed_mean_mm").get<double>(), 2.0,
              1e-9);
  EXPECT_EQ(pair.at("surface_dice").at(0).at("value"), 0.0);
  EXPECT_EQ(pair.at("surface_dice").at(1).at("value"), 1.0);
  EXPECT_NEAR(pair.at("volume_difference_percent").get<double>(), 33.1, 1e-9);
  EXPECT_EQ(pair.at("overlap").at("cells"), "cubes");
  EXPECT_NEAR(pair.at("overlap").at("dice").get<double>(), 2.0 / (1.0 + 1.331), 2e-4);
}

TEST(CliCompare, TolerancesMayComeBeforeTheFiles)
{
  const TemporaryFolder folder;
  WriteSphere(folder / "a.json", 22.0, Vector3::Zero());
  const Json pair = Compare(folder, {"--tolerance", "4,0.5", "a.json", "a.json"}).at(0);
  ASSERT_EQ(pair.at("surface_dice").size(), 2u);
  EXPECT_EQ(pair.at("surface_dice").at(0).at("tolerance_mm"), 0.5);
}

TEST(CliCompare, StructuresOfOneNumberArePaired)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const std::vector<Json> pairs = Compare(folder, {"a.nii.gz", "a.nii.gz"});
  ASSERT_EQ(pairs.size(), 2u);
  for (const Json& pair : pairs)
  {
    EXPECT_EQ(pair.at("first").at("label"), pair.at("reference").at("label"));
    EXPECT_EQ(pair.at("overlap").at("dice"), 1.0);
    EXPECT_EQ(pair.at("overlap").at("cells"), "voxels");
    EXPECT_EQ(pair.at("distance").at("both").at("max_mm"), 0.0);
  }
}

TEST(CliCompare, OtherLabelIsChosenForTheReference)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const Json pair =
      Compare(folder, {"a.nii.gz", "a.nii.gz", "--label", "1", "--reference-label", "2"}).at(0);
  EXPECT_EQ(pair.at("overlap").at("dice"), 0.0);
  EXPECT_NE(pair.at("notes").at(0).get<std::string>().find("share no volume"), std::string::npos);
}

TEST(CliCompare, MaskAndModelAgreeWithTheFitsOwnNumbers)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun fit =
      RunPalpate({"fit", "a.nii.gz", "--label", "1", "--degree", "6", "--output", "out", "--json"},
                 folder.Path());
  ASSERT_EQ(fit.Code, 0) << fit.Errors;
  const Json quality = Json::parse(fit.Output).at("quality").at("mask");
  const Json pair = Compare(folder, {"out/model.json", "a.nii.gz", "--label", "1"}).at(0);
  EXPECT_EQ(pair.at("overlap").at("cells"), "mask-voxels");
  EXPECT_NEAR(pair.at("overlap").at("dice").get<double>(), quality.at("dice").get<double>(), 1e-3);
  // The fit measures from its drawing, and marches the mask's boundary in another way.
  EXPECT_NEAR(pair.at("distance").at("both").at("mean_mm").get<double>(),
              quality.at("mean_mm").get<double>(), 0.03);
}

TEST(CliCompare, OpenSurfaceHasNoVolumeAndANote)
{
  const TemporaryFolder folder;
  IndexedMesh open = Sphere(10, 20.0);
  open.Triangles.resize(open.Triangles.size() / 2);
  WriteMesh(folder / "open.stl", open);
  WriteMesh(folder / "closed.ply", Sphere(20, 20.0));
  const Json pair = Compare(folder, {"open.stl", "closed.ply"}).at(0);
  EXPECT_TRUE(pair.at("overlap").is_null());
  EXPECT_TRUE(pair.at("first").at("volume_ml").is_null());
  EXPECT_TRUE(pair.at("distance").at("reference_to_first").at("signed_mean_mm").is_null());
  EXPECT_NE(pair.at("notes").at(0).get<std::string>().find("is open"), std::string::npos);
}

TEST(CliCompare, WritesMapPictureAndPageWithoutPaths)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "secret");
  WriteSphere(folder / "secret/a.json", 22.0, Vector3::Zero());
  WriteTwoSpheres(folder / "secret/b.nii.gz");
  Compare(folder, {"secret/a.json", "secret/b.nii.gz", "--label", "1", "--output", "out"});
  const vtkSmartPointer<vtkPolyData> first = ReadSurface(folder / "out/first.vtp");
  const TriangleMesh mesh = TrianglesOf(first, "first.vtp");
  ASSERT_EQ(mesh.Values.size(), 1u);
  EXPECT_EQ(mesh.Values.front().Name, "SignedDistance");
  EXPECT_GT(mesh.Values.front().Numbers.front(), 10.0);
  EXPECT_EQ(ReadAll(folder / "out/map.png").substr(1, 3), "PNG");
  const std::string page = ReadAll(folder / "out/report.html");
  EXPECT_NE(page.find("Nikolov"), std::string::npos);
  EXPECT_EQ(page.find("secret"), std::string::npos);
  EXPECT_EQ(page.find(folder.Path().string()), std::string::npos);
}

TEST(CliCompare, FoldersGiveATableAndNameWhatIsAlone)
{
  const TemporaryFolder folder;
  for (const char* reader : {"one", "two"})
  {
    std::filesystem::create_directory(folder / reader);
    WriteSphere(folder / reader / "p1.json", 20.0, Vector3::Zero());
  }
  WriteSphere(folder / "one" / "p2.json", 21.0, Vector3::Zero());
  WriteSphere(folder / "two" / "p2.json", 20.0, Vector3::Zero());
  WriteSphere(folder / "two" / "p3.json", 20.0, Vector3::Zero());
  const CommandRun run = RunPalpate({"compare", "one", "two", "--output", "out"}, folder.Path());
  EXPECT_EQ(run.Code, 0);
  EXPECT_NE(run.Output.find("2 pairs"), std::string::npos) << run.Output;
  EXPECT_NE(run.Errors.find("p3.json has no partner"), std::string::npos) << run.Errors;
  const std::string table = ReadAll(folder / "out/comparison.csv");
  EXPECT_NE(table.find("\np1,"), std::string::npos) << table;
  EXPECT_NE(table.find("\np2,"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/p2/report.html"));
  EXPECT_NE(ReadAll(folder / "out/report.html").find("href=\"p2/report.html\""), std::string::npos);
}

TEST(CliCompare, CohortsModelsArePairedWithTheirMasks)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "masks");
  WriteTwoSpheres(folder / "masks/a.nii.gz");
  WriteTwoSpheres(folder / "masks/b.nii.gz");
  ASSERT_EQ(RunPalpate({"fit", "masks", "--degree", "4", "--output", "fitted"}, folder.Path()).Code,
            0);
  const std::vector<Json> pairs = Compare(folder, {"masks", "fitted"});
  ASSERT_EQ(pairs.size(), 4u); // two structures each
  for (const Json& pair : pairs)
  {
    EXPECT_EQ(pair.at("status"), "compared");
    EXPECT_GT(pair.at("overlap").at("dice").get<double>(), 0.9);
  }
  const std::vector<Json> chosen = Compare(folder, {"masks", "fitted", "--label", "2"});
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_EQ(chosen.front().at("first").at("label"), 2);
}

TEST(CliCompare, CaseThatCannotBeReadDoesNotStopTheOthers)
{
  const TemporaryFolder folder;
  WriteSphere(folder / "a.json", 20.0, Vector3::Zero());
  WriteAll(folder / "broken.stl", "solid nothing");
  WriteAll(folder / "pairs.csv", "case,first,reference\nx,broken.stl,a.json\ny,a.json,a.json\n");
  const std::vector<Json> pairs = Compare(folder, {"--pairs", "pairs.csv", "--output", "out"}, 1);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].at("status"), "bad-input");
  EXPECT_EQ(pairs[1].at("status"), "compared");
  EXPECT_NE(ReadAll(folder / "out/comparison.csv").find("bad-input"), std::string::npos);
}

TEST(CliCompare, RefusesWithTheWayOut)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  WriteSphere(folder / "b.json", 20.0, Vector3::Zero());
  std::filesystem::create_directory(folder / "folder");
  const auto refusal = [&](const std::vector<std::string>& words)
  {
    std::vector<std::string> all{"compare"};
    all.insert(all.end(), words.begin(), words.end());
    const CommandRun run = RunPalpate(all, folder.Path());
    EXPECT_EQ(run.Code, 2);
    return run.Errors;
  };
  EXPECT_NE(refusal({"a.nii.gz", "b.json"}).find("choose one with --label"), std::string::npos);
  EXPECT_NE(refusal({"b.json", "b.json", "--label", "1"}).find("leave out --label"),
            std::string::npos);
  EXPECT_NE(refusal({"a.nii.gz", "folder"}).find("two files or two folders"), std::string::npos);
  EXPECT_NE(refusal({"a.nii.gz"}).find("REFERENCE"), std::string::npos);
  EXPECT_NE(refusal({"a.nii.gz", "b.json", "--label", "7"}).find("7"), std::string::npos);
  EXPECT_NE(refusal({"a.nii.gz", "b.json", "--tolerance", "nan"}).find("--tolerance"),
            std::string::npos);
}
} // namespace
} // namespace palpate::cli_compare_test
