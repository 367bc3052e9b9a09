#pragma once

#include "Vector3.h"

namespace palpate::test
{
/// A point rounded to single precision. GCC 12 leaves out both conversions of
/// .cast<float>().cast<double>() when -O3 vectorises three coordinates; the addition between them
/// prevents that (and changes at most the sign of a zero).
inline Vector3 InSinglePrecision(const Vector3& point)
{
  return (point.cast<float>().array() + 0.0F).matrix().cast<double>();
}
} // namespace palpate::test
