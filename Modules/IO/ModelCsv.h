#pragma once

#include "ModelDocument.h"
#include "PalpateIOModule.h"

#include <string>

namespace palpate
{
/// A model as a table: comment lines `# name: value` that state convention (see ModelConvention),
/// degree, centre (mm, patient LPS) and provenance, then `l,m,coefficient_mm`, or
/// `l,m,x_mm,y_mm,z_mm` for a parametric surface, one row a coefficient. Every finite double comes
/// back to the same bits. Throws InputError where a number is not finite; `fileName` is named in
/// messages.
PALPATEIO_EXPORT std::string ModelToCsv(const ModelDocument& document, const std::string& fileName);

/// The model of such a text; rows may come in any order. Throws InputError on anything that is not
/// one in this convention.
PALPATEIO_EXPORT ModelDocument ModelFromCsv(const std::string& text, const std::string& fileName);
} // namespace palpate
