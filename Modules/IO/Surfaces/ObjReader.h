#pragma once

#include "PalpateIOModule.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace palpate
{
/// Reads the faces of a Wavefront OBJ text as polygons; coordinates in single precision, unchanged.
/// Normals are kept if every point has one; texture coordinates, lines, groups and materials are
/// ignored. Throws InputError naming `fileName` for an index before the first vertex, a face of
/// fewer than three vertices, and invalid or non-finite numbers. Indices may exceed the points,
/// since these may follow the faces; TrianglesOf checks them. (VTK's reader uses indices
/// unchecked.) Source: Wavefront Technologies, Advanced Visualizer manual, appendix B1 (object
/// files).
PALPATEIO_EXPORT vtkSmartPointer<vtkPolyData> SurfaceFromObj(const std::string& text,
                                                             const std::string& fileName);
} // namespace palpate
