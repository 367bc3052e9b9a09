#pragma once

#include "Vector3.h"

namespace palpate
{
/// Three numbers that may be copied as bytes, which Eigen's vectors may not: for what is exchanged
/// between threads or written to files.
struct PlainVector3
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;

  PlainVector3() = default;
  PlainVector3(const Vector3& v) noexcept : X(v[0]), Y(v[1]), Z(v[2]) {}
  operator Vector3() const noexcept { return {this->X, this->Y, this->Z}; }
};
} // namespace palpate
