#include "AddressSpaceLimit.h"
#include "MessageOf.h"
#include "SurfaceFile.h"
#include "TemporaryFolder.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

namespace palpate::hostile_surfaces_test
{
namespace
{
using namespace palpate::test;

// Indices and counts of surface files are checked before they are used.
constexpr rlim_t SomeMemory = rlim_t{1} << 30; // limit for reading a file of some bytes

std::string Refusal(const std::string& name, const std::string& bytes)
{
  const TemporaryFolder folder;
  WriteAll(folder / name, bytes);
  const AddressSpaceLimit limit(SomeMemory);
  return MessageOf([&] { ReadSurface(folder / name); });
}

std::string ObjRefusal(const std::string& lines)
{
  return Refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n" + lines);
}

// A file in VTK's XML format; the default is a triangle.
struct VtpSpec
{
  std::string Points = "3";
  std::string Polys = "1";
  std::string PointArray = "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">"
                           "0 0 0 1 0 0 0 1 0</DataArray>";
  std::string Connectivity = "0 1 2";
  std::string Offsets = "3";
  std::string PointData;
  std::string Before; // of the piece
  std::string FileAttributes;
  std::string Appended;
};

std::string VtpText(const VtpSpec& spec)
{
  return "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt32\" " +
         spec.FileAttributes + "><PolyData>" + spec.Before + "<Piece NumberOfPoints=\"" +
         spec.Points + "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" " +
         "NumberOfPolys=\"" + spec.Polys + "\"><PointData>" + spec.PointData +
         "</PointData><Points>" + spec.PointArray + "</Points><Polys>" +
         "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" + spec.Connectivity +
         "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" + spec.Offsets +
         "</DataArray></Polys></Piece></PolyData>" + spec.Appended + "</VTKFile>";
}

std::string VtpRefusal(const VtpSpec& spec)
{
  return Refusal("a.vtp", VtpText(spec));
}

std::string Word(std::uint32_t value)
{
  std::string bytes;
  for (int byte = 0; byte < 4; ++byte)
  {
    bytes += static_cast<char>(value >> (8 * byte) & 255U);
  }
  return bytes;
}

// Points in zlib blocks whose header is this.
VtpSpec WithBlocks(const std::string& header)
{
  VtpSpec spec;
  spec.FileAttributes = "compressor=\"vtkZLibDataCompressor\"";
  spec.PointArray =
      "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/>";
  spec.Appended =
      "<AppendedData encoding=\"raw\">_" + header + std::string(64, '\1') + "</AppendedData>";
  return spec;
}

TEST(HostileSurfaces, RejectsObjIndicesOutOfRange)
{
  for (const char* face : {"f 1 2 5", "f 1 2 0", "f 1 2 -5", "f 1 2 99999999999",
                           "f 1 2 2147483647", "f 1 2 x", "f 1//9999999 2//1 3//1", "f 1/2/-1 2 3"})
  {
    EXPECT_TRUE(Contains(ObjRefusal(std::string(face) + "\n"), "that does not exist")) << face;
  }
  EXPECT_TRUE(Contains(ObjRefusal("f 1 2\n"), "fewer than three vertices"));
  EXPECT_TRUE(
      Contains(ObjRefusal("v 1 nan 2\nf 1 2 3\n"), "three finite numbers were expected in line 5"));
  EXPECT_TRUE(Contains(ObjRefusal("v 1e300 0 0\nf 1 2 5\n"), "three finite numbers were expected"));
  EXPECT_TRUE(Contains(ObjRefusal(""), "has no triangles"));
}

TEST(HostileSurfaces, RejectsPlyIndicesOutOfRange)
{
  for (const char* corners : {"0 1 3", "0 1 2147483647"})
  {
    const std::string bytes =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n3 " +
        std::string(corners) + "\n";
    EXPECT_TRUE(Contains(Refusal("a.ply", bytes), "refers to a point that does not exist"))
        << corners;
  }
}

TEST(HostileSurfaces, ReadsEveryFormOfObjFace)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.obj", "# comment\r\no body\r\nf 1 2 3 4\r\nv 0 0 0\r\nv 1 0 0 1.0\r\n"
                             "v 1 1 0 0.5 0.5 0.5\r\nv 0 1 0\r\nvt 0 0\r\nvn 0 0 1\r\n"
                             "f -4/1/1 -3/1/1 \\\r\n-2/1/1\r\nf 1//1 3//-1 4//1\r\n");
  const auto surface = ReadSurface(folder / "a.obj");
  EXPECT_EQ(surface->GetNumberOfPoints(), 4);
  ASSERT_EQ(surface->GetNumberOfPolys(), 3);
  EXPECT_EQ(surface->GetCell(0)->GetNumberOfPoints(), 4);
  EXPECT_EQ(surface->GetCell(1)->GetPointId(2), 2);
  EXPECT_EQ(surface->GetCell(2)->GetPointId(2), 3);
  EXPECT_EQ(surface->GetPointData()->GetNormals(), nullptr); // the first face has none
}

TEST(HostileSurfaces, ReadsVtpTriangle)
{
  EXPECT_EQ(VtpRefusal({}), "no error");
}

TEST(HostileSurfaces, RejectsVtpIndicesOutOfRange)
{
  for (const char* corners : {"0 1 3", "0 1 -1", "0 1 1000000000000", "0 1 9223372036854775807"})
  {
    VtpSpec spec;
    spec.Connectivity = corners;
    EXPECT_TRUE(Contains(VtpRefusal(spec), "refers to a point that does not exist")) << corners;
  }
}

TEST(HostileSurfaces, RejectsVtpOffsetsOutOfRange)
{
  for (const char* offsets : {"1000000", "4611686018427387904", "-3", "9223372036854775807"})
  {
    VtpSpec spec;
    spec.Offsets = offsets;
    EXPECT_TRUE(Contains(VtpRefusal(spec), "cannot be read as a surface")) << offsets;
  }
  VtpSpec falling;
  falling.Polys = "2";
  falling.Connectivity = "0 1 2 0 1 2";
  falling.Offsets = "6 3";
  EXPECT_TRUE(Contains(VtpRefusal(falling), "more corners than it can hold"));
}

TEST(HostileSurfaces, RejectsVtpCountsThatExceedFile)
{
  for (const char* count : {"2000000000", "4611686018427387904", "-1", "1e300"})
  {
    VtpSpec spec;
    spec.Points = count;
    EXPECT_TRUE(Contains(VtpRefusal(spec), "cannot be read as a surface")) << count;
    spec.Points = "3";
    spec.Polys = count;
    EXPECT_TRUE(Contains(VtpRefusal(spec), "cannot be read as a surface")) << count;
  }
  VtpSpec fields;
  fields.Before = "<FieldData><DataArray type=\"Float64\" Name=\"a\" "
                  "NumberOfTuples=\"4000000000\" format=\"ascii\">1</DataArray></FieldData>";
  EXPECT_TRUE(Contains(VtpRefusal(fields), "more values than it can hold"));
}

TEST(HostileSurfaces, RejectsVtpArraysThatExceedFile)
{
  VtpSpec spec;
  for (const char* components : {"2", "4", "0", "1000000000", "-3"})
  {
    spec.PointArray = std::string("<DataArray type=\"Float32\" NumberOfComponents=\"") +
                      components + "\" format=\"ascii\">0 0 0 1 0 0 0 1 0 1 1 1</DataArray>";
    EXPECT_TRUE(Contains(VtpRefusal(spec), "a.vtp ")) << components;
  }
  spec.PointArray = "<DataArray type=\"String\" format=\"ascii\">0 0 0</DataArray>";
  EXPECT_TRUE(Contains(VtpRefusal(spec), "a.vtp "));
}

TEST(HostileSurfaces, RejectsVtpTextArraysAndDuplicateNames)
{
  VtpSpec spec;
  spec.PointData = "<DataArray type=\"String\" Name=\"a\" format=\"ascii\">1 2 3</DataArray>";
  EXPECT_TRUE(Contains(VtpRefusal(spec), "of a type that is not supported"));
  spec.PointData = "<DataArray type=\"Int8\" Name=\"a\" format=\"ascii\">1 2 3</DataArray>";
  EXPECT_EQ(VtpRefusal(spec), "no error");
  spec.PointData += spec.PointData;
  EXPECT_TRUE(Contains(VtpRefusal(spec), "has a duplicate name"));
}

TEST(HostileSurfaces, RejectsDeeplyNestedVtpElements)
{
  constexpr int Levels = 300000;
  VtpSpec spec;
  for (int level = 0; level < Levels; ++level)
  {
    spec.Before += "<a>";
  }
  for (int level = 0; level < Levels; ++level)
  {
    spec.Before += "</a>";
  }
  EXPECT_TRUE(Contains(VtpRefusal(spec), "nested too deeply"));
}

TEST(HostileSurfaces, RejectsDamagedVtpBlocks)
{
  const std::vector<std::string> headers{
      Word(1) + Word(0) + Word(0) + Word(64),                   // blocks of size 0
      Word(0) + Word(32768) + Word(36),                         // a last block without blocks
      Word(0xFFFFFFFF) + Word(32768) + Word(0),                 // more blocks than bytes
      Word(1) + Word(0xFFFFFFF0) + Word(0) + Word(64),          // gigabytes from 64 bytes
      Word(2) + Word(4) + Word(4000000000) + Word(8) + Word(8), // a last block that is larger
      Word(1) + Word(32768) + Word(36) + Word(0xFFFFFFFF)};     // more than the file has
  for (const std::string& header : headers)
  {
    EXPECT_TRUE(Contains(VtpRefusal(WithBlocks(header)), "its compressed blocks are damaged"));
  }
}

TEST(HostileSurfaces, WritersRejectIndicesOutOfRange)
{
  const TemporaryFolder folder;
  vtkNew<vtkPolyData> surface;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  surface->SetPoints(points);
  vtkNew<vtkCellArray> faces;
  faces->InsertNextCell({0, 1, 2});
  surface->SetPolys(faces);
  for (const char* name : {"a.vtp", "a.stl", "a.ply", "a.obj", "a.gltf", "a.glb", "a.x3d"})
  {
    EXPECT_TRUE(Contains(MessageOf([&] { WriteSurface(folder / name, surface); }),
                         "refers to a point that does not exist"))
        << name;
  }
}

TEST(HostileSurfaces, RejectsStlTextThatVtkTakesForBinary)
{
  // The characters from 80 on are read as a triangle count.
  std::string text = "solid a\nendsolid a\n" + std::string(100, '\xEC');
  EXPECT_TRUE(Contains(Refusal("a.stl", text), "is not a complete STL file"));
  text[19] = '\n';
  EXPECT_TRUE(Contains(Refusal("a.stl", text), "is not a complete STL file"));
  EXPECT_TRUE(Contains(Refusal("a.stl", "solid a\nendsolid a\n" + std::string(100, '\x01')),
                       "is not a complete STL file"));
}

TEST(HostileSurfaces, RejectsDuplicatePlyElements)
{
  const std::string point = "property float x\nproperty float y\nproperty float z\n"
                            "property float q\n";
  EXPECT_TRUE(Contains(Refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\n" + point +
                                            "element vertex 3\n" + point +
                                            "element face 1\nproperty list uchar int "
                                            "vertex_indices\nend_header\n0 0 0 1\n0 0 0 1\n"
                                            "1 0 0 1\n0 1 0 1\n3 0 1 2\n"),
                       "is declared twice"));
}

TEST(HostileSurfaces, RejectsTooManyPlyElements)
{
  std::string header = "ply\nformat ascii 1.0\n";
  for (int element = 0; element < 257; ++element)
  {
    header += "element e" + std::to_string(element) + " 0\n";
  }
  EXPECT_TRUE(Contains(Refusal("a.ply", header + "end_header\n"), "more than 256 elements"));
}
} // namespace
} // namespace palpate::hostile_surfaces_test
