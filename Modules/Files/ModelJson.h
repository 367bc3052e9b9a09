#pragma once

#include "ModelDocument.h"

#include <string>

namespace palpate
{
/// A model as JSON text that states its convention (see ModelConvention), degree, centre and
/// coefficients (mm, patient LPS) and provenance. Every finite double is restored bit by bit.
/// Throws InputError if a number is not finite; `fileName` is used in messages.
std::string ModelToJson(const ModelDocument& document, const std::string& fileName);

/// The model of such a text. Throws InputError if the text is not a model in this convention.
ModelDocument ModelFromJson(const std::string& text, const std::string& fileName);
} // namespace palpate
