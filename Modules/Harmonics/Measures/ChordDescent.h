#pragma once

#include "SurfaceModel.h"
#include "Vector3.h"

#include <vector>

namespace palpate
{
/// Makes the sum of squared chords of a curve on a surface model least, between fixed ends: the
/// work of Straightened.
class ChordDescent
{
public:
  /// At least two unit vectors of parameters. Keeps the address of the surface.
  ChordDescent(const SurfaceModel& surface, std::vector<Vector3> parameters);

  /// Until a step gains less than 1e-15 of the sum. False after `mostSteps`.
  bool Run(int mostSteps);

  const std::vector<Vector3>& Parameters() const noexcept { return this->Nodes; }
  std::vector<Vector3> Points() const;
  double Length() const noexcept; ///< of the chords, mm

private:
  using Sample = SurfaceModel::SecondOrderSample;
  using Step = Eigen::Vector2d;
  using Block = Eigen::Matrix2d;

  static double SumOf(const std::vector<Sample>& samples) noexcept;
  std::vector<Sample> At(const std::vector<Vector3>& nodes) const;
  // Halves of the gradient and of the Hessian's diagonal at an inner node.
  Step Slope(std::size_t node) const noexcept;
  Block Diagonal(std::size_t node, bool isNewton) const noexcept;
  bool Solve(bool isNewton, std::vector<Step>& steps) const;
  bool Improve(const std::vector<Step>& steps, double& gain);

  const SurfaceModel& Surface;
  std::vector<Vector3> Nodes;
  std::vector<Sample> Samples; // of the nodes
};
} // namespace palpate
