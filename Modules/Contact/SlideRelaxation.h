#pragma once

#include "Vector3.h"

#include <algorithm>

namespace palpate
{
/// Steps of a sphere in a groove. From plane to plane they overshoot or lag by about the same
/// fraction each time: Aitken's process removes that fraction along the previous step (Irons and
/// Tuck, Int. J. Numer. Meth. Eng. 1, 1969).
class SlideRelaxation
{
public:
  Vector3 Relaxed(const Vector3& step) noexcept
  {
    Vector3 relaxed = step;
    const double square = this->Last.squaredNorm();
    if (square > 0.0)
    {
      const double change = (step - this->Last).dot(this->Last);
      this->Factor = change < 0.0 ? std::clamp(-this->Factor * square / change, 0.1, 3.0) : 1.0;
      relaxed += (this->Factor - 1.0) * step.dot(this->Last) / square * this->Last;
    }
    this->Last = step;
    return relaxed;
  }

private:
  Vector3 Last = Vector3::Zero();
  double Factor = 1.0;
};
} // namespace palpate
