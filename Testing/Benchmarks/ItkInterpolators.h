#pragma once

#include "FieldGrid.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace palpate::bench
{
/// ITK's linear and cubic B-spline interpolation of a volume, at points in the world.
class ItkInterpolators
{
public:
  ItkInterpolators(const FieldGrid& grid, const std::vector<std::int16_t>& samples);
  ~ItkInterpolators();
  ItkInterpolators(const ItkInterpolators&) = delete;
  ItkInterpolators& operator=(const ItkInterpolators&) = delete;

  void AreInsideLinear(double iso, const std::vector<Vector3>& pointsWorld,
                       std::vector<unsigned char>& inside) const;
  void AreInsideBSpline(double iso, const std::vector<Vector3>& pointsWorld,
                        std::vector<unsigned char>& inside) const;

private:
  struct Parts;
  std::unique_ptr<Parts> P;
};
} // namespace palpate::bench
