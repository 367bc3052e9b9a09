#include "MessageOf.h"
#include "SurfaceFile.h"
#include "SurfaceSpace.h"
#include "TemporaryFolder.h"
#include "Vector3.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <array>
#include <gtest/gtest.h>
#include <set>

namespace palpate::surface_space_test
{
namespace
{
using namespace palpate::test;

using Points = std::set<std::array<double, 3>>;

const std::vector<Vector3> Corners{{1.5, -2.25, 3.0}, {4.0, 5.5, -6.0}, {-7.0, 8.0, 9.75}};

// A triangle; its normal is not a unit vector, but exact in single precision.
vtkSmartPointer<vtkPolyData> Triangle()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  for (const Vector3& corner : Corners)
  {
    points->InsertNextPoint(corner.data());
    normals->InsertNextTuple3(0.5, -0.25, 1.0);
  }
  vtkNew<vtkCellArray> faces;
  faces->InsertNextCell({0, 1, 2});
  auto triangle = vtkSmartPointer<vtkPolyData>::New();
  triangle->SetPoints(points);
  triangle->SetPolys(faces);
  triangle->GetPointData()->SetNormals(normals);
  return triangle;
}

Points PointsOf(vtkPolyData* surface)
{
  Points points;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* point = surface->GetPoint(i);
    points.insert({point[0], point[1], point[2]});
  }
  return points;
}

// Corners with x and y multiplied.
Points CornersTimes(double sign)
{
  Points points;
  for (const Vector3& corner : Corners)
  {
    points.insert({sign * corner.x(), sign * corner.y(), corner.z()});
  }
  return points;
}

std::string VerticesText(const std::string& start)
{
  std::string text;
  for (const Vector3& corner : Corners)
  {
    text += start + std::to_string(corner.x()) + ' ' + std::to_string(corner.y()) + ' ' +
            std::to_string(corner.z()) + '\n';
  }
  return text;
}

// The triangle's text files with a comment each.
std::vector<std::pair<std::string, std::string>> TextFiles(const std::string& comment)
{
  return {{"a.stl", "solid " + comment + "\nfacet normal 0 0 1\nouter loop\n" +
                        VerticesText("vertex ") + "endloop\nendfacet\nendsolid\n"},
          {"a.ply", "ply\nformat ascii 1.0\ncomment " + comment +
                        "\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                        "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
                        VerticesText("") + "3 0 1 2\n"},
          {"a.obj", "# " + comment + '\n' + VerticesText("v ") + "f 1 2 3\n"}};
}

void ExpectTextFilesAreReadTimes(const std::string& comment, double sign)
{
  const TemporaryFolder folder;
  for (const auto& [name, text] : TextFiles(comment))
  {
    WriteAll(folder / name, text);
    EXPECT_EQ(PointsOf(ReadSurface(folder / name)), CornersTimes(sign)) << name << ": " << comment;
  }
}

// A written file with its stated space exchanged.
void WriteStating(const std::filesystem::path& file, const std::string& space)
{
  WriteSurface(file, Triangle());
  std::string bytes = ReadAll(file);
  const std::size_t at = bytes.find("SPACE=LPS");
  ASSERT_NE(at, std::string::npos) << file;
  WriteAll(file, bytes.replace(at + 6, 3, space));
}

vtkSmartPointer<vtkPolyData> TriangleStating(const std::string& space)
{
  const vtkSmartPointer<vtkPolyData> triangle = Triangle();
  vtkNew<vtkStringArray> array;
  array->SetName("SPACE");
  array->InsertNextValue(space);
  triangle->GetFieldData()->AddArray(array);
  return triangle;
}

TEST(SurfaceSpace, FollowsSpaceStatedInText)
{
  ExpectTextFilesAreReadTimes("3D Slicer output. SPACE=RAS", -1.0);
  ExpectTextFilesAreReadTimes("SPACE=RAS;UNIT=mm", -1.0);
  ExpectTextFilesAreReadTimes("3D Slicer output. SPACE=LPS", 1.0);
}

TEST(SurfaceSpace, DefaultIsLps)
{
  ExpectTextFilesAreReadTimes("made elsewhere", 1.0);
  ExpectTextFilesAreReadTimes("WORKSPACE=RAS", 1.0);
}

TEST(SurfaceSpace, FollowsSpaceStatedInBinaryFiles)
{
  const TemporaryFolder folder;
  for (const char* name : {"a.stl", "a.ply", "a.obj"})
  {
    WriteStating(folder / name, "RAS");
    EXPECT_EQ(PointsOf(ReadSurface(folder / name)), CornersTimes(-1.0)) << name;
    WriteStating(folder / name, "LPS");
    EXPECT_EQ(PointsOf(ReadSurface(folder / name)), CornersTimes(1.0)) << name;
  }
}

TEST(SurfaceSpace, NormalsRotateWithPoints)
{
  const TemporaryFolder folder;
  for (const char* name : {"a.ply", "a.obj"})
  {
    WriteStating(folder / name, "RAS");
    const vtkSmartPointer<vtkPolyData> surface = ReadSurface(folder / name);
    vtkDataArray* normals = surface->GetPointData()->GetNormals();
    ASSERT_NE(normals, nullptr) << name;
    EXPECT_EQ(Vector3(normals->GetTuple3(0)), Vector3(-0.5, 0.25, 1.0)) << name;
  }
}

TEST(SurfaceSpace, FollowsAndRemovesVtpField)
{
  const TemporaryFolder folder;
  WriteSurface(folder / "a.vtp", TriangleStating("RAS"));
  const vtkSmartPointer<vtkPolyData> turned = ReadSurface(folder / "a.vtp");
  EXPECT_EQ(PointsOf(turned), CornersTimes(-1.0));
  EXPECT_EQ(turned->GetFieldData()->GetAbstractArray("SPACE"), nullptr);
  WriteSurface(folder / "b.vtp", turned);
  EXPECT_EQ(PointsOf(ReadSurface(folder / "b.vtp")), CornersTimes(-1.0));
  WriteSurface(folder / "c.vtp", TriangleStating("LPS"));
  EXPECT_EQ(PointsOf(ReadSurface(folder / "c.vtp")), CornersTimes(1.0));
}

TEST(SurfaceSpace, RejectsOtherSpacesByName)
{
  const TemporaryFolder folder;
  for (const char* space : {"LAS", "RASH", "ras"})
  {
    for (const auto& [name, text] : TextFiles(std::string("SPACE=") + space))
    {
      const std::filesystem::path file = folder / name;
      WriteAll(file, text);
      EXPECT_TRUE(Contains(MessageOf([&file] { ReadSurface(file); }),
                           name + " states an unsupported space: \"" + space + '"'));
    }
  }
  WriteSurface(folder / "a.vtp", TriangleStating("LAS"));
  EXPECT_TRUE(Contains(MessageOf([&] { ReadSurface(folder / "a.vtp"); }), "\"LAS\""));
}
} // namespace
} // namespace palpate::surface_space_test
