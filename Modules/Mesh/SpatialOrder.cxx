#include "SpatialOrder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>

namespace palpate
{
namespace
{
constexpr int Bits = 10; // of each coordinate

// With two zeros between the bits.
std::uint64_t Spread(std::uint64_t number)
{
  std::uint64_t spread = 0;
  for (int bit = 0; bit < Bits; ++bit)
  {
    spread |= (number >> bit & 1U) << 3 * bit;
  }
  return spread;
}
} // namespace

std::vector<int> SpatialOrder(const std::vector<Vector3>& points)
{
  Eigen::AlignedBox3d box;
  for (const Vector3& point : points)
  {
    box.extend(point);
  }
  constexpr std::uint64_t Last = (1U << Bits) - 1;
  const double side = points.empty() ? 0.0 : box.sizes().maxCoeff();
  const double scale = side > 0.0 ? static_cast<double>(Last) / side : 0.0;
  std::vector<std::uint64_t> spread(Last + 1);
  for (std::uint64_t number = 0; number <= Last; ++number)
  {
    spread[number] = Spread(number);
  }
  // The place along the curve, then the number.
  std::vector<std::uint64_t> keys;
  keys.reserve(points.size());
  for (const Vector3& point : points)
  {
    const Eigen::Vector3i cell = (scale * (point - box.min())).cast<int>();
    const std::uint64_t place = spread[cell[0]] | spread[cell[1]] << 1U | spread[cell[2]] << 2U;
    keys.push_back(place << 32U | keys.size());
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order;
  order.reserve(points.size());
  for (const std::uint64_t key : keys)
  {
    order.push_back(static_cast<int>(key & 0xffffffffU));
  }
  return order;
}
} // namespace palpate
