#pragma once

#include "KernelProgress.h"
#include "NormalDisplacement.h"
#include "OrganModel.h"
#include "SideAsymmetry.h"
#include "Status.h"

#include <vector>

namespace palpate
{
/// Left shapes and, in the same order, mirrored right ones; of one kind and degree, about the
/// origin.
struct ShapeSides
{
  std::vector<OrganModel> Left;
  std::vector<OrganModel> Right;
};

/// How left and right shapes differ.
struct ShapeAsymmetry
{
  static constexpr std::size_t FewestIndividuals = 3;

  SideAnova Anova;            ///< of the coefficients
  NormalDisplacement Surface; ///< of the mean of both sides, as the left one
  SideTest Points;            ///< displacement along its normals of left minus right, mm
  /// Of each individual: displacement of left minus right, RMS over the mean surface, mm.
  std::vector<double> Individuals;
};

/// The mirror image at the sagittal plane; of surface models with parameters that start where those
/// of the target do.
OrganModel MirroredTowards(const OrganModel& shape, const OrganModel& target);

/// Shapes and their own mirror images; if `turnsToMean`, all turned to their common mean
/// (AlignByProcrustes). Fails as that does.
Status MakeMirroredSides(const std::vector<OrganModel>& shapes, bool turnsToMean,
                         const KernelProgress& progress, ShapeSides& sides);

/// `arePairs`: of paired organs, else of an organ and its mirror image. Tests at the directions of
/// an icosahedron of this frequency. Fails for fewer than FewestIndividuals, and if `progress`
/// cancels.
Status FindShapeAsymmetry(const ShapeSides& sides, bool arePairs, int frequency,
                          const PermutationSettings& flips, const KernelProgress& progress,
                          ShapeAsymmetry& asymmetry);

/// Over the surface, of displacements at its points: root mean square, mm.
double RmsOverPoints(const NormalDisplacement& surface, const Eigen::VectorXd& displacements);
} // namespace palpate
