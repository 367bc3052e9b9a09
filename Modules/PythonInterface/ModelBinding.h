#pragma once

#include "Call.h"

#include <pybind11/pybind11.h>

namespace palpate
{
/// palpate.Model. Immutable, so that threads may share it.
struct BoundModel
{
  Owned<palpate_model> Handle;
};

/// Adds Model, fit_points, fit_mask and read_model.
void BindModels(pybind11::module_& module);
} // namespace palpate
