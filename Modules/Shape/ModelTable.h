#pragma once

#include "PalpateShapeModule.h"
#include "SphericalHarmonicModel.h"

class vtkTable;

namespace palpate
{
/// A model as VTK data: a table with one row per coefficient (columns "Degree", "Order",
/// "Coefficient", the last in mm) and the centre (world mm) in the field data array "Center". The
/// convention is that of SphericalHarmonicBasis.
PALPATESHAPE_EXPORT void ToTable(const SphericalHarmonicModel& model, vtkTable* table);

/// Reads such a table; rows may come in any order, missing ones are zero. Returns false if the
/// table does not hold a model.
PALPATESHAPE_EXPORT bool FromTable(vtkTable* table, SphericalHarmonicModel& model);
} // namespace palpate
