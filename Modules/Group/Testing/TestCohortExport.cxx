#include "CohortExport.h"
#include "FilterRun.h"
#include "LatitudeAxis.h"
#include "ModelFile.h"
#include "ParametricPhantoms.h"
#include "RandomShapes.h"
#include "SpharmPdmCoefficients.h"
#include "SurfaceFile.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataReader.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace palpate::cohort_export_test
{
namespace
{
using namespace palpate::test;

/// Two bent tubes, 30 mm away from the origin, with their models in files.
class ExportedCohort
{
public:
  ExportedCohort()
  {
    Random random(4);
    for (const char* name : {"a b", "a_b"})
    {
      const ParametricSphericalSurface tube =
          BumpyTube(random, 4).Transformed(Matrix3::Identity(), Vector3(30.0, -10.0, 5.0));
      CohortRow row;
      row.Case = name;
      row.Model = std::string(name) + ".json";
      WriteModel(this->Folder / row.Model.string(), {tube, {}});
      this->Group.Rows.push_back(row);
      this->Group.Models.emplace_back(
          tube.Transformed(Matrix3::Identity(), Vector3(-30.0, 10.0, -5.0)));
      this->Tubes.push_back(tube);
    }
  }
  void Export(ExportKind kind) const
  {
    ExportCohort(this->Group, this->Folder.Path(), kind, this->Folder / "out", {});
  }

  TemporaryFolder Folder;
  CohortGroup Group;
  std::vector<ParametricSphericalSurface> Tubes;
};

// As ParaToSPHARMMesh names and fills them.
TEST(CohortExport, SpharmPdmFilesHoldTheModelInThreePoses)
{
  const ExportedCohort cohort;
  cohort.Export(ExportKind::SpharmPdm);
  const std::filesystem::path base = cohort.Folder / "out/Step3_ParaToSPHARMMesh/a_b_pp_surf";
  const ParametricSphericalSurface read =
      SurfaceFromSpharmPdm(ReadAll(base.string() + "_SPHARM.coef"), "test");
  const auto surface = ReadSurface(base.string() + "_SPHARM.vtk");
  const auto parameters = ReadSurface(base.string() + "_para.vtk");
  const auto aligned = ReadSurface(base.string() + "_SPHARM_procalign.vtk");
  ASSERT_EQ(surface->GetNumberOfPoints(), 4002);
  ASSERT_EQ(parameters->GetNumberOfPoints(), 4002);
  for (vtkIdType p = 0; p < 4002; p += 97)
  {
    // The reader turns RAS to LPS, also the parameters, which have no place in the patient.
    const Vector3 u(-parameters->GetPoint(p)[0], -parameters->GetPoint(p)[1],
                    parameters->GetPoint(p)[2]);
    const Vector3 point(surface->GetPoint(p));
    // Single precision of coordinates up to 60 mm, and of u.
    EXPECT_LT((point - read.Point(u.normalized())).norm(), 1e-4);
    EXPECT_LT((point - cohort.Tubes[0].Point(u.normalized())).norm(), 1e-4);
    EXPECT_LT((point - Vector3(aligned->GetPoint(p)) - Vector3(30.0, -10.0, 5.0)).norm(), 1e-4);
  }
  EXPECT_TRUE(std::filesystem::exists(base.string() + "_SPHARM_ellalign.coef"));
  EXPECT_TRUE(std::filesystem::exists(cohort.Folder / "out/Step2_GenParaMesh/a_b_pp_surf.vtk"));
  // Two names that are equal as file names.
  EXPECT_TRUE(std::filesystem::exists(cohort.Folder / "out/Step2_GenParaMesh/a_b-2_pp_para.vtk"));
}

TEST(CohortExport, SpharmPdmParametersTellPointsApart)
{
  const ExportedCohort cohort;
  cohort.Export(ExportKind::SpharmPdm);
  const std::string base = (cohort.Folder / "out/Step3_ParaToSPHARMMesh/a_b_pp_surf").string();
  vtkNew<vtkPolyDataReader> reader;
  reader->SetFileName((base + "_SPHARM.vtk").c_str());
  reader->Update();
  vtkPolyData* surface = reader->GetOutput();
  for (const char* name : {"_paraPhi", "_paraPhiHalf", "_paraTheta", "_paraMix"})
  {
    vtkDataArray* array = surface->GetPointData()->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    std::istringstream text(ReadAll(base + name + ".txt"));
    std::string line;
    std::getline(text, line);
    EXPECT_EQ(line, "NUMBER_OF_POINTS = 4002");
    std::getline(text, line);
    EXPECT_EQ(line, "DIMENSION = 1");
    std::getline(text, line);
    EXPECT_EQ(line, "TYPE = Scalar");
    double value = 0.0;
    vtkIdType count = 0;
    for (; text >> value; ++count)
    {
      ASSERT_NEAR(value, array->GetComponent(count, 0), 1e-8);
    }
    EXPECT_EQ(count, 4002);
  }
  EXPECT_NEAR(surface->GetPointData()->GetArray("_paraPhi")->GetRange()[1], 2.0 * M_PI, 0.1);
  EXPECT_NEAR(surface->GetPointData()->GetArray("_paraPhiHalf")->GetRange()[1], M_PI, 0.1);
}

TEST(CohortExport, SpharmPdmAxisOfAnEllipsoidIsItsOwn)
{
  // x = 30 sin cos, y = 20 sin sin, z = 10 cos: coefficients of degree 1, (Y_1,-1, Y_1,0, Y_1,1) =
  // (y, z, x).
  const double unit = std::sqrt(4.0 * M_PI / 3.0);
  const ParametricSphericalSurface ellipsoid(1, {std::vector<double>{0.0, 0.0, 0.0, 30.0 * unit},
                                                 std::vector<double>{0.0, 20.0 * unit, 0.0, 0.0},
                                                 std::vector<double>{0.0, 0.0, 10.0 * unit, 0.0}});
  const LatitudeAxis axis = FindLatitudeAxis(ellipsoid, 5, 400);
  EXPECT_LT((axis.Middles[1] - Vector3(0.0, 0.0, 10.0 * std::cos(M_PI / 4.0))).norm(), 1e-12);
  // The fan of 400 triangles of an ellipse: pi a b sin(x) / x, x = 2 pi / 400.
  EXPECT_NEAR(axis.Areas[2], M_PI * 600.0, 0.1);
  EXPECT_NEAR(axis.Areas[0], 0.0, 1e-12);
  EXPECT_NEAR(axis.Radii[2], 25.0, 0.3); // between the half axes
}

TEST(CohortExport, ShapeWorksProjectNamesCorrespondingParticles)
{
  const ExportedCohort cohort;
  cohort.Export(ExportKind::ShapeWorks);
  const auto project = nlohmann::json::parse(ReadAll(cohort.Folder / "out/cohort.swproj"));
  ASSERT_EQ(project["data"].size(), 2U);
  const auto& row = project["data"][0];
  EXPECT_EQ(row["name"], "a_b");
  std::istringstream local(
      ReadAll(cohort.Folder / ("out/" + row["local_particles_1"].get<std::string>())));
  std::istringstream world(
      ReadAll(cohort.Folder / ("out/" + row["world_particles_1"].get<std::string>())));
  Vector3 a;
  Vector3 b;
  int count = 0;
  while (local >> a.x() >> a.y() >> a.z() && world >> b.x() >> b.y() >> b.z())
  {
    ASSERT_LT((a - b - Vector3(30.0, -10.0, 5.0)).norm(), 1e-10);
    ++count;
  }
  EXPECT_EQ(count, 1002);
  EXPECT_EQ(ReadSurface(cohort.Folder / ("out/" + row["groomed_1"].get<std::string>()))
                ->GetNumberOfPoints(),
            4002);
}

TEST(CohortExport, CanBeCancelled)
{
  const ExportedCohort cohort;
  EXPECT_THROW(ExportCohort(cohort.Group, cohort.Folder.Path(), ExportKind::ShapeWorks,
                            cohort.Folder / "out",
                            [](double, const std::string&) { return false; }),
               Cancelled);
}
} // namespace
} // namespace palpate::cohort_export_test
