#include "TurnLimit.h"

#include <algorithm>

namespace palpate
{
void TurnLimit::Follow(double period, std::array<double, 4>& orientation) noexcept
{
  Eigen::Map<Eigen::Quaterniond> wanted(orientation.data());
  if (this->HasLast)
  {
    wanted.coeffs() *= this->Last.dot(wanted) < 0.0 ? -1.0 : 1.0;
    const double angle = this->Last.angularDistance(wanted);
    const double most = MostTurn * std::max(period, 0.0);
    if (angle > most)
    {
      wanted = this->Last.slerp(most / angle, wanted).normalized();
    }
  }
  this->Last = wanted;
  this->HasLast = true;
}
} // namespace palpate
