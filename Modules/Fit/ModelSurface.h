#pragma once

#include "ModelDocument.h"
#include "PalpateFitModule.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// Triangulates a model over the icosahedron of a frequency, 10 f^2 + 2 points and 20 f^2 faces in
/// patient LPS (mm), with analytic normals and outward orientation.
PALPATEFIT_EXPORT vtkSmartPointer<vtkPolyData> DrawModel(const OrganModel& surface, int frequency);

/// The frequency at which a fit draws its model: `frequency`, and for a surface model at least 1.6
/// times its degree, about three triangles' sides per shortest half-wave. A coarser drawing cuts
/// off 0.001 to 0.002 of the Dice of thin organs.
PALPATEFIT_EXPORT int DrawnFrequency(const OrganModel& surface, int frequency);
} // namespace palpate
