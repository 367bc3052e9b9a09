#pragma once

#include <pybind11/pybind11.h>

namespace palpate
{
/// Adds register_landmarks and register_points.
void BindRegistrations(pybind11::module_& module);
} // namespace palpate
