#pragma once

#include "IndexedMesh.h"
#include "KernelProgress.h"
#include "SphericalPlacement.h"
#include "Status.h"
#include "SurfaceModel.h"
#include "Vector3.h"

#include <limits>
#include <vector>

namespace palpate
{
struct SurfaceModelFitOptions
{
  int Degree = 20;
  /// How the parameter sphere is turned: so that its directions are those of the frame of the mesh
  /// (PlaceByPolarFactor), so that surfaces of different patients correspond; or, where the axes of
  /// that frame mean nothing, those of the surface's ellipsoid (PlaceByEllipsoid).
  enum class PlacementKind
  {
    Frame,
    Ellipsoid
  };
  PlacementKind Placing = PlacementKind::Frame;
  /// Rounds in which the vertices slide to their nearest parameters and the surface is fitted
  /// again along the mesh's normals. 0: one fit by distances of points.
  int Refits = 4;
  double Ridge = 1e-4;         ///< see SurfaceModelSolver
  double TangentWeight = 0.05; ///< of tangential residuals in a refit
  int Iterations = 15;         ///< of conjugate gradients in a refit
  /// The last refit is repeated with stiffer tangents around vertices where the surface's area
  /// element falls below this part of its mean or turns over; 0 for no such guard.
  double LeastAreaRatio = 0.25;
  /// Rounds at most in which crossings of the surface with itself are taken apart (CrossingRemedy)
  /// after the last refit. A surface without any is kept if its RMS distance from the mesh rises by
  /// at most 4 % of half its shortest wavelength, with which the rounds end; else the one with the
  /// fewest, if these are less than half and that distance rises by at most 0.75 %.
  int MostSeparations = 12;
  /// A fit that leaves more than this (mm, NormalRms) keeps its crossings, since it is not wanted.
  double LargestRms = std::numeric_limits<double>::infinity();
};

struct SurfaceModelFitResult
{
  SurfaceModel Surface{0, {{{0.0}, {0.0}, {0.0}}}};
  std::vector<Vector3> Parameters; ///< of the mesh's vertices, after sliding
  SphericalPlacement Placement;    ///< not for degree 0
  bool IsAmbiguous = false;        ///< placed by an ellipsoid of which two axes are within 10 %
  double NormalRms = 0.0;          ///< mm, area-weighted distance of the vertices along normals
  int Folded = 0;                  ///< vertices at which the area element turns over
};

/// Fits a surface model to a closed genus-0 mesh (mm) with a bijective spherical
/// parametrisation, one unit vector per vertex. Fails if the parameters are not bijective or do not
/// determine the surface, if its placement is undetermined, or on cancellation.
///
/// With refits, the surface has the volume of the mesh (to second order of the change). The mesh
/// should not cross itself.
///
/// After Brechbuhler, Gerig and Kubler, "Parametrization of closed surfaces for 3-D shape
/// description", CVIU 61 (1995); the refits minimise distances along normals, since a surface may
/// slide in itself without a change of shape.
Status FitSurfaceModel(const IndexedMesh& mesh, const std::vector<Vector3>& parameters,
                       const SurfaceModelFitOptions& options, SurfaceModelFitResult& result,
                       const KernelProgress& progress = {});
} // namespace palpate
