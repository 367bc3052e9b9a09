#include "ProofCells.h"

#include <utility>

namespace palpate
{
namespace
{
constexpr double Boundless = std::numeric_limits<double>::infinity();
} // namespace

template <typename Surface>
void ProofCells<Surface>::Begin(const ClosestPointSearchOf<Surface>& search) noexcept
{
  constexpr std::size_t Roots = SurfacePatchTreeOf<Surface>::RootCount;
  static_assert(Roots % Count == 0, "roots fill whole groups");
  this->Search = &search;
  this->Parts.Begin(Roots / Count);
  this->ClearUntil.fill(Boundless);
  for (std::size_t group = 0; group < Roots / Count; ++group)
  {
    this->BeginGroup(group, static_cast<int>(Count * group), -Boundless);
  }
}

// Of nodes from this one on, or of triangles.
template <typename Surface>
void ProofCells<Surface>::BeginGroup(std::size_t group, int firstNode, double clearUntil) noexcept
{
  this->Bounds[group].Forget();
  this->FirstNodes[group] = firstNode;
  for (std::size_t part = 0; part < Count; ++part)
  {
    this->ClearUntil[Count * group + part] = clearUntil;
    this->Nodes[Count * group + part] =
        firstNode == None ? None : firstNode + static_cast<int>(part);
  }
}

template <typename Surface>
void ProofCells<Surface>::Join(double far) noexcept
{
  this->Parts.Join([&](std::size_t group) { return this->LeastOf(group) > far; },
                   [&](std::size_t cell, std::size_t group)
                   {
                     this->ClearUntil[cell] = this->LeastOf(group);
                     std::fill_n(&this->ClearUntil[Count * group], Count, Boundless);
                   });
}

template <typename Surface>
std::size_t ProofCells<Surface>::Quarter(std::size_t index, int firstNode) noexcept
{
  const std::size_t group = this->Parts.Quarter(index);
  if (group != QuarteredCells<Groups>::None)
  {
    this->BeginGroup(group, firstNode, std::exchange(this->ClearUntil[index], Boundless));
  }
  return group;
}

template <typename Surface>
std::size_t ProofCells<Surface>::CutNode(std::size_t index) noexcept
{
  return this->Quarter(index, SurfacePatchTreeOf<Surface>::FirstPart(this->Nodes[index]));
}

template <typename Surface>
std::size_t ProofCells<Surface>::CutTriangle(std::size_t index) noexcept
{
  const std::size_t group = this->Quarter(index, None);
  if (group == Groups)
  {
    return group;
  }
  const Triangle& whole = this->Triangles[index];
  const std::array<SphericalTriangle, Count> parts =
      (whole.Leaf != None ? this->Search->Tree().Triangle(whole.Leaf) : whole.Corners).Split();
  for (std::size_t part = 0; part < Count; ++part)
  {
    Triangle& triangle = this->Triangles[Count * group + part];
    triangle.Leaf = None;
    triangle.IsEvaluated = false;
    triangle.Corners = parts[part];
    triangle.Cap = parts[part].Cap();
  }
  return group;
}

template <typename Surface>
void ProofCells<Surface>::Separate(std::size_t index) noexcept
{
  Triangle& triangle = this->Triangles[index];
  triangle.Leaf = std::exchange(this->Nodes[index], None);
  triangle.IsEvaluated = false;
  triangle.Cap = this->Search->Tree().CapOf(triangle.Leaf);
}

template <typename Surface>
void ProofCells<Surface>::Evaluate(std::size_t index) noexcept
{
  Triangle& triangle = this->Triangles[index];
  const SphericalCap& cap = triangle.Cap;
  triangle.Sample = this->Search->Model().EvaluateSecondOrder(cap.Center);
  triangle.Bounds = this->Search->Descent().BoundsWithin(cap.Center, triangle.Sample, cap.Radius);
  triangle.IsEvaluated = true;
}

template struct ProofCells<RadialModel>;
template struct ProofCells<CenteredSurface>;
} // namespace palpate
