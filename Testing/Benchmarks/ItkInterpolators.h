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
  virtual ~ItkInterpolators() = default;
  virtual void AreInsideLinear(double iso, const std::vector<Vector3>& pointsWorld,
                               std::vector<unsigned char>& inside) const = 0;
  virtual void AreInsideBSpline(double iso, const std::vector<Vector3>& pointsWorld,
                                std::vector<unsigned char>& inside) const = 0;
};

/// Their templates compiled for the fastest instruction set that this processor supports.
std::unique_ptr<ItkInterpolators> MakeItkInterpolators(const FieldGrid& grid,
                                                       const std::vector<std::int16_t>& samples);
} // namespace palpate::bench
