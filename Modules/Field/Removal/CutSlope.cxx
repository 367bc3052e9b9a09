#include "CutSlope.h"

#include "Median.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace palpate
{
namespace
{
// Statistics of some cells of a brick.
struct CellFacts
{
  std::vector<double> Slopes; // per mm, at centres of cells near which the surface passes
  std::vector<double> Depths; // margin of the condition, where it holds

  void Add(const double (&corners)[8], const FieldGrid& grid)
  {
    Vector3 gradient = Vector3::Zero();
    double mean = 0.0;
    for (int n = 0; n < 8; ++n)
    {
      const Vector3 side(n & 1, n >> 1 & 1, n >> 2);
      gradient += 0.25 * corners[n] * (2.0 * side - Vector3::Ones());
      mean += 0.125 * corners[n];
    }
    if (corners[0] > 0.0)
    {
      this->Depths.push_back(corners[0]);
    }
    const double slope = grid.GradientWorld(gradient).norm();
    if (std::abs(mean) < 0.5 * slope * grid.Spacing().minCoeff())
    {
      this->Slopes.push_back(slope);
    }
  }
};
} // namespace

double SlopeOfCuts(const ScalarField& field, const FieldCondition& condition)
{
  constexpr int Step = 7; // between sampled cells
  const BrickedChannel& channel = field.Channel(condition.Channel);
  const BrickLayout& layout = field.Layout();
  const int mask = layout.Cells - 1;
  CellFacts facts;
  for (std::size_t brick = 0; brick < layout.BrickCount(); ++brick)
  {
    const std::uint32_t block = channel.SlotOf(brick).Block;
    for (int cell = 0; block != BrickedChannel::NotStored && cell < 1 << (3 * layout.Shift);
         cell += Step)
    {
      const int node = layout.FirstNodeOfCell(cell & mask, cell >> layout.Shift & mask,
                                              cell >> (2 * layout.Shift));
      double corners[8];
      channel.Load<2>(block, node, corners);
      condition.Relate(corners, 8);
      facts.Add(corners, field.Grid());
    }
  }
  const double steepest = UpperMedian(facts.Depths) / field.Grid().Spacing().norm();
  const double slope = std::min(UpperMedian(facts.Slopes), steepest);
  return std::isfinite(slope) ? slope : 1.0;
}
} // namespace palpate
