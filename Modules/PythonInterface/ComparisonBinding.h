#pragma once

#include <pybind11/pybind11.h>

namespace palpate
{
/// compare.
void BindComparisons(pybind11::module_& module);
/// relate and shape.
void BindRelations(pybind11::module_& module);
} // namespace palpate
