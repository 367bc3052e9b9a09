#pragma once

#include "ModelDocument.h"
#include "PalpateIOModule.h"

#include <string>

namespace palpate
{
/// A model as JSON text that states its convention (see ModelConvention), degree, centre and
/// coefficients (mm, patient LPS) and provenance. Every finite double comes back to the same bits.
/// Throws InputError where a number is not finite; `fileName` is named in messages.
PALPATEIO_EXPORT std::string ModelToJson(const ModelDocument& document,
                                         const std::string& fileName);

/// The model of such a text. Throws InputError on anything that is not one in this convention.
PALPATEIO_EXPORT ModelDocument ModelFromJson(const std::string& text, const std::string& fileName);
} // namespace palpate
