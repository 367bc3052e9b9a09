#include "UncertainStiffness.h"

#include "FieldBuilder.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double VoxelsAlong = 24.0;
constexpr double LeastSpacing = 1.0;     // mm
constexpr double LargestExtent = 1000.0; // mm
// Beyond the points: what the stiffness blends in, and a voxel more.
constexpr double MarginVoxels = StiffnessImage::FadeVoxels + 2.0;

FieldGrid GridAround(const Vector3& least, const Vector3& extent)
{
  const double spacing = std::max(LeastSpacing, extent.maxCoeff() / VoxelsAlong);
  std::array<int, 3> size{};
  for (int axis = 0; axis < 3; ++axis)
  {
    size[static_cast<std::size_t>(axis)] =
        1 + static_cast<int>(std::ceil(extent[axis] / spacing + 2.0 * MarginVoxels));
  }
  return {size, least - Vector3::Constant(MarginVoxels * spacing), Vector3::Constant(spacing),
          Matrix3::Identity()};
}

// Values of some voxels, which grow over the others.
class SpreadValues
{
public:
  explicit SpreadValues(const FieldGrid& grid)
      : Size(grid.Size()), Sums(SamplesOf(grid), 0.0), Weights(Sums.size(), 0.0)
  {
  }
  void Add(const Vector3& pointIndex, double value)
  {
    const std::size_t at = this->At(static_cast<int>(std::lround(pointIndex[0])),
                                    static_cast<int>(std::lround(pointIndex[1])),
                                    static_cast<int>(std::lround(pointIndex[2])));
    this->Sums[at] += value;
    this->Weights[at] += 1.0;
  }
  // Each voxel without a value takes the mean of its neighbours, as long as there is one.
  std::vector<double> Filled()
  {
    std::vector<double> values(this->Sums.size());
    std::vector<char> isSet(values.size());
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      isSet[n] = this->Weights[n] > 0.0 ? 1 : 0;
      values[n] = isSet[n] != 0 ? this->Sums[n] / this->Weights[n] : 0.0;
    }
    while (std::find(isSet.begin(), isSet.end(), 0) != isSet.end())
    {
      this->Grow(values, isSet);
    }
    return values;
  }

private:
  static std::size_t SamplesOf(const FieldGrid& grid)
  {
    return SamplesOfGrid(static_cast<const double*>(nullptr), grid).Count();
  }
  std::size_t At(int i, int j, int k) const
  {
    const auto one = [](int n) { return static_cast<std::size_t>(n); };
    return (one(k) * one(this->Size[1]) + one(j)) * one(this->Size[0]) + one(i);
  }
  void Grow(std::vector<double>& values, std::vector<char>& isSet) const
  {
    const std::vector<char> before = isSet;
    for (int k = 0; k < this->Size[2]; ++k)
    {
      for (int j = 0; j < this->Size[1]; ++j)
      {
        for (int i = 0; i < this->Size[0]; ++i)
        {
          const std::size_t at = this->At(i, j, k);
          if (before[at] == 0)
          {
            isSet[at] = this->MeanAround({{i, j, k}}, before, values) ? 1 : 0;
          }
        }
      }
    }
  }
  // Neighbours over faces.
  bool MeanAround(const std::array<int, 3>& index, const std::vector<char>& isSet,
                  std::vector<double>& values) const
  {
    double sum = 0.0;
    int count = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const int step : {-1, 1})
      {
        std::array<int, 3> next = index;
        next[axis] += step;
        const bool isInside = next[axis] >= 0 && next[axis] < this->Size[axis];
        const std::size_t at = isInside ? this->At(next[0], next[1], next[2]) : 0;
        if (isInside && isSet[at] != 0)
        {
          sum += values[at];
          ++count;
        }
      }
    }
    if (count > 0)
    {
      values[this->At(index[0], index[1], index[2])] = sum / count;
    }
    return count > 0;
  }

  std::array<int, 3> Size;
  std::vector<double> Sums;
  std::vector<double> Weights;
};
} // namespace

Status MakeUncertainStiffness(const std::vector<Vector3>& pointsWorld,
                              const std::vector<double>& deviations, double own,
                              std::shared_ptr<const StiffnessImage>& made)
{
  bool areValid = !pointsWorld.empty() && pointsWorld.size() == deviations.size() && own >= 0.0 &&
                  std::isfinite(own);
  Vector3 least = areValid ? pointsWorld.front() : Vector3::Zero();
  Vector3 most = least;
  for (std::size_t n = 0; areValid && n < pointsWorld.size(); ++n)
  {
    areValid = pointsWorld[n].allFinite() && deviations[n] >= 0.0 && std::isfinite(deviations[n]);
    least = least.cwiseMin(pointsWorld[n]);
    most = most.cwiseMax(pointsWorld[n]);
  }
  const Vector3 extent = most - least;
  if (!areValid || !(extent.maxCoeff() <= LargestExtent))
  {
    return Status::Failure("A surface's standard deviations are missing or not finite, or its "
                           "points are too far apart.");
  }
  const FieldGrid grid = GridAround(least, extent);
  SpreadValues shares(grid); // of the own stiffness
  for (std::size_t n = 0; n < pointsWorld.size(); ++n)
  {
    shares.Add(grid.PointIndex(pointsWorld[n]),
               1.0 / (1.0 + own * deviations[n] / UncertaintyForce));
  }
  const std::vector<double> values = shares.Filled();
  FieldBuilder builder(grid);
  builder.AddChannel(SamplesOfGrid(values.data(), grid));
  builder.KeepAll();
  std::shared_ptr<const ScalarField> field;
  Status status = builder.Build(field);
  return status.IsOk() ? StiffnessImage::Make(field, 0, {0.0, 1.0, 0.0, own}, made) : status;
}
} // namespace palpate
