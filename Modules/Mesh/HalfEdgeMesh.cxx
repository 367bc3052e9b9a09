#include "HalfEdgeMesh.h"

#include "EdgeRings.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr std::size_t MostOfHalfEdges = 500'000'000; // four numbers each
constexpr double MostMillimetres = 1e15;             // areas fit into float

Status CheckArrays(const IndexedMesh& mesh)
{
  if (std::max(mesh.Triangles.size(), mesh.Points.size()) > MostOfHalfEdges)
  {
    return Status::Failure("The surface has more than 500 million triangles or points.");
  }
  if (!std::all_of(mesh.Points.begin(), mesh.Points.end(),
                   [](const Vector3& p)
                   { return p.allFinite() && p.cwiseAbs().maxCoeff() <= MostMillimetres; }))
  {
    return Status::Failure("The surface has points that are not finite or beyond 1e15 mm.");
  }
  return std::all_of(mesh.Triangles.begin(), mesh.Triangles.end(),
                     [&mesh](const std::array<int, 3>& t)
                     { return HasThreePoints(t, mesh.Points.size()); })
             ? Status::Success()
             : Status::Failure("The surface has triangles with invalid or repeated points.");
}
} // namespace

Status HalfEdgeMesh::Make(const IndexedMesh& mesh, HalfEdgeMesh& made)
{
  if (Status status = CheckArrays(mesh); !status.IsOk())
  {
    return status;
  }
  const EdgeRings rings(mesh);
  made.Count = static_cast<int>(mesh.Triangles.size());
  made.Points = mesh.Points;
  made.Starts.assign(4 * mesh.Triangles.size(), -1);
  made.Twins.assign(4 * mesh.Triangles.size(), -1);
  for (int t = 0; t < made.Count; ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int other = rings.Next(3 * t + k);
      if (!rings.IsPair(3 * t + k) || StartOf(mesh, other) == mesh.Triangles[t][k])
      {
        return Status::Failure("The surface is not closed or not consistently oriented.");
      }
      made.Starts[4 * t + k] = mesh.Triangles[t][k];
      made.Twins[4 * t + k] = 4 * (other / 3) + other % 3;
    }
  }
  return made.LinkOutgoing();
}

Status HalfEdgeMesh::LinkOutgoing()
{
  std::vector<int> fanSizes(this->Points.size(), 0);
  this->Outgoing.assign(this->Points.size(), -1);
  for (int h = 0; h < this->HalfEdgeLimit(); ++h)
  {
    if (this->IsAlive(h))
    {
      this->Outgoing[this->Start(h)] = h;
      ++fanSizes[this->Start(h)];
    }
  }
  for (const int first : this->Outgoing)
  {
    if (first < 0)
    {
      continue;
    }
    int& left = fanSizes[this->Start(first)];
    int h = first;
    do
    {
      --left;
      h = this->Around(h);
    } while (h != first);
    if (left != 0)
    {
      return Status::Failure("The surface has pinched points, where it touches itself.");
    }
  }
  return Status::Success();
}

void HalfEdgeMesh::Collapse(int h) noexcept
{
  const int kept = this->Start(h);
  const int removed = this->End(h);
  const int back = this->Twin(h);
  int g = Next(h); // leaves the removed point
  do
  {
    this->Starts[g] = kept;
    g = this->Around(g);
  } while (g != Next(h));
  for (const int side : {h, back})
  {
    // Half-edge `in` ends at the third point of the triangle, `out` leaves it.
    const int in = this->Twin(Previous(side));
    const int out = this->Twin(Next(side));
    this->Outgoing[this->Start(out)] = out;
    this->Pair(in, out);
    this->Outgoing[kept] = this->Start(in) == kept ? in : out;
  }
  for (const int side : {h, back})
  {
    const int first = side & ~3;
    std::fill_n(this->Starts.begin() + first, 3, -1);
  }
  this->Outgoing[removed] = -1;
  this->Count -= 2;
}

void HalfEdgeMesh::Flip(int h) noexcept
{
  const int back = this->Twin(h);
  const int a = this->Start(h);
  const int b = this->Start(back);
  const int c = this->Start(Previous(h));
  const int d = this->Start(Previous(back));
  const int bc = this->Twin(Next(h));
  const int ca = this->Twin(Previous(h));
  const int ad = this->Twin(Next(back));
  const int db = this->Twin(Previous(back));
  // Triangle of h becomes d, c, a (h: d to c), that of back c, d, b.
  this->Starts[h] = d;
  this->Starts[Next(h)] = c;
  this->Starts[Previous(h)] = a;
  this->Starts[back] = c;
  this->Starts[Next(back)] = d;
  this->Starts[Previous(back)] = b;
  this->Pair(Next(h), ca);
  this->Pair(Previous(h), ad);
  this->Pair(Next(back), db);
  this->Pair(Previous(back), bc);
  this->Outgoing[a] = Previous(h);
  this->Outgoing[b] = Previous(back);
  this->Outgoing[c] = back;
  this->Outgoing[d] = h;
}

IndexedMesh HalfEdgeMesh::ToIndexedMesh() const
{
  IndexedMesh mesh;
  mesh.Points.reserve(this->Points.size() -
                      std::count(this->Outgoing.begin(), this->Outgoing.end(), -1));
  std::vector<int> numbers(this->Points.size(), -1);
  for (std::size_t p = 0; p < this->Points.size(); ++p)
  {
    if (this->Outgoing[p] >= 0)
    {
      numbers[p] = static_cast<int>(mesh.Points.size());
      mesh.Points.push_back(this->Points[p]);
    }
  }
  mesh.Triangles.reserve(this->Count);
  for (int h = 0; h < this->HalfEdgeLimit(); h += 4)
  {
    if (this->IsAlive(h))
    {
      mesh.Triangles.push_back(
          {numbers[this->Start(h)], numbers[this->Start(h + 1)], numbers[this->Start(h + 2)]});
    }
  }
  return mesh;
}
} // namespace palpate
