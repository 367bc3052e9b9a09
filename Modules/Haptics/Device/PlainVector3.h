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
  /// Of a vector or of an expression that gives one.
  template <typename Derived>
  PlainVector3(const Eigen::MatrixBase<Derived>& v) noexcept
  {
    const Vector3 value = v;
    this->X = value[0];
    this->Y = value[1];
    this->Z = value[2];
  }
  operator Vector3() const noexcept { return {this->X, this->Y, this->Z}; }
};
} // namespace palpate
