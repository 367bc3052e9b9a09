#include "IcosahedronDirections.h"
#include "MeshGltf.h"

#include <cstring>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::mesh_gltf_test
{
namespace
{
using Json = nlohmann::json;

TriangleMesh Mesh()
{
  const IcosahedronDirections sphere(5);
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

std::uint32_t WordAt(const std::string& bytes, std::size_t at)
{
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

// The two parts of a .glb file.
struct Glb
{
  explicit Glb(const std::string& bytes)
  {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(WordAt(bytes, 4), 2u);
    EXPECT_EQ(WordAt(bytes, 8), bytes.size());
    const std::size_t textBytes = WordAt(bytes, 12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    this->Description = Json::parse(bytes.substr(20, textBytes));
    EXPECT_EQ(textBytes % 4, 0u);
    const std::size_t bufferBytes = WordAt(bytes, 20 + textBytes);
    EXPECT_EQ(bytes.substr(24 + textBytes, 4), std::string("BIN\0", 4));
    this->Buffer = bytes.substr(28 + textBytes);
    EXPECT_EQ(this->Buffer.size(), bufferBytes);
  }

  const char* Data(std::size_t accessor) const
  {
    const Json& view =
        this->Description["bufferViews"][this->Description["accessors"][accessor]["bufferView"]
                                             .get<std::size_t>()];
    return this->Buffer.data() + view["byteOffset"].get<std::size_t>();
  }
  std::size_t Attribute(const char* name) const
  {
    return this->Description["meshes"][0]["primitives"][0]["attributes"][name].get<std::size_t>();
  }

  Json Description;
  std::string Buffer;
};

std::string FromBase64(const std::string& text)
{
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('=')))
  {
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes.push_back(static_cast<char>(bits >> count & 255));
    }
  }
  return bytes;
}

TEST(MeshGltf, RoundTripsPositionsAndIndices)
{
  const TriangleMesh mesh = Mesh();
  const Glb file(MeshToGlb(mesh));
  const char* positions = file.Data(file.Attribute("POSITION"));
  for (std::size_t i = 0; i < mesh.PointsWorld.size(); ++i)
  {
    float point[3];
    std::memcpy(point, positions + 12 * i, sizeof point);
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_EQ(point[k], static_cast<float>(mesh.PointsWorld[i][k]));
    }
  }
  const Json& primitive = file.Description["meshes"][0]["primitives"][0];
  const char* indices = file.Data(primitive["indices"].get<std::size_t>());
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    std::uint32_t corners[3];
    std::memcpy(corners, indices + 12 * i, sizeof corners);
    for (std::size_t k = 0; k < 3; ++k)
    {
      ASSERT_EQ(corners[k], static_cast<std::uint32_t>(mesh.Triangles[i][k]));
    }
  }
}

TEST(MeshGltf, ViewsFillBufferInWholeWords)
{
  const Glb file(MeshToGlb(Mesh()));
  std::size_t end = 0;
  for (const Json& view : file.Description["bufferViews"])
  {
    EXPECT_EQ(view["byteOffset"].get<std::size_t>(), end);
    EXPECT_EQ(end % 4, 0u);
    end += view["byteLength"].get<std::size_t>();
  }
  EXPECT_EQ(file.Description["buffers"][0]["byteLength"].get<std::size_t>(), end);
  EXPECT_EQ(file.Buffer.size(), end);
}

TEST(MeshGltf, CountsMatchMesh)
{
  const TriangleMesh mesh = Mesh();
  const Glb file(MeshToGlb(mesh));
  const Json& accessors = file.Description["accessors"];
  for (const char* name : {"POSITION", "NORMAL", "COLOR_0"})
  {
    EXPECT_EQ(accessors[file.Attribute(name)]["count"].get<std::size_t>(), mesh.PointsWorld.size())
        << name;
  }
  const Json& primitive = file.Description["meshes"][0]["primitives"][0];
  EXPECT_EQ(accessors[primitive["indices"].get<std::size_t>()]["count"].get<std::size_t>(),
            3 * mesh.Triangles.size());
}

TEST(MeshGltf, BoundsAreTight)
{
  const TriangleMesh mesh = Mesh();
  const Glb file(MeshToGlb(mesh));
  const Json& accessor = file.Description["accessors"][file.Attribute("POSITION")];
  for (int k = 0; k < 3; ++k)
  {
    float low = static_cast<float>(mesh.PointsWorld[0][k]);
    float high = low;
    for (const Vector3& point : mesh.PointsWorld)
    {
      low = std::min(low, static_cast<float>(point[k]));
      high = std::max(high, static_cast<float>(point[k]));
    }
    EXPECT_EQ(accessor["min"][static_cast<std::size_t>(k)].get<float>(), low);
    EXPECT_EQ(accessor["max"][static_cast<std::size_t>(k)].get<float>(), high);
  }
}

TEST(MeshGltf, NodeMatrixConvertsToUprightMetres)
{
  const Glb file(MeshToGlb(Mesh()));
  ASSERT_EQ(file.Description["scenes"][0]["nodes"], Json::array({0}));
  const Json& matrix = file.Description["nodes"][0]["matrix"];
  ASSERT_EQ(matrix.size(), 16u);
  const auto column = [&](std::size_t k)
  {
    return Vector3(matrix[4 * k].get<double>(), matrix[4 * k + 1].get<double>(),
                   matrix[4 * k + 2].get<double>());
  };
  EXPECT_EQ(column(0), Vector3(0.001, 0.0, 0.0));  // left stays left
  EXPECT_EQ(column(1), Vector3(0.0, 0.0, -0.001)); // posterior is backwards
  EXPECT_EQ(column(2), Vector3(0.0, 0.001, 0.0));  // superior is up
}

TEST(MeshGltf, TextFormHasSameBuffer)
{
  const Json text = Json::parse(MeshToGltf(Mesh()));
  const std::string uri = text["buffers"][0]["uri"].get<std::string>();
  const std::string prefix = "data:application/octet-stream;base64,";
  ASSERT_EQ(uri.rfind(prefix, 0), 0u);
  EXPECT_EQ(FromBase64(uri.substr(prefix.size())), Glb(MeshToGlb(Mesh())).Buffer);
}

TEST(MeshGltf, OmitsAbsentNormalsAndColours)
{
  TriangleMesh mesh = Mesh();
  mesh.Normals.clear();
  mesh.Colors.clear();
  const Glb file(MeshToGlb(mesh));
  EXPECT_EQ(file.Description["meshes"][0]["primitives"][0]["attributes"].size(), 1u);
}
} // namespace
} // namespace palpate::mesh_gltf_test
