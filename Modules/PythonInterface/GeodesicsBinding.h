#pragma once

#include <pybind11/pybind11.h>

namespace palpate
{
/// Adds lengths along surfaces to a module.
void BindGeodesics(pybind11::module_& module);
} // namespace palpate
