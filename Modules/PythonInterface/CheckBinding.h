#pragma once

#include <pybind11/pybind11.h>

namespace palpate
{
/// Adds MaskCase, CheckGroup, read_check_group and check.
void BindChecks(pybind11::module_& module);
} // namespace palpate
