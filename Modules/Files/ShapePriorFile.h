#pragma once

#include "OrganCompletion.h"
#include "ShapePrior.h"

#include <filesystem>

namespace palpate
{
/// Writes a prior as JSON (format "palpate shape prior", version 1) under AtomicFile's rules, in
/// single precision, patient LPS. Of kind "radial": degree, number of cases, mean and covariance
/// (lower triangle) of the coefficients of ln(radius / mm). Of kind "surface": mean, modes (one
/// after the other), variances and rest of SurfacePrior (mm), and the numbers of OrganRelation. No
/// case is named. Throws InputError.
void WriteShapePrior(const ShapePrior& prior, const std::filesystem::path& file);
void WriteShapePrior(const SurfacePrior& prior, const std::filesystem::path& file);
/// A file without a kind is of kind "radial". Throws InputError if the file is not such a prior.
OrganPrior ReadOrganPrior(const std::filesystem::path& file);
} // namespace palpate
