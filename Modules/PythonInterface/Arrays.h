#pragma once

#include <array>
#include <cstdint>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <vector>

namespace palpate
{
using Numbers = pybind11::array_t<double, pybind11::array::c_style>;

/// An argument as an array of real numbers; TypeError, which names the argument, if it is none.
pybind11::array RealArray(const pybind11::object& given, const char* name);

/// An argument of shape (n, 3), or (3,) for one vector, of any type of real numbers and any
/// strides. Results have the same leading dimension. Else ValueError or TypeError, which name the
/// argument.
class VectorArray
{
public:
  VectorArray(const pybind11::object& given, const char* name);

  std::size_t Count() const { return static_cast<std::size_t>(this->Vectors); }
  const double* Data() const { return this->Values.data(); }
  /// An array for results of this shape for each vector.
  template <typename Number = double>
  pybind11::array_t<Number> Results(std::vector<pybind11::ssize_t> shape = {}) const
  {
    if (!this->IsSingle)
    {
      shape.insert(shape.begin(), this->Vectors);
    }
    return pybind11::array_t<Number>(shape);
  }

private:
  Numbers Values;
  pybind11::ssize_t Vectors;
  bool IsSingle;
};

/// Three numbers.
std::array<double, 3> TripleOf(const pybind11::object& given, const char* name);

/// Indices of shape (m, 3), each from 0 to below `pointCount`.
std::vector<std::int32_t> TrianglesOf(const pybind11::object& given, std::size_t pointCount);
} // namespace palpate
