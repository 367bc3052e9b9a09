#include "CaseMasks.h"

#include "IslandNeighbours.h"
#include "OrderedTasks.h"
#include "Units.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t MostOfWhole = 8; // structures that are judged as one body, too
constexpr double LargestOfWhole = 0.9; // of its volume that is one part
constexpr double NestedShare = 0.9;

// Voxels that two masks of one grid share.
long long SharedVoxels(const VoxelMask& a, const VoxelMask& b)
{
  std::array<int, 3> first{};
  std::array<int, 3> end{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    first[axis] = std::max(a.StartIndex[axis], b.StartIndex[axis]);
    end[axis] = std::min(a.StartIndex[axis] + a.Size[axis], b.StartIndex[axis] + b.Size[axis]);
  }
  const auto rowOf = [&](const VoxelMask& mask, int j, int k)
  {
    return &mask.Inside[mask.Offset(first[0] - mask.StartIndex[0], j - mask.StartIndex[1],
                                    k - mask.StartIndex[2])];
  };
  long long shared = 0;
  for (int k = first[2]; k < end[2] && first[0] < end[0]; ++k)
  {
    for (int j = first[1]; j < end[1]; ++j)
    {
      const unsigned char* const one = rowOf(a, j, k);
      const unsigned char* const other = rowOf(b, j, k);
      for (int i = 0; i < end[0] - first[0]; ++i)
      {
        shared += one[i] & other[i];
      }
    }
  }
  return shared;
}

// Keeps the larger share of an organ.
void TakeOverlap(double share, double volume, const CheckedOrgan& other, CheckedOrgan& organ)
{
  MaskStatistic& overlap = organ.Measured.Statistics.back();
  if (share <= NestedShare && share > overlap.Value)
  {
    overlap.Value = share;
    overlap.Amount = volume;
    overlap.Other = other.Name;
  }
}

void AddOverlaps(const CaseMasks& masks, CheckedCase& patient)
{
  std::vector<CheckedMask> made;
  for (std::size_t n = 0; n < masks.Structures.size(); ++n)
  {
    made.push_back(masks.MaskOf(n));
    MeasuredMask& measured = patient.Organs[n].Measured;
    measured.Statistics.push_back({"overlap", 0.0, measured.Centroid, 0.0});
  }
  for (std::size_t a = 0; a < made.size(); ++a)
  {
    for (std::size_t b = a + 1; b < made.size(); ++b)
    {
      if (masks.Structures[a].Layer == masks.Structures[b].Layer)
      {
        continue;
      }
      const std::array<double, 3>& spacing = made[a].Voxels.Spacing;
      const auto shared = static_cast<double>(SharedVoxels(made[a].Voxels, made[b].Voxels));
      const double volume = shared * spacing[0] * spacing[1] * spacing[2];
      CheckedOrgan& one = patient.Organs[a];
      CheckedOrgan& other = patient.Organs[b];
      const double least = CubicMillimetersPerMilliliter *
                           std::min(one.Measured.Milliliters, other.Measured.Milliliters);
      TakeOverlap(volume / least, volume, other, one);
      TakeOverlap(volume / least, volume, one, other);
    }
  }
}

void AddWhole(const CaseMasks& masks, const RadialProbe& probe, CheckedCase& patient)
{
  const std::size_t count = masks.Structures.size();
  if (count < 2 || count > MostOfWhole || !masks.AreOnOneGrid)
  {
    return;
  }
  CheckedOrgan whole{CheckedCase::WholeName, true, MeasureMask(masks.Union(), probe)};
  if (whole.Measured.Statistics.front().Value <= 1.0 - LargestOfWhole)
  {
    patient.Organs.push_back(std::move(whole));
  }
}
} // namespace

CheckedMask CaseMasks::Union() const
{
  std::vector<CheckedMask> masks;
  for (std::size_t n = 0; n < this->Structures.size(); ++n)
  {
    masks.push_back(this->MaskOf(n));
  }
  return UnionOf(masks);
}

CheckedCase MeasureCase(const CaseMasks& masks, const RadialProbe& probe, std::size_t atATime,
                        const std::function<void(double)>& report)
{
  CheckedCase patient;
  patient.IsOriented = masks.IsOriented;
  OrderedTasks<MeasuredMask> tasks(masks.Structures.size(), atATime,
                                   [&](std::size_t n)
                                   { return MeasureMask(masks.MaskOf(n), probe); });
  for (const CaseMasks::Structure& one : masks.Structures)
  {
    patient.Organs.push_back(
        {one.Name.empty() ? "label " + std::to_string(one.Label) : one.Name, false, tasks.Next()});
    if (report)
    {
      report(static_cast<double>(patient.Organs.size()) /
             static_cast<double>(masks.Structures.size()));
    }
  }
  if (masks.Structures.size() > 1 && masks.AreOnOneGrid)
  {
    NameIslandNeighbours(masks, patient);
  }
  if (masks.LayerCount > 1 && masks.AreOnOneGrid)
  {
    AddOverlaps(masks, patient);
  }
  AddWhole(masks, probe, patient);
  MeasureSides(patient);
  return patient;
}

std::vector<OrganJudgement> JudgeCase(CheckedCase& patient, const CheckGroup* group, double rate)
{
  if (group != nullptr)
  {
    return group->Judge(patient, rate);
  }
  std::vector<OrganJudgement> judged;
  std::transform(patient.Organs.begin(), patient.Organs.end(), std::back_inserter(judged),
                 [](const CheckedOrgan& organ) { return JudgeByRules(organ); });
  return judged;
}
} // namespace palpate
