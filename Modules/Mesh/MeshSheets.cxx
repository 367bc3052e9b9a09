#include "MeshSheets.h"

#include "DisjointSets.h"

#include <algorithm>

namespace palpate
{
MeshSheets::MeshSheets(const IndexedMesh& mesh, const EdgeRings& rings)
    : SheetOf(mesh.Triangles.size(), -1), IsTurned(mesh.Triangles.size(), 0)
{
  std::vector<int> stack;
  const int count = static_cast<int>(mesh.Triangles.size());
  for (int t = 0; t < count; ++t)
  {
    if (this->SheetOf[t] < 0 && !rings.IsLeftOut(t))
    {
      this->Flood(mesh, rings, t, stack);
      ++this->SheetCount;
    }
  }
  this->KeepMajority(rings);
  this->JoinParts(rings);
}

void MeshSheets::Flood(const IndexedMesh& mesh, const EdgeRings& rings, int first,
                       std::vector<int>& stack)
{
  this->SheetOf[first] = this->SheetCount;
  stack.push_back(first);
  while (!stack.empty())
  {
    const int t = stack.back();
    stack.pop_back();
    for (int h = 3 * t; h < 3 * t + 3; ++h)
    {
      if (!rings.IsPair(h))
      {
        continue;
      }
      const int other = rings.Next(h);
      const bool isAlike = StartOf(mesh, h) == StartOf(mesh, other);
      const char turned = static_cast<char>((this->IsTurned[t] != 0) != isAlike);
      const int next = other / 3;
      if (this->SheetOf[next] < 0)
      {
        this->SheetOf[next] = this->SheetCount;
        this->IsTurned[next] = turned;
        stack.push_back(next);
      }
      else if (this->IsTurned[next] != turned)
      {
        this->IsOrientable = false;
      }
    }
  }
}

void MeshSheets::KeepMajority(const EdgeRings& rings)
{
  std::vector<int> balance(this->SheetCount, 0);
  const int count = static_cast<int>(this->SheetOf.size());
  for (int t = 0; t < count; ++t)
  {
    if (!rings.IsLeftOut(t))
    {
      balance[this->SheetOf[t]] += this->IsTurned[t] != 0 ? -1 : 1;
    }
  }
  for (int t = 0; t < count; ++t)
  {
    if (!rings.IsLeftOut(t) && balance[this->SheetOf[t]] < 0)
    {
      this->IsTurned[t] = static_cast<char>(1 - this->IsTurned[t]);
    }
  }
}

void MeshSheets::JoinParts(const EdgeRings& rings)
{
  DisjointSets parts(static_cast<std::size_t>(this->SheetCount));
  const int count = 3 * static_cast<int>(this->SheetOf.size());
  for (int h = 0; h < count; ++h)
  {
    if (rings.Next(h) >= 0)
    {
      parts.Join(static_cast<std::size_t>(this->SheetOf[h / 3]),
                 static_cast<std::size_t>(this->SheetOf[rings.Next(h) / 3]));
    }
  }
  this->PartOf.resize(this->SheetCount);
  for (int sheet = 0; sheet < this->SheetCount; ++sheet)
  {
    const int root = static_cast<int>(parts.Root(static_cast<std::size_t>(sheet)));
    this->PartOf[sheet] = root == sheet ? this->PartCount++ : this->PartOf[root];
  }
}
} // namespace palpate
