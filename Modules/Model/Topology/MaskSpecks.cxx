#include "MaskSpecks.h"

#include "MaskRuns.h"

#include <cstddef>
#include <vector>

namespace palpate
{
namespace
{
// The middle and the diagonal of the box of a component.
void DescribePlace(const RunSet& runs, const std::vector<int>& components, int wanted,
                   const VoxelMask& mask, TopologyChange& change)
{
  Vector3 first = Vector3::Constant(1e300);
  Vector3 last = Vector3::Constant(-1e300);
  for (std::size_t row = 0; row < runs.Rows().size(); ++row)
  {
    const RunSet::Row& at = runs.Rows()[row];
    for (std::size_t run = at.Start; run < runs.RowEnd(row); ++run)
    {
      if (components[run] == wanted)
      {
        first = first.cwiseMin(Vector3(runs.Runs()[run].First, at.Y, at.Z));
        last = last.cwiseMax(Vector3(runs.Runs()[run].End - 1, at.Y, at.Z));
      }
    }
  }
  const Vector3 spacing(mask.Spacing[0], mask.Spacing[1], mask.Spacing[2]);
  change.LargestCentre = spacing.cwiseProduct(0.5 * (first + last));
  change.LargestExtent = spacing.cwiseProduct(last - first + Vector3::Ones()).norm();
}
} // namespace

TopologyChange DropSpecks(double small, VoxelMask& mask)
{
  const RunSet runs = RunsOf(mask);
  const std::vector<int> components = LabelRunComponents(runs, Neighborhood::FacesEdgesCorners);
  const std::vector<long long> voxels = ComponentVoxels(runs, components);
  const double few = small * static_cast<double>(mask.Count());
  TopologyChange dropped;
  long long sum = 0;
  int largest = -1;
  for (std::size_t part = 0; part < voxels.size(); ++part)
  {
    if (static_cast<double>(voxels[part]) < few)
    {
      ++dropped.Count;
      sum += voxels[part];
      largest = largest < 0 || voxels[part] > voxels[static_cast<std::size_t>(largest)]
                    ? static_cast<int>(part)
                    : largest;
    }
  }
  if (dropped.Count == static_cast<int>(voxels.size()) || !(static_cast<double>(sum) > few))
  {
    return {};
  }
  dropped.Volume = static_cast<double>(sum) * mask.VoxelVolume();
  dropped.LargestVolume =
      static_cast<double>(voxels[static_cast<std::size_t>(largest)]) * mask.VoxelVolume();
  DescribePlace(runs, components, largest, mask, dropped);
  SetRuns(
      runs,
      [&](std::size_t run)
      { return static_cast<double>(voxels[static_cast<std::size_t>(components[run])]) < few; },
      0, mask);
  return dropped;
}
} // namespace palpate
