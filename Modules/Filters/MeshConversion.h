#pragma once

#include "IndexedMesh.h"
#include "PalpateFiltersModule.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// The triangles of a surface as arrays. Other cells are ignored.
PALPATEFILTERS_EXPORT IndexedMesh ToIndexedMesh(vtkPolyData* surface);

/// A mesh as a data set, without normals.
PALPATEFILTERS_EXPORT vtkSmartPointer<vtkPolyData> ToPolyData(const IndexedMesh& mesh);
} // namespace palpate
