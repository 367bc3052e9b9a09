#include "PartStatistics.h"

#include "MaskRuns.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
// The centroid of the runs of one component, in the world.
Vector3 CentroidOf(const RunSet& set, const std::vector<int>& components, int wanted,
                   const CheckedMask& mask)
{
  Vector3 sum = Vector3::Zero();
  double count = 0.0;
  for (std::size_t row = 0; row < set.Rows().size(); ++row)
  {
    for (std::size_t run = set.Rows()[row].Start; run < set.RowEnd(row); ++run)
    {
      if (components[run] == wanted)
      {
        const RowRun& of = set.Runs()[run];
        const double length = of.End - of.First;
        sum +=
            length * Vector3(0.5 * (of.First + of.End - 1), set.Rows()[row].Y, set.Rows()[row].Z);
        count += length;
      }
    }
  }
  return mask.WorldOfBox(sum / std::max(count, 1.0));
}

// Voxels outside of a slice's mask that no path over edges and corners joins with its border.
class SliceHoles
{
public:
  explicit SliceHoles(const VoxelMask& mask) : Mask(mask) {}

  void Fill(int k)
  {
    const std::size_t first = this->Mask.Offset(0, 0, k);
    const std::size_t count = this->Mask.Offset(0, 0, k + 1) - first;
    this->Reached.assign(this->Mask.Inside.begin() + static_cast<std::ptrdiff_t>(first),
                         this->Mask.Inside.begin() + static_cast<std::ptrdiff_t>(first + count));
    this->Reach(0, 0); // the rim is outside and of one piece
    while (!this->Open.empty())
    {
      const auto [i, j] = this->Open.back();
      this->Open.pop_back();
      for (int n = 0; n < 9; ++n)
      {
        this->Reach(i + n % 3 - 1, j + n / 3 - 1);
      }
    }
    this->Found = 0;
    this->Sum = Vector3::Zero();
    for (std::size_t at = 0; at < count; ++at)
    {
      if (this->Reached[at] == 0)
      {
        ++this->Found;
        const auto width = static_cast<std::size_t>(this->Mask.Size[0]);
        this->Sum += Vector3(static_cast<double>(at % width), static_cast<double>(at / width), k);
      }
    }
  }

  long long Count() const { return this->Found; }
  Vector3 Middle() const { return this->Sum / static_cast<double>(std::max(this->Found, 1LL)); }

private:
  void Reach(int i, int j)
  {
    if (i < 0 || j < 0 || i >= this->Mask.Size[0] || j >= this->Mask.Size[1])
    {
      return;
    }
    unsigned char& reached = this->Reached[this->Mask.Offset(i, j, 0)];
    if (reached == 0)
    {
      reached = 1;
      this->Open.emplace_back(i, j);
    }
  }

  const VoxelMask& Mask;
  std::vector<unsigned char> Reached; // or inside
  std::vector<std::pair<int, int>> Open;
  long long Found = 0;
  Vector3 Sum = Vector3::Zero();
};

MaskStatistic SliceHoleStatistic(const CheckedMask& mask, double voxels)
{
  MaskStatistic found{"slice_hole", 0.0, mask.Centroid(), 0.0};
  SliceHoles holes(mask.Voxels);
  long long all = 0;
  long long most = 0;
  for (int k = 0; k < mask.Voxels.Size[2]; ++k)
  {
    holes.Fill(k);
    all += holes.Count();
    if (holes.Count() > most)
    {
      most = holes.Count();
      found.Place = mask.WorldOfBox(holes.Middle());
    }
  }
  found.Value = static_cast<double>(all) / voxels;
  found.Amount = static_cast<double>(all) * mask.Voxels.VoxelVolume();
  return found;
}

MaskStatistic HoleStatistic(const CheckedMask& mask, double voxels)
{
  MaskStatistic found{"hole", 0.0, mask.Centroid(), 0.0};
  VoxelMask outside = mask.Voxels;
  for (unsigned char& voxel : outside.Inside)
  {
    voxel = voxel == 0 ? 1 : 0;
  }
  const RunSet runs = RunsOf(outside);
  const std::vector<int> regions = LabelRunComponents(runs, Neighborhood::Faces);
  std::vector<long long> counts = ComponentVoxels(runs, regions);
  counts.front() = 0; // the first run is of the rim, which is of one piece
  const auto most = std::max_element(counts.begin(), counts.end());
  if (*most == 0)
  {
    return found;
  }
  for (const long long one : counts)
  {
    found.Value += static_cast<double>(one) / voxels;
  }
  found.Amount = static_cast<double>(*most) * mask.Voxels.VoxelVolume();
  found.Place = CentroidOf(runs, regions, static_cast<int>(most - counts.begin()), mask);
  return found;
}
} // namespace

void MeasureParts(const CheckedMask& mask, MaskStatistics& statistics, CheckedMask& largest)
{
  largest = mask;
  std::fill(largest.Voxels.Inside.begin(), largest.Voxels.Inside.end(), 0);
  const RunSet runs = RunsOf(mask.Voxels);
  const std::vector<int> parts = LabelRunComponents(runs, Neighborhood::FacesEdgesCorners);
  std::vector<long long> counts = ComponentVoxels(runs, parts);
  if (counts.empty())
  {
    return;
  }
  const auto first =
      static_cast<int>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  SetRuns(
      runs, [&](std::size_t run) { return parts[run] == first; }, 1, largest.Voxels);
  const auto voxels = static_cast<double>(mask.Voxels.Count());
  MaskStatistic part{"part",
                     1.0 - static_cast<double>(counts[static_cast<std::size_t>(first)]) / voxels,
                     mask.Centroid(), 0.0};
  if (counts.size() > 1)
  {
    counts[static_cast<std::size_t>(first)] = 0;
    const auto second = std::max_element(counts.begin(), counts.end());
    part.Amount = static_cast<double>(*second) * mask.Voxels.VoxelVolume();
    part.Place = CentroidOf(runs, parts, static_cast<int>(second - counts.begin()), mask);
  }
  statistics.push_back(part);
  statistics.push_back(HoleStatistic(mask, voxels));
  statistics.push_back(SliceHoleStatistic(mask, voxels));
}
} // namespace palpate
