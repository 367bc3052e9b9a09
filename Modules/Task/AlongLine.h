#pragma once

#include "Vector3.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace palpate
{
/// mm; closed: back to its start.
inline double LengthOf(const std::vector<Vector3>& line, bool isClosed)
{
  double length = isClosed ? (line.front() - line.back()).norm() : 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    length += (line[i] - line[i - 1]).norm();
  }
  return length;
}

/// Visits points along a line, at most a millimetre apart, or a few thousand; each with the length
/// that it stands for.
template <typename Function>
void AlongLine(const std::vector<Vector3>& line, bool isClosed, const Function& visit)
{
  constexpr double MostSteps = 5000.0;
  const double spacing = std::max(1.0, LengthOf(line, isClosed) / MostSteps);
  const std::size_t segments = line.size() - (isClosed ? 0 : 1);
  for (std::size_t i = 0; i < segments; ++i)
  {
    const Vector3& a = line[i];
    const Vector3& b = line[(i + 1) % line.size()];
    const double length = (b - a).norm();
    const int steps = std::max(1, static_cast<int>(std::ceil(length / spacing)));
    for (int step = 0; step < steps; ++step)
    {
      visit(Vector3(a + (step + 0.5) / steps * (b - a)), length / steps);
    }
  }
}
} // namespace palpate
