#pragma once

#include "ModelDocument.h"
#include "PalpateIOModule.h"

#include <filesystem>

namespace palpate
{
/// Whether the ending is one of a model file: .json, .csv or .coef, in either case.
PALPATEIO_EXPORT bool IsModelFile(const std::filesystem::path& path);

/// Reads a model by its ending: Palpate's JSON (see ModelToJson) or CSV (ModelToCsv), or
/// SPHARM-PDM's .coef (SurfaceFromSpharmPdm). Lengths mm, frame patient LPS. Throws InputError.
PALPATEIO_EXPORT ModelDocument ReadModel(const std::filesystem::path& path);

/// Writes a model by its ending, under AtomicFile's rules. Of the provenance's input only the file
/// name is kept. Throws InputError.
PALPATEIO_EXPORT void WriteModel(const std::filesystem::path& path, const ModelDocument& document);
} // namespace palpate
