#include "NeckStatistic.h"

#include "DisjointSets.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

namespace palpate
{
namespace
{
constexpr double LeastShare = 0.01; // of the voxels, of a body

// Bodies that grow from the deepest voxels on.
class GrowingBodies
{
public:
  GrowingBodies(const VoxelMask& mask, const std::vector<float>& depths)
      : Mask(mask), Depths(depths)
  {
    for (std::size_t at = 0; at < mask.Inside.size(); ++at)
    {
      if (mask.Inside[at] != 0)
      {
        this->Order.push_back(static_cast<std::uint32_t>(at));
      }
    }
    std::sort(this->Order.begin(), this->Order.end(),
              [&depths](std::uint32_t a, std::uint32_t b)
              { return depths[a] != depths[b] ? depths[a] > depths[b] : a < b; });
    this->Sets.assign(mask.Inside.size(), None);
  }

  void Grow()
  {
    DisjointSets sets(this->Order.size());
    this->Peaks.resize(this->Order.size());
    this->Counts.assign(this->Order.size(), 1);
    for (std::uint32_t n = 0; n < this->Order.size(); ++n)
    {
      const std::uint32_t at = this->Order[n];
      this->Sets[at] = n;
      this->Peaks[n] = this->Depths[at];
      this->JoinNeighbours(n, sets);
    }
  }

  double Neck = 0.0;
  double Depth = 0.0; ///< of the saddle, mm
  std::size_t Place = 0;

private:
  static constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();

  void JoinNeighbours(std::uint32_t n, DisjointSets& sets)
  {
    const auto row = static_cast<std::ptrdiff_t>(this->Mask.Offset(0, 1, 0));
    const auto slice = static_cast<std::ptrdiff_t>(this->Mask.Offset(0, 0, 1));
    const auto at = static_cast<std::ptrdiff_t>(this->Order[n]);
    for (std::ptrdiff_t dk = -1; dk <= 1; ++dk)
    {
      for (std::ptrdiff_t dj = -1; dj <= 1; ++dj)
      {
        for (std::ptrdiff_t di = -1; di <= 1; ++di)
        {
          // Inside voxels have neighbours in the box, which has a rim.
          const std::uint32_t other =
              this->Sets[static_cast<std::size_t>(at + di + dj * row + dk * slice)];
          if (other != None)
          {
            this->Meet(sets.Root(other), sets.Root(n), n, sets);
          }
        }
      }
    }
  }

  // Roots are the first, and so the deepest, voxels of their bodies.
  void Meet(std::size_t a, std::size_t b, std::uint32_t saddle, DisjointSets& sets)
  {
    if (a == b)
    {
      return;
    }
    const std::size_t dying = std::max(a, b);
    const double depth = this->Depths[this->Order[saddle]];
    const double neck = 1.0 - depth / this->Peaks[dying];
    if (neck > this->Neck &&
        this->Counts[dying] >= LeastShare * static_cast<double>(this->Order.size()))
    {
      this->Neck = neck;
      this->Depth = depth;
      this->Place = this->Order[saddle];
    }
    this->Counts[std::min(a, b)] += this->Counts[dying];
    sets.Join(a, b);
  }

  const VoxelMask& Mask;
  const std::vector<float>& Depths;
  std::vector<std::uint32_t> Order; // voxels, the deepest first
  std::vector<std::uint32_t> Sets;  // of voxels: their place in the order
  std::vector<float> Peaks;
  std::vector<double> Counts;
};
} // namespace

void MeasureNeck(const CheckedMask& part, const std::vector<float>& depths,
                 MaskStatistics& statistics)
{
  GrowingBodies bodies(part.Voxels, depths);
  bodies.Grow();
  MaskStatistic neck{"neck", bodies.Neck, part.Centroid(), 2.0 * bodies.Depth};
  if (bodies.Neck > 0.0)
  {
    const auto width = static_cast<std::size_t>(part.Voxels.Size[0]);
    const auto height = static_cast<std::size_t>(part.Voxels.Size[1]);
    neck.Place = part.WorldOfBox(Vector3(static_cast<double>(bodies.Place % width),
                                         static_cast<double>(bodies.Place / width % height),
                                         static_cast<double>(bodies.Place / width / height)));
  }
  statistics.push_back(neck);
}
} // namespace palpate
