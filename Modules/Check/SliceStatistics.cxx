#include "SliceStatistics.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace palpate
{
namespace
{
constexpr const char* SideNames[] = {"left",     "right",    "posterior",
                                     "anterior", "superior", "inferior"};

// Voxels and first moments of the slices across each axis.
struct SliceAreas
{
  std::array<std::vector<long long>, 3> Counts;
  std::vector<Vector3> Middles; ///< of slices along the last axis, box indices

  explicit SliceAreas(const VoxelMask& mask)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Counts[axis].assign(static_cast<std::size_t>(mask.Size[axis]), 0);
    }
    this->Middles.assign(this->Counts[2].size(), Vector3::Zero());
    std::size_t at = 0;
    for (int k = 0; k < mask.Size[2]; ++k)
    {
      const auto slice = static_cast<std::size_t>(k);
      for (int j = 0; j < mask.Size[1]; ++j)
      {
        for (int i = 0; i < mask.Size[0]; ++i)
        {
          if (mask.Inside[at++] != 0)
          {
            ++this->Counts[0][static_cast<std::size_t>(i)];
            ++this->Counts[1][static_cast<std::size_t>(j)];
            ++this->Counts[2][slice];
            this->Middles[slice] += Vector3(i, j, k);
          }
        }
      }
      this->Middles[slice] /= static_cast<double>(std::max(this->Counts[2][slice], 1LL));
    }
  }

  static double Largest(const std::vector<long long>& counts)
  {
    return static_cast<double>(*std::max_element(counts.begin(), counts.end()));
  }
};

// Voxels that are in one of the slices k and k + 1 only.
long long DifferenceOf(const VoxelMask& mask, int k)
{
  const auto first = mask.Inside.begin() + static_cast<std::ptrdiff_t>(mask.Offset(0, 0, k));
  const auto second = mask.Inside.begin() + static_cast<std::ptrdiff_t>(mask.Offset(0, 0, k + 1));
  long long count = 0;
  for (std::ptrdiff_t at = 0; at < second - first; ++at)
  {
    count += first[at] != second[at] ? 1 : 0;
  }
  return count;
}

MaskStatistic GapStatistic(const CheckedMask& mask, const SliceAreas& areas)
{
  const std::vector<long long>& counts = areas.Counts[2];
  MaskStatistic found{"gap", 0.0, mask.Centroid(), 0.0};
  std::size_t last = 0; // filled slice
  for (std::size_t k = 1; k < counts.size(); ++k)
  {
    if (counts[k] == 0)
    {
      continue;
    }
    if (counts[last] > 0 && k > last + 1)
    {
      const double value =
          static_cast<double>(std::min(counts[last], counts[k])) / SliceAreas::Largest(counts);
      if (value > found.Value)
      {
        found.Value = value;
        found.Amount = static_cast<double>(k - last - 1);
        found.Place = mask.WorldOfBox(0.5 * (areas.Middles[last] + areas.Middles[k]));
      }
    }
    last = k;
  }
  return found;
}

MaskStatistic CopiedStatistic(const CheckedMask& mask, const SliceAreas& areas)
{
  MaskStatistic found{"copied", 0.0, mask.Centroid(), 1.0};
  int pairs = 0;
  int equal = 0;
  int run = 1;
  for (int k = 0; k + 1 < mask.Voxels.Size[2]; ++k)
  {
    const auto slice = static_cast<std::size_t>(k);
    const long long area = std::min(areas.Counts[2][slice], areas.Counts[2][slice + 1]);
    if (area == 0)
    {
      run = 1;
      continue;
    }
    ++pairs;
    const bool isEqual = 100 * DifferenceOf(mask.Voxels, k) <= area;
    equal += isEqual ? 1 : 0;
    run = isEqual ? run + 1 : 1;
    if (run > found.Amount)
    {
      found.Amount = run;
      found.Place = mask.WorldOfBox(areas.Middles[slice]);
    }
  }
  found.Value = pairs > 0 ? static_cast<double>(equal) / pairs : 0.0;
  return found;
}

MaskStatistic BorderStatistic(const CheckedMask& mask)
{
  const VoxelMask& voxels = mask.Voxels;
  MaskStatistic found{"border", 0.0, mask.Centroid(), 0.0};
  Vector3 sum = Vector3::Zero();
  double faces = 0.0;
  std::size_t at = 0;
  for (int k = 0; k < voxels.Size[2]; ++k)
  {
    for (int j = 0; j < voxels.Size[1]; ++j)
    {
      for (int i = 0; i < voxels.Size[0]; ++i)
      {
        if (voxels.Inside[at++] == 0)
        {
          continue;
        }
        const std::array<int, 3> index{i, j, k};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          const int image = index[axis] + voxels.StartIndex[axis];
          const int ends = (image == 0 ? 1 : 0) + (image == mask.ImageSize[axis] - 1 ? 1 : 0);
          found.Amount += ends * voxels.VoxelVolume() / voxels.Spacing[axis];
          sum += ends * Vector3(i, j, k);
          faces += ends;
        }
      }
    }
  }
  const double volume = static_cast<double>(voxels.Count()) * voxels.VoxelVolume();
  found.Value = volume > 0.0 ? found.Amount / std::pow(volume, 2.0 / 3.0) : 0.0;
  if (faces > 0.0)
  {
    found.Place = mask.WorldOfBox(sum / faces);
  }
  return found;
}

// The centre of the voxels of a slice across an axis.
Vector3 MiddleOfSlice(const VoxelMask& mask, std::size_t axis, int slice)
{
  Vector3 sum = Vector3::Zero();
  double count = 0.0;
  std::array<int, 3> at{};
  std::array<int, 3> first{0, 0, 0};
  std::array<int, 3> end = mask.Size;
  first[axis] = slice;
  end[axis] = slice + 1;
  for (at[2] = first[2]; at[2] < end[2]; ++at[2])
  {
    for (at[1] = first[1]; at[1] < end[1]; ++at[1])
    {
      for (at[0] = first[0]; at[0] < end[0]; ++at[0])
      {
        const double one = mask.Inside[mask.Offset(at[0], at[1], at[2])];
        sum += one * Vector3(at[0], at[1], at[2]);
        count += one;
      }
    }
  }
  return sum / std::max(count, 1.0);
}

MaskStatistic StepStatistic(const CheckedMask& part, const SliceAreas& areas)
{
  MaskStatistic found{"step", 0.0, part.Centroid(), 0.0};
  const double least = SliceAreas::Largest(areas.Counts[2]) / 3.0;
  for (int k = 0; k + 1 < part.Voxels.Size[2]; ++k)
  {
    const auto slice = static_cast<std::size_t>(k);
    const auto one = static_cast<double>(areas.Counts[2][slice]);
    const auto next = static_cast<double>(areas.Counts[2][slice + 1]);
    if (std::min(one, next) < least || least == 0.0)
    {
      continue;
    }
    const double value = 2.0 * static_cast<double>(DifferenceOf(part.Voxels, k)) / (one + next);
    if (value > found.Value)
    {
      found.Value = value;
      found.Amount = 100.0 * value;
      found.Place = part.WorldOfBox(0.5 * (areas.Middles[slice] + areas.Middles[slice + 1]));
    }
  }
  return found;
}
} // namespace

void MeasureSlices(const CheckedMask& mask, MaskStatistics& statistics)
{
  const SliceAreas areas(mask.Voxels);
  statistics.push_back(GapStatistic(mask, areas));
  statistics.push_back(CopiedStatistic(mask, areas));
  statistics.push_back(BorderStatistic(mask));
}

void MeasureEnds(const CheckedMask& part, MaskStatistics& statistics)
{
  const SliceAreas areas(part.Voxels);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::vector<long long>& counts = areas.Counts[axis];
    const auto isFilled = [](long long count) { return count > 0; };
    const auto low = std::find_if(counts.begin(), counts.end(), isFilled) - counts.begin();
    const auto high = counts.rend() - std::find_if(counts.rbegin(), counts.rend(), isFilled) - 1;
    const Vector3 direction = part.ToWorld.Axes.col(static_cast<Eigen::Index>(axis));
    for (const bool isHigh : {false, true})
    {
      const auto slice = static_cast<std::size_t>(isHigh ? high : low);
      const double value = static_cast<double>(counts[slice]) / SliceAreas::Largest(counts);
      const int side = PatientSideOf(isHigh ? direction : Vector3(-direction));
      statistics.push_back(
          {(axis == 2 ? "end_" : "edge_") + std::string(SideNames[side]), value,
           part.WorldOfBox(MiddleOfSlice(part.Voxels, axis, static_cast<int>(slice))),
           100.0 * value});
    }
  }
  statistics.push_back(StepStatistic(part, areas));
}
} // namespace palpate
