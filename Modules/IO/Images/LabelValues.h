#pragma once

#include "PalpateIOModule.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <filesystem>
#include <map>

namespace palpate
{
/// The voxels as labels, in the smallest of unsigned char, unsigned short and int that holds them;
/// the array itself if it has that type. Throws InputError for values that are fractional, NaN,
/// negative, or above the range of int.
PALPATEIO_EXPORT vtkSmartPointer<vtkDataArray> ToLabels(const std::filesystem::path& file,
                                                        vtkDataArray* voxels);

/// VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT or VTK_INT.
PALPATEIO_EXPORT int LabelType(int largestLabel) noexcept;

/// The number of voxels of every label but 0, in an array that ToLabels made.
PALPATEIO_EXPORT std::map<int, vtkIdType> CountLabels(vtkDataArray* labels);
} // namespace palpate
