#include "MarchingTetrahedra.h"

#include "KuhnNeighborhood.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace palpate
{
namespace
{
constexpr double LeastPart = 0.01; // of an edge between a vertex and the edge's ends

// Corners of a cube: bit 0 is i, 1 is j, 2 is k. The tetrahedra of a cube, with positive volume.
using Corners = std::array<unsigned, 4>;
constexpr std::array<Corners, 6> Tetrahedra{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

// A triangle's vertices as edges between two corners of a tetrahedron.
using EdgeTriangle = std::array<std::array<std::size_t, 2>, 3>;
struct TetrahedronCase
{
  int Count = 0;
  std::array<EdgeTriangle, 2> Triangles{};
};

// The triangles for each set of corners inside, bit n for corner n.
std::array<TetrahedronCase, 16> MakeCases()
{
  std::array<TetrahedronCase, 16> cases{};
  // Corner n and the others, in an order of positive volume.
  constexpr std::array<std::array<std::size_t, 4>, 4> around{
      {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 0, 1, 3}, {3, 0, 2, 1}}};
  for (const auto& [n, a, b, c] : around)
  {
    cases[1u << n] = {1, {{{{{n, a}, {n, b}, {n, c}}}}}};
    cases[15u & ~(1u << n)] = {1, {{{{{n, a}, {n, c}, {n, b}}}}}};
  }
  // Corners a and b inside, c and d outside, in an order of positive volume.
  constexpr std::array<std::array<std::size_t, 4>, 6> pairs{
      {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {3, 1, 0, 2}, {2, 3, 0, 1}}};
  for (const auto& [a, b, c, d] : pairs)
  {
    cases[1u << a | 1u << b] = {2, {{{{{a, c}, {b, d}, {b, c}}}, {{{a, c}, {a, d}, {b, d}}}}}};
  }
  return cases;
}

// Two slices of nodes with the vertices on their edges.
class EdgeVertices
{
public:
  EdgeVertices(const ShapeField& field, std::vector<Vector3>& points)
      : Field(&field), Points(&points), Steps(OffsetsOf(field.Grid)),
        SliceNodes(field.Grid.Offset(0, 0, 1))
  {
    for (std::size_t parity = 0; parity < 2; ++parity)
    {
      this->First[parity].resize(this->SliceNodes);
      this->Crossed[parity].resize(this->SliceNodes);
    }
  }

  // The cube of each node of slice k: its corners inside, as bits.
  void Add(int k, const std::vector<std::uint8_t>& cubes)
  {
    const auto parity = static_cast<std::size_t>(k & 1);
    for (std::size_t at = 0; at < this->SliceNodes; ++at)
    {
      const std::uint8_t corners = cubes[at];
      this->Crossed[parity][at] = 0;
      if (corners != 0 && corners != 255)
      {
        this->AddEdges(at, k, corners);
      }
    }
  }

  // The vertex between corners a and b (a set of bits within b) of the cube at a node of slice k.
  int Find(std::size_t at, int k, unsigned a, unsigned b) const
  {
    const std::size_t node = at + this->InSlice(a);
    const auto parity = static_cast<std::size_t>((k + static_cast<int>(a >> 2)) & 1);
    const unsigned edge = (b ^ a) - 1;
    const unsigned before = this->Crossed[parity][node] & ((1u << edge) - 1);
    return this->First[parity][node] + static_cast<int>(this->BitCount(before));
  }

private:
  std::size_t InSlice(unsigned corner) const
  {
    return (corner & 1) + (corner >> 1 & 1) * static_cast<std::size_t>(this->Field->Grid.Size[0]);
  }

  static unsigned BitCount(unsigned bits)
  {
    bits = bits - (bits >> 1 & 0x55u);
    bits = (bits & 0x33u) + (bits >> 2 & 0x33u);
    return (bits + (bits >> 4)) & 0xfu;
  }

  // The edges from a node to the other corners of its cube that are on the other side.
  void AddEdges(std::size_t at, int k, unsigned corners)
  {
    const auto parity = static_cast<std::size_t>(k & 1);
    const unsigned others = (corners & 1) != 0 ? ~corners & 255u : corners;
    this->First[parity][at] = static_cast<int>(this->Points->size());
    this->Crossed[parity][at] = static_cast<std::uint8_t>(others >> 1);
    const auto row = static_cast<std::size_t>(this->Field->Grid.Size[0]);
    const std::array<int, 3> index{static_cast<int>(at % row), static_cast<int>(at / row), k};
    const std::size_t node = this->SliceNodes * static_cast<std::size_t>(k) + at;
    for (std::size_t edge = 0; edge < 7; ++edge)
    {
      if ((others >> (edge + 1) & 1) != 0)
      {
        this->AddVertex(node, index, edge);
      }
    }
  }

  void AddVertex(std::size_t node, const std::array<int, 3>& index, std::size_t edge)
  {
    const float* value = &this->Field->Values[node];
    const double from = value[0];
    const double to = value[this->Steps[edge]];
    const double part = std::clamp(from / (from - to), LeastPart, 1.0 - LeastPart);
    const double length = part * this->Field->Grid.Spacing;
    const std::array<int, 3> step = KuhnStep(static_cast<int>(edge));
    this->Points->push_back(this->Field->Grid.Point(index) +
                            length * Vector3(step[0], step[1], step[2]));
  }

  const ShapeField* Field;
  std::vector<Vector3>* Points;
  KuhnOffsets Steps;
  std::size_t SliceNodes;
  std::array<std::vector<int>, 2> First;            // vertex of each node, by parity of the slice
  std::array<std::vector<std::uint8_t>, 2> Crossed; // edges with a vertex, as bits
};

class Marcher
{
public:
  Marcher(const ShapeField& field, IndexedMesh& mesh)
      : Field(&field), Mesh(&mesh), Row(static_cast<std::size_t>(field.Grid.Size[0])),
        SliceNodes(field.Grid.Offset(0, 0, 1)), Vertices(field, mesh.Points), Cases(MakeCases())
  {
  }

  void Run()
  {
    std::array<std::vector<std::uint8_t>, 2> cubes;
    cubes.fill(std::vector<std::uint8_t>(this->SliceNodes, 0));
    // Border nodes are outside, so that the last slice has no cubes and no edges.
    this->FindCubes(0, cubes[0]);
    this->Vertices.Add(0, cubes[0]);
    for (int k = 0; k + 1 < this->Field->Grid.Size[2]; ++k)
    {
      std::vector<std::uint8_t>& above = cubes[static_cast<std::size_t>((k + 1) & 1)];
      this->FindCubes(k + 1, above);
      this->Vertices.Add(k + 1, above);
      this->AddTriangles(k, cubes[static_cast<std::size_t>(k & 1)]);
    }
  }

private:
  void FindCubes(int k, std::vector<std::uint8_t>& cubes) const
  {
    if (k + 1 == this->Field->Grid.Size[2])
    {
      std::fill(cubes.begin(), cubes.end(), std::uint8_t{0});
      return;
    }
    const float* low = &this->Field->Values[this->SliceNodes * static_cast<std::size_t>(k)];
    const float* high = low + this->SliceNodes;
    const auto column = [&](std::size_t at)
    {
      return static_cast<unsigned>(low[at] > 0.0f) |
             static_cast<unsigned>(low[at + this->Row] > 0.0f) << 2 |
             static_cast<unsigned>(high[at] > 0.0f) << 4 |
             static_cast<unsigned>(high[at + this->Row] > 0.0f) << 6;
    };
    const std::size_t last = this->SliceNodes - this->Row - 1;
    unsigned before = column(0);
    for (std::size_t at = 0; at < last; ++at)
    {
      const unsigned next = column(at + 1);
      cubes[at] = static_cast<std::uint8_t>(before | next << 1);
      before = next;
    }
    // A row's last node has no cube.
    for (std::size_t at = this->Row - 1; at < last; at += this->Row)
    {
      cubes[at] = 0;
    }
  }

  void AddTriangles(int k, const std::vector<std::uint8_t>& cubes)
  {
    for (std::size_t at = 0; at < this->SliceNodes; ++at)
    {
      if (cubes[at] != 0 && cubes[at] != 255)
      {
        for (const Corners& tetrahedron : Tetrahedra)
        {
          this->AddTetrahedron(at, k, tetrahedron, cubes[at]);
        }
      }
    }
  }

  void AddTetrahedron(std::size_t at, int k, const Corners& corners, unsigned inside)
  {
    unsigned set = 0;
    for (unsigned n = 0; n < 4; ++n)
    {
      set |= (inside >> corners[n] & 1) << n;
    }
    const TetrahedronCase& found = this->Cases[set];
    for (int n = 0; n < found.Count; ++n)
    {
      std::array<int, 3> triangle{};
      for (std::size_t v = 0; v < 3; ++v)
      {
        const auto& [a, b] = found.Triangles[static_cast<std::size_t>(n)][v];
        triangle[v] = this->Vertices.Find(at, k, std::min(corners[a], corners[b]),
                                          std::max(corners[a], corners[b]));
      }
      this->Mesh->Triangles.push_back(triangle);
    }
  }

  const ShapeField* Field;
  IndexedMesh* Mesh;
  std::size_t Row;
  std::size_t SliceNodes;
  EdgeVertices Vertices;
  std::array<TetrahedronCase, 16> Cases;
};

bool IsBorderOutside(const ShapeField& field)
{
  const std::array<int, 3>& size = field.Grid.Size;
  const auto isOutside = [&](int i, int j, int k)
  { return !(field.Values[field.Grid.Offset(i, j, k)] > 0.0f); };
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      const bool isFace = k == 0 || j == 0 || k + 1 == size[2] || j + 1 == size[1];
      const int step = isFace || size[0] == 1 ? 1 : size[0] - 1;
      for (int i = 0; i < size[0]; i += step)
      {
        if (!isOutside(i, j, k))
        {
          return false;
        }
      }
    }
  }
  return true;
}
} // namespace

Status MarchTetrahedra(const ShapeField& field, IndexedMesh& mesh)
{
  mesh = {};
  // Seven edges a node, each with a vertex.
  constexpr std::size_t most = std::numeric_limits<int>::max() / 7;
  const std::size_t nodes = field.Grid.NodeCount();
  const int least = *std::min_element(field.Grid.Size.begin(), field.Grid.Size.end());
  if (least < 2 || nodes != field.Values.size() || nodes > most)
  {
    return Status::Failure("A field must have a value for each of its nodes, at least two along "
                           "each axis and 306 million in all.");
  }
  const bool isFinite = std::all_of(field.Values.begin(), field.Values.end(),
                                    [](float value) { return std::isfinite(value); });
  if (!isFinite || !IsBorderOutside(field))
  {
    return Status::Failure("A field must be finite, and outside at the border of its grid.");
  }
  Marcher(field, mesh).Run();
  return Status::Success();
}
} // namespace palpate
