#include "FileSizeLimit.h"
#include "IcosahedronDirections.h"
#include "InputError.h"
#include "SurfaceFile.h"
#include "TemporaryFolder.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFeatureEdges.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace palpate::surface_file_test
{
namespace
{
using namespace palpate::test;

enum class Precision
{
  Single,
  Double
};

// A closed, bumpy body off the origin, with normals and a point array.
vtkSmartPointer<vtkPolyData> Body(Precision precision)
{
  const IcosahedronDirections sphere(6);
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> bump(20.0, 21.0);
  vtkNew<vtkPoints> points;
  points->SetDataType(precision == Precision::Double ? VTK_DOUBLE : VTK_FLOAT);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> distance;
  distance->SetName("Distance To Surface");
  for (const Vector3& u : sphere.Directions())
  {
    const Vector3 point = Vector3(-31.7, 12.3, 140.9) + bump(random) * u;
    points->InsertNextPoint(point.data());
    normals->InsertNextTuple(u.data());
    distance->InsertNextValue(bump(random) / 3.0);
  }
  vtkNew<vtkCellArray> faces;
  for (const auto& face : sphere.Triangles())
  {
    faces->InsertNextCell({face[0], face[1], face[2]});
  }
  auto body = vtkSmartPointer<vtkPolyData>::New();
  body->SetPoints(points);
  body->SetPolys(faces);
  body->GetPointData()->SetNormals(normals);
  body->GetPointData()->AddArray(distance);
  return body;
}

vtkIdType OpenOrBadEdges(vtkPolyData* surface)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->BoundaryEdgesOn();
  edges->NonManifoldEdgesOn();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

double LargestPointDifference(vtkPolyData* a, vtkPolyData* b)
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    const double distance = (Vector3(a->GetPoint(i)) - Vector3(b->GetPoint(i))).norm();
    largest = distance <= largest ? largest : distance; // NaN counts as large
  }
  return largest;
}

void ExpectSameTriangles(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  for (vtkIdType i = 0; i < a->GetNumberOfCells(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_EQ(a->GetCell(i)->GetPointId(k), b->GetCell(i)->GetPointId(k));
    }
  }
}

// Single precision of coordinates up to 162 mm, three of them.
constexpr double SingleMm = 1.8 * 162.0 * 6e-8;

TEST(SurfaceFile, VtpKeepsEveryBitAndArray)
{
  const TemporaryFolder folder;
  const auto body = Body(Precision::Double);
  WriteSurface(folder / "a.vtp", body);
  const auto back = ReadSurface(folder / "a.vtp");
  ASSERT_EQ(back->GetNumberOfPoints(), body->GetNumberOfPoints());
  EXPECT_EQ(LargestPointDifference(body, back), 0.0);
  ExpectSameTriangles(body, back);
  vtkDataArray* distance = back->GetPointData()->GetArray("Distance To Surface");
  ASSERT_NE(distance, nullptr);
  for (vtkIdType i = 0; i < back->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(distance->GetTuple1(i),
              body->GetPointData()->GetArray("Distance To Surface")->GetTuple1(i));
  }
  EXPECT_NE(back->GetPointData()->GetNormals(), nullptr);
}

TEST(SurfaceFile, VtpStatesFrameAndKeepsInput)
{
  const TemporaryFolder folder;
  const auto body = Body(Precision::Single);
  WriteSurface(folder / "a.vtp", body);
  EXPECT_EQ(body->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_NE(ReadSurface(folder / "a.vtp")->GetFieldData()->GetAbstractArray("Frame"), nullptr);
}

TEST(SurfaceFile, PlyAndObjKeepPointsTrianglesAndNormals)
{
  const TemporaryFolder folder;
  for (const char* name : {"a.ply", "a.obj"})
  {
    for (const Precision precision : {Precision::Single, Precision::Double})
    {
      const auto body = Body(precision);
      WriteSurface(folder / name, body);
      const auto back = ReadSurface(folder / name);
      ASSERT_EQ(back->GetNumberOfPoints(), body->GetNumberOfPoints()) << name;
      EXPECT_LE(LargestPointDifference(body, back), precision == Precision::Single ? 0.0 : SingleMm)
          << name;
      ExpectSameTriangles(body, back);
      vtkDataArray* normals = back->GetPointData()->GetNormals();
      ASSERT_NE(normals, nullptr) << name;
      for (vtkIdType i = 0; i < back->GetNumberOfPoints(); ++i)
      {
        const Vector3 before(body->GetPointData()->GetNormals()->GetTuple3(i));
        ASSERT_EQ((before - Vector3(normals->GetTuple3(i))).norm(), 0.0) << name;
      }
    }
  }
}

TEST(SurfaceFile, StlIsClosedAgainAfterReading)
{
  const TemporaryFolder folder;
  const auto body = Body(Precision::Double);
  WriteSurface(folder / "a.stl", body);
  const auto back = ReadSurface(folder / "a.stl");
  EXPECT_EQ(back->GetNumberOfPoints(), body->GetNumberOfPoints());
  EXPECT_EQ(back->GetNumberOfCells(), body->GetNumberOfCells());
  EXPECT_EQ(OpenOrBadEdges(back), 0);
}

TEST(SurfaceFile, SinglePrecisionRefusesWhatItCannotHold)
{
  const TemporaryFolder folder;
  for (const double shift : {0.0, 1e5, 1e9, 1e300})
  {
    TriangleMesh mesh;
    mesh.PointsWorld = {
        {shift, 0, 0}, {shift + 10.0, 0, 0}, {shift, 10, 0}, {shift + 5.0, 5.0, 10.0}};
    mesh.Triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    for (const char* name : {"a.stl", "a.glb", "a.gltf", "a.x3d"})
    {
      if (shift < 1e6)
      {
        EXPECT_NO_THROW(WriteSurface(folder / name, PolyDataOf(mesh))) << shift << name;
      }
      else
      {
        EXPECT_THROW(WriteSurface(folder / name, PolyDataOf(mesh)), InputError) << shift << name;
      }
    }
    EXPECT_NO_THROW(WriteSurface(folder / "a.obj", PolyDataOf(mesh)));
  }
}

TEST(SurfaceFile, StlKeepsVertexOrder)
{
  const TemporaryFolder folder;
  const auto body = Body(Precision::Double);
  WriteSurface(folder / "a.stl", body);
  const auto back = ReadSurface(folder / "a.stl");
  for (vtkIdType i = 0; i < body->GetNumberOfCells(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 before(body->GetPoint(body->GetCell(i)->GetPointId(k)));
      const Vector3 after(back->GetPoint(back->GetCell(i)->GetPointId(k)));
      ASSERT_LE((before - after).norm(), SingleMm);
    }
  }
}

TEST(SurfaceFile, PolygonsAreCutIntoTriangles)
{
  const TemporaryFolder folder;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(1, 1, 0);
  points->InsertNextPoint(0, 1, 0);
  vtkNew<vtkCellArray> faces;
  faces->InsertNextCell({0, 1, 2, 3});
  vtkNew<vtkPolyData> square;
  square->SetPoints(points);
  square->SetPolys(faces);
  WriteSurface(folder / "a.stl", square);
  EXPECT_EQ(ReadSurface(folder / "a.stl")->GetNumberOfCells(), 2);
}

TEST(SurfaceFile, CommentsStateFrameAndUnit)
{
  const TemporaryFolder folder;
  for (const char* name : {"a.ply", "a.obj", "a.stl"})
  {
    WriteSurface(folder / name, Body(Precision::Single));
    const std::string head = ReadAll(folder / name).substr(0, 120);
    EXPECT_NE(head.find("SPACE=LPS, unit mm"), std::string::npos) << name;
    EXPECT_NE(head.rfind("solid", 0), 0u) << name; // would look like a text STL
  }
}

TEST(SurfaceFile, UnwritableSurfaceLeavesNothing)
{
  const TemporaryFolder folder;
  vtkNew<vtkPolyData> empty;
  const auto broken = Body(Precision::Double);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  broken->GetPoints()->SetPoint(5, 0.0, nan, 0.0);
  for (const char* name : {"a.vtp", "a.stl", "a.ply", "a.obj", "a.gltf", "a.glb", "a.x3d"})
  {
    EXPECT_THROW(WriteSurface(folder / name, empty), InputError) << name;
    EXPECT_THROW(WriteSurface(folder / name, broken), InputError) << name;
    const FileSizeLimit limit(512);
    EXPECT_THROW(WriteSurface(folder / name, Body(Precision::Double)), InputError) << name;
  }
  EXPECT_THROW(WriteSurface(folder / "a.txt", Body(Precision::Double)), InputError);
  EXPECT_EQ(folder.EntryCount(), 0u);
}

TEST(SurfaceFile, RejectsMissingEmptyAndForeignFiles)
{
  const TemporaryFolder folder;
  EXPECT_THROW(ReadSurface(folder / "none.vtp"), InputError);
  EXPECT_THROW(ReadSurface(folder.Path()), InputError);
  for (const char* name : {"a.vtp", "a.stl", "a.ply", "a.obj", "a.x3d", "a"})
  {
    WriteAll(folder / name, "");
    EXPECT_THROW(ReadSurface(folder / name), InputError) << name;
    WriteAll(folder / name, "This is a letter, not a surface.\n");
    EXPECT_THROW(ReadSurface(folder / name), InputError) << name;
  }
}

TEST(SurfaceFile, RejectsTruncatedFiles)
{
  const TemporaryFolder folder;
  for (const char* name : {"a.vtp", "a.stl"})
  {
    WriteSurface(folder / name, Body(Precision::Single));
    const std::string bytes = ReadAll(folder / name);
    for (std::size_t part = 1; part < 40; ++part)
    {
      WriteAll(folder / name, bytes.substr(0, bytes.size() * part / 40));
      EXPECT_THROW(ReadSurface(folder / name), InputError) << name << " " << part << "/40";
    }
  }
}

TEST(SurfaceFile, ReadsTextStl)
{
  const TemporaryFolder folder;
  const std::string text = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                           "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n";
  WriteAll(folder / "a.stl", text);
  EXPECT_EQ(ReadSurface(folder / "a.stl")->GetNumberOfCells(), 1);
  WriteAll(folder / "a.stl", text.substr(0, text.size() - 12));
  EXPECT_THROW(ReadSurface(folder / "a.stl"), InputError);
}

TEST(SurfaceFile, TextStlMayBeInUpperCaseWithLongSolidLines)
{
  const TemporaryFolder folder;
  const std::string name(5000, 'x');
  WriteAll(folder / "a.stl",
           "SOLID " + name +
               " facet vertex\r\n  FACET NORMAL 0 0 1\r\n    OUTER LOOP\r\n"
               "VERTEX 0 0 0\r\nVERTEX 1.5E+00 0 0\r\nVERTEX 0 +1 0\r\nENDLOOP\r\n"
               "ENDFACET\r\nENDSOLID " +
               name + "\r\n");
  const auto surface = ReadSurface(folder / "a.stl");
  EXPECT_EQ(surface->GetNumberOfCells(), 1);
  EXPECT_EQ(surface->GetBounds()[1], 1.5);
  EXPECT_EQ(surface->GetBounds()[3], 1.0);
}

TEST(SurfaceFile, RejectsTextStlWithDamagedNumbers)
{
  const TemporaryFolder folder;
  for (const char* number : {"x", "1,5", "1.0.0", "0x1", ""})
  {
    WriteAll(folder / "a.stl", std::string("solid a\nfacet normal 0 0 1\nouter loop\n"
                                           "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 ") +
                                   number + "\nendloop\nendfacet\nendsolid a\n");
    EXPECT_THROW(ReadSurface(folder / "a.stl"), InputError) << number;
  }
}

TEST(SurfaceFile, AcceptsUpperCaseEndings)
{
  EXPECT_TRUE(IsSurfaceFile("a.STL"));
  EXPECT_TRUE(IsSurfaceFile("a.x3d"));
  EXPECT_FALSE(IsSurfaceFile("a.json"));
  EXPECT_FALSE(IsSurfaceFile("a"));
}
} // namespace
} // namespace palpate::surface_file_test
