#pragma once

#include "CorrectionStep.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

namespace palpate
{
/// The steps as a JSON array: {"do": "pull", "place_mm", "displacement_mm" or "target_mm",
/// "width_mm", "second_width_mm" if there is one}, {"do": "islands"}, {"do": "fill"}, {"do":
/// "smooth", "deviation_mm"}, {"do": "cut", "point_mm", "normal"}, {"do": "paint" or "erase",
/// "path_mm" (x, y, z after each other), "radius_mm", "slice_normal" if it is in one}, {"do":
/// "add_voxels" or "remove_voxels", "runs" (i, j, k and a count along i, after each other)}, {"do":
/// "copy_slice" or "fill_between", "axis", "slices" (two)}.
nlohmann::ordered_json CorrectionJson(const std::vector<CorrectionStep>& steps);

/// The steps of such an array, which is in a file. Throws InputError as ReadCorrections.
std::vector<CorrectionStep> CorrectionsOf(const nlohmann::json& list,
                                          const std::filesystem::path& file);

/// Writes the steps (format "palpate-corrections", version 1; mm, patient LPS) under AtomicFile's
/// rules. Throws InputError.
void WriteCorrections(const std::vector<CorrectionStep>& steps, const std::filesystem::path& file);
/// Throws InputError if the file is not such a list, or has more than 1,100 steps. Numbers are
/// finite; their limits are the kernel's.
std::vector<CorrectionStep> ReadCorrections(const std::filesystem::path& file);
} // namespace palpate
