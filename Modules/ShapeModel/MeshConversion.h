#pragma once

#include "DirectionCaster.h"
#include "PalpateShapeModelModule.h"

class vtkPolyData;

namespace palpate
{
/// The triangles of a surface as arrays. Cells other than triangles are left out.
PALPATESHAPEMODEL_EXPORT IndexedMesh ToIndexedMesh(vtkPolyData* surface);
} // namespace palpate
