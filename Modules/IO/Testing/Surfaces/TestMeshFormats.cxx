#include "IcosahedronDirections.h"
#include "MeshFormats.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

#include <gtest/gtest.h>
#include <sstream>

namespace palpate::mesh_formats_test
{
namespace
{
TriangleMesh Mesh(int frequency)
{
  const IcosahedronDirections sphere(frequency);
  TriangleMesh mesh;
  mesh.Normals = sphere.Directions();
  for (const Vector3& u : sphere.Directions())
  {
    mesh.PointsWorld.push_back(Vector3(10.1, -20.2, 30.3) + 7.0 * u);
    mesh.Colors.push_back({255, 128, 0});
  }
  mesh.Triangles = sphere.Triangles();
  return mesh;
}

vtkSmartPointer<vtkXMLDataElement> Parse(const std::string& text)
{
  return vtkSmartPointer<vtkXMLDataElement>::Take(
      vtkXMLUtilities::ReadElementFromString(text.c_str()));
}

std::vector<float> Numbers(vtkXMLDataElement* scope, const char* element, const char* attribute)
{
  std::string text = scope->LookupElementWithName(element)->GetAttribute(attribute);
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream words(text);
  std::vector<float> numbers;
  for (float number = 0.0f; words >> number;)
  {
    numbers.push_back(number);
  }
  EXPECT_TRUE(words.eof());
  return numbers;
}

TEST(MeshFormats, X3dIsXmlWithExactIcosahedronCounts)
{
  const auto root = Parse(MeshToX3d(Mesh(20)));
  ASSERT_NE(root, nullptr);
  EXPECT_STREQ(root->GetName(), "X3D");
  const auto points = Numbers(root, "Coordinate", "point");
  EXPECT_EQ(points.size(), 3u * 4002u);
  EXPECT_EQ(Numbers(root, "Normal", "vector").size(), 3u * 4002u);
  EXPECT_EQ(Numbers(root, "IndexedFaceSet", "coordIndex").size(), 4u * 8000u);
}

TEST(MeshFormats, X3dKeepsSinglePrecisionBits)
{
  const TriangleMesh mesh = Mesh(3);
  const auto points = Numbers(Parse(MeshToX3d(mesh)), "Coordinate", "point");
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    ASSERT_EQ(points[i], static_cast<float>(mesh.PointsWorld[i / 3][static_cast<int>(i % 3)]));
  }
}

TEST(MeshFormats, X3dFacesListAndTerminateIndices)
{
  const TriangleMesh mesh = Mesh(2);
  const auto indices = Numbers(Parse(MeshToX3d(mesh)), "IndexedFaceSet", "coordIndex");
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      ASSERT_EQ(indices[4 * i + k], static_cast<float>(mesh.Triangles[i][k]));
    }
    ASSERT_EQ(indices[4 * i + 3], -1.0f);
  }
}

TEST(MeshFormats, X3dColoursAreFractionsAndOptional)
{
  TriangleMesh mesh = Mesh(1);
  const auto colors = Numbers(Parse(MeshToX3d(mesh)), "Color", "color");
  ASSERT_EQ(colors.size(), 3u * 12u);
  EXPECT_EQ(colors[0], 1.0f);
  EXPECT_EQ(colors[1], 128.0f / 255.0f);
  EXPECT_EQ(colors[2], 0.0f);
  mesh.Colors.clear();
  mesh.Normals.clear();
  const auto plain = Parse(MeshToX3d(mesh));
  EXPECT_EQ(plain->LookupElementWithName("Color"), nullptr);
  EXPECT_EQ(plain->LookupElementWithName("Normal"), nullptr);
}

TEST(MeshFormats, X3dStatesFrameAndUnit)
{
  const std::string text = MeshToX3d(Mesh(1));
  EXPECT_NE(text.find("<meta name=\"frame\" content=\"patient LPS\"/>"), std::string::npos);
  EXPECT_NE(text.find("<meta name=\"unit\" content=\"mm\"/>"), std::string::npos);
}

TEST(MeshFormats, StlHasExactSize)
{
  EXPECT_EQ(MeshToStl(Mesh(20)).size(), 84u + 50u * 8000u);
}

TEST(MeshFormats, StlFacetNormalsPointOut)
{
  const TriangleMesh mesh = Mesh(4);
  const std::string bytes = MeshToStl(mesh);
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    float normal[3];
    std::memcpy(normal, bytes.data() + 84 + 50 * i, sizeof normal);
    const Vector3 outward = mesh.Normals[static_cast<std::size_t>(mesh.Triangles[i][0])];
    // A facet of a sphere of frequency 4 leans by less than 0.2 rad against its corners.
    ASSERT_GT(Vector3(normal[0], normal[1], normal[2]).dot(outward), 0.98);
  }
}

TEST(MeshFormats, PlyKeepsColoursAndPointArrays)
{
  TriangleMesh mesh = Mesh(1);
  mesh.Values = {{"Distance to surface", std::vector<double>(12, 0.1)}};
  const std::string bytes = MeshToPly(mesh);
  const std::size_t end = bytes.find("end_header\n");
  const std::string header = bytes.substr(0, end);
  EXPECT_NE(header.find("property uchar red"), std::string::npos);
  EXPECT_NE(header.find("property double Distance_to_surface"), std::string::npos);
  // 3 doubles, 3 floats, 3 bytes and a double per point; a byte and 3 integers per face.
  EXPECT_EQ(bytes.size() - end - 11, 12u * (24 + 12 + 3 + 8) + 20u * 13);
}
} // namespace
} // namespace palpate::mesh_formats_test
