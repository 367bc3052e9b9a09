#include "MapDescent.h"

#include "VertexRelaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr std::size_t LongestMemory = 8; // steps
constexpr int StepsBetweenTests = 10;
constexpr double LeastGain = 1e-4; // of the energy, between tests
constexpr int MostCuts = 12;
constexpr double LeastDecrease = 1e-4; // of what the gradient predicts
// To first order no step lowers a D by more than this share,
constexpr double LargestShareLost = 0.8;
// or moves a vertex farther than this, rad.
constexpr double FarthestMove = 0.1;

double Dot(const std::vector<Vector3>& a, const std::vector<Vector3>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += a[i].dot(b[i]);
  }
  return sum;
}
} // namespace

MapDescent::MapDescent(const VertexRings& rings, const std::vector<int>& present,
                       std::vector<MappedVertex>& vertices)
    : Present(present), Vertices(vertices), Gradient(present.size()), Curvature(present.size())
{
  for (const int vertex : present)
  {
    this->Directions.push_back(vertices[static_cast<std::size_t>(vertex)].Direction);
  }
  this->AddTriangles(rings);
  this->Current = this->EnergyOf(this->Directions);
}

void MapDescent::AddTriangles(const VertexRings& rings)
{
  std::vector<int> place(this->Vertices.size(), -1);
  for (std::size_t i = 0; i < this->Present.size(); ++i)
  {
    place[static_cast<std::size_t>(this->Present[i])] = static_cast<int>(i);
  }
  this->Triangles.reserve(2 * this->Present.size());
  for (const int vertex : this->Present)
  {
    const Ring ring = rings.Of(vertex);
    for (int i = 0; i < ring.Count; ++i)
    {
      const int next = ring.First[i];
      const int last = ring.First[i + 1 < ring.Count ? i + 1 : 0];
      if (vertex < next && vertex < last)
      {
        this->AddTriangle(vertex, next, last);
      }
    }
  }
  for (Triangle& triangle : this->Triangles)
  {
    for (int& corner : triangle.Corners)
    {
      corner = place[static_cast<std::size_t>(corner)];
    }
  }
}

void MapDescent::AddTriangle(int a, int b, int c)
{
  const auto point = [this](int v) -> const Vector3&
  { return this->Vertices[static_cast<std::size_t>(v)].Point; };
  std::array<double, 3> square = {(point(b) - point(c)).squaredNorm(),
                                  (point(c) - point(a)).squaredNorm(),
                                  (point(a) - point(b)).squaredNorm()};
  const double share = VertexRelaxation::EquilateralShare * (square[0] + square[1] + square[2]);
  const double sum = square[0] + square[1] + square[2] + 3.0 * share;
  std::array<double, 3> others;
  for (std::size_t k = 0; k < 3; ++k)
  {
    others[k] = sum - 2.0 * (square[k] + share);
  }
  const double area16 = others[0] * others[1] + others[1] * others[2] + others[2] * others[0];
  const double weight = std::sqrt(std::sqrt(area16));
  this->Triangles.push_back(
      {{a, b, c}, {weight * others[0], weight * others[1], weight * others[2]}});
}

double MapDescent::EnergyOf(const Field& directions) const
{
  double energy = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : this->Triangles)
  {
    const Vector3& a = directions[static_cast<std::size_t>(t.Corners[0])];
    const Vector3 ab = directions[static_cast<std::size_t>(t.Corners[1])] - a;
    const Vector3 ac = directions[static_cast<std::size_t>(t.Corners[2])] - a;
    const double determinant = a.dot(ab.cross(ac));
    const double numerator =
        0.5 * (t.Weights[0] * (ac - ab).squaredNorm() + t.Weights[1] * ac.squaredNorm() +
               t.Weights[2] * ab.squaredNorm());
    least = std::min(least, determinant);
    energy += numerator / (determinant * std::sqrt(determinant)); // NaN if turned over
  }
  return least > 0.0 ? energy : std::numeric_limits<double>::infinity();
}

void MapDescent::FindGradient()
{
  std::fill(this->Gradient.begin(), this->Gradient.end(), Vector3::Zero());
  std::fill(this->Curvature.begin(), this->Curvature.end(), 0.0);
  for (const Triangle& triangle : this->Triangles)
  {
    this->AddGradient(triangle);
  }
  for (std::size_t i = 0; i < this->Gradient.size(); ++i)
  {
    const Vector3& q = this->Directions[i];
    this->Gradient[i] -= this->Gradient[i].dot(q) * q;
  }
}

void MapDescent::AddGradient(const Triangle& triangle)
{
  std::array<Vector3, 3> q;
  for (std::size_t k = 0; k < 3; ++k)
  {
    q[k] = this->Directions[static_cast<std::size_t>(triangle.Corners[k])];
  }
  const Vector3 ab = q[1] - q[0];
  const Vector3 ac = q[2] - q[0];
  const double numerator =
      0.5 * (triangle.Weights[0] * (ac - ab).squaredNorm() +
             triangle.Weights[1] * ac.squaredNorm() + triangle.Weights[2] * ab.squaredNorm());
  const double inverse = 1.0 / q[0].dot(ab.cross(ac));
  const double power = inverse * std::sqrt(inverse);
  const double first = 1.5 * numerator * power * inverse;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t l = (k + 1) % 3;
    const std::size_t m = (k + 2) % 3;
    const Vector3 pull = triangle.Weights[m] * q[l] + triangle.Weights[l] * q[m];
    const Vector3 normal = q[l].cross(q[m]);
    const double along = normal.dot(q[k]);
    const double across = std::max(0.0, normal.squaredNorm() - along * along);
    const auto corner = static_cast<std::size_t>(triangle.Corners[k]);
    this->Gradient[corner] -= power * pull + first * normal;
    this->Curvature[corner] +=
        1.25 * first * inverse * across + power * std::max(0.0, pull.dot(q[k]));
  }
}

// The two loops of L-BFGS.
MapDescent::Field MapDescent::Direction() const
{
  Field direction = this->Gradient;
  std::vector<double> parts(this->Memory.size());
  for (std::size_t n = this->Memory.size(); n > 0; --n)
  {
    const Pair& pair = this->Memory[n - 1];
    parts[n - 1] = pair.Scale * Dot(pair.Step, direction);
    for (std::size_t i = 0; i < direction.size(); ++i)
    {
      direction[i] -= parts[n - 1] * pair.Change[i];
    }
  }
  for (std::size_t i = 0; i < direction.size(); ++i)
  {
    direction[i] /= this->Curvature[i];
  }
  for (std::size_t n = 0; n < this->Memory.size(); ++n)
  {
    const Pair& pair = this->Memory[n];
    const double part = parts[n] - pair.Scale * Dot(pair.Change, direction);
    for (std::size_t i = 0; i < direction.size(); ++i)
    {
      direction[i] += part * pair.Step[i];
    }
  }
  for (std::size_t i = 0; i < direction.size(); ++i)
  {
    const Vector3& q = this->Directions[i];
    direction[i] = -(direction[i] - direction[i].dot(q) * q);
  }
  return direction;
}

double MapDescent::LargestScale(const Field& direction) const
{
  double farthest = 0.0;
  for (const Vector3& step : direction)
  {
    farthest = std::max(farthest, step.norm());
  }
  double scale = std::min(1.0, FarthestMove / farthest);
  for (const Triangle& triangle : this->Triangles)
  {
    const auto a = static_cast<std::size_t>(triangle.Corners[0]);
    const auto b = static_cast<std::size_t>(triangle.Corners[1]);
    const auto c = static_cast<std::size_t>(triangle.Corners[2]);
    const Vector3 bc = this->Directions[b].cross(this->Directions[c]);
    const double determinant = this->Directions[a].dot(bc);
    const double change = direction[a].dot(bc) +
                          direction[b].dot(this->Directions[c].cross(this->Directions[a])) +
                          direction[c].dot(this->Directions[a].cross(this->Directions[b]));
    if (scale * change < -LargestShareLost * determinant)
    {
      scale = -LargestShareLost * determinant / change;
    }
  }
  return scale;
}

// False if no step along the direction lowers the energy.
bool MapDescent::Advance(const Field& direction, Field& moved, double& energy) const
{
  const double slope = Dot(this->Gradient, direction);
  if (!(slope < 0.0))
  {
    return false;
  }
  double scale = this->LargestScale(direction);
  for (int cut = 0; cut < MostCuts; ++cut)
  {
    for (std::size_t i = 0; i < moved.size(); ++i)
    {
      moved[i] = (this->Directions[i] + scale * direction[i]).normalized();
    }
    energy = this->EnergyOf(moved);
    if (energy <= this->Current + LeastDecrease * scale * slope)
    {
      return true;
    }
    scale *= 0.5;
  }
  return false;
}

void MapDescent::Remember(const Field& before, const Field& gradient)
{
  Pair pair{this->Directions, this->Gradient, 0.0};
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    pair.Step[i] -= before[i];
    pair.Change[i] -= gradient[i];
  }
  const double product = Dot(pair.Step, pair.Change);
  if (product > 0.0)
  {
    pair.Scale = 1.0 / product;
    this->Memory.push_back(std::move(pair));
    if (this->Memory.size() > LongestMemory)
    {
      this->Memory.pop_front();
    }
  }
}

void MapDescent::Run(int mostSteps)
{
  this->FindGradient();
  double tested = this->Current;
  Field moved = this->Directions;
  for (int step = 1; step <= mostSteps; ++step)
  {
    double energy = 0.0;
    if (!this->Advance(this->Direction(), moved, energy))
    {
      if (this->Memory.empty())
      {
        break;
      }
      this->Memory.clear();
      continue;
    }
    const Field gradient = this->Gradient;
    std::swap(this->Directions, moved);
    this->Current = energy;
    this->FindGradient();
    this->Remember(moved, gradient);
    if (step % StepsBetweenTests == 0)
    {
      if (tested - energy < LeastGain * energy)
      {
        break;
      }
      tested = energy;
    }
  }
  for (std::size_t i = 0; i < this->Present.size(); ++i)
  {
    this->Vertices[static_cast<std::size_t>(this->Present[i])].Direction = this->Directions[i];
  }
}
} // namespace palpate
