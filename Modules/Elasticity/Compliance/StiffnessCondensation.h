#pragma once

#include "HexElasticity.h"
#include "KernelProgress.h"
#include "NestedDissection.h"
#include "Status.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace palpate
{
/// A row for each unknown, a column for each load. Most rows are empty.
using LoadMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Computes B' K^-1 B for loads B and a positive definite stiffness K, on the calling thread and
/// another one. It is the sum of (L^-1 B)' (L^-1 B) over the unknowns as they are eliminated,
/// K = L L': no factor is kept, and no equation is solved backwards. The result has the same bits
/// each time, on any number of processors.
///
/// `order` is that of the mesh's nodes, each of which has three unknowns. Fails if memory is short,
/// if the stiffness is not positive definite in double precision, and if `progress` cancels.
Status CondenseStiffness(const StiffnessMatrix& lowerTriangle, const NestedDissection& order,
                         const LoadMatrix& loads, const KernelProgress& progress,
                         Eigen::MatrixXd& compliance);
} // namespace palpate
