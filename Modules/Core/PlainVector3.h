#pragma once

#include "Vector3.h"

namespace palpate
{
/// Three numbers that can be copied as bytes, unlike Eigen's vectors: for exchange between threads
/// and for files.
struct PlainVector3
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;

  PlainVector3() = default;
  /// From a vector or a vector expression.
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
