#pragma once

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// An elastic sphere of concentric layers on a bed all round, in closed form: solutions of Navier's
/// equation in vector spherical harmonics, four powers of the radius for each degree in each layer.
/// The truth that approximations are measured against.
class LayeredSphere
{
public:
  struct Layer
  {
    double OuterRadius; ///< mm
    double Modulus;     ///< Young's, N/mm^2
  };

  /// From inside to outside, at least one, with growing radii; `poissonRatio` in [0, 0.5);
  /// `bedStiffness` in N/mm^3.
  LayeredSphere(std::vector<Layer> layers, double poissonRatio, double bedStiffness);

  double Radius() const noexcept { return this->Layers.back().OuterRadius; }

  /// Displacement (U, V) of the surface, U Y e_r + V grad Y on the unit sphere (mm), under the
  /// traction T_r Y e_r + T_t grad Y (N/mm^2): the columns are for T_r = 1 and T_t = 1. Allocates.
  Eigen::Matrix2d Response(int degree) const;

  /// Mean displacement (mm/N) along the normal under a Hertz bump of radius `patchRadius` (mm,
  /// less than the sphere's) in the tangent plane that pushes along that plane's normal, weighted
  /// with the bump itself. Allocates.
  double Compliance(double patchRadius) const;

private:
  std::vector<Layer> Layers;
  double PoissonRatio;
  double BedStiffness; // N/mm^3
};
} // namespace palpate
