#include "GiftiReader.h"

#include "MessageOf.h"
#include "SurfaceFile.h"
#include "SyntheticSurfaces.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::gifti_reader_test
{
namespace
{
using namespace palpate::test;

TriangleMesh MeshOf(const GiftiSpec& spec)
{
  return MeshFromGifti(GiftiBytes(spec), "a.gii");
}

std::string Refusal(const std::string& text)
{
  return MessageOf([&] { TrianglesOf(PolyDataOf(MeshFromGifti(text, "a.gii")), "a.gii"); });
}

std::string RefusalWith(const std::string& from, const std::string& to, const GiftiSpec& spec = {})
{
  std::string text = GiftiBytes(spec);
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return Refusal(text.replace(place, from.size(), to));
}

void ExpectTetrahedron(const TriangleMesh& mesh)
{
  ASSERT_EQ(mesh.PointsWorld.size(), 4u);
  ASSERT_EQ(mesh.Triangles.size(), 4u);
  EXPECT_EQ(mesh.PointsWorld[1], Vector3(10, 0, 0));
  EXPECT_EQ(mesh.PointsWorld[3], Vector3(0, 0, 10));
  EXPECT_EQ(mesh.Triangles[1], (std::array<int, 3>{0, 1, 3}));
  EXPECT_TRUE(mesh.SinglePrecision);
}

TEST(GiftiReader, ReadsEveryEncodingByteOrderAndIndexOrder)
{
  for (const char* encoding : {"ASCII", "Base64Binary", "GZipBase64Binary"})
  {
    for (const bool isBigEndian : {false, true})
    {
      for (const bool byColumns : {false, true})
      {
        GiftiSpec spec;
        spec.Encoding = encoding;
        spec.IsBigEndian = isBigEndian;
        spec.ByColumns = byColumns;
        ExpectTetrahedron(MeshOf(spec));
      }
    }
  }
}

TEST(GiftiReader, SurfaceFileIsTurnedFromRasToLps)
{
  const TemporaryFolder folder;
  GiftiSpec spec;
  spec.Points[3] = 7.25F;
  for (const char* name : {"a.gii", "a.surf.gii", "A.SURF.GII"})
  {
    WriteAll(folder / name, GiftiBytes(spec));
    const auto surface = ReadSurface(folder / name);
    EXPECT_EQ(surface->GetPoint(1)[0], -7.25);
    EXPECT_EQ(surface->GetPoint(2)[1], -10.0);
    EXPECT_EQ(surface->GetPoint(3)[2], 10.0);
    EXPECT_EQ(surface->GetNumberOfPolys(), 4);
  }
}

TEST(GiftiReader, OnlyTransformToScannerIsApplied)
{
  GiftiSpec spec;
  spec.Matrix = "0 -2 0 1\n2 0 0 2\n0 0 2 3\n0 0 0 1\n";
  ExpectTetrahedron(MeshOf(spec));
  spec.Space = "NIFTI_XFORM_SCANNER_ANAT";
  const TriangleMesh mesh = MeshOf(spec);
  EXPECT_EQ(mesh.PointsWorld[1], Vector3(1, 22, 3));
  EXPECT_EQ(mesh.PointsWorld[2], Vector3(-19, 2, 3));
  EXPECT_EQ(mesh.Triangles[1], (std::array<int, 3>{0, 1, 3}));
}

TEST(GiftiReader, ReflectionKeepsTrianglesOutward)
{
  GiftiSpec spec;
  spec.Space = "NIFTI_XFORM_SCANNER_ANAT";
  spec.Matrix = "-1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";
  const TriangleMesh mesh = MeshOf(spec);
  EXPECT_EQ(mesh.PointsWorld[1], Vector3(-10, 0, 0));
  EXPECT_EQ(mesh.Triangles[1], (std::array<int, 3>{0, 3, 1}));
}

TEST(GiftiReader, RejectsSingularTransforms)
{
  GiftiSpec spec;
  spec.Space = "NIFTI_XFORM_SCANNER_ANAT";
  for (const char* matrix : {"0 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1",
                             "1 2 3", "nan 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", ""})
  {
    spec.Matrix = matrix;
    EXPECT_TRUE(Contains(Refusal(GiftiBytes(spec)), "is not a readable GIfTI surface")) << matrix;
  }
}

TEST(GiftiReader, RejectsFilesTruncatedAnywhere)
{
  const std::string text = GiftiBytes({});
  for (std::size_t length = 0; length + 2 < text.size(); ++length)
  {
    EXPECT_TRUE(Contains(Refusal(text.substr(0, length)), "is not a readable GIfTI")) << length;
  }
}

TEST(GiftiReader, RejectsStatedSizesThatDiffer)
{
  for (const char* encoding : {"ASCII", "Base64Binary", "GZipBase64Binary"})
  {
    GiftiSpec spec;
    spec.Encoding = encoding;
    for (const char* size : {"3", "5", "2147483647", "99999999999999999999", "0", "-4", "x", ""})
    {
      const std::string message =
          RefusalWith("Dim0=\"4\"", "Dim0=\"" + std::string(size) + "\"", spec);
      EXPECT_TRUE(Contains(message, "is not a readable GIfTI surface")) << encoding << size;
    }
    EXPECT_TRUE(Contains(RefusalWith("Dim1=\"3\"", "Dim1=\"2\"", spec), "are not triples"));
    EXPECT_TRUE(Contains(RefusalWith("Dim1=\"3\"", "Dim2=\"3\"", spec), "are not triples"));
  }
}

TEST(GiftiReader, RejectsCompressionBeyondAnySurface)
{
  GiftiSpec spec;
  spec.Points.assign(300000, 0.0F);
  EXPECT_TRUE(Contains(Refusal(GiftiBytes(spec)), "states more values than it can hold"));
}

TEST(GiftiReader, RejectsDamagedData)
{
  GiftiSpec plain;
  plain.Encoding = "Base64Binary";
  EXPECT_TRUE(Contains(RefusalWith("<Data>A", "<Data>!", plain), "Base64 text is damaged"));
  EXPECT_TRUE(Contains(RefusalWith("<Data>", "<Data>AA", plain), "Base64 text is damaged"));
  EXPECT_TRUE(Contains(RefusalWith("<Data>", "<Data>AAAA", plain), "not as many as it states"));
  EXPECT_TRUE(Contains(RefusalWith("<Data>e", "<Data>f"), "damaged"));
  GiftiSpec text;
  text.Encoding = "ASCII";
  EXPECT_TRUE(Contains(RefusalWith("<Data>0", "<Data>nan", text), "not a number"));
  EXPECT_TRUE(Contains(RefusalWith("<Data>0", "<Data>1e39", text), "too large"));
  EXPECT_TRUE(Contains(RefusalWith("<Data>0", "<Data>0 0", text), "more values than it states"));
  EXPECT_TRUE(Contains(RefusalWith("ASCII", "ExternalFileBinary", text), "not in the file itself"));
}

TEST(GiftiReader, RejectsOtherContent)
{
  EXPECT_TRUE(Contains(RefusalWith("FLOAT32", "INT32"), "not floating-point"));
  EXPECT_TRUE(Contains(RefusalWith("TYPE_INT32", "TYPE_UINT8"), "not 32-bit integers"));
  EXPECT_TRUE(Contains(RefusalWith("INTENT_TRIANGLE", "INTENT_SHAPE"), "has no points and"));
  EXPECT_TRUE(Contains(RefusalWith("INTENT_TRIANGLE", "INTENT_POINTSET"), "more than one array"));
  EXPECT_TRUE(Contains(Refusal("<VTKFile/>"), "has no GIFTI element"));
  EXPECT_TRUE(Contains(RefusalWith("SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\"",
                                   "[<!ENTITY a \"aaaaaaaaaa\">]"),
                       "declares entities"));
}

TEST(GiftiReader, RejectsIndicesAndCoordinatesOutOfRange)
{
  for (const int index : {-1, 4, 2147483647})
  {
    GiftiSpec spec;
    spec.Triangles[5] = index;
    EXPECT_TRUE(Contains(Refusal(GiftiBytes(spec)), "refers to a point that does not exist"));
  }
  GiftiSpec spec;
  spec.Points[4] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(Contains(Refusal(GiftiBytes(spec)), "are not finite"));
}

TEST(GiftiReader, DeepNestingIsSkipped)
{
  std::string nested;
  for (int i = 0; i < 200000; ++i)
  {
    nested += "<a>";
  }
  for (int i = 0; i < 200000; ++i)
  {
    nested += "</a>";
  }
  std::string text = GiftiBytes({});
  ExpectTetrahedron(MeshFromGifti(text.insert(text.find("<LabelTable/>"), nested), "a.gii"));
}

TEST(GiftiReader, IsNotTakenForImage)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.gii", GiftiBytes({}));
  EXPECT_TRUE(Contains(MessageOf([&] { ReadVolume(folder / "a.gii"); }), "is a surface"));
}
} // namespace
} // namespace palpate::gifti_reader_test
