#pragma once

#include "ModelDocument.h"

#include <string>

namespace palpate
{
/// A model as a table for spreadsheets and scripts: comment lines `# name: value` that state
/// convention (see ModelConvention), degree, centre (mm, patient LPS) and provenance, then
/// `l,m,coefficient_mm`, or `l,m,x_mm,y_mm,z_mm` for a surface model, one row per coefficient,
/// every number in full precision. Palpate does not read such tables. Throws InputError if a number
/// is not finite; `fileName` is used in messages.
std::string ModelToCsv(const ModelDocument& document, const std::string& fileName);
} // namespace palpate
