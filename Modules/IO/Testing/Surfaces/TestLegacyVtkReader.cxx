#include "LegacyVtkReader.h"

#include "AddressSpaceLimit.h"
#include "MessageOf.h"
#include "SurfaceFile.h"
#include "SyntheticSurfaces.h"
#include "TemporaryFolder.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

namespace palpate::legacy_vtk_reader_test
{
namespace
{
using namespace palpate::test;

constexpr rlim_t SomeMemory = rlim_t{1} << 30; // limit for reading a file of some bytes

// A square, a strip of two triangles and a line, with arrays of every kind around them.
vtkSmartPointer<vtkPolyData> Mixed(int precision)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(precision);
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(0.1 * (i & 1), -0.1 * (i >> 1 & 1), 10.0 / 3.0 * (i >> 2));
  }
  surface->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({0, 1, 3, 2});
  polygons->InsertNextCell({0, 1, 5});
  surface->SetPolys(polygons);
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({4, 5, 6, 7});
  surface->SetStrips(strips);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({0, 7});
  surface->SetLines(lines);
  surface->SetVerts(lines);
  vtkNew<vtkStringArray> names;
  names->SetName("names of things");
  names->InsertNextValue("two words");
  names->InsertNextValue(std::string(300, 'x'));
  names->InsertNextValue("");
  surface->GetFieldData()->AddArray(names);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ids");
  ids->SetNumberOfComponents(2);
  ids->SetComponentName(0, "first"); // written as meta-data
  ids->InsertNextTuple2(1, 2);
  surface->GetFieldData()->AddArray(ids);
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("radii");
  radii->SetNumberOfValues(8);
  radii->FillValue(1.0);
  surface->GetPointData()->SetScalars(radii);
  return surface;
}

std::vector<std::vector<vtkIdType>> CellsOf(vtkCellArray* cells)
{
  std::vector<std::vector<vtkIdType>> all;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(cell, count, corners);
    all.emplace_back(corners, corners + count);
  }
  return all;
}

void ExpectEqual(vtkPolyData* read, vtkPolyData* expected)
{
  ASSERT_EQ(read->GetNumberOfPoints(), expected->GetNumberOfPoints());
  EXPECT_EQ(read->GetPoints()->GetDataType(), expected->GetPoints()->GetDataType());
  for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(Vector3(read->GetPoint(i)), Vector3(expected->GetPoint(i)));
  }
  EXPECT_EQ(CellsOf(read->GetPolys()), CellsOf(expected->GetPolys()));
  EXPECT_EQ(CellsOf(read->GetStrips()), CellsOf(expected->GetStrips()));
}

// Three points and two triangles.
std::string TextOf(const std::string& version, const std::string& cells,
                   const std::string& title = "title")
{
  return "# vtk DataFile Version " + version + "\n" + title +
         "\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n" + cells;
}

std::string Refusal(const std::string& bytes)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.vtk", bytes);
  const AddressSpaceLimit limit(SomeMemory);
  return MessageOf([&] { ReadSurface(folder / "a.vtk"); });
}

std::string BinaryOf(const std::string& section)
{
  return "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET POLYDATA\n" + section;
}

TEST(LegacyVtkReader, ReadsWhatVtkWrites)
{
  for (const int version : {42, 51})
  {
    for (const bool isBinary : {false, true})
    {
      // VTK writes all digits of doubles into text, but only those of a float to 1e-6.
      const auto surface = Mixed(isBinary ? VTK_FLOAT : VTK_DOUBLE);
      const std::string bytes = LegacyVtkBytes(surface, version, isBinary);
      SCOPED_TRACE(bytes.substr(0, 200));
      const auto read = SurfaceFromLegacyVtk(bytes, "a.vtk");
      if (isBinary)
      {
        ExpectEqual(read, surface);
      }
      else
      {
        EXPECT_EQ(CellsOf(read->GetPolys()), CellsOf(surface->GetPolys()));
        EXPECT_EQ(CellsOf(read->GetStrips()), CellsOf(surface->GetStrips()));
        EXPECT_NEAR(read->GetPoint(4)[2], 10.0 / 3.0, 1e-5);
      }
    }
  }
}

TEST(LegacyVtkReader, ReadsCellsOfAllVersions)
{
  for (const auto& [version, cells] : std::vector<std::pair<std::string, std::string>>{
           {"2.0", "POLYGONS 1 4\n3 0 1 2\n"},
           {"3.0", "polygons 1 4 3 0 1 2"},
           {"4.2", "METADATA\nINFORMATION 0\n\nPOLYGONS 1 4\n3 0 1 2\n"},
           {"5.1", "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 2\n"}})
  {
    const auto surface = SurfaceFromLegacyVtk(TextOf(version, cells), "a.vtk");
    EXPECT_EQ(CellsOf(surface->GetPolys()), (std::vector<std::vector<vtkIdType>>{{0, 1, 2}}))
        << version;
  }
}

TEST(LegacyVtkReader, AttributesEndGeometry)
{
  const auto surface = SurfaceFromLegacyVtk(
      TextOf("3.0", "POLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nSCALARS a float\nnonsense"), "a.vtk");
  EXPECT_EQ(surface->GetNumberOfPolys(), 1);
  EXPECT_EQ(surface->GetPointData()->GetNumberOfArrays(), 0);
}

TEST(LegacyVtkReader, FollowsSpaceOfTitle)
{
  const TemporaryFolder folder;
  const auto secondPoint = [&](const std::string& title)
  {
    WriteAll(folder / "a.vtk", TextOf("4.2", "POLYGONS 1 4\n3 0 1 2\n", title));
    return Vector3(ReadSurface(folder / "a.vtk")->GetPoint(1));
  };
  EXPECT_EQ(secondPoint("3D Slicer output. SPACE=RAS"), Vector3(-1, 0, 0));
  EXPECT_EQ(secondPoint("3D Slicer output. SPACE=LPS"), Vector3(1, 0, 0));
  EXPECT_EQ(secondPoint("vtk output"), Vector3(1, 0, 0));
}

TEST(LegacyVtkReader, RejectsFilesTruncatedAnywhere)
{
  for (const int version : {42, 51})
  {
    for (const bool isBinary : {false, true})
    {
      const std::string whole = LegacyVtkBytes(Mixed(VTK_DOUBLE), version, isBinary);
      const std::size_t geometry = whole.find("POINT_DATA");
      ASSERT_NE(geometry, std::string::npos);
      // A file may end behind a section; a shorter one is refused or has fewer cells.
      const auto complete = SurfaceFromLegacyVtk(whole, "a.vtk");
      for (std::size_t length = 0; length + 2 < geometry; ++length)
      {
        MessageOf(
            [&]
            {
              const auto read = SurfaceFromLegacyVtk(whole.substr(0, length), "a.vtk");
              EXPECT_LE(read->GetNumberOfCells(), complete->GetNumberOfCells());
              EXPECT_EQ(read->GetNumberOfPoints(), 8);
            });
      }
    }
  }
}

TEST(LegacyVtkReader, RejectsOtherFiles)
{
  EXPECT_TRUE(Contains(Refusal("solid a\n"), "does not start with"));
  EXPECT_TRUE(Contains(Refusal(TextOf("6.0", "")), "does not start with"));
  EXPECT_TRUE(Contains(Refusal("# vtk DataFile Version 3.0\nt\nEBCDIC\n"), "neither ASCII nor"));
  EXPECT_TRUE(Contains(Refusal("# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n"),
                       "its data set is not POLYDATA"));
  EXPECT_TRUE(Contains(Refusal("# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n"),
                       "it has no points"));
  EXPECT_TRUE(Contains(Refusal(TextOf("3.0", "")), "has no triangles"));
}

TEST(LegacyVtkReader, RejectsCountsBeyondFile)
{
  for (const char* count : {"-1", "1.5", "x", "4", "2147483647", "1e300", "18446744073709551615"})
  {
    for (const std::string& bytes :
         {"# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS " + std::string(count) +
              " float\n0 0 0 1 0 0 0 1 0\n",
          BinaryOf("POINTS " + std::string(count) + " float\n" + std::string(36, '\0')),
          TextOf("3.0", "POLYGONS " + std::string(count) + " 4\n3 0 1 2\n"),
          TextOf("3.0", "POLYGONS 1 " + std::string(count) + "0\n3 0 1 2\n"),
          TextOf("3.0", "POLYGONS 1 4\n" + std::string(count) + " 0 1 2\n"),
          TextOf("5.1", "POLYGONS " + std::string(count) +
                            " 3\nOFFSETS int\n0 3\nCONNECTIVITY int\n0 1 2\n"),
          TextOf("5.1", "POLYGONS 2 3\nOFFSETS int\n0 " + std::string(count) +
                            "\nCONNECTIVITY int\n0 1 2\n"),
          TextOf("3.0", "FIELD f 1\na 1 " + std::string(count) + "00 double\n1\n"),
          TextOf("3.0", "FIELD f " + std::string(count) + "\na 1 1 string\nx\n"),
          BinaryOf("FIELD f 1\na 1 " + std::string(count) + " string\n\x1f" + "ff")})
    {
      EXPECT_TRUE(Contains(Refusal(bytes), "is not a readable legacy VTK surface")) << bytes;
    }
  }
}

TEST(LegacyVtkReader, RejectsIndicesOutOfRange)
{
  for (const char* corners : {"0 1 3", "0 1 -1", "0 1 2147483647", "0 1 1e300", "0 1 0.5"})
  {
    EXPECT_TRUE(Contains(Refusal(TextOf("3.0", std::string("POLYGONS 1 4\n3 ") + corners + "\n")),
                         "refers to a point that does not exist"))
        << corners;
  }
}

TEST(LegacyVtkReader, RejectsBrokenCells)
{
  EXPECT_TRUE(
      Contains(Refusal(TextOf("3.0", "POLYGONS 1 3\n2 0 1\n")), "fewer than three corners"));
  EXPECT_TRUE(Contains(Refusal(TextOf("3.0", "TRIANGLE_STRIPS 2 2\n0 0\n")), "fewer than three"));
  EXPECT_TRUE(Contains(Refusal(TextOf("3.0", "POLYGONS 1 5\n3 0 1 2 0\n")), "their stated size"));
  EXPECT_TRUE(Contains(Refusal(TextOf("5.1", "POLYGONS 3 6\nOFFSETS int\n0 6 3\nCONNECTIVITY int\n"
                                             "0 1 2 0 1 2\n")),
                       "their stated size"));
  EXPECT_TRUE(Contains(Refusal(TextOf("5.1", "POLYGONS 1 4\n3 0 1 2\n")), "lack their offsets"));
  EXPECT_TRUE(Contains(Refusal(TextOf("3.0", "POLYGONS 0 0\nPOLYGONS 0 0\n")), "two sections"));
  EXPECT_TRUE(
      Contains(Refusal(TextOf("3.0", "CELLS 1 4\n3 0 1 2\n")), "section that is not known"));
}

TEST(LegacyVtkReader, RejectsPointsThatAreNotFinite)
{
  EXPECT_TRUE(Contains(Refusal(BinaryOf("POINTS 1 float\n" + std::string(12, '\xff'))),
                       "coordinates are not finite"));
  EXPECT_TRUE(Contains(Refusal("# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 1 "
                               "float\n1e60 0 0\n"),
                       "coordinates are not finite"));
  EXPECT_TRUE(Contains(Refusal("# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 1 "
                               "string\na\nb\nc\n"),
                       "are not numbers"));
}

TEST(LegacyVtkReader, ReadsManySectionsInLinearTime)
{
  std::string fields;
  for (int i = 0; i < 200000; ++i)
  {
    fields += "METADATA\n\nFIELD f 0\n";
  }
  EXPECT_EQ(Refusal(TextOf("3.0", fields + "POLYGONS 1 4\n3 0 1 2\n")), "no error");
}
} // namespace
} // namespace palpate::legacy_vtk_reader_test
