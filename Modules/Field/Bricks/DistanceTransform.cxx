#include "DistanceTransform.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// Lower envelopes along lines of one length; the buffers are reused between lines.
class LineTransform
{
public:
  LineTransform(int length, double spacing)
      : Length(length), Spacing(spacing), Heights(static_cast<std::size_t>(length)),
        Apexes(static_cast<std::size_t>(length)), Starts(static_cast<std::size_t>(length) + 1)
  {
  }

  // Replaces the squared distances of a line by min_q (f(q) + (spacing (p - q))^2).
  void Run(float* first, std::size_t stride)
  {
    for (int q = 0; q < this->Length; ++q)
    {
      this->Heights[Index(q)] = first[Index(q) * stride];
    }
    const int parabolas = this->BuildEnvelope();
    if (parabolas == 0)
    {
      return;
    }
    int k = 0;
    for (int p = 0; p < this->Length; ++p)
    {
      while (k + 1 < parabolas && this->Starts[Index(k + 1)] < p)
      {
        ++k;
      }
      const int apex = this->Apexes[Index(k)];
      const double step = this->Spacing * (p - apex);
      first[Index(p) * stride] = static_cast<float>(step * step + this->Heights[Index(apex)]);
    }
  }

private:
  static std::size_t Index(int i) { return static_cast<std::size_t>(i); }

  // Where, in voxels, the parabola with apex q falls below the one with the earlier apex p.
  double Crossing(int p, int q) const
  {
    const double square = this->Spacing * this->Spacing;
    const double rise = this->Heights[Index(q)] - this->Heights[Index(p)];
    return 0.5 * (rise / (square * (q - p)) + q + p);
  }

  int BuildEnvelope()
  {
    int count = 0;
    for (int q = 0; q < this->Length; ++q)
    {
      if (this->Heights[Index(q)] == Infinity)
      {
        continue;
      }
      while (count > 0 &&
             this->Crossing(this->Apexes[Index(count - 1)], q) <= this->Starts[Index(count - 1)])
      {
        --count;
      }
      this->Starts[Index(count)] =
          count > 0 ? this->Crossing(this->Apexes[Index(count - 1)], q) : -Infinity;
      this->Apexes[Index(count++)] = q;
    }
    return count;
  }

  int Length;
  double Spacing;
  std::vector<double> Heights;
  std::vector<int> Apexes;
  std::vector<double> Starts; // from where each apex is the lowest, in voxels
};
} // namespace

std::vector<float> DistanceToOthers(const VoxelMask& mask, unsigned char value,
                                    DistanceDomain domain)
{
  std::vector<float> squared(mask.Inside.size());
  for (std::size_t at = 0; at < squared.size(); ++at)
  {
    squared[at] = mask.Inside[at] == value ? std::numeric_limits<float>::infinity() : 0.0f;
  }
  const std::array<std::size_t, 3> strides{1, mask.Offset(0, 1, 0), mask.Offset(0, 0, 1)};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (axis == static_cast<std::size_t>(domain))
    {
      continue;
    }
    LineTransform line(mask.Size[axis], mask.Spacing[axis]);
    const std::size_t second = axis == 0 ? 1 : 0;
    const std::size_t third = axis == 2 ? 1 : 2;
    for (int k = 0; k < mask.Size[third]; ++k)
    {
      for (int j = 0; j < mask.Size[second]; ++j)
      {
        line.Run(&squared[static_cast<std::size_t>(k) * strides[third] +
                          static_cast<std::size_t>(j) * strides[second]],
                 strides[axis]);
      }
    }
  }
  for (float& distance : squared)
  {
    distance = std::sqrt(distance);
  }
  return squared;
}

std::vector<float> SignedDistance(const VoxelMask& mask, DistanceDomain domain, double halfStep)
{
  const std::vector<float> inner = DistanceToOthers(mask, 1, domain);
  const std::vector<float> outer = DistanceToOthers(mask, 0, domain);
  const auto half = static_cast<float>(halfStep);
  std::vector<float> field(inner.size());
  for (std::size_t at = 0; at < field.size(); ++at)
  {
    field[at] = mask.Inside[at] != 0 ? inner[at] - half : half - outer[at];
  }
  return field;
}

std::vector<float> BoundedDistances(std::vector<float> distances, double bound)
{
  const auto most = static_cast<float>(bound);
  for (float& distance : distances)
  {
    distance = std::clamp(distance, -most, most);
  }
  return distances;
}
} // namespace palpate
