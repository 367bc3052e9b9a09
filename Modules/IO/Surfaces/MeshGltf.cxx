#include "MeshGltf.h"

#include "DataUri.h"
#include "LittleEndian.h"

#include <cstdint>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
using OrderedJson = nlohmann::ordered_json;

// glTF's codes of component types, targets and the chunks of a .glb file.
constexpr int PointComponent = 5126;
constexpr int ColorComponent = 5121;
constexpr int IndexComponent = 5125;
constexpr int ArrayBuffer = 34962;
constexpr int ElementArrayBuffer = 34963;
constexpr std::uint32_t GlbMagic = 0x46546c67;
constexpr std::uint32_t GlbVersion = 2;
constexpr std::uint32_t GlbJsonChunk = 0x4e4f534a;
constexpr std::uint32_t GlbBinaryChunk = 0x004e4942;
constexpr std::size_t GlbHeaderBytes = 12;

/// The JSON description and the binary buffer that it refers to.
struct GltfFile
{
  OrderedJson Description;
  std::string Buffer;

  /// Adds a view and an accessor for what was appended since `start`; returns the accessor.
  std::size_t AddAccessor(std::size_t start, int target, OrderedJson accessor)
  {
    OrderedJson& views = this->Description["bufferViews"];
    accessor["bufferView"] = views.size();
    views.push_back({{"buffer", 0},
                     {"byteOffset", start},
                     {"byteLength", this->Buffer.size() - start},
                     {"target", target}});
    this->Description["accessors"].push_back(std::move(accessor));
    return this->Description["accessors"].size() - 1;
  }

  void Append(const std::vector<Vector3>& vectors)
  {
    for (const Vector3& vector : vectors)
    {
      for (int k = 0; k < 3; ++k)
      {
        AppendLittleEndian(this->Buffer, static_cast<float>(vector[k]));
      }
    }
  }
};

std::size_t AddPositions(const TriangleMesh& mesh, GltfFile& file)
{
  // The bounds must be those of the single-precision numbers that are stored.
  Eigen::Vector3f low = mesh.PointsWorld.front().cast<float>();
  Eigen::Vector3f high = low;
  for (const Vector3& point : mesh.PointsWorld)
  {
    low = low.cwiseMin(point.cast<float>());
    high = high.cwiseMax(point.cast<float>());
  }
  const std::size_t start = file.Buffer.size();
  file.Append(mesh.PointsWorld);
  return file.AddAccessor(start, ArrayBuffer,
                          {{"componentType", PointComponent},
                           {"count", mesh.PointsWorld.size()},
                           {"type", "VEC3"},
                           {"min", {low.x(), low.y(), low.z()}},
                           {"max", {high.x(), high.y(), high.z()}}});
}

std::size_t AddNormals(const TriangleMesh& mesh, GltfFile& file)
{
  const std::size_t start = file.Buffer.size();
  file.Append(mesh.Normals);
  return file.AddAccessor(
      start, ArrayBuffer,
      {{"componentType", PointComponent}, {"count", mesh.Normals.size()}, {"type", "VEC3"}});
}

std::size_t AddColors(const TriangleMesh& mesh, GltfFile& file)
{
  const std::size_t start = file.Buffer.size();
  for (const auto& color : mesh.Colors)
  {
    for (const unsigned char channel : color)
    {
      file.Buffer.push_back(static_cast<char>(channel));
    }
    // Opaque; four bytes, since attributes must start at multiples of four.
    file.Buffer.push_back('\xff');
  }
  return file.AddAccessor(start, ArrayBuffer,
                          {{"componentType", ColorComponent},
                           {"normalized", true},
                           {"count", mesh.Colors.size()},
                           {"type", "VEC4"}});
}

std::size_t AddIndices(const TriangleMesh& mesh, GltfFile& file)
{
  const std::size_t start = file.Buffer.size();
  for (const auto& triangle : mesh.Triangles)
  {
    for (const int corner : triangle)
    {
      AppendLittleEndian(file.Buffer, static_cast<std::uint32_t>(corner));
    }
  }
  return file.AddAccessor(start, ElementArrayBuffer,
                          {{"componentType", IndexComponent},
                           {"count", 3 * mesh.Triangles.size()},
                           {"type", "SCALAR"}});
}

GltfFile Describe(const TriangleMesh& mesh)
{
  GltfFile file;
  file.Description["asset"] = {{"version", "2.0"}, {"generator", "palpate"}};
  file.Description["scene"] = 0;
  file.Description["scenes"] = {{{"nodes", {0}}}};
  // Column by column: left stays x, superior becomes y, posterior becomes -z; mm become metres.
  const std::array<double, 16> matrix{
      {1e-3, 0.0, 0.0, 0.0, 0.0, 0.0, -1e-3, 0.0, 0.0, 1e-3, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}};
  file.Description["nodes"] = {
      {{"name", "surface, patient LPS, mm"}, {"mesh", 0}, {"matrix", matrix}}};
  OrderedJson primitive;
  primitive["attributes"]["POSITION"] = AddPositions(mesh, file);
  if (!mesh.Normals.empty())
  {
    primitive["attributes"]["NORMAL"] = AddNormals(mesh, file);
  }
  if (!mesh.Colors.empty())
  {
    primitive["attributes"]["COLOR_0"] = AddColors(mesh, file);
  }
  primitive["indices"] = AddIndices(mesh, file);
  primitive["material"] = 0;
  file.Description["meshes"] = {{{"primitives", {primitive}}}};
  const OrderedJson white{1.0, 1.0, 1.0, 1.0};
  const OrderedJson flesh{0.9, 0.6, 0.4, 1.0};
  file.Description["materials"] = {{{"pbrMetallicRoughness",
                                     {{"baseColorFactor", mesh.Colors.empty() ? flesh : white},
                                      {"metallicFactor", 0.0},
                                      {"roughnessFactor", 0.7}}}}};
  file.Description["buffers"] = {{{"byteLength", file.Buffer.size()}}};
  return file;
}

void AppendChunk(std::string& bytes, std::uint32_t type, std::string content, char filler)
{
  content.resize((content.size() + 3) / 4 * 4, filler);
  AppendLittleEndian(bytes, static_cast<std::uint32_t>(content.size()));
  AppendLittleEndian(bytes, type);
  bytes += content;
}
} // namespace

std::string MeshToGltf(const TriangleMesh& mesh)
{
  GltfFile file = Describe(mesh);
  file.Description["buffers"][0]["uri"] = DataUri("application/octet-stream", file.Buffer);
  return file.Description.dump(1) + "\n";
}

std::string MeshToGlb(const TriangleMesh& mesh)
{
  const GltfFile file = Describe(mesh);
  std::string chunks;
  AppendChunk(chunks, GlbJsonChunk, file.Description.dump(), ' ');
  AppendChunk(chunks, GlbBinaryChunk, file.Buffer, '\0');
  std::string bytes;
  AppendLittleEndian(bytes, GlbMagic);
  AppendLittleEndian(bytes, GlbVersion);
  AppendLittleEndian(bytes, static_cast<std::uint32_t>(GlbHeaderBytes + chunks.size()));
  return bytes + chunks;
}
} // namespace palpate
