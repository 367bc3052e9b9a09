#include "ClampedLength.h"

namespace palpate
{
Vector3 ClampedLength(const Vector3& vector, double maximum) noexcept
{
  if (!vector.allFinite() || !(maximum > 0.0))
  {
    return Vector3::Zero();
  }
  const double largest = vector.cwiseAbs().maxCoeff();
  if (largest <= maximum && vector.norm() <= maximum)
  {
    return vector;
  }
  const Vector3 scaled = vector / largest;
  // Slightly less, since the length of the product is exact only to some units in the last place.
  return scaled * (maximum / scaled.norm() * (1.0 - 1e-15));
}
} // namespace palpate
