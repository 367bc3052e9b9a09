#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace palpate
{
/// Some unknowns of linear equations while the first of them are eliminated (a front of the
/// multifrontal method: Duff and Reid, ACM Trans. Math. Softw. 9, 1983): their stiffness, of which
/// the lower triangle counts, and their rows of the loads. Of further loads all rows are zero.
class DenseFront
{
public:
  /// All zero.
  DenseFront(Eigen::Index eliminated, Eigen::Index remaining, Eigen::Index loads);

  /// Of an unknown that is eliminated, and of an unknown not before it.
  double& Stiffness(Eigen::Index row, Eigen::Index column) { return this->Pivots(row, column); }
  double& Load(Eigen::Index row, Eigen::Index load) { return this->PivotLoads(row, load); }
  /// Adds what remains of another front, whose unknowns are at `places`, ascending.
  void Add(const DenseFront& other, const std::vector<Eigen::Index>& places);

  /// Eliminates, K = L L'. Adds the products of the loads, (L^-1 B)' (L^-1 B), to the lower
  /// triangle of `energy`. Calls `goesOn` for every few unknowns. Returns false if it does, or if
  /// the stiffness is not positive definite; then the front has no meaning any more. By BLAS, on
  /// the calling thread (see SingleBlasThread).
  bool Eliminate(const std::function<bool()>& goesOn, Eigen::MatrixXd& energy);

private:
  bool TakePivots(Eigen::Index first, Eigen::Index count);
  void ChangeRest(Eigen::Index first, Eigen::Index count);

  Eigen::MatrixXd Pivots; // columns of the eliminated, a row for each unknown
  Eigen::MatrixXd PivotLoads;
  Eigen::MatrixXd Rest;
  Eigen::MatrixXd RestLoads;
};
} // namespace palpate
