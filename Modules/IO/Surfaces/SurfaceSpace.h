#pragma once

#include "PalpateIOModule.h"
#include "vtkPolyData.h"

#include <filesystem>
#include <string_view>

namespace palpate
{
/// The frame that a surface file states for its coordinates. 3D Slicer writes it as SPACE=LPS or
/// SPACE=RAS into the comments of STL, PLY and OBJ, and as a field array SPACE into VTP, and takes
/// LPS where a file says nothing (vtkMRMLModelStorageNode).
enum class SurfaceSpace
{
  Lps,
  Ras
};

/// What the comments of a file state; LPS where they state nothing. Throws InputError, naming
/// `file`, for any other space.
PALPATEIO_EXPORT SurfaceSpace SpaceOfComments(const std::filesystem::path& file,
                                              std::string_view comments);

/// The same of a field array SPACE, which is taken out, since it would be untrue after a turn.
PALPATEIO_EXPORT SurfaceSpace TakeSpaceOfFields(const std::filesystem::path& file,
                                                vtkPolyData* surface);

/// Turns a surface from a space to patient LPS in place: from RAS, x and y of points, normals and
/// vectors change sign, exactly.
PALPATEIO_EXPORT void TurnToLps(SurfaceSpace space, vtkPolyData* surface);
} // namespace palpate
