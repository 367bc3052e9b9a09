#pragma once

#include <pybind11/pybind11.h>

namespace palpate
{
/// Adds masks and models under correction to a module.
void BindCorrections(pybind11::module_& module);
} // namespace palpate
