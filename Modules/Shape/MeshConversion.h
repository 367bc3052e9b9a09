#pragma once

#include "IndexedMesh.h"
#include "PalpateShapeModule.h"

class vtkPolyData;

namespace palpate
{
/// The triangles of a surface as arrays. Other cells are ignored.
PALPATESHAPE_EXPORT IndexedMesh ToIndexedMesh(vtkPolyData* surface);
} // namespace palpate
