#include "ReducedCompliance.h"

#include "GaussLegendre.h"
#include "SparseCholesky.h"
#include "SphericalHarmonicBasis.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
// Integrals of shape functions times harmonics: a row for each node.
Eigen::MatrixXd SurfaceIntegrals(const StarMesh& mesh, int degree)
{
  constexpr int Order = 4; // exact to rounding for faces of a few degrees
  const SphericalHarmonicBasis basis(degree);
  const GaussLegendre gauss(Order);
  Eigen::VectorXd values(static_cast<Eigen::Index>(basis.Size()));
  Eigen::MatrixXd integrals =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(mesh.Nodes().size()), values.size());
  for (const StarMesh::Face& face : mesh.Faces())
  {
    for (std::size_t i = 0; i < Order; ++i)
    {
      for (std::size_t j = 0; j < Order; ++j)
      {
        const StarMesh::FacePoint point = StarMesh::At(face, gauss.Nodes[i], gauss.Nodes[j]);
        basis.Evaluate(point.Direction, values.data());
        const double weight = gauss.Weights[i] * gauss.Weights[j] * point.SolidAngle;
        for (std::size_t corner = 0; corner < 4; ++corner)
        {
          integrals.row(face.Nodes[corner]) += weight * point.Shape[corner] * values.transpose();
        }
      }
    }
  }
  return integrals;
}
} // namespace

Status ReducedCompliance::Make(const StarMesh& mesh, const StiffnessMatrix& stiffness, int degree,
                               const KernelProgress& progress, ReducedCompliance& compliance)
{
  if (degree < 0 || degree > MostDegree)
  {
    return Status::Failure("The degree of the compliance is not a number from 0 to " +
                           std::to_string(MostDegree) + ".");
  }
  constexpr double PartOfFactor = 0.4;
  Status cancelled = Status::Failure("Cancelled.");
  const auto goesOn = [&](double fraction) { return !progress || progress(fraction); };
  if (!goesOn(0.0))
  {
    return cancelled;
  }
  SparseCholesky solver;
  Status factored =
      solver.Factor(stiffness, [&](double fraction) { return goesOn(PartOfFactor * fraction); });
  if (!factored.IsOk())
  {
    return factored;
  }
  const Eigen::MatrixXd integrals = SurfaceIntegrals(mesh, degree);
  const Eigen::Index nodes = integrals.rows();
  const Eigen::Index harmonics = integrals.cols();
  Eigen::MatrixXd values(3 * harmonics, 3 * harmonics);
  constexpr Eigen::Index Together = 64; // right sides, which bounds memory and time to cancel
  const Eigen::Index all = 3 * harmonics;
  for (Eigen::Index first = 0; first < all; first += Together)
  {
    if (!goesOn(PartOfFactor +
                (1.0 - PartOfFactor) * static_cast<double>(first) / static_cast<double>(all)))
    {
      return cancelled;
    }
    const Eigen::Index count = std::min(Together, all - first);
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(3 * nodes, count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      const Eigen::Index component = (first + i) / harmonics;
      Eigen::Map<Eigen::Matrix3Xd>(columns.col(i).data(), 3, nodes).row(component) =
          integrals.col((first + i) % harmonics).transpose();
    }
    Status solved = solver.Solve(columns);
    if (!solved.IsOk())
    {
      return solved;
    }
    for (Eigen::Index i = 0; i < count; ++i)
    {
      const Eigen::Map<const Eigen::Matrix3Xd> moved(columns.col(i).data(), 3, nodes);
      Eigen::Map<Eigen::MatrixXd>(values.col(first + i).data(), harmonics, 3) =
          (moved * integrals).transpose();
    }
  }
  compliance.MaximumDegree = degree;
  compliance.Values = 0.5 * (values + values.transpose()); // of rounding
  return goesOn(1.0) ? Status::Success() : cancelled;
}

ReducedCompliance ReducedCompliance::Of(int degree, Eigen::MatrixXd matrix)
{
  ReducedCompliance compliance;
  compliance.MaximumDegree = degree;
  compliance.Values = std::move(matrix);
  return compliance;
}

ReducedCompliance ReducedCompliance::Truncated(int degree) const
{
  const Eigen::Index from = this->Values.rows() / 3;
  const auto to = static_cast<Eigen::Index>(SphericalHarmonicBasis::CoefficientCount(degree));
  Eigen::MatrixXd part(3 * to, 3 * to);
  for (Eigen::Index i = 0; i < 3; ++i)
  {
    for (Eigen::Index j = 0; j < 3; ++j)
    {
      part.block(i * to, j * to, to, to) = this->Values.block(i * from, j * from, to, to);
    }
  }
  return Of(degree, std::move(part));
}

Eigen::VectorXd ReducedCompliance::Traction(const HertzPatch& patch) const
{
  const SphericalHarmonicBasis basis(this->MaximumDegree);
  const auto harmonics = static_cast<Eigen::Index>(basis.Size());
  Eigen::VectorXd bump(harmonics);
  patch.Project(basis, bump.data());
  for (Eigen::Index l = 0; l <= this->MaximumDegree; ++l)
  {
    bump.segment(l * l, 2 * l + 1) *= Window(static_cast<double>(l), this->MaximumDegree);
  }
  Eigen::VectorXd traction(3 * harmonics);
  for (Eigen::Index component = 0; component < 3; ++component)
  {
    traction.segment(component * harmonics, harmonics) = -patch.Normal[component] * bump;
  }
  return traction;
}

Eigen::MatrixX3d ReducedCompliance::Displacement(const HertzPatch& patch) const
{
  const Eigen::VectorXd moved =
      this->Values.selfadjointView<Eigen::Lower>() * this->Traction(patch);
  const Eigen::Index harmonics = moved.size() / 3;
  Eigen::MatrixX3d coefficients = Eigen::Map<const Eigen::MatrixX3d>(moved.data(), harmonics, 3);
  for (Eigen::Index l = 0; l <= this->MaximumDegree; ++l)
  {
    coefficients.middleRows(l * l, 2 * l + 1) *=
        Window(static_cast<double>(l), this->MaximumDegree);
  }
  return coefficients;
}

double ReducedCompliance::Compliance(const HertzPatch& patch) const
{
  const Eigen::VectorXd traction = this->Traction(patch);
  return traction.dot(this->Values.selfadjointView<Eigen::Lower>() * traction);
}

double ReducedCompliance::Window(double degree, int degreeLimit) noexcept
{
  constexpr double HalfPi = 1.57079632679489661923;
  const double start = 0.5 * degreeLimit;
  const double end = degreeLimit + 0.5;
  const double part = std::clamp((degree - start) / (end - start), 0.0, 1.0);
  const double cosine = std::cos(HalfPi * part);
  return part < 1.0 ? cosine * cosine : 0.0;
}
} // namespace palpate
