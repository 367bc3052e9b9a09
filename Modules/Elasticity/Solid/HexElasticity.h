#pragma once

#include "ElasticBed.h"
#include "StarMesh.h"
#include "Status.h"
#include "TissueMap.h"

#include <Eigen/SparseCore>

namespace palpate
{
/// The lower triangle of a symmetric matrix. Rows and columns 3 i + c belong to component c of node
/// i of a mesh.
using StiffnessMatrix = Eigen::SparseMatrix<double>;

/// Tissue for linear elasticity: isotropic, heterogeneous, on a bed.
struct ElasticSolid
{
  static constexpr double MostPoissonRatio = 0.4999;

  TissueMap Tissue;
  double PoissonRatio = 0.49;
  ElasticBed Bed;
};

/// Assembles the stiffness (N/mm) of trilinear hexahedra with mean dilatation, which do not lock
/// where the material is nearly incompressible (Hughes, The Finite Element Method, 1987, section
/// 4.5; the modulus is that at the Gauss points, the bulk modulus its harmonic mean in the
/// element), and of the bed on the surface. `centerWorld` is that of the mesh. Fails for a
/// Poisson's ratio outside [0, MostPoissonRatio], and what the tissue and the bed refuse.
/// Allocates.
Status AssembleStiffness(const StarMesh& mesh, const Vector3& centerWorld,
                         const ElasticSolid& solid, StiffnessMatrix& stiffness);
} // namespace palpate
