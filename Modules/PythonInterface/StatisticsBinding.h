#pragma once

#include <pybind11/pybind11.h>

namespace palpate
{
/// LinearModel and displacement.
void BindStatistics(pybind11::module_& module);
} // namespace palpate
