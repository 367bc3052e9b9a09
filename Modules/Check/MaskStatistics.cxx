#include "MaskStatistics.h"

#include "DistanceTransform.h"
#include "NeckStatistic.h"
#include "PartStatistics.h"
#include "SliceStatistics.h"
#include "Units.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
// About 0.6 s for distances and their order.
constexpr std::size_t MostVoxels = 2'000'000;
} // namespace

MeasuredMask MeasureMask(CheckedMask mask, const RadialProbe& probe)
{
  mask = WithSlicesLast(std::move(mask));
  MeasuredMask measured;
  measured.Milliliters = static_cast<double>(mask.Voxels.Count()) * mask.Voxels.VoxelVolume() /
                         CubicMillimetersPerMilliliter;
  measured.Centroid = mask.Centroid();
  CheckedMask part;
  MeasureParts(mask, measured.Statistics, part);
  MeasureSlices(mask, measured.Statistics);
  MeasureEnds(part, measured.Statistics);
  part = Coarsened(std::move(part), MostVoxels);
  const std::vector<float> inner = DistanceToOthers(part.Voxels, 1, DistanceDomain::Space);
  MeasureNeck(part, inner, measured.Statistics);
  std::vector<float> depths = DistanceToOthers(part.Voxels, 0, DistanceDomain::Space);
  std::transform(inner.begin(), inner.end(), depths.begin(), depths.begin(),
                 [](float in, float out) { return in > 0.0f ? in : -out; });
  measured.Outline = probe.Measure(part, depths);
  measured.Statistics.push_back({"rough", measured.Outline.Residual, measured.Outline.Rough,
                                 100.0 * measured.Outline.Residual});
  return measured;
}
} // namespace palpate
