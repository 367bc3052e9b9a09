#include "CohortExport.h"
#include "LatitudeAxis.h"
#include "ModelFile.h"
#include "Progress.h"
#include "RandomOrientation.h"
#include "RandomShapes.h"
#include "SpharmPdmCoefficients.h"
#include "SurfaceFile.h"
#include "SurfacePhantoms.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataReader.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>
#include <vector>

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
      const SurfaceModel tube =
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
  std::vector<SurfaceModel> Tubes;
};

// As ParaToSPHARMMesh names and fills them.
TEST(CohortExport, SpharmPdmFilesHoldTheModelInThreePoses)
{
  const ExportedCohort cohort;
  cohort.Export(ExportKind::SpharmPdm);
  const std::filesystem::path base = cohort.Folder / "out/Step3_ParaToSPHARMMesh/a_b_pp_surf";
  const SurfaceModel read = SurfaceFromSpharmPdm(ReadAll(base.string() + "_SPHARM.coef"), "test");
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

// x = 30 cos, y = 20 ..., z = 10 ...: coefficients of degree 1, (Y_1,-1, Y_1,0, Y_1,1) = (y, z, x).
SurfaceModel Ellipsoid()
{
  const double unit = std::sqrt(4.0 * M_PI / 3.0);
  return {1,
          {std::vector<double>{0.0, 0.0, 0.0, 30.0 * unit},
           std::vector<double>{0.0, 20.0 * unit, 0.0, 0.0},
           std::vector<double>{0.0, 0.0, 10.0 * unit, 0.0}}};
}

// Mean distance of the points of an ellipse of half axes 20 and 10 from its centre, at equal steps
// of its angle: Legendre's complete integral of the second kind.
double MeanEllipseRadius()
{
  return 20.0 * 2.0 / M_PI * std::comp_ellint_2(std::sqrt(0.75));
}

TEST(CohortExport, SpharmPdmAxisOfAnEllipsoidIsItsLongAxis)
{
  const LatitudeAxis axis = FindLatitudeAxis(Ellipsoid(), 5, 401);
  EXPECT_LT((axis.Middles[1] - Vector3(30.0 * std::cos(M_PI / 4.0), 0.0, 0.0)).norm(), 1e-12);
  // The fan of 400 triangles of an ellipse: pi a b sin(x) / x, x = 2 pi / 400.
  const double x = 2.0 * M_PI / 400.0;
  EXPECT_NEAR(axis.Areas[2], M_PI * 200.0 * std::sin(x) / x, 1e-10);
  EXPECT_NEAR(axis.Areas[0], 0.0, 1e-12);
  // The rule of equal steps converges geometrically.
  EXPECT_NEAR(axis.Radii[2], MeanEllipseRadius(), 1e-12);
  EXPECT_NEAR(axis.Radii[1], std::sqrt(0.5) * MeanEllipseRadius(), 1e-12);
}

// However body and parameters lie.
TEST(CohortExport, SpharmPdmAxisFollowsTheBody)
{
  Random random(31);
  for (int trial = 0; trial < 10; ++trial)
  {
    const Matrix3 turn = RandomOrientation(random);
    const Vector3 centre(40.0, -5.0, 12.0);
    const SurfaceModel turned = WithLongAxisFirst(
        Ellipsoid().Transformed(turn, centre).Reparametrized(RandomOrientation(random)));
    const LatitudeAxis axis = FindLatitudeAxis(turned, 9, 65);
    const Vector3 along = turn.col(0);
    EXPECT_NEAR((axis.Middles[0] - axis.Middles[8]).norm(), 60.0, 1e-11);
    for (std::size_t i = 0; i < axis.Middles.size(); ++i)
    {
      EXPECT_LT((axis.Middles[i] - centre).cross(along).norm(), 1e-11);
      EXPECT_NEAR(axis.Radii[i], std::sin(axis.Theta[i]) * MeanEllipseRadius(), 1e-9);
    }
  }
}

// A text file as KWMeshVisu reads it: three lines, then a number a point.
std::vector<double> MedialScalars(const std::string& file)
{
  std::istringstream text(ReadAll(file));
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line, "NUMBER_OF_POINTS=10000");
  std::getline(text, line);
  EXPECT_EQ(line, "DIMENSION=1");
  std::getline(text, line);
  EXPECT_EQ(line, "TYPE=Scalar");
  std::vector<double> values;
  for (double value = 0.0; text >> value;)
  {
    values.push_back(value);
  }
  return values;
}

TEST(CohortExport, SpharmPdmMedialMeshIsTheSurfaceInCircles)
{
  const ExportedCohort cohort;
  cohort.Export(ExportKind::SpharmPdm);
  const std::string base = (cohort.Folder / "out/Step3_ParaToSPHARMMesh/a_b_pp_surf").string();
  vtkNew<vtkPolyDataReader> reader;
  reader->SetFileName((base + "_SPHARMMedialMesh.vtk").c_str());
  reader->Update();
  vtkPolyData* mesh = reader->GetOutput();
  ASSERT_EQ(mesh->GetNumberOfPoints(), 100 * 100);
  ASSERT_EQ(mesh->GetNumberOfPolys(), 2 * 99 * 99);
  const std::array<std::pair<const char*, const char*>, 4> arrays{
      {{"radius", "Radius"},
       {"area", "Area"},
       {"partial_area", "PartialArea"},
       {"partial_radius", "PartialRadius"}}};
  for (const auto& [name, ending] : arrays)
  {
    vtkDataArray* array = mesh->GetPointData()->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    const std::vector<double> text = MedialScalars(base + "_medialMesh" + ending + ".txt");
    ASSERT_EQ(text.size(), 10000U);
    for (vtkIdType p = 0; p < 10000; ++p)
    {
      ASSERT_NEAR(text[static_cast<std::size_t>(p)], array->GetComponent(p, 0),
                  1e-8 * (1.0 + text[static_cast<std::size_t>(p)]));
    }
  }
  vtkNew<vtkPolyDataReader> line;
  line->SetFileName((base + "_SPHARMMedialAxis.vtk").c_str());
  line->Update();
  vtkDataArray* areas = mesh->GetPointData()->GetArray("area");
  vtkDataArray* parts = mesh->GetPointData()->GetArray("partial_area");
  for (vtkIdType circle = 0; circle < 100; circle += 9)
  {
    Vector3 middle = Vector3::Zero();
    double area = 0.0;
    for (vtkIdType k = 0; k < 99; ++k)
    {
      middle += Vector3(mesh->GetPoint(100 * circle + k)) / 99.0;
      area += parts->GetComponent(100 * circle + k, 0);
    }
    // Single precision of coordinates up to 60 mm.
    EXPECT_LT((middle - Vector3(line->GetOutput()->GetPoint(circle))).norm(), 1e-4);
    EXPECT_NEAR(area, areas->GetComponent(100 * circle, 0), 1e-8 * (1.0 + area));
    EXPECT_EQ(mesh->GetPoint(100 * circle)[0], mesh->GetPoint(100 * circle + 99)[0]);
  }
  // Enclosed volume by the divergence theorem: positive if the triangles are outward, and that of
  // the model but for facets.
  double volume = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, corners);
    const Vector3 a(mesh->GetPoint(corners->GetId(0)));
    const Vector3 b(mesh->GetPoint(corners->GetId(1)));
    volume += a.dot(b.cross(Vector3(mesh->GetPoint(corners->GetId(2))))) / 6.0;
  }
  EXPECT_NEAR(volume / cohort.Tubes[0].Volume(), 1.0, 0.02);
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
