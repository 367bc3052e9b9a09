#pragma once

#include "PalpateFiltersModule.h"
#include "RadialModel.h"

class vtkTable;

namespace palpate
{
/// A model as VTK data: a table with one row per coefficient (columns "Degree", "Order",
/// "Coefficient", the last in mm) and the centre (world mm) in the field data array "Center". The
/// convention is that of SphericalHarmonicBasis.
PALPATEFILTERS_EXPORT void ToTable(const RadialModel& model, vtkTable* table);

/// Reads such a table; rows may come in any order, missing ones are zero. Returns false if the
/// table does not hold a model.
PALPATEFILTERS_EXPORT bool FromTable(vtkTable* table, RadialModel& model);
} // namespace palpate
