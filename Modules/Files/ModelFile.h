#pragma once

#include "ModelDocument.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// Whether the ending is that of a model file: .json, .coef, or .csv, which is write-only.
bool IsModelFile(const std::filesystem::path& path);

std::vector<std::string> ReadableModelEndings();

/// Whether a file of this ending preserves a radial model; SPHARM-PDM has only surface
/// surfaces.
bool KeepsRadialModel(const std::filesystem::path& path);

/// Reads a model by its ending: Palpate's JSON (see ModelToJson) or SPHARM-PDM's .coef
/// (SurfaceFromSpharmPdm). Lengths mm, frame patient LPS. Throws InputError, also for a .csv.
ModelDocument ReadModel(const std::filesystem::path& path);

/// Writes a model by its ending, under AtomicFile's rules. Of the provenance's input only the file
/// name is kept. Throws InputError.
void WriteModel(const std::filesystem::path& path, const ModelDocument& document);
} // namespace palpate
