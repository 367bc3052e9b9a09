#pragma once

#include "PalpateIOModule.h"
#include "vtkPolyData.h"

#include <filesystem>
#include <string_view>

namespace palpate
{
/// The frame stated by a surface file for its coordinates. 3D Slicer writes it as SPACE=LPS or
/// SPACE=RAS into the comments of STL, PLY and OBJ, the title of legacy VTK, and as a field array
/// SPACE into VTP, and assumes LPS if a file states none (vtkMRMLModelStorageNode).
enum class SurfaceSpace
{
  Lps,
  Ras
};

/// The space stated by the comments of a file; LPS if they state none. Throws InputError, naming
/// `file`, for any other space.
PALPATEIO_EXPORT SurfaceSpace SpaceOfComments(const std::filesystem::path& file,
                                              std::string_view comments);

/// The same for a field array SPACE, which is removed, since it would be wrong after a conversion.
PALPATEIO_EXPORT SurfaceSpace TakeSpaceOfFields(const std::filesystem::path& file,
                                                vtkPolyData* surface);

/// Converts a surface from a space to patient LPS in place: from RAS, x and y of points, normals
/// and vectors change sign, exactly.
PALPATEIO_EXPORT void TurnToLps(SurfaceSpace space, vtkPolyData* surface);
} // namespace palpate
