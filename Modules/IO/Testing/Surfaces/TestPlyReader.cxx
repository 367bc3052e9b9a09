#include "IcosahedronDirections.h"
#include "InputError.h"
#include "MeshFormats.h"
#include "PlyReader.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace palpate::ply_reader_test
{
namespace
{
TriangleMesh Mesh()
{
  const IcosahedronDirections sphere(3);
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0.0, 30.0);
  TriangleMesh mesh;
  mesh.Triangles = sphere.Triangles();
  mesh.Values = {{"Distance", {}}};
  for (const Vector3& u : sphere.Directions())
  {
    mesh.PointsWorld.push_back(Vector3(noise(random), noise(random), noise(random)));
    // Multiples of 2^-10 are exact in single precision.
    mesh.Normals.push_back((1024.0 * u).array().round() / 1024.0);
    mesh.Colors.push_back({static_cast<unsigned char>(random() % 256), 7, 255});
    mesh.Values[0].Numbers.push_back(noise(random));
  }
  return mesh;
}

std::string RefusalOf(const std::string& bytes)
{
  try
  {
    MeshFromPly(bytes, "folder/name.ply");
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "accepted";
}

const char* const TwoTrianglesAsText = "ply\r\nformat ascii 1.0\ncomment by hand\n"
                                       "element vertex 4\nproperty float x\nproperty float y\n"
                                       "property float z\nproperty uchar quality\n"
                                       "element face 1\nproperty list uchar int vertex_index\n"
                                       "end_header\n"
                                       "0 0 0 1\n1 0 0 2\n1 1.5 0 3\n0 1 -2e-1 4\n4 0 1 2 3\n";

TEST(PlyReader, RoundTripsBitForBit)
{
  const TriangleMesh mesh = Mesh();
  const TriangleMesh back = MeshFromPly(MeshToPly(mesh), "f");
  EXPECT_EQ(back.PointsWorld, mesh.PointsWorld);
  EXPECT_EQ(back.Normals, mesh.Normals);
  EXPECT_EQ(back.Colors, mesh.Colors);
  EXPECT_EQ(back.Triangles, mesh.Triangles);
  EXPECT_FALSE(back.SinglePrecision);
  ASSERT_EQ(back.Values.size(), 1u);
  EXPECT_EQ(back.Values[0].Name, "Distance");
  EXPECT_EQ(back.Values[0].Numbers, mesh.Values[0].Numbers);
}

TEST(PlyReader, ReadsTextWithPolygon)
{
  const TriangleMesh mesh = MeshFromPly(TwoTrianglesAsText, "f");
  ASSERT_EQ(mesh.PointsWorld.size(), 4u);
  EXPECT_EQ(mesh.PointsWorld[2], Vector3(1.0, 1.5, 0.0));
  EXPECT_EQ(mesh.PointsWorld[3], Vector3(0.0, 1.0, -0.2));
  ASSERT_EQ(mesh.Triangles.size(), 2u);
  EXPECT_EQ(mesh.Triangles[0], (std::array<int, 3>{0, 1, 2}));
  EXPECT_EQ(mesh.Triangles[1], (std::array<int, 3>{0, 2, 3}));
  ASSERT_EQ(mesh.Values.size(), 1u);
  EXPECT_EQ(mesh.Values[0].Numbers, (std::vector<double>{1, 2, 3, 4}));
}

TEST(PlyReader, ReadsBigEndianNumbersOfEveryType)
{
  std::string bytes = "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty char x\n"
                      "property ushort y\nproperty int z\nproperty float a\nproperty double b\n"
                      "end_header\n";
  const unsigned char body[] = {0xfe, 0xff, 0x01, 0xff, 0xff, 0xff, 0xfd, 0x3f, 0xc0, 0,
                                0,    0xc0, 0x04, 0,    0,    0,    0,    0,    0};
  bytes.append(reinterpret_cast<const char*>(body), sizeof body);
  const TriangleMesh mesh = MeshFromPly(bytes, "f");
  ASSERT_EQ(mesh.PointsWorld.size(), 1u);
  EXPECT_EQ(mesh.PointsWorld[0], Vector3(-2.0, 65281.0, -3.0));
  ASSERT_EQ(mesh.Values.size(), 2u);
  EXPECT_EQ(mesh.Values[0].Numbers[0], 1.5);
  EXPECT_EQ(mesh.Values[1].Numbers[0], -2.5);
}

TEST(PlyReader, RejectsWrongHeadersAndIndices)
{
  const std::string text = TwoTrianglesAsText;
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"ply", "plx"},
           {"ascii", "morse"},
           {"element vertex 4", "element vertex"},
           {"element vertex 4", "element vertex 5"},
           {"element vertex 4", "element vertex 99999999999999"},
           {"property float x", "property longfloat x"},
           {"element vertex 4\n", ""},
           {"4 0 1 2 3", "4 0 1 2 -1"},
           {"4 0 1 2 3", "4 0 1 2 0.5"},
           {"4 0 1 2 3", "-4 0 1 2 3"},
           {"4 0 1 2 3", "4000000 0 1 2 3"},
           {"1 1.5 0 3", "1 nan 0 3"},
           {"end_header", "end_heade"}})
  {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    const std::string message = RefusalOf(changed);
    EXPECT_NE(message.find("folder/name.ply"), std::string::npos) << to << ": " << message;
  }
}

TEST(PlyReader, RejectsEveryTruncation)
{
  const std::string bytes = MeshToPly(Mesh());
  for (std::size_t length = 0; length < bytes.size(); length += 7)
  {
    ASSERT_NE(RefusalOf(bytes.substr(0, length)), "accepted") << length << " bytes";
  }
}
} // namespace
} // namespace palpate::ply_reader_test
