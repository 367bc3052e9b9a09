#pragma once

#include "Call.h"

#include <pybind11/pybind11.h>

namespace palpate
{
/// palpate.Field. Immutable, so that threads may share it.
struct BoundField
{
  Owned<palpate_field> Handle;
};

void BindFields(pybind11::module_& module);
} // namespace palpate
