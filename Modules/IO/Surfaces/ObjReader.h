#pragma once

#include "PalpateIOModule.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace palpate
{
/// Reads the faces of a Wavefront OBJ text as polygons; coordinates in single precision, as they
/// stand. Normals are taken where every point has one; texture coordinates, lines, groups and
/// materials are left out. Throws InputError naming `fileName` for a corner that is no point, a
/// face of fewer than three vertices and numbers that are none or not finite. (VTK's reader uses
/// indices as they come.) Source: Wavefront Technologies, Advanced Visualizer manual, appendix B1
/// (object files).
PALPATEIO_EXPORT vtkSmartPointer<vtkPolyData> SurfaceFromObj(const std::string& text,
                                                             const std::string& fileName);
} // namespace palpate
