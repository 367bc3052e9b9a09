#pragma once

#include "ModelDocument.h"
#include "PalpateIOModule.h"

#include <string>

namespace palpate
{
/// A model as a table for spreadsheets and scripts: comment lines `# name: value` that state
/// convention (see ModelConvention), degree, centre (mm, patient LPS) and provenance, then
/// `l,m,coefficient_mm`, or `l,m,x_mm,y_mm,z_mm` for a parametric surface, one row a coefficient,
/// every number with all its bits. Such a table is not read again. Throws InputError where a number
/// is not finite; `fileName` is named in messages.
PALPATEIO_EXPORT std::string ModelToCsv(const ModelDocument& document, const std::string& fileName);
} // namespace palpate
