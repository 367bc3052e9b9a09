#include "GltfReader.h"

#include "DataUri.h"
#include "IcosahedronDirections.h"
#include "MeshGltf.h"
#include "MessageOf.h"
#include "SinglePrecision.h"
#include "StoredImages.h"
#include "SurfaceFile.h"
#include "TemporaryFolder.h"

#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace palpate::gltf_reader_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

// Points of a tetrahedron of 10 mm edges, in metres: x left, y up, z front.
const std::vector<float> Points{0, 0, 0, 0.01F, 0, 0, 0, 0.01F, 0, 0, 0, 0.01F};
const std::vector<std::uint32_t> Corners{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

Json Tetrahedron(const std::vector<float>& points = Points,
                 const std::vector<std::uint32_t>& corners = Corners)
{
  const std::string bytes = BytesOf(points) + BytesOf(corners);
  const std::size_t start = 4 * points.size();
  Json file;
  file["asset"]["version"] = "2.0";
  file["scene"] = 0;
  file["scenes"] = {{{"nodes", {0}}}};
  file["nodes"] = {{{"mesh", 0}}};
  file["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}};
  file["accessors"] = {
      {{"bufferView", 0}, {"componentType", 5126}, {"count", points.size() / 3}, {"type", "VEC3"}},
      {{"bufferView", 1}, {"componentType", 5125}, {"count", corners.size()}, {"type", "SCALAR"}}};
  file["bufferViews"] = {
      {{"buffer", 0}, {"byteLength", start}},
      {{"buffer", 0}, {"byteOffset", start}, {"byteLength", 4 * corners.size()}}};
  file["buffers"] = {
      {{"byteLength", bytes.size()}, {"uri", DataUri("application/octet-stream", bytes)}}};
  return file;
}

TriangleMesh MeshOf(const Json& file)
{
  return MeshFromGltf(file.dump(), "a.gltf");
}

// The message for the tetrahedron's file after a change.
std::string Refusal(const std::function<void(Json&)>& change)
{
  Json file = Tetrahedron();
  change(file);
  return MessageOf([&] { MeshOf(file); });
}

TriangleMesh Sphere()
{
  const IcosahedronDirections sphere(5);
  TriangleMesh mesh;
  mesh.Normals = sphere.Directions();
  for (const Vector3& u : sphere.Directions())
  {
    mesh.PointsWorld.push_back(InSinglePrecision(Vector3(10.1, -20.2, 30.3) + 7.0 * u));
    mesh.Colors.push_back({255, 128, 0});
  }
  mesh.Triangles = sphere.Triangles();
  return mesh;
}

TEST(GltfReader, InvertsWriterBitForBit)
{
  const TriangleMesh mesh = Sphere();
  for (const std::string& bytes : {MeshToGltf(mesh), MeshToGlb(mesh)})
  {
    const TriangleMesh back = MeshFromGltf(bytes, "a.glb");
    EXPECT_EQ(back.PointsWorld, mesh.PointsWorld);
    EXPECT_EQ(back.Triangles, mesh.Triangles);
    EXPECT_TRUE(back.SinglePrecision);
  }
}

TEST(GltfReader, MetresYUpBecomeLps)
{
  const TriangleMesh mesh = MeshOf(Tetrahedron());
  ASSERT_EQ(mesh.PointsWorld.size(), 4u);
  EXPECT_EQ(mesh.PointsWorld[1], Vector3(10, 0, 0));
  EXPECT_EQ(mesh.PointsWorld[2], Vector3(0, 0, 10));  // up is superior
  EXPECT_EQ(mesh.PointsWorld[3], Vector3(0, -10, 0)); // the front is anterior
  EXPECT_EQ(mesh.Triangles[1], (std::array<int, 3>{0, 1, 3}));
}

TEST(GltfReader, SurfaceFilesHaveBothEndings)
{
  const TemporaryFolder folder;
  for (const char* name : {"a.gltf", "a.glb"})
  {
    WriteSurface(folder / name, PolyDataOf(Sphere()));
    EXPECT_EQ(ReadSurface(folder / name)->GetNumberOfPoints(), 252);
  }
}

TEST(GltfReader, NodesPlaceTheirMeshes)
{
  Json file = Tetrahedron();
  file["nodes"] = {{{"children", {1, 2}}, {"translation", {0.001, 0.002, 0.003}}},
                   {{"mesh", 0}, {"scale", {2, 2, 2}}},
                   // A quarter turn about y takes x to -z.
                   {{"mesh", 0}, {"rotation", {0, 0.70710678118654752, 0, 0.70710678118654752}}}};
  const TriangleMesh mesh = MeshOf(file);
  // The first point of both is the same.
  ASSERT_EQ(mesh.PointsWorld.size(), 7u);
  ASSERT_EQ(mesh.Triangles.size(), 8u);
  const auto has = [&mesh](const Vector3& wanted)
  {
    return std::any_of(mesh.PointsWorld.begin(), mesh.PointsWorld.end(),
                       [&wanted](const Vector3& p) { return (p - wanted).norm() < 1e-5; });
  };
  EXPECT_TRUE(has({1, -3, 2}));
  EXPECT_TRUE(has({21, -3, 2}));
  EXPECT_TRUE(has({1, 7, 2}));
}

TEST(GltfReader, ReflectionKeepsTrianglesOutward)
{
  Json file = Tetrahedron();
  file["nodes"][0]["scale"] = {-1, 1, 1};
  const TriangleMesh mesh = MeshOf(file);
  EXPECT_EQ(mesh.PointsWorld[1], Vector3(-10, 0, 0));
  EXPECT_EQ(mesh.Triangles[1], (std::array<int, 3>{3, 1, 0}));
}

TEST(GltfReader, MergesEqualPoints)
{
  std::vector<float> points;
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t corner : Corners)
  {
    corners.push_back(static_cast<std::uint32_t>(corners.size()));
    points.insert(points.end(), Points.begin() + 3 * corner, Points.begin() + 3 * corner + 3);
  }
  points[0] = -0.0F;
  corners.insert(corners.end(), {0, 3, 6}); // one point three times
  const TriangleMesh mesh = MeshOf(Tetrahedron(points, corners));
  EXPECT_EQ(mesh.PointsWorld.size(), 4u);
  ASSERT_EQ(mesh.Triangles.size(), 4u);
  EXPECT_EQ(mesh.Triangles[0], (std::array<int, 3>{0, 1, 2}));
  EXPECT_EQ(mesh.Triangles[3], (std::array<int, 3>{2, 1, 3}));
}

TEST(GltfReader, ReadsNarrowIndicesStridesAndNoIndices)
{
  Json file = Tetrahedron();
  const std::vector<unsigned char> narrow(Corners.begin(), Corners.end());
  const std::vector<std::uint16_t> wide(Corners.begin(), Corners.end());
  for (const auto& [type, bytes] : {std::pair<int, std::string>{5121, BytesOf(narrow)},
                                    std::pair<int, std::string>{5123, BytesOf(wide)}})
  {
    file["buffers"][0] = {{"byteLength", 48 + bytes.size()},
                          {"uri", DataUri("a", BytesOf(Points) + bytes)}};
    file["bufferViews"][1]["byteLength"] = bytes.size();
    file["accessors"][1]["componentType"] = type;
    EXPECT_EQ(MeshOf(file).Triangles, MeshOf(Tetrahedron()).Triangles);
  }
  file = Tetrahedron();
  file["bufferViews"][0]["byteStride"] = 12;
  file["accessors"][0]["count"] = 3;
  file["meshes"][0]["primitives"][0].erase("indices");
  EXPECT_EQ(MeshOf(file).Triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}}));
}

TEST(GltfReader, PrimitivesShareTheirPoints)
{
  Json file = Tetrahedron();
  Json& primitives = file["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  const TriangleMesh mesh = MeshOf(file);
  EXPECT_EQ(mesh.PointsWorld.size(), 4u);
  EXPECT_EQ(mesh.Triangles.size(), 8u);
}

TEST(GltfReader, RejectsFilesTruncatedAnywhere)
{
  const std::string text = Tetrahedron().dump();
  for (std::size_t length = 0; length < text.size(); ++length)
  {
    EXPECT_NE(MessageOf([&] { MeshFromGltf(text.substr(0, length), "a.gltf"); }), "no error");
  }
  TriangleMesh mesh;
  mesh.PointsWorld = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.Triangles = {{{0, 1, 2}}};
  const std::string binary = MeshToGlb(mesh);
  for (std::size_t length = 0; length < binary.size(); ++length)
  {
    EXPECT_NE(MessageOf([&] { MeshFromGltf(binary.substr(0, length), "a.glb"); }), "no error");
  }
}

TEST(GltfReader, RejectsSizesBeyondBuffer)
{
  const std::vector<std::function<void(Json&, std::int64_t)>> changes{
      [](Json& f, std::int64_t n) { f["accessors"][0]["count"] = n; },
      [](Json& f, std::int64_t n) { f["accessors"][1]["count"] = n; },
      [](Json& f, std::int64_t n) { f["accessors"][1]["byteOffset"] = n; },
      [](Json& f, std::int64_t n) { f["bufferViews"][0]["byteOffset"] = n; },
      [](Json& f, std::int64_t n) { f["bufferViews"][1]["byteLength"] = n; },
      [](Json& f, std::int64_t n) { f["bufferViews"][1]["byteStride"] = n; },
      [](Json& f, std::int64_t n) { f["buffers"][0]["byteLength"] = n; },
      [](Json& f, std::int64_t n) { f["accessors"][0]["bufferView"] = n; },
      [](Json& f, std::int64_t n) { f["bufferViews"][0]["buffer"] = n; },
      [](Json& f, std::int64_t n) { f["nodes"][0]["mesh"] = n; },
      [](Json& f, std::int64_t n) { f["scenes"][0]["nodes"][0] = n; },
      [](Json& f, std::int64_t n) { f["scene"] = n; },
      [](Json& f, std::int64_t n) { f["meshes"][0]["primitives"][0]["indices"] = n; }};
  for (const auto& change : changes)
  {
    for (const std::int64_t number :
         {std::int64_t{-1}, std::int64_t{97}, (std::int64_t{1} << 32) - 1, std::int64_t{1} << 32,
          std::numeric_limits<std::int64_t>::max()})
    {
      EXPECT_TRUE(Contains(Refusal([&](Json& file) { change(file, number); }),
                           "is not a readable glTF surface"))
          << number;
    }
  }
}

TEST(GltfReader, RejectsNodesThatAreNotTree)
{
  EXPECT_TRUE(Contains(Refusal([](Json& f) { f["nodes"][0]["children"] = {0}; }), "not a tree"));
  EXPECT_TRUE(Contains(Refusal([](Json& f) { f["scenes"][0]["nodes"] = {0, 0}; }), "not a tree"));
  EXPECT_TRUE(Contains(Refusal(
                           [](Json& f) {
                             f["nodes"] = {{{"children", {1}}},
                                           {{"children", {2}}},
                                           {{"children", {1}}, {"mesh", 0}}};
                           }),
                       "not a tree"));
}

TEST(GltfReader, RejectsMeshesPlacedTooOften)
{
  EXPECT_TRUE(Contains(Refusal(
                           [](Json& f)
                           {
                             for (int node = 1; node < 2000; ++node)
                             {
                               f["nodes"].push_back(f["nodes"][0]);
                               f["scenes"][0]["nodes"].push_back(node);
                             }
                             // Many triangles of few bytes.
                             const std::vector<unsigned char> corners(3000, 1);
                             f["buffers"][0] = {
                                 {"byteLength", 3048},
                                 {"uri", DataUri("a", BytesOf(Points) + BytesOf(corners))}};
                             f["bufferViews"][1]["byteLength"] = 3000;
                             f["accessors"][1]["count"] = 3000;
                             f["accessors"][1]["componentType"] = 5121;
                           }),
                       "places the same mesh too often"));
}

TEST(GltfReader, RejectsTransformsThatAreNotAffine)
{
  for (const Json& matrix : {Json({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0}),
                             Json({1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}),
                             Json({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2}),
                             Json({"x", 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}),
                             Json({1e308, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1})})
  {
    EXPECT_TRUE(Contains(Refusal([&](Json& f) { f["nodes"][0]["matrix"] = matrix; }),
                         "is not a readable glTF surface"));
  }
  EXPECT_TRUE(Contains(Refusal(
                           [](Json& f) {
                             f["nodes"][0]["rotation"] = {0, 0, 0, 0};
                           }),
                       "the transform of one of its nodes is invalid"));
}

TEST(GltfReader, RejectsPointsThatAreNotFiniteAndIndicesOutOfRange)
{
  std::vector<float> points = Points;
  points[4] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(Contains(MessageOf([&] { MeshOf(Tetrahedron(points)); }), "are not finite"));
  for (const std::uint32_t corner : {4U, 0x80000000U, 0xffffffffU})
  {
    std::vector<std::uint32_t> corners = Corners;
    corners[7] = corner;
    EXPECT_TRUE(Contains(MessageOf([&] { MeshOf(Tetrahedron(Points, corners)); }),
                         "refers to a point that does not exist"));
  }
}

TEST(GltfReader, RejectsWhatItDoesNotRead)
{
  const auto primitive = [](Json& f) -> Json& { return f["meshes"][0]["primitives"][0]; };
  EXPECT_TRUE(Contains(Refusal([](Json& f) { f["asset"]["version"] = "1.0"; }), "version 2.0"));
  EXPECT_TRUE(
      Contains(Refusal([](Json& f) { f["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }),
               "requires extensions"));
  EXPECT_TRUE(
      Contains(Refusal([](Json& f) { f["buffers"][0]["uri"] = "/dev/zero"; }), "in another file"));
  EXPECT_TRUE(Contains(Refusal([](Json& f) { f["accessors"][0]["sparse"] = Json::object(); }),
                       "a type that is not supported"));
  EXPECT_TRUE(Contains(Refusal([](Json& f) { f["accessors"][0]["componentType"] = 5122; }),
                       "not floating-point"));
  EXPECT_TRUE(Contains(Refusal([](Json& f) { f["accessors"][0]["type"] = 3; }), "of a type that"));
  EXPECT_TRUE(Contains(Refusal([](Json& f) { f["accessors"][0]["count"] = "x"; }), "is invalid"));
  EXPECT_TRUE(Contains(Refusal(
                           [](Json& f) {
                             f["nodes"] = Json::object({{"a", 1}});
                           }),
                       "its nodes"));
  EXPECT_TRUE(Contains(Refusal([](Json& f) { f["buffers"][0]["uri"] = 3; }), "in another file"));
  EXPECT_TRUE(Contains(Refusal([](Json& f) { f["nodes"][0]["skin"] = 0; }), "a skeleton"));
  EXPECT_TRUE(Contains(Refusal([&](Json& f) { primitive(f)["mode"] = 1; }), "points, lines or"));
  EXPECT_TRUE(Contains(Refusal([](Json& f) { f["nodes"][0].erase("mesh"); }), "no triangles"));
  EXPECT_TRUE(Contains(Refusal([](Json& f) { f["accessors"][1]["count"] = 11; }), "not triples"));
}

TEST(GltfReader, MessagesRepeatNoNames)
{
  const std::string message = Refusal(
      [](Json& f)
      {
        f["nodes"][0]["name"] = "Jane Doe";
        f["extensionsRequired"] = {"Jane Doe"};
      });
  EXPECT_EQ(message.find("Jane"), std::string::npos);
}
} // namespace
} // namespace palpate::gltf_reader_test
