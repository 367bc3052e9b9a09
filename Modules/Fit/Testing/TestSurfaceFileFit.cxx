#include "SurfaceFileFit.h"

#include "FitCases.h"
#include "FitFiles.h"
#include "FitStructure.h"
#include "MeshGltf.h"
#include "ModelSurface.h"
#include "SinglePrecision.h"
#include "SurfaceFile.h"
#include "SurfacePhantoms.h"
#include "TemporaryFolder.h"
#include "TestData.h"
#include "TriangleMesh.h"

#include "vtkNew.h"
#include "vtkPolyDataWriter.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace palpate::surface_file_fit_test
{
namespace
{
using test::HasNote;
using namespace palpate::test;
using Outcome = FitResult::Outcome;

FitSettings Settings(FitSettings::ModelKind model, int degree)
{
  FitSettings settings;
  settings.Model = model;
  settings.Degree = degree;
  return settings;
}

// A phantom's surface in single precision, which every format keeps.
vtkSmartPointer<vtkPolyData> SurfaceOf(const SurfaceModel& phantom, int frequency)
{
  TriangleMesh mesh = TrianglesOf(DrawModel(phantom, frequency), "phantom");
  for (Vector3& point : mesh.PointsWorld)
  {
    point = InSinglePrecision(point);
  }
  mesh.SinglePrecision = true;
  mesh.Normals.clear();
  return PolyDataOf(mesh);
}

FitResult Fit(vtkPolyData* surface, const FitSettings& settings)
{
  return FitSurfaceFile("folder/a.stl", surface, settings);
}

std::vector<double> CoefficientsOf(const FitResult& result)
{
  if (const RadialModel* radial = result.Radial())
  {
    return radial->Coefficients();
  }
  std::vector<double> all;
  for (const int coordinate : {0, 1, 2})
  {
    const auto& one = std::get<SurfaceModel>(result.Model).Coefficients(coordinate);
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

TEST(SurfaceFileFit, EveryFormatGivesSameCoefficients)
{
  const TemporaryFolder folder;
  const auto surface = SurfaceOf(EllipsoidPhantom({30.0, 20.0, 15.0}), 10);
  std::vector<std::filesystem::path> files;
  for (const char* name : {"a.vtp", "a.stl", "a.ply", "a.obj", "a.gltf", "a.glb"})
  {
    files.push_back(folder / name);
    WriteSurface(files.back(), surface);
  }
  vtkNew<vtkPolyDataWriter> legacy;
  legacy->SetFileName((folder / "a.vtk").c_str());
  legacy->SetFileTypeToBinary();
  legacy->SetInputData(surface);
  legacy->Write();
  files.push_back(folder / "a.vtk");
  for (const auto model : {FitSettings::ModelKind::Radial, FitSettings::ModelKind::Surface})
  {
    const FitResult expected = Fit(surface, Settings(model, 6));
    ASSERT_EQ(expected.State, Outcome::Fitted) << expected.Message;
    for (const std::filesystem::path& file : files)
    {
      const FitResult result = FitSurfaceFile(file, ReadSurface(file), Settings(model, 6));
      EXPECT_EQ(CoefficientsOf(result), CoefficientsOf(expected)) << file;
    }
  }
}

TEST(SurfaceFileFit, RecoversEllipsoid)
{
  const auto surface = SurfaceOf(EllipsoidPhantom({30.0, 20.0, 15.0}), 24);
  const FitResult result = Fit(surface, Settings(FitSettings::ModelKind::Surface, 5));
  ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
  EXPECT_TRUE(result.IsOfSurface);
  EXPECT_EQ(result.CaseName, "a");
  EXPECT_EQ(result.Mask, nullptr);
  // The facets of 11,520 triangles are 0.05 mm below the ellipsoid.
  EXPECT_LT(result.ModelToSurface.Mean, 0.05);
  EXPECT_GT(result.Dice, 0.995);
  EXPECT_GT(result.DiceSpacing, 0.0);
  EXPECT_NEAR(result.ModelMilliliters, 4.0 / 3.0 * M_PI * 9.0, 0.2);
  EXPECT_EQ(result.Details.Folded, 0);
}

TEST(SurfaceFileFit, AutomaticChoosesByVisibility)
{
  const FitResult ellipsoid = Fit(SurfaceOf(EllipsoidPhantom({30.0, 20.0, 15.0}), 16),
                                  Settings(FitSettings::ModelKind::Automatic, 6));
  ASSERT_EQ(ellipsoid.State, Outcome::Fitted) << ellipsoid.Message;
  EXPECT_NE(ellipsoid.Radial(), nullptr);
  const FitResult bowl =
      Fit(SurfaceOf(Bowl(), 24), Settings(FitSettings::ModelKind::Automatic, 12));
  ASSERT_EQ(bowl.State, Outcome::Fitted) << bowl.Message;
  EXPECT_EQ(bowl.Radial(), nullptr);
  EXPECT_GT(bowl.Dice, 0.95);
}

TEST(SurfaceFileFit, SearchesDegreeForTolerance)
{
  const auto surface = SurfaceOf(EllipsoidPhantom({30.0, 20.0, 15.0}), 16);
  for (const auto model : {FitSettings::ModelKind::Radial, FitSettings::ModelKind::Surface})
  {
    FitSettings settings = Settings(model, 0);
    settings.Tolerance = 0.3;
    const FitResult result = Fit(surface, settings);
    ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
    EXPECT_LE(result.Rms, 0.3);
    EXPECT_GT(DegreeOf(result.Model), 0);
  }
}

TEST(SurfaceFileFit, CoarseBoxIsSampledBetweenItsCorners)
{
  TriangleMesh box;
  for (int corner = 0; corner < 8; ++corner)
  {
    box.PointsWorld.emplace_back(20.0 * (corner & 1), 10.0 * (corner & 2), 5.0 * (corner & 4));
  }
  box.Triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  for (const auto model : {FitSettings::ModelKind::Radial, FitSettings::ModelKind::Surface})
  {
    const FitResult result = Fit(PolyDataOf(box), Settings(model, 12));
    ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
    EXPECT_GT(result.Dice, 0.97);
  }
}

TEST(SurfaceFileFit, BadSurfaceIsBadInputUnlessRepaired)
{
  TriangleMesh open = TrianglesOf(SurfaceOf(EllipsoidPhantom({30.0, 20.0, 15.0}), 16), "a");
  open.Triangles.resize(open.Triangles.size() - 3);
  FitSettings settings = Settings(FitSettings::ModelKind::Automatic, 6);
  const FitResult refused = Fit(PolyDataOf(open), settings);
  EXPECT_EQ(refused.State, Outcome::BadInput);
  EXPECT_EQ(refused.Message.rfind("has 1 hole", 0), 0U) << refused.Message;
  EXPECT_NE(refused.OptionHint.find("--repair"), std::string::npos);
  settings.Repairs = true;
  const FitResult repaired = Fit(PolyDataOf(open), settings);
  ASSERT_EQ(repaired.State, Outcome::Fitted) << repaired.Message;
  ASSERT_FALSE(repaired.Notes.empty());
  EXPECT_NE(repaired.Notes.front().find("has 1 hole: it was made again from voxels of"),
            std::string::npos)
      << repaired.Notes.front();
  EXPECT_NEAR(repaired.ModelMilliliters, 4.0 / 3.0 * M_PI * 9.0, 0.5);
}

TEST(SurfaceFileFit, RepairTellsHowMuchOfTheSurfaceIsNew)
{
  TriangleMesh open = TrianglesOf(SurfaceOf(EllipsoidPhantom({30.0, 20.0, 15.0}), 64), "a");
  auto& triangles = open.Triangles;
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                 [&open](const auto& t)
                                 { return open.PointsWorld[t.front()].x() > 12.0; }),
                  triangles.end());
  FitSettings settings = Settings(FitSettings::ModelKind::Surface, 6);
  settings.Repairs = true;
  const FitResult result = Fit(PolyDataOf(open), settings);
  ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
  // The lid of pi 20 15 mm^2, on half of an ellipsoid of 5,550 mm^2; its rim is not counted.
  EXPECT_GT(result.Details.AddedAreaPercent, 20.0);
  EXPECT_LT(result.Details.AddedAreaPercent, 26.0);
  EXPECT_TRUE(HasNote(result, "% of its area is new, up to 1"));
}

// An ellipsoid of 4.691 ml with debris, and one that is there twice.
TEST(SurfaceFileFit, DebrisIsDroppedOnRequestAndNeverBridged)
{
  for (const char* name : {"odd/stl_debris.stl", "odd/obj_twice.obj"})
  {
    const auto path = DataPath(name);
    PALPATE_REQUIRE_FILE(path);
    const auto surface = ReadSurface(path);
    FitSettings settings = Settings(FitSettings::ModelKind::Automatic, 8);
    settings.Repairs = true;
    const FitResult bridged = Fit(surface, settings);
    EXPECT_EQ(bridged.State, Outcome::BadInput) << name;
    EXPECT_NE(bridged.Message.find("mm apart"), std::string::npos) << bridged.Message;
    EXPECT_NE(bridged.OptionHint.find("--component 1"), std::string::npos);
    settings.Repairs = false;
    settings.IsAlone = true;
    const FitResult alone = Fit(surface, settings);
    ASSERT_EQ(alone.State, Outcome::Fitted) << alone.Message;
    EXPECT_NEAR(alone.ModelMilliliters, 4.691, 0.05) << name;
    EXPECT_TRUE(HasNote(alone, "of it left out"));
  }
}

TEST(SurfaceFileFit, SurfaceInMetresIsNoticed)
{
  const TriangleMesh given = TrianglesOf(SurfaceOf(EllipsoidPhantom({30.0, 20.0, 15.0}), 16), "a");
  TriangleMesh metres = given;
  for (Vector3& point : metres.PointsWorld)
  {
    point *= 0.001;
  }
  const FitSettings settings = Settings(FitSettings::ModelKind::Automatic, 6);
  EXPECT_TRUE(HasNote(Fit(PolyDataOf(metres), settings), "its coordinates are taken as mm"));
  EXPECT_FALSE(HasNote(Fit(PolyDataOf(given), settings), "its coordinates are taken as mm"));
}

TEST(SurfaceFileFit, FilesHaveErrorMapAndNoMask)
{
  const TemporaryFolder folder;
  const FitResult result = Fit(SurfaceOf(EllipsoidPhantom({30.0, 20.0, 15.0}), 10),
                               Settings(FitSettings::ModelKind::Surface, 4));
  WriteFitFiles(result, nullptr, folder / "out", "test");
  for (const char* file : {"model.json", "model.csv", "model.vtp", "surface.vtp"})
  {
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / file)) << file;
  }
  const std::string report = ReadAll(folder / "out" / "report.html");
  EXPECT_NE(report.find("Signed distance from the model to the surface,"), std::string::npos);
  EXPECT_NE(report.find("Overlap of model and surface"), std::string::npos);
  for (const char* word : {"Model and mask", "against the mask", "Mask volume", "label 0"})
  {
    EXPECT_EQ(report.find(word), std::string::npos) << word;
  }
}
} // namespace
} // namespace palpate::surface_file_fit_test
