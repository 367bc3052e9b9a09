#include "PalpationSearch.h"

#include "ForcePerception.h"
#include "Median.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>

namespace palpate
{
namespace
{
double MeanOf(const PalpationSearch::Press& press, const FreePlace& place, int times)
{
  double sum = 0.0;
  for (int i = 0; i < times; ++i)
  {
    sum += press(place);
  }
  return sum / times;
}

// Of the largest values, the largest first.
std::vector<std::size_t> Largest(const std::vector<double>& values, int count)
{
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t kept = std::min(values.size(), static_cast<std::size_t>(count));
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept), order.end(),
                    [&values](std::size_t a, std::size_t b) { return values[a] > values[b]; });
  order.resize(kept);
  return order;
}
} // namespace

std::vector<FreePlace> PalpationSearch::Raster(std::uint64_t seed) const
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> fraction(0.0, 1.0);
  const Eigen::Rotation2Dd turn(2.0 * M_PI * fraction(random));
  const double across = fraction(random);
  const double along = fraction(random);
  const int steps = static_cast<int>(std::ceil(this->Way.Reach / this->Way.Spacing)) + 1;
  std::vector<FreePlace> places;
  for (int j = -steps; j <= steps; ++j)
  {
    for (int i = -steps; i <= steps; ++i)
    {
      const FreePlace place = this->Way.Spacing * FreePlace(i + across, j + along);
      if (place.norm() <= this->Way.Reach)
      {
        places.emplace_back(turn * place);
      }
    }
  }
  return places;
}

std::optional<PalpationSearch::Finding> PalpationSearch::Search(const Press& press,
                                                                std::uint64_t seed) const
{
  const std::vector<FreePlace> places = this->Raster(seed);
  std::vector<double> felt;
  felt.reserve(places.size());
  for (const FreePlace& place : places)
  {
    felt.push_back(MeanOf(press, place, this->Way.Sweeps));
  }
  std::vector<double> sorted = felt;
  const double usual = UpperMedian(sorted);
  std::optional<Finding> finding;
  for (const std::size_t suspect : Largest(felt, this->Way.Suspects))
  {
    // The presses that made it a suspect are too high on average, and do not count.
    const double again = MeanOf(press, places[suspect], this->Way.Returns);
    const double contrast = ForcePerception::Contrast(again, usual);
    if (contrast > this->Way.Threshold && (!finding || contrast > finding->Contrast))
    {
      finding = Finding{places[suspect], contrast, usual};
    }
  }
  return finding;
}
} // namespace palpate
