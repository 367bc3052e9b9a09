#pragma once

#include "ShapePrior.h"

#include <filesystem>

namespace palpate
{
/// Writes a prior as JSON (format "palpate shape prior", version 1) under AtomicFile's rules:
/// degree, number of cases, mean and covariance (lower triangle) of the coefficients of ln(radius /
/// mm), in single precision, patient LPS. No case is named. Throws InputError.
void WriteShapePrior(const ShapePrior& prior, const std::filesystem::path& file);
/// Throws InputError if the file is not such a prior.
ShapePrior ReadShapePrior(const std::filesystem::path& file);
} // namespace palpate
