#pragma once

#include "PalpateIOModule.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// The whole number that a voxel's value stands for: values within 0.001 of one are taken as it,
/// since a scale factor or resampling to floating point makes 2.9999 of 3 and 1e-8 of 0. Nothing
/// for other values, NaN and infinity.
PALPATEIO_EXPORT std::optional<double> WholeValue(double value) noexcept;

/// The voxels as labels, in the smallest of unsigned char, unsigned short and int that holds them;
/// the array itself if it has that type. Adds a note if values were rounded (WholeValue). Throws
/// InputError for values that are fractional, NaN, negative, or above the range of int.
PALPATEIO_EXPORT vtkSmartPointer<vtkDataArray>
ToLabels(const std::filesystem::path& file, vtkDataArray* voxels, std::vector<std::string>& notes);

/// VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT or VTK_INT.
PALPATEIO_EXPORT int LabelType(int largestLabel) noexcept;

/// The number of voxels of every label but 0, in an array that ToLabels made.
PALPATEIO_EXPORT std::map<int, vtkIdType> CountLabels(vtkDataArray* labels);
} // namespace palpate
