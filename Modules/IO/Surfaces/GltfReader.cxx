#include "GltfReader.h"

#include "GltfDocument.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace palpate
{
namespace
{
using Json = GltfDocument::Json;

constexpr std::uint64_t Triangles = 4; // of a primitive's mode

/// Collects the triangles of a scene.
class SceneReader
{
public:
  SceneReader(const std::string& bytes, const std::string& fileName)
      : File(bytes, fileName), MostParts(std::min<std::size_t>(bytes.size(), MostIndex))
  {
  }

  TriangleMesh Mesh()
  {
    const Json& scene =
        this->File.Item("scenes", this->File.Whole(this->File.Description(), "scene", 0));
    // From glTF's frame to patient LPS, mm.
    Eigen::Matrix4d toWorld = Eigen::Matrix4d::Zero();
    toWorld(0, 0) = 1000.0;
    toWorld(1, 2) = -1000.0;
    toWorld(2, 1) = 1000.0;
    toWorld(3, 3) = 1.0;
    this->AddNodes(scene, "nodes", toWorld);
    while (!this->Waiting.empty())
    {
      const auto [node, parentToWorld] = this->Waiting.back();
      this->Waiting.pop_back();
      this->AddNode(this->File.Item("nodes", node), parentToWorld);
    }
    if (this->Result.Triangles.empty())
    {
      this->File.Refuse("its scene has no triangles");
    }
    MergeEqualPoints(this->Result);
    return std::move(this->Result);
  }

private:
  struct Range
  {
    std::size_t Start = 0;
    std::size_t Count = 0;
  };
  /// Points of a mesh by their accessor, which its primitives may share.
  using PlacedPoints = std::map<std::uint64_t, Range>;

  static constexpr std::size_t MostIndex = std::numeric_limits<int>::max();

  void AddNodes(const Json& parent, const char* key, const Eigen::Matrix4d& toWorld)
  {
    for (const std::uint64_t node : this->File.Wholes(parent, key))
    {
      this->File.Item("nodes", node);
      this->IsPlaced.resize(std::max<std::size_t>(this->IsPlaced.size(), node + 1), false);
      if (this->IsPlaced[node])
      {
        this->File.Refuse("its nodes are not a tree");
      }
      this->IsPlaced[node] = true;
      this->Waiting.emplace_back(node, toWorld);
    }
  }

  void AddNode(const Json& node, const Eigen::Matrix4d& parentToWorld)
  {
    const Eigen::Matrix4d toWorld = parentToWorld * this->TransformOf(node);
    if (!toWorld.allFinite() || toWorld.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
    {
      this->File.Refuse("the transform of one of its nodes is invalid");
    }
    if (GltfDocument::Find(node, "skin") != nullptr)
    {
      this->File.Refuse("it is placed by a skeleton");
    }
    if (GltfDocument::Find(node, "mesh") != nullptr)
    {
      this->AddMesh(this->File.Item("meshes", this->File.Whole(node, "mesh")), toWorld);
    }
    this->AddNodes(node, "children", toWorld);
  }

  Eigen::Matrix4d TransformOf(const Json& node) const
  {
    const std::vector<double> matrix = this->File.Numbers(node, "matrix", 16);
    if (!matrix.empty())
    {
      return Eigen::Map<const Eigen::Matrix4d>(matrix.data());
    }
    const std::vector<double> shift = this->File.Numbers(node, "translation", 3);
    const std::vector<double> turn = this->File.Numbers(node, "rotation", 4);
    const std::vector<double> scale = this->File.Numbers(node, "scale", 3);
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    if (!shift.empty())
    {
      transform.translate(Vector3(shift[0], shift[1], shift[2]));
    }
    if (!turn.empty())
    {
      // Not finite if it is zero.
      const Eigen::Vector4d xyzw(turn[0], turn[1], turn[2], turn[3]);
      transform.rotate(Eigen::Quaterniond(Eigen::Vector4d(xyzw / xyzw.norm())));
    }
    if (!scale.empty())
    {
      transform.scale(Vector3(scale[0], scale[1], scale[2]));
    }
    return transform.matrix();
  }

  void AddMesh(const Json& mesh, const Eigen::Matrix4d& toWorld)
  {
    const Json* const primitives = GltfDocument::Find(mesh, "primitives");
    if (primitives == nullptr || !primitives->is_array())
    {
      this->File.Refuse("one of its meshes is invalid");
    }
    PlacedPoints placed;
    for (const Json& primitive : *primitives)
    {
      this->AddPrimitive(primitive, toWorld, placed);
    }
  }

  void AddPrimitive(const Json& primitive, const Eigen::Matrix4d& toWorld, PlacedPoints& placed)
  {
    const Json* const attributes = GltfDocument::Find(primitive, "attributes");
    if (attributes == nullptr || this->File.Whole(primitive, "mode", Triangles) != Triangles)
    {
      this->File.Refuse("it has points, lines or strips beside triangles");
    }
    const std::uint64_t accessor = this->File.Whole(*attributes, "POSITION");
    if (placed.count(accessor) == 0)
    {
      const std::size_t start = this->Result.PointsWorld.size();
      this->AddPoints(this->File.Positions(accessor), toWorld);
      placed[accessor] = {start, this->Result.PointsWorld.size() - start};
    }
    this->AddTriangles(this->CornersOf(primitive, placed[accessor].Count), placed[accessor],
                       toWorld.topLeftCorner<3, 3>().determinant() < 0.0);
  }

  std::vector<std::uint32_t> CornersOf(const Json& primitive, std::size_t points) const
  {
    if (GltfDocument::Find(primitive, "indices") != nullptr)
    {
      return this->File.Indices(this->File.Whole(primitive, "indices"));
    }
    std::vector<std::uint32_t> corners(points);
    std::iota(corners.begin(), corners.end(), 0U);
    return corners;
  }

  void AddPoints(const std::vector<Vector3>& points, const Eigen::Matrix4d& toWorld)
  {
    this->Count(points.size());
    for (const Vector3& point : points)
    {
      // In the precision of the file, so that metres become the writer's mm again. The addition
      // removes the sign of zeros; without it, GCC 12 leaves out the conversions at -O3.
      const Vector3 world = toWorld.topRows<3>() * point.homogeneous();
      this->Result.PointsWorld.emplace_back(
          (world.cast<float>().array() + 0.0F).matrix().cast<double>());
      if (!this->Result.PointsWorld.back().allFinite())
      {
        this->File.Refuse("it has a point whose coordinates are not finite");
      }
    }
  }

  // A reflection would turn the surface inside out.
  void AddTriangles(const std::vector<std::uint32_t>& corners, const Range& points,
                    bool isReflected)
  {
    this->Count(corners.size() / 3);
    if (corners.size() % 3 != 0)
    {
      this->File.Refuse("its triangles are not triples");
    }
    for (std::size_t i = 0; i < corners.size(); i += 3)
    {
      std::array<int, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::uint32_t corner = corners[i + (isReflected ? 2 - k : k)];
        if (corner >= points.Count)
        {
          this->File.Refuse("a triangle refers to a point that does not exist");
        }
        triangle[k] = static_cast<int>(points.Start + corner);
      }
      this->Result.Triangles.push_back(triangle);
    }
  }

  void Count(std::size_t more)
  {
    this->Parts += more;
    if (this->Parts > this->MostParts)
    {
      this->File.Refuse("it places the same mesh too often");
    }
  }

  GltfDocument File;
  std::size_t MostParts; // points and triangles
  std::size_t Parts = 0;
  TriangleMesh Result;
  std::vector<std::pair<std::uint64_t, Eigen::Matrix4d>> Waiting;
  std::vector<bool> IsPlaced;
};
} // namespace

TriangleMesh MeshFromGltf(const std::string& bytes, const std::string& fileName)
{
  TriangleMesh mesh = SceneReader(bytes, fileName).Mesh();
  mesh.SinglePrecision = true;
  return mesh;
}
} // namespace palpate
