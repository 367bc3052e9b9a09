// palpate fit SURFACE: closed surfaces without a mask.
#include "CommandRun.h"
#include "JsonLines.h"
#include "MeshShapes.h"
#include "SurfaceFile.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"
#include "TriangleMesh.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace palpate::cli_fit_surface_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

void Write(const IndexedMesh& mesh, const std::filesystem::path& file)
{
  TriangleMesh triangles;
  triangles.PointsWorld = mesh.Points;
  triangles.Triangles = mesh.Triangles;
  WriteSurface(file, PolyDataOf(triangles));
}

IndexedMesh Open()
{
  IndexedMesh mesh = Sphere(16, 20.0);
  mesh.Triangles.resize(mesh.Triangles.size() - 2);
  return mesh;
}

IndexedMesh Crossing()
{
  IndexedMesh mesh = Sphere(16, 20.0);
  mesh.Points[0] *= -1.5; // through the opposite side
  return mesh;
}

IndexedMesh TwoParts()
{
  IndexedMesh mesh = Sphere(8, 20.0);
  const IndexedMesh more = Sphere(8, 20.0, {43.0, 0.0, 0.0});
  const int start = static_cast<int>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), more.Points.begin(), more.Points.end());
  for (const std::array<int, 3>& t : more.Triangles)
  {
    mesh.Triangles.push_back({t[0] + start, t[1] + start, t[2] + start});
  }
  return mesh;
}

std::vector<std::pair<IndexedMesh, std::string>> BadSurfaces()
{
  return {{Torus(60, 30, 20.0, 6.0), "has 1 handle"},
          {Open(), "has 1 hole"},
          {Crossing(), "has triangles that cross each other"},
          {TwoParts(), "has 2 separate parts"}};
}

TEST(CliFitSurface, SphereGivesNumbersFilesAndReport)
{
  const TemporaryFolder folder;
  Write(Sphere(16, 20.0, {5.0, -3.0, 40.0}), folder / "ball.stl");
  for (const char* model : {"radial", "surface"})
  {
    const std::string out = std::string("out-") + model;
    const CommandRun run = RunPalpate(
        {"fit", "ball.stl", "--model", model, "--degree", "4", "--output", out, "--json"},
        folder.Path());
    ASSERT_EQ(run.Code, 0) << run.Errors;
    const Json result = Json::parse(run.Output);
    EXPECT_EQ(result.at("status"), "fitted");
    EXPECT_EQ(result.at("model"), model);
    EXPECT_TRUE(result.at("label").is_null());
    EXPECT_EQ(result.at("name"), "ball");
    EXPECT_GT(result.at("quality").at("overlap").at("dice").get<double>(), 0.99);
    EXPECT_GT(result.at("quality").at("overlap").at("spacing_mm").get<double>(), 0.0);
    EXPECT_LT(result.at("quality").at("surface").at("mean_mm").get<double>(), 0.1);
    // No mask, so nothing is measured against one.
    EXPECT_TRUE(result.at("quality").at("mask").at("dice").is_null());
    EXPECT_TRUE(result.at("quality").at("surface_to_mask").at("mean_mm").is_null());
    EXPECT_TRUE(result.at("volume_ml").at("mask").is_null());
    EXPECT_NEAR(result.at("volume_ml").at("surface").get<double>(), 33.3, 0.3);
    for (const char* file : {"model.json", "model.csv", "model.vtp", "surface.vtp", "report.html"})
    {
      EXPECT_TRUE(std::filesystem::exists(folder / out / file)) << file;
    }
  }
}

TEST(CliFitSurface, LineNamesSurface)
{
  const TemporaryFolder folder;
  Write(Sphere(8, 20.0), folder / "ball.ply");
  const CommandRun run = RunPalpate({"fit", "ball.ply", "--degree", "2"}, folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(run.Output.rfind("ball.ply: degree 2, Dice 0.9", 0), 0U) << run.Output;
  EXPECT_NE(run.Output.find("distance to the surface mean"), std::string::npos) << run.Output;
}

TEST(CliFitSurface, BadSurfaceHasOneMessageAndNoFiles)
{
  for (const auto& [mesh, fact] : BadSurfaces())
  {
    const TemporaryFolder folder;
    Write(mesh, folder / "a.ply");
    const CommandRun run = RunPalpate({"fit", "a.ply", "--output", "out"}, folder.Path());
    EXPECT_EQ(run.Code, 2) << fact;
    EXPECT_EQ(run.Output, "");
    EXPECT_EQ(std::count(run.Errors.begin(), run.Errors.end(), '\n'), 1) << run.Errors;
    EXPECT_NE(run.Errors.find("a.ply " + fact), std::string::npos) << run.Errors;
    EXPECT_NE(run.Errors.find("--repair"), std::string::npos) << run.Errors;
    EXPECT_FALSE(std::filesystem::exists(folder / "out")) << fact;
  }
}

TEST(CliFitSurface, RepairFitsWhatVoxelsEnclose)
{
  for (const auto& [mesh, fact] : BadSurfaces())
  {
    const TemporaryFolder folder;
    Write(mesh, folder / "a.ply");
    const CommandRun run =
        RunPalpate({"fit", "a.ply", "--repair", "--model", "surface", "--degree", "10", "--json"},
                   folder.Path());
    EXPECT_EQ(run.Code, 0) << fact << run.Errors;
    const Json result = Json::parse(run.Output);
    EXPECT_EQ(result.at("status"), "fitted") << run.Errors;
    EXPECT_NE(result.at("notes").at(0).get<std::string>().find(fact), std::string::npos);
    EXPECT_TRUE(result.at("repair").is_object());
  }
}

TEST(CliFitSurface, RepairServesRadialModelsToo)
{
  const TemporaryFolder folder;
  IndexedMesh open = Sphere(16, 20.0);
  open.Triangles.pop_back();
  Write(open, folder / "a.ply");
  EXPECT_EQ(RunPalpate({"fit", "a.ply", "--model", "radial"}, folder.Path()).Code, 2);
  const CommandRun run =
      RunPalpate({"fit", "a.ply", "--model", "radial", "--repair"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
}

TEST(CliFitSurface, RefusesOptionsOfMasks)
{
  const TemporaryFolder folder;
  Write(Sphere(8, 20.0), folder / "a.stl");
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--label", "1"}, {"--method", "plain"}})
  {
    std::vector<std::string> words{"fit", "a.stl"};
    words.insert(words.end(), options.begin(), options.end());
    const CommandRun run = RunPalpate(words, folder.Path());
    EXPECT_EQ(run.Code, 2);
    EXPECT_NE(run.Errors.find("which are for masks"), std::string::npos) << run.Errors;
  }
}

TEST(CliFitSurface, MasksAndSurfacesTogether)
{
  const TemporaryFolder folder;
  Write(Sphere(8, 20.0), folder / "a.stl");
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run = RunPalpate(
      {"fit", "a.stl", "a.nii.gz", "--degree", "2", "--output", "out", "--json"}, folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(Lines(run.Output).size(), 3U);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/report.html"));
}

TEST(CliFitSurface, FolderOfSurfacesIsACohort)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "surfaces");
  Write(Sphere(8, 20.0), folder / "surfaces/a.stl");
  Write(Sphere(8, 22.0), folder / "surfaces/b.ply");
  const CommandRun run =
      RunPalpate({"fit", "surfaces", "--degree", "2", "--output", "out"}, folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const CommandRun cohort = RunPalpate({"cohort", "out"}, folder.Path());
  EXPECT_EQ(cohort.Code, 0) << cohort.Errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "out/cohort.html"));
  const CommandRun again =
      RunPalpate({"fit", "surfaces", "--degree", "2", "--output", "out"}, folder.Path());
  EXPECT_NE(again.Errors.find("2 of 2 cases were done before"), std::string::npos) << again.Errors;
}

// Without a volume what is inside is drawn.
TEST(CliFitSurface, ReportHasSlicesOfTheVolume)
{
  const TemporaryFolder folder;
  Write(Sphere(16, 8.0), folder / "a.stl");
  WriteTwoSpheres(folder / "v.nii.gz");
  WriteAll(folder / "cases.csv", "case,mask,volume\nwith,a.stl,v.nii.gz\nwithout,a.stl,\n");
  const CommandRun run = RunPalpate(
      {"fit", "--manifest", "cases.csv", "--degree", "2", "--output", "out"}, folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const auto page = [&](const std::string& name)
  {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "out" / name))
    {
      if (entry.path().filename() == "report.html")
      {
        return ReadAll(entry.path());
      }
    }
    return std::string();
  };
  EXPECT_NE(page("with").find("image: v.nii.gz"), std::string::npos);
  EXPECT_NE(page("without").find("image: inside and outside, no volume given"), std::string::npos);
  EXPECT_NE(page("without").find("<svg class=\"slice\""), std::string::npos);
  EXPECT_EQ(page("without").find("edges of its voxels"), std::string::npos);
}

TEST(CliFitSurface, BrokenFileIsBadInput)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n");
  const CommandRun run = RunPalpate({"fit", "a.vtk"}, folder.Path());
  EXPECT_EQ(run.Code, 2);
  EXPECT_NE(run.Errors.find("its data set is not POLYDATA"), std::string::npos) << run.Errors;
}

TEST(CliFitSurface, ComponentKeepsOnePartOfSeveral)
{
  const TemporaryFolder folder;
  IndexedMesh mesh = Sphere(6, 10.0, {60.0, 0.0, 0.0});
  mesh = Join(mesh, Sphere(12, 20.0));
  Write(mesh, folder / "a.stl");
  for (const char* word : {"", "--repair"})
  {
    std::vector<std::string> words{"fit", "a.stl", "--degree", "4"};
    if (*word != '\0')
    {
      words.emplace_back(word);
    }
    const CommandRun refused = RunPalpate(words, folder.Path());
    EXPECT_EQ(refused.Code, 2) << word;
    EXPECT_NE(refused.Errors.find("--component 1"), std::string::npos) << refused.Errors;
  }
  for (const char* component : {"1", "largest"})
  {
    const CommandRun run = RunPalpate(
        {"fit", "a.stl", "--degree", "4", "--component", component, "--json"}, folder.Path());
    ASSERT_EQ(run.Code, 0) << run.Errors;
    EXPECT_NE(run.Output.find("1 other part of it left out"), std::string::npos) << run.Output;
  }
}
} // namespace
} // namespace palpate::cli_fit_surface_test
