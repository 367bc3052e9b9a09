#pragma once

#include <pybind11/pybind11.h>
#include <utility>

namespace palpate
{
/// A named tuple of palpate/_results.py.
template <typename... Values>
pybind11::object Result(const char* name, Values&&... values)
{
  return pybind11::module_::import("palpate._results").attr(name)(std::forward<Values>(values)...);
}
} // namespace palpate
