#include "SphericalHarmonicBasis.h"

namespace palpate
{
void SphericalHarmonicBasis::Evaluate(const Vector3& direction, double* values) const noexcept
{
  const double x = direction.x();
  const double y = direction.y();
  const double z = direction.z();
  const int degree = this->Degree();
  double cosine = 1.0; // Re (x + iy)^m
  double sine = 0.0;   // Im (x + iy)^m
  for (int m = 0; m <= degree; ++m)
  {
    const auto store = [=](int l, double q)
    {
      values[Index(l, m)] = q * cosine;
      if (m > 0)
      {
        values[Index(l, -m)] = q * sine;
      }
    };
    double previous = 0.0;
    double current = this->Recurrence.Diagonal(m);
    store(m, current);
    const SphericalHarmonicRecurrence::Term* term = this->Recurrence.Column(m);
    for (int l = m + 1; l <= degree; ++l, ++term)
    {
      const double next = term->A * (z * current - term->B * previous);
      previous = current;
      current = next;
      store(l, current);
    }
    const double nextCosine = cosine * x - sine * y;
    sine = cosine * y + sine * x;
    cosine = nextCosine;
  }
}
} // namespace palpate
