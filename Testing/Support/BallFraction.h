#pragma once

#include "TissueMap.h"
#include "Vector3.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace palpate::test
{
/// A ball as a partial volume on a grid of `spacing` mm.
inline std::shared_ptr<const TissueMap::Samples> BallFraction(const Vector3& centerWorld,
                                                              double radius, double spacing = 0.5)
{
  const int nodes = 2 * static_cast<int>(std::ceil(radius / spacing + 2.0)) + 1;
  const Vector3 first = centerWorld - Vector3::Constant(0.5 * spacing * (nodes - 1));
  auto samples = std::make_shared<TissueMap::Samples>();
  samples->Grid =
      FieldGrid({nodes, nodes, nodes}, first, Vector3::Constant(spacing), Matrix3::Identity());
  for (int k = 0; k < nodes; ++k)
  {
    for (int j = 0; j < nodes; ++j)
    {
      for (int i = 0; i < nodes; ++i)
      {
        const double distance = (first + spacing * Vector3(i, j, k) - centerWorld).norm();
        samples->Values.push_back(
            static_cast<float>(std::clamp(0.5 + (radius - distance) / spacing, 0.0, 1.0)));
      }
    }
  }
  return samples;
}
} // namespace palpate::test
