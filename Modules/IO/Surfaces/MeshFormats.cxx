#include "MeshFormats.h"

#include "DecimalText.h"
#include "LittleEndian.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cstdint>

namespace palpate
{
namespace
{
constexpr const char* FrameComment = "Palpate surface, SPACE=LPS, unit mm";
constexpr std::size_t StlHeaderBytes = 80;

void AppendFloats(std::string& bytes, const Vector3& vector)
{
  for (int k = 0; k < 3; ++k)
  {
    AppendLittleEndian(bytes, static_cast<float>(vector[k]));
  }
}

Vector3 FacetNormal(const TriangleMesh& mesh, const std::array<int, 3>& triangle)
{
  const auto corner = [&](std::size_t k) -> const Vector3&
  { return mesh.PointsWorld[static_cast<std::size_t>(triangle[k])]; };
  const Vector3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
  const double length = normal.norm();
  return length > 0.0 ? Vector3(normal / length) : Vector3::Zero();
}

// PLY separates words by spaces.
std::string AsPlyName(std::string name)
{
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isgraph(c) == 0; }, '_');
  return name;
}

std::string PlyHeader(const TriangleMesh& mesh)
{
  const std::string coordinate = mesh.SinglePrecision ? "property float " : "property double ";
  std::string header = "ply\nformat binary_little_endian 1.0\ncomment ";
  header += FrameComment;
  header += "\nelement vertex " + std::to_string(mesh.PointsWorld.size()) + "\n" + coordinate +
            "x\n" + coordinate + "y\n" + coordinate + "z\n";
  if (!mesh.Normals.empty())
  {
    header += "property float nx\nproperty float ny\nproperty float nz\n";
  }
  if (!mesh.Colors.empty())
  {
    header += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  }
  for (const TriangleMesh::PointValues& values : mesh.Values)
  {
    header += "property double " + AsPlyName(values.Name) + "\n";
  }
  return header + "element face " + std::to_string(mesh.Triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

void AppendPlyVertex(std::string& bytes, const TriangleMesh& mesh, std::size_t i)
{
  if (mesh.SinglePrecision)
  {
    AppendFloats(bytes, mesh.PointsWorld[i]);
  }
  else
  {
    for (int k = 0; k < 3; ++k)
    {
      AppendLittleEndian(bytes, mesh.PointsWorld[i][k]);
    }
  }
  if (!mesh.Normals.empty())
  {
    AppendFloats(bytes, mesh.Normals[i]);
  }
  if (!mesh.Colors.empty())
  {
    for (const unsigned char channel : mesh.Colors[i])
    {
      bytes.push_back(static_cast<char>(channel));
    }
  }
  for (const TriangleMesh::PointValues& values : mesh.Values)
  {
    AppendLittleEndian(bytes, values.Numbers[i]);
  }
}

std::string Words(const Vector3& vector, bool singlePrecision)
{
  std::string text;
  for (int k = 0; k < 3; ++k)
  {
    text += k > 0 ? " " : "";
    text += singlePrecision ? ExactText(static_cast<float>(vector[k])) : ExactText(vector[k]);
  }
  return text;
}

std::string X3dVectors(const std::vector<Vector3>& vectors)
{
  std::string text;
  for (const Vector3& vector : vectors)
  {
    text += (text.empty() ? "" : ", ") + Words(vector, true);
  }
  return text;
}

std::string X3dColors(const std::vector<std::array<unsigned char, 3>>& colors)
{
  std::vector<Vector3> fractions;
  for (const auto& color : colors)
  {
    fractions.push_back(Vector3(color[0], color[1], color[2]) / 255.0);
  }
  return X3dVectors(fractions);
}

std::string X3dIndices(const std::vector<std::array<int, 3>>& triangles)
{
  std::string text;
  for (const auto& triangle : triangles)
  {
    text += (text.empty() ? "" : " ") + std::to_string(triangle[0]) + " " +
            std::to_string(triangle[1]) + " " + std::to_string(triangle[2]) + " -1";
  }
  return text;
}
} // namespace

std::string MeshToStl(const TriangleMesh& mesh)
{
  std::string bytes = FrameComment;
  bytes.resize(StlHeaderBytes, ' ');
  AppendLittleEndian(bytes, static_cast<std::uint32_t>(mesh.Triangles.size()));
  for (const auto& triangle : mesh.Triangles)
  {
    AppendFloats(bytes, FacetNormal(mesh, triangle));
    for (const int corner : triangle)
    {
      AppendFloats(bytes, mesh.PointsWorld[static_cast<std::size_t>(corner)]);
    }
    AppendLittleEndian(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string MeshToPly(const TriangleMesh& mesh)
{
  std::string bytes = PlyHeader(mesh);
  for (std::size_t i = 0; i < mesh.PointsWorld.size(); ++i)
  {
    AppendPlyVertex(bytes, mesh, i);
  }
  for (const auto& triangle : mesh.Triangles)
  {
    bytes.push_back(3);
    for (const int corner : triangle)
    {
      AppendLittleEndian(bytes, static_cast<std::int32_t>(corner));
    }
  }
  return bytes;
}

std::string MeshToObj(const TriangleMesh& mesh)
{
  std::string text = std::string("# ") + FrameComment + "\n";
  for (const Vector3& point : mesh.PointsWorld)
  {
    text += "v " + Words(point, mesh.SinglePrecision) + "\n";
  }
  for (const Vector3& normal : mesh.Normals)
  {
    text += "vn " + Words(normal, true) + "\n";
  }
  for (const auto& triangle : mesh.Triangles)
  {
    text += "f";
    for (const int corner : triangle)
    {
      const std::string number = std::to_string(corner + 1);
      text += " " + number + (mesh.Normals.empty() ? "" : "//" + number);
    }
    text += "\n";
  }
  return text;
}

std::string MeshToX3d(const TriangleMesh& mesh)
{
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                     "<X3D profile=\"Interchange\" version=\"3.0\">\n"
                     "  <head>\n"
                     "    <meta name=\"generator\" content=\"palpate\"/>\n"
                     "    <meta name=\"frame\" content=\"patient LPS\"/>\n"
                     "    <meta name=\"unit\" content=\"mm\"/>\n"
                     "  </head>\n"
                     "  <Scene>\n"
                     "    <Shape>\n"
                     "      <Appearance><Material diffuseColor=\"0.9 0.6 0.4\"/></Appearance>\n"
                     "      <IndexedFaceSet coordIndex=\"";
  text += X3dIndices(mesh.Triangles) + "\">\n";
  if (!mesh.Colors.empty())
  {
    text += "        <Color color=\"" + X3dColors(mesh.Colors) + "\"/>\n";
  }
  text += "        <Coordinate point=\"" + X3dVectors(mesh.PointsWorld) + "\"/>\n";
  if (!mesh.Normals.empty())
  {
    text += "        <Normal vector=\"" + X3dVectors(mesh.Normals) + "\"/>\n";
  }
  return text + "      </IndexedFaceSet>\n    </Shape>\n  </Scene>\n</X3D>\n";
}
} // namespace palpate
