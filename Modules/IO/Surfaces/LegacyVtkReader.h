#pragma once

#include "PalpateIOModule.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace palpate
{
/// The points, polygons and triangle strips of a legacy VTK file (.vtk, versions 1 to 5.1, ASCII or
/// BINARY) of the data set POLYDATA, with the coordinates as written. Points are in single
/// precision unless the file has double or whole numbers of more than two bytes. Vertices, lines,
/// fields and meta-data are skipped, and so are the attributes of points and cells, which end the
/// geometry. Memory and time are bounded by the file. Throws InputError, naming `fileName`. Indices
/// may exceed the points; TrianglesOf checks them.
/// Source: The VTK User's Guide, "VTK file formats"; VTK 9.1, vtkDataReader and vtkDataWriter.
PALPATEIO_EXPORT vtkSmartPointer<vtkPolyData> SurfaceFromLegacyVtk(const std::string& bytes,
                                                                   const std::string& fileName);

/// The second line of the file, where 3D Slicer states the space; empty if there is none.
PALPATEIO_EXPORT std::string TitleOfLegacyVtk(const std::string& bytes);
} // namespace palpate
