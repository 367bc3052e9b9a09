#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <utility>
#include <vector>

namespace palpate
{
/// Threshold-free cluster enhancement (Smith and Nichols, NeuroImage 44 (2009) 83) of a map on a
/// surface: at each point the integral over thresholds h from 0 to the value of area^0.5 h^2 dh,
/// where the area (mm^2) is that of the connected points at or above h. Exact, by a union of
/// components in descending order, where others sum over steps of h.
class ClusterEnhancement
{
public:
  /// `areas` of the points; `edges` between neighbours.
  ClusterEnhancement(std::vector<double> areas, const std::vector<std::pair<int, int>>& edges);

  /// Of the positive part of a map; 0 elsewhere. Allocates only in the first call.
  void Enhance(const Eigen::VectorXd& map, Eigen::VectorXd& enhanced);

private:
  std::size_t RootOf(std::size_t point);
  double TotalOf(std::size_t point) const;
  void BringTo(std::size_t root, double height);
  void Join(std::size_t one, std::size_t other, double height);

  std::vector<double> Areas;
  std::vector<std::size_t> FirstNeighbour;
  std::vector<int> Neighbours;
  // Of a root: its area, the integral and the height down to which that reaches. Of others: what to
  // add to the integral of their parent.
  std::vector<std::size_t> Parent;
  std::vector<double> Area;
  std::vector<double> Integral;
  std::vector<double> Height;
  std::vector<int> Order;
};
} // namespace palpate
