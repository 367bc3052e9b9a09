#pragma once

#include "DirectionCaster.h"
#include "PalpateShapeModelModule.h"

class vtkPolyData;

namespace palpate
{
/// The triangles of a surface as arrays. Other cells are ignored.
PALPATESHAPEMODEL_EXPORT IndexedMesh ToIndexedMesh(vtkPolyData* surface);
} // namespace palpate
