#include "ReducedCompliance.h"

#include "GaussLegendre.h"
#include "SphericalHarmonicBasis.h"
#include "StiffnessCondensation.h"

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

// Each harmonic as a traction along each axis.
LoadMatrix SurfaceLoads(const StarMesh& mesh, int degree)
{
  const Eigen::MatrixXd integrals = SurfaceIntegrals(mesh, degree);
  const Eigen::Index harmonics = integrals.cols();
  LoadMatrix loads(3 * integrals.rows(), 3 * harmonics);
  for (Eigen::Index row = 0; row < loads.rows(); ++row)
  {
    loads.startVec(row);
    for (Eigen::Index i = 0; i < harmonics; ++i)
    {
      if (const double integral = integrals(row / 3, i); integral != 0.0)
      {
        loads.insertBack(row, (row % 3) * harmonics + i) = integral;
      }
    }
  }
  loads.finalize();
  return loads;
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
  const auto goesOn = [&](double fraction) { return !progress || progress(fraction); };
  if (!goesOn(0.0))
  {
    return Status::Failure("Cancelled.");
  }
  Status condensed = CondenseStiffness(stiffness, NestedDissection(mesh.Places()),
                                       SurfaceLoads(mesh, degree), progress, compliance.Values);
  compliance.MaximumDegree = degree;
  return !condensed.IsOk() || goesOn(1.0) ? condensed : Status::Failure("Cancelled.");
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

Eigen::VectorXd ReducedCompliance::Pressure(const HertzPatch& patch) const
{
  const SphericalHarmonicBasis basis(this->MaximumDegree);
  Eigen::VectorXd bump(static_cast<Eigen::Index>(basis.Size()));
  patch.Project(basis, bump.data());
  for (Eigen::Index l = 0; l <= this->MaximumDegree; ++l)
  {
    bump.segment(l * l, 2 * l + 1) *= Window(static_cast<double>(l), this->MaximumDegree);
  }
  return bump;
}

Eigen::MatrixX3d ReducedCompliance::Displacement(const HertzPatch& patch) const
{
  const Eigen::VectorXd pressure = this->Pressure(patch);
  const Eigen::Index harmonics = pressure.size();
  Eigen::VectorXd traction(3 * harmonics);
  for (Eigen::Index component = 0; component < 3; ++component)
  {
    traction.segment(component * harmonics, harmonics) = -patch.Normal[component] * pressure;
  }
  const Eigen::VectorXd moved = this->Values.selfadjointView<Eigen::Lower>() * traction;
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
  return this->Compliances(patch.Normal, {patch}).front();
}

std::vector<double> ReducedCompliance::Compliances(const Vector3& normal,
                                                   const std::vector<HertzPatch>& patches) const
{
  const Eigen::Index harmonics = this->Values.rows() / 3;
  // Of the components along the normal. A product from both sides with one vector is the same with
  // a block below the diagonal as with that above it.
  Eigen::MatrixXd along = Eigen::MatrixXd::Zero(harmonics, harmonics);
  for (Eigen::Index column = 0; column < harmonics; ++column)
  {
    for (Eigen::Index i = 0; i < 3; ++i)
    {
      for (Eigen::Index j = 0; j <= i; ++j)
      {
        along.col(column) +=
            (i == j ? 1.0 : 2.0) * normal[i] * normal[j] *
            this->Values.col(j * harmonics + column).segment(i * harmonics, harmonics);
      }
    }
  }
  std::vector<double> compliances;
  compliances.reserve(patches.size());
  for (const HertzPatch& patch : patches)
  {
    const Eigen::VectorXd pressure = this->Pressure(patch);
    compliances.push_back(pressure.dot(along * pressure));
  }
  return compliances;
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
