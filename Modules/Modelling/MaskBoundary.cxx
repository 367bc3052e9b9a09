#include "MaskBoundary.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
// The corners of a cube have a bit each for i, j and k. Its edges along i, j and k:
constexpr std::array<std::array<unsigned, 2>, 12> CubeEdges{{{{0, 1}},
                                                             {{2, 3}},
                                                             {{4, 5}},
                                                             {{6, 7}},
                                                             {{0, 2}},
                                                             {{1, 3}},
                                                             {{4, 6}},
                                                             {{5, 7}},
                                                             {{0, 4}},
                                                             {{1, 5}},
                                                             {{2, 6}},
                                                             {{3, 7}}}};
// Its faces, counter-clockwise seen from outside.
constexpr std::array<std::array<unsigned, 4>, 6> CubeFaces{{{{0, 2, 3, 1}},
                                                            {{4, 5, 7, 6}},
                                                            {{0, 1, 5, 4}},
                                                            {{2, 6, 7, 3}},
                                                            {{0, 4, 6, 2}},
                                                            {{1, 3, 7, 5}}}};

constexpr std::size_t EdgeCount = CubeEdges.size();

std::size_t EdgeBetween(unsigned a, unsigned b)
{
  const auto edge = std::find_if(CubeEdges.begin(), CubeEdges.end(),
                                 [a, b](const std::array<unsigned, 2>& one)
                                 { return one[0] == std::min(a, b) && one[1] == std::max(a, b); });
  return static_cast<std::size_t>(edge - CubeEdges.begin());
}

// Triangles of edges.
using CubeTriangles = std::vector<std::array<std::size_t, 3>>;

// On each face, a line from where a run of corners inside begins to where it ends: so corners
// inside that only share a diagonal are apart, in both cubes of the face. The lines form loops
// around the cube.
CubeTriangles TrianglesOfCube(unsigned corners)
{
  std::array<std::size_t, EdgeCount> next{};
  next.fill(EdgeCount);
  const auto isInside = [corners](unsigned corner) { return (corners >> corner & 1U) != 0; };
  for (const std::array<unsigned, 4>& face : CubeFaces)
  {
    for (std::size_t begin = 0; begin < 4; ++begin)
    {
      if (isInside(face[begin]) || !isInside(face[(begin + 1) % 4]))
      {
        continue;
      }
      std::size_t end = begin + 1;
      while (isInside(face[(end + 1) % 4]))
      {
        ++end;
      }
      next[EdgeBetween(face[begin], face[(begin + 1) % 4])] =
          EdgeBetween(face[end % 4], face[(end + 1) % 4]);
    }
  }
  CubeTriangles triangles;
  for (std::size_t first = 0; first < EdgeCount; ++first)
  {
    if (next[first] == EdgeCount)
    {
      continue;
    }
    std::size_t from = std::exchange(next[first], EdgeCount);
    while (next[from] != first)
    {
      const std::size_t to = std::exchange(next[from], EdgeCount);
      triangles.push_back({first, from, to});
      from = to;
    }
    next[from] = EdgeCount;
  }
  return triangles;
}

std::array<CubeTriangles, 256> MakeCubes()
{
  std::array<CubeTriangles, 256> cubes;
  for (unsigned corners = 0; corners < cubes.size(); ++corners)
  {
    cubes[corners] = TrianglesOfCube(corners);
  }
  return cubes;
}

/// Marching cubes (Lorensen and Cline, SIGGRAPH 1987), with faces that fit each other: a vertex
/// half way between each pair of neighbouring voxels of which one is inside. A slice at a time.
class MarchedMask
{
public:
  explicit MarchedMask(const VoxelMask& mask)
      : Mask(mask), Row(static_cast<std::size_t>(mask.Size[0]) + 2),
        Rows(static_cast<std::size_t>(mask.Size[1]) + 2)
  {
    for (Slice& slice : this->Slices)
    {
      slice.Inside.assign(this->Row * this->Rows, 0);
      for (std::vector<int>& vertices : slice.Vertices)
      {
        vertices.assign(this->Row * this->Rows, 0);
      }
    }
  }

  /// In steps of the mask's grid from its box's first voxel. False if there are too many points.
  bool Build(IndexedMesh& mesh)
  {
    constexpr std::size_t MostPoints = 1'000'000'000;
    for (int k = -1; k < this->Mask.Size[2] && mesh.Points.size() < MostPoints; ++k)
    {
      std::swap(this->Slices[0], this->Slices[1]);
      this->Read(k + 1);
      this->AddVertices(k, mesh);
      this->AddTriangles(mesh);
    }
    return mesh.Points.size() < MostPoints;
  }

private:
  // Voxels, with a border of voxels outside, and the vertex behind each along i, j and k.
  struct Slice
  {
    std::vector<std::uint8_t> Inside;
    std::array<std::vector<int>, 3> Vertices;
  };

  // All are outside beyond the last slice.
  void Read(int k)
  {
    for (int j = 0; j < this->Mask.Size[1]; ++j)
    {
      std::uint8_t* to =
          this->Slices[1].Inside.data() + (static_cast<std::size_t>(j) + 1) * this->Row + 1;
      if (k == this->Mask.Size[2])
      {
        std::fill_n(to, this->Mask.Size[0], 0);
        continue;
      }
      const unsigned char* from = this->Mask.Inside.data() + this->Mask.Offset(0, j, k);
      std::transform(from, from + this->Mask.Size[0], to,
                     [](unsigned char inside) { return inside != 0 ? 1 : 0; });
    }
  }

  // Of the upper slice, and between the lower one, k, and it.
  void AddVertices(int k, IndexedMesh& mesh)
  {
    Slice& low = this->Slices[0];
    Slice& high = this->Slices[1];
    for (std::size_t at = 0; at + this->Row < low.Inside.size(); ++at)
    {
      const int here = high.Inside[at];
      const bool isCrossedI = here != high.Inside[at + 1];
      const bool isCrossedJ = here != high.Inside[at + this->Row];
      const bool isCrossedK = here != low.Inside[at];
      if (!isCrossedI && !isCrossedJ && !isCrossedK)
      {
        continue;
      }
      const Vector3 voxel(static_cast<double>(at % this->Row) - 1.0,
                          static_cast<double>(at / this->Row) - 1.0, k + 1.0);
      const auto add = [&](bool isCrossed, const Vector3& step, int& vertex)
      {
        if (isCrossed)
        {
          vertex = static_cast<int>(mesh.Points.size());
          mesh.Points.push_back(voxel + step);
        }
      };
      add(isCrossedI, {0.5, 0.0, 0.0}, high.Vertices[0][at]);
      add(isCrossedJ, {0.0, 0.5, 0.0}, high.Vertices[1][at]);
      add(isCrossedK, {0.0, 0.0, -0.5}, low.Vertices[2][at]);
    }
  }

  unsigned CornersAt(std::size_t at) const
  {
    const std::uint8_t* low = this->Slices[0].Inside.data() + at;
    const std::uint8_t* high = this->Slices[1].Inside.data() + at;
    const std::size_t row = this->Row;
    return low[0] | low[1] << 1U | low[row] << 2U | low[row + 1] << 3U | high[0] << 4U |
           high[1] << 5U | high[row] << 6U | high[row + 1] << 7U;
  }

  int VertexOn(std::size_t edge, std::size_t at) const
  {
    const unsigned corner = CubeEdges[edge][0];
    const std::size_t from = at + (corner & 1U) + ((corner >> 1U & 1U) != 0 ? this->Row : 0);
    return this->Slices[corner >> 2U].Vertices[edge / 4][from];
  }

  void AddTriangles(IndexedMesh& mesh) const
  {
    static const std::array<CubeTriangles, 256> Cubes = MakeCubes();
    for (std::size_t at = 0; at + this->Row + 1 < this->Slices[0].Inside.size(); ++at)
    {
      for (const auto& [a, b, c] : Cubes[this->CornersAt(at)])
      {
        mesh.Triangles.push_back(
            {this->VertexOn(a, at), this->VertexOn(b, at), this->VertexOn(c, at)});
      }
    }
  }

  const VoxelMask& Mask;
  std::size_t Row; // voxels of a row, with the border
  std::size_t Rows;
  std::array<Slice, 2> Slices; // the lower one first
};
} // namespace

Status MakeMaskBoundary(const VoxelMask& mask, const IndexToWorld& toWorld, IndexedMesh& boundary)
{
  if (mask.Count() == 0)
  {
    return Status::Failure("has no voxels");
  }
  IndexedMesh mesh;
  if (!MarchedMask(mask).Build(mesh))
  {
    return Status::Failure("has too many voxels at its boundary");
  }
  const Vector3 start(mask.StartIndex[0], mask.StartIndex[1], mask.StartIndex[2]);
  for (Vector3& point : mesh.Points)
  {
    point = toWorld(start + point);
  }
  if (toWorld.Axes.determinant() < 0.0)
  {
    for (std::array<int, 3>& triangle : mesh.Triangles)
    {
      std::swap(triangle[1], triangle[2]);
    }
  }
  boundary = std::move(mesh);
  return Status::Success();
}
} // namespace palpate
