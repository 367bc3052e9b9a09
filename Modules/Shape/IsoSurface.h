#pragma once

#include "PalpateShapeModule.h"
#include "ScalarGrid.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

class vtkImageData;

namespace palpate
{
/// Volume and area of a closed surface, in the units of its points; the volume is positive where
/// triangles run counter-clockwise seen from outside.
struct EnclosedMeasure
{
  double Volume;
  double Area;
};

PALPATESHAPE_EXPORT EnclosedMeasure MeasureEnclosed(vtkPolyData* surface);

PALPATESHAPE_EXPORT void ReverseTriangles(vtkPolyData* surface);

/// Moves a surface from mm along the axes of `grid` (from its first sample) to world mm, where
/// triangles still face outwards.
PALPATESHAPE_EXPORT void MoveToWorld(const ScalarGrid& grid, vtkImageData* image,
                                     vtkPolyData* surface);

enum class SurfacePieces
{
  Largest,
  All
};

struct IsoSurface
{
  vtkSmartPointer<vtkPolyData> Surface; ///< outward-facing triangles
  int PieceCount = 0;                   ///< connected pieces before one was selected
  double Level = 0.0;
};

/// The surface where `grid` passes `level`; points in mm along the grid's axes, from its first
/// sample. Closed if the grid's outermost samples lie below the level. Samples equal to the level
/// are moved off it.
PALPATESHAPE_EXPORT IsoSurface ExtractIsoSurface(ScalarGrid& grid, float level,
                                                 SurfacePieces pieces);

/// The same at a level near zero at which the surface encloses `volume` (mm^3) to a part in a
/// thousand, if the field's range allows it.
PALPATESHAPE_EXPORT IsoSurface ExtractIsoSurfaceOfVolume(ScalarGrid& grid, double volume,
                                                         SurfacePieces pieces);
} // namespace palpate
