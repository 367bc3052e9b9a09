#include "ParameterDescent.h"

#include "CaseLoop.h"
#include "MeshDistances.h"
#include "SphereMapQuality.h"
#include "SphericalHarmonicBasis.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace palpate
{
namespace
{
constexpr double NodesPerDegree = 2.0 / 3.0; // of the icosahedron's frequency
constexpr int LeastNodeFrequency = 8;
constexpr double LeastNodeArea = 0.2; // of what a triangle of nodes had on the parameter sphere
constexpr double SmallestShare = 1.0 / 64.0;

int NodeFrequency(int degree)
{
  return std::max(LeastNodeFrequency, static_cast<int>(std::ceil(NodesPerDegree * degree)));
}

Eigen::Index SizeOf(std::size_t count)
{
  return static_cast<Eigen::Index>(count);
}
} // namespace

ParameterDescent::ParameterDescent(const std::vector<SurfaceModel>& surfaces,
                                   const ReparametrisationSettings& settings)
    : Surfaces(surfaces), Settings(settings), Sphere(NodeFrequency(surfaces.front().Degree())),
      Flows(surfaces.size(), SphereFlow(settings.FieldDegree)),
      Places(surfaces.size(), this->Sphere.Directions())
{
  const Eigen::Index nodes = SizeOf(this->Sphere.Directions().size());
  this->Roots = Eigen::VectorXd::Ones(nodes);
  this->Shapes.resize(3 * nodes, SizeOf(surfaces.size()));
  ForEachCase(surfaces.size(), settings.Threads,
              [this](std::size_t i) {
                this->Shapes.col(SizeOf(i)) = this->ColumnOf(this->Surfaces[i], this->Places[i]);
              });
  const Eigen::VectorXd mean = this->Shapes.rowwise().mean();
  IndexedMesh drawn{{}, this->Sphere.Triangles()};
  for (Eigen::Index k = 0; k < nodes; ++k)
  {
    drawn.Points.emplace_back(mean.segment<3>(3 * k));
  }
  const std::vector<double> parts = PointAreas(drawn);
  const Eigen::Map<const Eigen::VectorXd> areas(parts.data(), nodes);
  this->Roots = (areas / areas.sum()).cwiseSqrt();
  for (Eigen::Index k = 0; k < nodes; ++k)
  {
    this->Shapes.middleRows<3>(3 * k) *= this->Roots[k];
  }
  this->Now = MeasureDescriptionLength(this->Shapes,
                                       settings.NoiseMillimeters * settings.NoiseMillimeters, true);
}

Eigen::VectorXd ParameterDescent::ColumnOf(const SurfaceModel& surface,
                                           const std::vector<Vector3>& nodes) const
{
  Eigen::VectorXd column(3 * SizeOf(nodes.size()));
  for (std::size_t k = 0; k < nodes.size(); ++k)
  {
    column.segment<3>(3 * SizeOf(k)) = this->Roots[SizeOf(k)] * surface.Point(nodes[k]);
  }
  return column;
}

// Minimises sum over the nodes of Pull_ii |S + dX v - T|^2 / 2 for a field v, where T is what the
// others predict; S - T = `pulled` / Pull_ii.
ParameterDescent::Wish ParameterDescent::WishOf(std::size_t i, const Eigen::MatrixXd& pulled) const
{
  const SphericalHarmonicBasis basis(this->Settings.FieldDegree);
  const Eigen::Index size = SizeOf(basis.Size());
  const std::vector<Vector3>& places = this->Places[i];
  Eigen::MatrixXd harmonics(size, SizeOf(places.size()));
  Eigen::MatrixXd squares(6, harmonics.cols()); // of dX, weighted: xx, yx, yy, zx, zy, zz
  Eigen::MatrixXd slopes(harmonics.cols(), 3);
  for (Eigen::Index k = 0; k < harmonics.cols(); ++k)
  {
    const Vector3& u = places[static_cast<std::size_t>(k)];
    basis.Evaluate(u, harmonics.col(k).data());
    const SurfaceModel::Sample sample = this->Surfaces[i].Evaluate(u);
    const Matrix3 along = this->Roots[k] * (sample.First[0] * sample.Tangents[0].transpose() +
                                            sample.First[1] * sample.Tangents[1].transpose());
    const Matrix3 square = along.transpose() * along;
    squares.col(k) << square(0, 0), square(1, 0), square(1, 1), square(2, 0), square(2, 1),
        square(2, 2);
    slopes.row(k) = along.transpose() * pulled.block<3, 1>(3 * k, SizeOf(i));
  }
  Eigen::MatrixXd curvature(3 * size, 3 * size);
  int pair = 0;
  for (Eigen::Index a = 0; a < 3; ++a)
  {
    for (Eigen::Index b = 0; b <= a; ++b, ++pair)
    {
      const Eigen::MatrixXd block =
          harmonics * squares.row(pair).asDiagonal() * harmonics.transpose();
      curvature.block(a * size, b * size, size, size) = block;
      curvature.block(b * size, a * size, size, size) = block;
    }
  }
  curvature *= this->Now.Pull(SizeOf(i), SizeOf(i));
  const double damping = this->Settings.Damping * curvature.trace() / (3.0 * size);
  for (int l = 0; l <= this->Settings.FieldDegree; ++l)
  {
    for (Eigen::Index k = l * l; k < (l + 1) * (l + 1); ++k)
    {
      for (Eigen::Index a = 0; a < 3; ++a)
      {
        curvature(a * size + k, a * size + k) += damping * (1.0 + l * (l + 1.0));
      }
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(curvature);
  Eigen::VectorXd slope(3 * size);
  for (Eigen::Index a = 0; a < 3; ++a)
  {
    slope.segment(a * size, size) = harmonics * slopes.col(a);
  }
  return {factor.solve(Eigen::MatrixXd::Identity(3 * size, 3 * size)), -factor.solve(slope)};
}

// The minimisers under the condition that their sum is zero.
std::vector<SphereFlow::Field> ParameterDescent::FieldsOf(const std::vector<Wish>& wishes) const
{
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(wishes.front().Step.size());
  Eigen::MatrixXd inverses = Eigen::MatrixXd::Zero(sum.size(), sum.size());
  for (const Wish& wish : wishes)
  {
    sum += wish.Step;
    inverses += wish.Inverse;
  }
  const Eigen::VectorXd multiplier = inverses.llt().solve(sum);
  std::vector<SphereFlow::Field> fields;
  for (const Wish& wish : wishes)
  {
    const Eigen::VectorXd step = wish.Step - wish.Inverse * multiplier;
    fields.emplace_back(
        Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3>>(step.data(), step.size() / 3, 3)
            .transpose());
  }
  return fields;
}

// The largest part of the share that leaves each triangle of nodes enough area; 0 if none does.
double ParameterDescent::UnfoldedShare(std::size_t i, const std::vector<Vector3>& tangents,
                                       double share) const
{
  double longest = 0.0;
  for (const Vector3& tangent : tangents)
  {
    longest = std::max(longest, tangent.norm());
  }
  share = std::min(share, this->Flows[i].LongestStep() / (longest + 1e-300));
  const std::vector<Vector3>& before = this->Sphere.Directions();
  for (int halving = 0; halving < 6; ++halving, share *= 0.5)
  {
    std::vector<Vector3> moved = this->Places[i];
    SphereFlow::Move(tangents, share, moved);
    const auto area = [](const std::vector<Vector3>& points, const std::array<int, 3>& t)
    {
      return SphericalDeterminant(points[static_cast<std::size_t>(t[0])],
                                  points[static_cast<std::size_t>(t[1])],
                                  points[static_cast<std::size_t>(t[2])]);
    };
    const bool isUnfolded =
        std::all_of(this->Sphere.Triangles().begin(), this->Sphere.Triangles().end(),
                    [&](const std::array<int, 3>& t)
                    { return area(moved, t) >= LeastNodeArea * area(before, t); });
    if (isUnfolded)
    {
      return share;
    }
  }
  return 0.0;
}

bool ParameterDescent::Try(const std::vector<SphereFlow::Field>& fields, double share)
{
  std::vector<std::vector<Vector3>> places = this->Places;
  std::vector<double> shares(places.size());
  Eigen::MatrixXd shapes(this->Shapes.rows(), this->Shapes.cols());
  ForEachCase(places.size(), this->Settings.Threads,
              [&](std::size_t i)
              {
                const std::vector<Vector3> tangents =
                    this->Flows[i].TangentsOf(fields[i], places[i]);
                shares[i] = this->UnfoldedShare(i, tangents, share);
                SphereFlow::Move(tangents, shares[i], places[i]);
                shapes.col(SizeOf(i)) = this->ColumnOf(this->Surfaces[i], places[i]);
              });
  const double noise = this->Settings.NoiseMillimeters * this->Settings.NoiseMillimeters;
  DescriptionLength length = MeasureDescriptionLength(shapes, noise, true);
  if (!(length.Value < this->Now.Value))
  {
    return false;
  }
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (shares[i] > 0.0)
    {
      this->Flows[i].Add(shares[i] * fields[i]);
    }
  }
  this->Now = std::move(length);
  this->Places = std::move(places);
  this->Shapes = std::move(shapes);
  return true;
}

bool ParameterDescent::Step()
{
  const Eigen::MatrixXd pulled = this->Shapes * this->Now.Pull;
  std::vector<Wish> wishes(this->Surfaces.size());
  ForEachCase(wishes.size(), this->Settings.Threads,
              [&](std::size_t i) { wishes[i] = this->WishOf(i, pulled); });
  const std::vector<SphereFlow::Field> fields = this->FieldsOf(wishes);
  for (double share = std::min(1.0, 2.0 * this->Share); share >= SmallestShare; share *= 0.5)
  {
    if (this->Try(fields, share))
    {
      this->Share = share;
      return true;
    }
  }
  return false;
}

// The trace that majorises the length, as a function of one shape, with the others as they are.
void ParameterDescent::DropUselessMoves()
{
  for (std::size_t i = 0; i < this->Surfaces.size(); ++i)
  {
    const Eigen::Index at = SizeOf(i);
    const double precision = this->Now.Pull(at, at);
    const Eigen::VectorXd own = this->ColumnOf(this->Surfaces[i], this->Sphere.Directions());
    const Eigen::VectorXd left = this->Shapes * this->Now.Pull.col(at) / precision;
    const Eigen::VectorXd change = own - this->Shapes.col(at);
    if (!this->Flows[i].IsIdentity() && (left + change).squaredNorm() <= left.squaredNorm())
    {
      this->Flows[i] = SphereFlow(this->Settings.FieldDegree);
      this->Places[i] = this->Sphere.Directions();
      this->Shapes.col(at) = own;
      this->Now = MeasureDescriptionLength(
          this->Shapes, this->Settings.NoiseMillimeters * this->Settings.NoiseMillimeters, true);
    }
  }
}

DescriptionLength ParameterDescent::Measure(const std::vector<SurfaceModel>& surfaces) const
{
  Eigen::MatrixXd shapes(this->Shapes.rows(), this->Shapes.cols());
  ForEachCase(surfaces.size(), this->Settings.Threads,
              [&](std::size_t i)
              { shapes.col(SizeOf(i)) = this->ColumnOf(surfaces[i], this->Sphere.Directions()); });
  return MeasureDescriptionLength(
      shapes, this->Settings.NoiseMillimeters * this->Settings.NoiseMillimeters, false);
}
} // namespace palpate
