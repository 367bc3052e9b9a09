#include "SurfaceModelSolver.h"

#include "LeastSquaresSolver.h"
#include "MomentKernelChoice.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace palpate
{
namespace
{
// Place of a symmetric 3 x 3 matrix's entry in its lower triangle.
std::size_t PairOf(std::size_t a, std::size_t b)
{
  return std::max(a, b) * (std::max(a, b) + 1) / 2 + std::min(a, b);
}

double Dot(const CacheLineVector<double>& a, const CacheLineVector<double>& b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

template <typename Coordinates>
double DotAll(const Coordinates& a, const Coordinates& b)
{
  return Dot(a[0], b[0]) + Dot(a[1], b[1]) + Dot(a[2], b[2]);
}

// to := to + factor * from.
template <typename Coordinates>
void AddScaled(Coordinates& to, double factor, const Coordinates& from)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t i = 0; i < to[axis].size(); ++i)
    {
      to[axis][i] += factor * from[axis][i];
    }
  }
}
} // namespace

SurfaceModelSolver::SurfaceModelSolver(int degree, double strength)
    : MaximumDegree(degree), Strength(strength),
      Tables(std::make_shared<const MomentTables>(
          degree, moments::KernelFor(FastestInstructionSet()).Lanes)),
      Moments(Tables, moments::KernelFor(FastestInstructionSet())),
      Residual(Tables, moments::KernelFor(FastestInstructionSet())),
      Assembly(*Tables, moments::KernelFor(FastestInstructionSet())),
      Factor((degree + 1) * (degree + 1)), Lower(Factor.MakeVector()), Upper(Factor.MakeVector())
{
  this->Solution = this->MakeCoordinates();
}

SurfaceModelSolver::Coordinates SurfaceModelSolver::MakeCoordinates() const
{
  return {this->Factor.MakeVector(), this->Factor.MakeVector(), this->Factor.MakeVector()};
}

SampleView SurfaceModelSolver::View(const SurfaceSamples& samples,
                                    const std::vector<double>& weights) const noexcept
{
  return {samples.Parameters.front().data(), weights.data(), this->Values.data(),
          static_cast<long>(this->Values.size())};
}

void SurfaceModelSolver::CopyCoordinate(const SurfaceSamples& samples, int axis)
{
  this->Values.resize(samples.Points.size());
  std::transform(samples.Points.begin(), samples.Points.end(), this->Values.begin(),
                 [this, axis](const Vector3& point) { return point[axis] - this->Origin[axis]; });
}

double SurfaceModelSolver::RidgeOf(int degree) const noexcept
{
  const double highest = LeastSquaresSolver::Roughness(std::max(this->MaximumDegree, 1));
  return this->Strength * LeastSquaresSolver::Roughness(degree) / highest / (4.0 * M_PI);
}

void SurfaceModelSolver::AddRidge(PackedTriangle& matrix) const noexcept
{
  for (int l = 1; l <= this->MaximumDegree; ++l)
  {
    for (int i = l * l; i < (l + 1) * (l + 1); ++i)
    {
      matrix.At(i, i) += this->RidgeOf(l);
    }
  }
}

bool SurfaceModelSolver::FitPoints(const SurfaceSamples& samples)
{
  this->Origin = Vector3::Zero();
  for (std::size_t i = 0; i < samples.Points.size(); ++i)
  {
    this->Origin += samples.Weights[i] * samples.Points[i];
  }
  this->CopyCoordinate(samples, 0);
  this->Moments.Clear();
  this->Moments.Add(this->View(samples, samples.Weights));
  this->Factor.Clear();
  this->Assembly.Assemble(*this->Tables, this->Moments.Weights(), 1.0, this->Factor);
  this->AddRidge(this->Factor);
  if (!this->Factor.Factorise())
  {
    return false;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->CopyCoordinate(samples, static_cast<int>(axis));
    this->Left[axis].resize(this->Values.size());
    std::fill(this->Lower.begin(), this->Lower.end(), 0.0);
    std::fill(this->Solution[axis].begin(), this->Solution[axis].end(), 0.0);
    this->Residual.Find(this->View(samples, samples.Weights), this->Lower.data(),
                        this->Left[axis].data(), this->Solution[axis].data());
    this->Factor.Solve(this->Solution[axis].data());
  }
  return true;
}

// The matrices sum_i w_i A_i Y Y^T for A = t I + (1 - t) n n^T, entry by entry of A.
void SurfaceModelSolver::SetTangentWeights(const SurfaceSamples& samples,
                                           std::vector<double> tangentWeights)
{
  this->TangentWeights = std::move(tangentWeights);
  this->Normal.resize(6, PackedTriangle(this->Factor.Size()));
  this->Scaled.resize(samples.Points.size());
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::size_t b = 0; b <= a; ++b)
    {
      for (std::size_t i = 0; i < this->Scaled.size(); ++i)
      {
        const double t = this->TangentWeights[i];
        const Vector3& n = samples.Normals[i];
        const double along = n[static_cast<long>(a)] * n[static_cast<long>(b)];
        this->Scaled[i] = samples.Weights[i] * ((a == b ? t : 0.0) + (1.0 - t) * along);
      }
      PackedTriangle& matrix = this->Normal[PairOf(a, b)];
      this->Moments.Clear();
      this->Moments.Add(this->View(samples, this->Scaled));
      matrix.Clear();
      this->Assembly.Assemble(*this->Tables, this->Moments.Weights(), 1.0, matrix);
      if (a == b)
      {
        this->AddRidge(matrix);
      }
    }
  }
}

// Minus half the gradient at the solution: sums of w A (p - X) with the harmonics, less the ridge.
void SurfaceModelSolver::NormalResiduals(const SurfaceSamples& samples, Coordinates& gradient)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->CopyCoordinate(samples, static_cast<int>(axis));
    this->Residual.Find(this->View(samples, samples.Weights), this->Solution[axis].data(),
                        this->Left[axis].data(), gradient[axis].data());
  }
  std::fill(this->Lower.begin(), this->Lower.end(), 0.0);
  this->Scaled.resize(samples.Points.size());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t i = 0; i < samples.Points.size(); ++i)
    {
      const Vector3 left(this->Left[0][i], this->Left[1][i], this->Left[2][i]);
      const Vector3& n = samples.Normals[i];
      const double t = this->TangentWeights[i];
      const auto at = static_cast<long>(axis);
      this->Values[i] = t * left[at] + (1.0 - t) * n.dot(left) * n[at];
    }
    this->Residual.Find(this->View(samples, samples.Weights), this->Lower.data(),
                        this->Scaled.data(), gradient[axis].data());
    for (int l = 1; l <= this->MaximumDegree; ++l)
    {
      for (int i = l * l; i < (l + 1) * (l + 1); ++i)
      {
        const auto at = static_cast<std::size_t>(i);
        gradient[axis][at] -= this->RidgeOf(l) * this->Solution[axis][at];
      }
    }
  }
}

// A symmetric matrix is its lower triangle and the transpose of it, less the diagonal.
void SurfaceModelSolver::MultiplyNormal(const Coordinates& x, Coordinates& y) noexcept
{
  for (std::size_t a = 0; a < 3; ++a)
  {
    std::fill(y[a].begin(), y[a].end(), 0.0);
    for (std::size_t b = 0; b < 3; ++b)
    {
      const PackedTriangle& matrix = this->Normal[PairOf(a, b)];
      matrix.MultiplyLower(x[b].data(), this->Lower.data());
      matrix.MultiplyUpper(x[b].data(), this->Upper.data());
      for (int i = 0; i < matrix.Size(); ++i)
      {
        const auto at = static_cast<std::size_t>(i);
        y[a][at] += this->Lower[at] + this->Upper[at] - matrix.At(i, i) * x[b][at];
      }
    }
  }
}

void SurfaceModelSolver::FitNormals(const SurfaceSamples& samples, int iterations)
{
  constexpr double NegligibleSquare = 1e-20; // of the squared residual: below rounding
  Coordinates residual = this->MakeCoordinates();
  Coordinates direction = this->MakeCoordinates();
  Coordinates product = this->MakeCoordinates();
  this->NormalResiduals(samples, residual);
  Coordinates conditioned = residual;
  double before = 0.0;
  double first = 0.0;
  for (int step = 0; step < iterations; ++step)
  {
    conditioned = residual;
    for (CacheLineVector<double>& axis : conditioned)
    {
      this->Factor.Solve(axis.data());
    }
    const double now = DotAll(residual, conditioned);
    first = step == 0 ? now : first;
    if (!(now > NegligibleSquare * first))
    {
      break;
    }
    const double keep = step == 0 ? 0.0 : now / before;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (std::size_t i = 0; i < direction[axis].size(); ++i)
      {
        direction[axis][i] = conditioned[axis][i] + keep * direction[axis][i];
      }
    }
    this->MultiplyNormal(direction, product);
    const double along = now / DotAll(direction, product);
    AddScaled(this->Solution, along, direction);
    AddScaled(residual, -along, product);
    before = now;
  }
}

SurfaceModel SurfaceModelSolver::Surface() const
{
  const auto count = static_cast<std::ptrdiff_t>(this->Factor.Size());
  std::array<std::vector<double>, 3> coefficients;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    coefficients[axis].assign(this->Solution[axis].begin(), this->Solution[axis].begin() + count);
    coefficients[axis].front() +=
        this->Origin[static_cast<long>(axis)] * std::sqrt(4.0 * M_PI); // of Y_00
  }
  return {this->MaximumDegree, coefficients};
}
} // namespace palpate
