#pragma once

#include "CoefficientCovariance.h"
#include "DirectionCoverage.h"
#include "SurfaceModelFit.h"

namespace palpate
{
/// How far to trust a fit of a surface model. Along its normals such a surface has as many free
/// numbers as one series over the parameter sphere (tangential ones only slide points within it),
/// so it is judged as a radial fit whose directions are the parameters and whose radii are the
/// distances along the normals.
struct SurfaceModelUncertainty
{
  DirectionCoverage Coverage;       ///< directions are parameters
  CoefficientCovariance Covariance; ///< of a series for the surface's place along its normals
  double Condition = 0.0;           ///< of that series
  double NoiseDeviation = 0.0;      ///< mm, of a sample of mean weight
  double DegreesOfFreedom = 0.0;    ///< of that series
};

/// Judges `fit`, of `mesh`. Fails where FitRadialModel does. Some milliseconds at degree 12,
/// some tens at 20.
Status AssessSurfaceModelFit(const IndexedMesh& mesh, const SurfaceModelFitResult& fit,
                             SurfaceModelUncertainty& uncertainty);
} // namespace palpate
