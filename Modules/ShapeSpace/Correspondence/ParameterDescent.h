#pragma once

#include "DescriptionLength.h"
#include "GroupReparametrisation.h"
#include "IcosahedronDirections.h"
#include "SphereFlow.h"

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// The descent of ReparametriseGroup: the surfaces at the nodes of an icosahedron, and the flows of
/// their parameters.
class ParameterDescent
{
public:
  ParameterDescent(const std::vector<SurfaceModel>& surfaces,
                   const ReparametrisationSettings& settings);

  double Length() const noexcept { return this->Now.Value; }
  double Variance() const noexcept { return this->Now.Variance; }
  const SphereFlow& FlowOf(std::size_t i) const { return this->Flows[i]; }

  /// One round. Returns false if no step shortens the description.
  bool Step();
  /// Gives those back their own parameters that are as well off with them.
  void DropUselessMoves();
  /// Of other surfaces, with the same weights.
  DescriptionLength Measure(const std::vector<SurfaceModel>& surfaces) const;

private:
  /// A case's minimiser of its squared distance from what the others predict.
  struct Wish
  {
    Eigen::MatrixXd Inverse; ///< of the damped curvature
    Eigen::VectorXd Step;    ///< coefficients of the field, harmonic by harmonic
  };

  Eigen::VectorXd ColumnOf(const SurfaceModel& surface, const std::vector<Vector3>& nodes) const;
  Wish WishOf(std::size_t i, const Eigen::MatrixXd& pulled) const;
  std::vector<SphereFlow::Field> FieldsOf(const std::vector<Wish>& wishes) const;
  double UnfoldedShare(std::size_t i, const std::vector<Vector3>& tangents, double share) const;
  bool Try(const std::vector<SphereFlow::Field>& fields, double share);

  const std::vector<SurfaceModel>& Surfaces;
  const ReparametrisationSettings& Settings;
  IcosahedronDirections Sphere;
  Eigen::VectorXd Roots; // of the nodes' shares of the mean surface
  std::vector<SphereFlow> Flows;
  std::vector<std::vector<Vector3>> Places; // of the nodes on each surface
  Eigen::MatrixXd Shapes;                   // see MeasureDescriptionLength
  DescriptionLength Now;
  double Share = 1.0; // of the last step
};
} // namespace palpate
