#include "MarchingCubes.h"

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
// inside that only share a diagonal are apart, in both cubes of the face. `EdgeCount` where no line
// begins.
std::array<std::size_t, EdgeCount> LinesOfCube(unsigned corners)
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
  return next;
}

bool ShareFace(std::size_t one, std::size_t other)
{
  const auto has = [](const std::array<unsigned, 4>& face, std::size_t edge)
  {
    return std::count(face.begin(), face.end(), CubeEdges[edge][0]) != 0 &&
           std::count(face.begin(), face.end(), CubeEdges[edge][1]) != 0;
  };
  return std::any_of(CubeFaces.begin(), CubeFaces.end(),
                     [&](const std::array<unsigned, 4>& face)
                     { return has(face, one) && has(face, other); });
}

// Turns a loop so that no triangle of the fan from its first edge has a side across a face, where
// the next cube could have the same one. All loops have such a start.
void TurnToFan(std::vector<std::size_t>& loop)
{
  const auto crossesFace = [&loop]
  {
    return std::any_of(loop.begin() + 2, loop.end() - 1,
                       [&loop](std::size_t edge) { return ShareFace(loop.front(), edge); });
  };
  for (std::size_t turn = 0; turn < loop.size() && crossesFace(); ++turn)
  {
    std::rotate(loop.begin(), loop.begin() + 1, loop.end());
  }
}

// The lines form loops around the cube.
CubeTriangles TrianglesOfCube(unsigned corners)
{
  std::array<std::size_t, EdgeCount> next = LinesOfCube(corners);
  CubeTriangles triangles;
  for (std::size_t first = 0; first < EdgeCount; ++first)
  {
    std::vector<std::size_t> loop;
    for (std::size_t edge = first; next[edge] != EdgeCount;)
    {
      loop.push_back(edge);
      edge = std::exchange(next[edge], EdgeCount);
    }
    if (!loop.empty())
    {
      TurnToFan(loop);
    }
    for (std::size_t i = 2; i < loop.size(); ++i)
    {
      triangles.push_back({loop[0], loop[i - 1], loop[i]});
    }
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

// A slice at a time.
class MarchingCubes
{
public:
  MarchingCubes(const SampledGrid& grid, float level)
      : Grid(grid), Level(level), Row(static_cast<std::size_t>(grid.Size[0]) + 2),
        Rows(static_cast<std::size_t>(grid.Size[1]) + 2)
  {
    for (Slice& slice : this->Slices)
    {
      slice.Values.assign(this->Row * this->Rows, grid.Beyond);
      slice.Inside.assign(this->Row * this->Rows, 0);
      for (std::vector<int>& vertices : slice.Vertices)
      {
        vertices.assign(this->Row * this->Rows, 0);
      }
    }
  }

  // False if there are too many points.
  bool Build(IndexedMesh& mesh)
  {
    constexpr std::size_t MostPoints = 1'000'000'000;
    for (int k = -1; k < this->Grid.Size[2] && mesh.Points.size() < MostPoints; ++k)
    {
      std::swap(this->Slices[0], this->Slices[1]);
      this->Read(k + 1);
      this->AddVertices(k, mesh);
      this->AddTriangles(mesh);
    }
    return mesh.Points.size() < MostPoints;
  }

private:
  // Samples, with a border of those beyond, and the vertex behind each along i, j and k.
  struct Slice
  {
    std::vector<float> Values;
    std::vector<std::uint8_t> Inside;
    std::array<std::vector<int>, 3> Vertices;
  };

  void Read(int k)
  {
    Slice& slice = this->Slices[1];
    if (k == this->Grid.Size[2])
    {
      std::fill(slice.Values.begin(), slice.Values.end(), this->Grid.Beyond);
      std::fill(slice.Inside.begin(), slice.Inside.end(), 0);
      return;
    }
    for (int j = 0; j < this->Grid.Size[1]; ++j)
    {
      const std::size_t first = (static_cast<std::size_t>(j) + 1) * this->Row + 1;
      this->Grid.Row(j, k, &slice.Values[first]);
      for (std::size_t at = first; at < first + this->Row - 2; ++at)
      {
        slice.Inside[at] = slice.Values[at] > this->Level ? 1 : 0;
      }
    }
  }

  // The part of the way from one sample to its neighbour at which the surface parts them.
  double Crossing(float from, float to) const
  {
    constexpr double Margin = 1e-3;
    const double part =
        (static_cast<double>(this->Level) - from) / (static_cast<double>(to) - from);
    return std::clamp(part, Margin, 1.0 - Margin);
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
      const Vector3 sample(static_cast<double>(at % this->Row) - 1.0,
                           static_cast<double>(at / this->Row) - 1.0, k + 1.0);
      const float value = high.Values[at];
      const auto add = [&](bool isCrossed, int axis, double step, int& vertex)
      {
        if (isCrossed)
        {
          vertex = static_cast<int>(mesh.Points.size());
          mesh.Points.push_back(sample + step * Vector3::Unit(axis));
        }
      };
      add(isCrossedI, 0, this->Crossing(value, high.Values[at + 1]), high.Vertices[0][at]);
      add(isCrossedJ, 1, this->Crossing(value, high.Values[at + this->Row]), high.Vertices[1][at]);
      add(isCrossedK, 2, -this->Crossing(value, low.Values[at]), low.Vertices[2][at]);
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

  const SampledGrid& Grid;
  float Level;
  std::size_t Row; // samples of a row, with the border
  std::size_t Rows;
  std::array<Slice, 2> Slices; // the lower one first
};
} // namespace

bool MarchCubes(const SampledGrid& grid, float level, IndexedMesh& mesh)
{
  mesh = {};
  return MarchingCubes(grid, level).Build(mesh);
}
} // namespace palpate
