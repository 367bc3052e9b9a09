#include "VertexRelaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// Over-relaxation: fewer sweeps than with Newton's step.
constexpr double StepFactor = 1.5;
// Of a Hessian's eigenvalues, relative to the larger one.
constexpr double LeastCurvature = 0.1;
// A step lowers no D by more than this share,
constexpr double LargestLoss = 0.8;
// is no longer than this, rad,
constexpr double LongestStep = 0.5;
// and, if it changes D by less than this, is in the region where the quadratic model holds.
constexpr double TrustedChange = 0.1;
constexpr int MostShortenings = 6;
constexpr double Shortening = 0.4;
} // namespace

void VertexRelaxation::FindNeighbours(const std::vector<MappedVertex>& vertices, int vertex,
                                      Ring ring)
{
  const MappedVertex& self = vertices[static_cast<std::size_t>(vertex)];
  const Vector3& q = self.Direction;
  // Frame without branches but the sign (Duff et al. 2017).
  const double sign = q.z() < 0.0 ? -1.0 : 1.0;
  const double a = -1.0 / (sign + q.z());
  const double b = q.x() * q.y() * a;
  this->E1 = {1.0 + sign * q.x() * q.x() * a, sign * b, -sign * q.x()};
  this->E2 = {b, sign + q.y() * q.y() * a, -q.y()};
  this->Count = static_cast<std::size_t>(ring.Count);
  if (this->Neighbours.size() < this->Count + 1)
  {
    this->Neighbours.resize(this->Count + 1);
    this->Triangles.resize(this->Count);
  }
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const MappedVertex& other = vertices[static_cast<std::size_t>(ring.First[i])];
    const Vector3& d = other.Direction;
    const Vector3 edge = other.Point - self.Point;
    this->Neighbours[i] = {this->E1.dot(d), this->E2.dot(d), q.dot(d),          edge.x(),
                           edge.y(),        edge.z(),        edge.squaredNorm()};
  }
  this->Neighbours[this->Count] = this->Neighbours[0];
}

void VertexRelaxation::FindTriangles() noexcept
{
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const Neighbour& a = this->Neighbours[i];
    const Neighbour& b = this->Neighbours[i + 1];
    const double u = b.U - a.U;
    const double v = b.V - a.V;
    const double w = b.W - a.W;
    const double rim = u * u + v * v + w * w;
    const double share = EquilateralShare * (a.SquaredLength + b.SquaredLength + rim);
    // Of the edges to a, to b and between them; their pairs' products sum to 16 A^2.
    const double toA = rim + b.SquaredLength - a.SquaredLength + share;
    const double toB = rim + a.SquaredLength - b.SquaredLength + share;
    const double across = a.SquaredLength + b.SquaredLength - rim + share;
    const double weight = toA * toB + toB * across + across * toA;
    const double p = weight * toA;
    const double q = weight * toB;
    const double x = b.X - a.X;
    const double y = b.Y - a.Y;
    const double z = b.Z - a.Z;
    this->Triangles[i] = {a.Y * b.Z - a.Z * b.Y,
                          a.Z * b.X - a.X * b.Z,
                          a.X * b.Y - a.Y * b.X,
                          -p * a.X - q * b.X,
                          -p * a.Y - q * b.Y,
                          -p * a.Z - q * b.Z,
                          p + q + 0.5 * weight * across * (x * x + y * y + z * z)};
  }
}

// Of sum N / D^3 for N and D linear on the sphere. The gradient's radial part, times -1, adds to
// the Hessian's diagonal.
void VertexRelaxation::FindDerivatives() noexcept
{
  double energy = 0.0;
  double gx = 0.0;
  double gy = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  double radial = 0.0;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const Triangle& t = this->Triangles[i];
    const double numerator = t.Constant + t.Gz;
    const double inverse = 1.0 / t.Mz;
    const double cube = inverse * inverse * inverse;
    const double value = numerator * cube;
    const double first = 3.0 * value * inverse;
    const double mixed = 3.0 * cube * inverse;
    const double second = 4.0 * first * inverse;
    energy += value;
    gx += cube * t.Gx - first * t.Mx;
    gy += cube * t.Gy - first * t.My;
    xx += (second * t.Mx - 2.0 * mixed * t.Gx) * t.Mx;
    yy += (second * t.My - 2.0 * mixed * t.Gy) * t.My;
    xy += second * t.Mx * t.My - mixed * (t.Gx * t.My + t.Gy * t.Mx);
    radial += cube * (2.0 * numerator + t.Constant);
  }
  this->Energy = energy;
  this->Gx = gx;
  this->Gy = gy;
  this->Hxx = xx + radial;
  this->Hxy = xy;
  this->Hyy = yy + radial;
}

void VertexRelaxation::FindNewtonStep() noexcept
{
  const double mean = 0.5 * (this->Hxx + this->Hyy);
  const double half = 0.5 * (this->Hxx - this->Hyy);
  const double root = std::sqrt(half * half + this->Hxy * this->Hxy);
  const double shift = std::max(0.0, LeastCurvature * (std::abs(mean) + root) - (mean - root));
  const double xx = this->Hxx + shift;
  const double yy = this->Hyy + shift;
  const double factor = -StepFactor / (xx * yy - this->Hxy * this->Hxy);
  this->Sx = factor * (yy * this->Gx - this->Hxy * this->Gy);
  this->Sy = factor * (xx * this->Gy - this->Hxy * this->Gx);
}

// Shortens the step where it is too long; returns its largest relative change of a D.
double VertexRelaxation::LimitStep() noexcept
{
  double loss = 0.0;
  double gain = 0.0;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const Triangle& t = this->Triangles[i];
    const double change = (t.Mx * this->Sx + t.My * this->Sy) / t.Mz;
    loss = std::max(loss, -change);
    gain = std::max(gain, change);
  }
  const double length = std::sqrt(this->Sx * this->Sx + this->Sy * this->Sy);
  const double scale = 1.0 / std::max({1.0, loss / LargestLoss, length / LongestStep});
  this->Sx *= scale;
  this->Sy *= scale;
  return scale * std::max(loss, gain);
}

double VertexRelaxation::EnergyAt(double x, double y) const noexcept
{
  const double z = 1.0 / std::sqrt(1.0 + x * x + y * y);
  x *= z;
  y *= z;
  double energy = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const Triangle& t = this->Triangles[i];
    const double determinant = t.Mx * x + t.My * y + t.Mz * z;
    const double numerator = t.Constant + t.Gx * x + t.Gy * y + t.Gz * z;
    least = std::min(least, determinant);
    energy += numerator / (determinant * determinant * determinant);
  }
  return least > 0.0 ? energy : std::numeric_limits<double>::infinity();
}

double VertexRelaxation::Step(std::vector<MappedVertex>& vertices, int vertex, Ring ring)
{
  this->FindNeighbours(vertices, vertex, ring);
  this->FindTriangles();
  this->FindDerivatives();
  this->FindNewtonStep();
  double change = this->LimitStep();
  // Also refuses NaN.
  if (!(change <= TrustedChange))
  {
    int shortenings = 0;
    while (!(this->EnergyAt(this->Sx, this->Sy) <= this->Energy))
    {
      if (++shortenings > MostShortenings)
      {
        return 0.0;
      }
      this->Sx *= Shortening;
      this->Sy *= Shortening;
      change *= Shortening;
    }
  }
  Vector3& q = vertices[static_cast<std::size_t>(vertex)].Direction;
  q = (q + this->Sx * this->E1 + this->Sy * this->E2).normalized();
  return change;
}

bool VertexRelaxation::IsInside(const std::vector<MappedVertex>& vertices, int vertex, Ring ring)
{
  this->FindNeighbours(vertices, vertex, ring);
  bool inside = true;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const Neighbour& a = this->Neighbours[i];
    const Neighbour& b = this->Neighbours[i + 1];
    inside = inside && a.X * b.Y - a.Y * b.X > 0.0;
  }
  return inside;
}
} // namespace palpate
