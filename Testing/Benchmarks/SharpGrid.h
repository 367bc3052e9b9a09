#pragma once

#include "RadialModel.h"

#include <memory>
#include <vector>

namespace palpate::bench
{
/// Radius and gradient on a whole grid of latitudes (Gauss nodes) and longitudes by libsharp, on
/// one core: the fastest library for grids.
class SharpGrid
{
public:
  SharpGrid(int degree, const std::vector<double>& coefficients, int rings, int columns);
  ~SharpGrid();
  SharpGrid(const SharpGrid&) = delete;
  SharpGrid& operator=(const SharpGrid&) = delete;

  /// Ring by ring from north to south, longitudes from 0 eastwards.
  const std::vector<Vector3>& Directions() const { return this->Nodes; }
  void Run();
  /// Result of the last run at a node.
  RadialModel::Sample At(std::size_t node) const;

private:
  struct Plan;
  std::unique_ptr<Plan> Work;
  std::vector<Vector3> Nodes;
  std::vector<double> Radii;
  std::vector<double> AlongTheta;
  std::vector<double> AlongPhi; // divided by the sine of the polar angle
};
} // namespace palpate::bench
