#include "DenseFront.h"
#include "ElasticCases.h"
#include "StiffnessCondensation.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace palpate::stiffness_condensation_test
{
namespace
{
// A bumpy organ with a stiff part, and loads on some of its nodes, wherever they are.
struct LoadedOrgan
{
  LoadedOrgan()
  {
    std::mt19937_64 random(7);
    test::ElasticCase organ;
    organ.Model = test::RandomModel(random);
    organ.Solid.Tissue.AddInclusion(
        test::BallFraction(organ.Model.CenterWorld() + Vector3(8.0, 0.0, 0.0), 6.0), 1.0);
    EXPECT_TRUE(StarMesh::Make(organ.Model, 6, this->Mesh).IsOk());
    EXPECT_TRUE(
        AssembleStiffness(this->Mesh, organ.Model.CenterWorld(), organ.Solid, this->Stiffness)
            .IsOk());
    constexpr int Count = 12;
    this->Loads.resize(this->Stiffness.rows(), Count);
    std::uniform_int_distribution<Eigen::Index> row(0, this->Stiffness.rows() - 1);
    std::normal_distribution<double> force;
    for (int load = 0; load < Count; ++load)
    {
      for (int i = 0; i < 5; ++i)
      {
        this->Loads.coeffRef(row(random), load) += force(random);
      }
    }
  }

  Status Condense(Eigen::MatrixXd& compliance) const
  {
    return CondenseStiffness(this->Stiffness, NestedDissection(this->Mesh.Places()), this->Loads,
                             {}, compliance);
  }

  StarMesh Mesh;
  StiffnessMatrix Stiffness;
  LoadMatrix Loads;
};

TEST(StiffnessCondensation, IsWhatSolutionsOfTheEquationsGive)
{
  const LoadedOrgan organ;
  const Eigen::SimplicialLLT<StiffnessMatrix> solver(organ.Stiffness);
  ASSERT_EQ(solver.info(), Eigen::Success);
  const Eigen::MatrixXd exact =
      organ.Loads.transpose() * solver.solve(Eigen::MatrixXd(organ.Loads));
  Eigen::MatrixXd compliance;
  ASSERT_TRUE(organ.Condense(compliance).IsOk());
  // Rounding, times the condition of the equations.
  EXPECT_LE((compliance - exact).norm(), 1e-10 * exact.norm());
}

TEST(StiffnessCondensation, HasTheSameBitsEachTime)
{
  const LoadedOrgan organ;
  Eigen::MatrixXd first;
  ASSERT_TRUE(organ.Condense(first).IsOk());
  for (int repeat = 0; repeat < 5; ++repeat)
  {
    Eigen::MatrixXd again;
    ASSERT_TRUE(organ.Condense(again).IsOk());
    EXPECT_EQ(first, again);
  }
}

TEST(StiffnessCondensation, RefusesEquationsThatAreNotDefinite)
{
  for (const double entry : {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN()})
  {
    LoadedOrgan organ;
    organ.Stiffness.coeffRef(300, 300) = entry;
    Eigen::MatrixXd compliance;
    EXPECT_FALSE(organ.Condense(compliance).IsOk()) << entry;
  }
}

// At the front, not after all the others were eliminated.
TEST(DenseFront, StopsWhereItsStiffnessIsNotDefinite)
{
  for (const double entry : {1.0, 0.0, -1.0})
  {
    DenseFront front(2, 1, 1);
    front.Stiffness(0, 0) = 1.0;
    front.Stiffness(1, 1) = entry;
    Eigen::MatrixXd energy = Eigen::MatrixXd::Zero(1, 1);
    EXPECT_EQ(front.Eliminate([] { return true; }, energy), entry > 0.0) << entry;
  }
}

TEST(StiffnessCondensation, RefusesEquationsThatAreSingularToRounding)
{
  LoadedOrgan organ;
  // Two unknowns that hardly anything resists.
  Eigen::MatrixXd dense = organ.Stiffness;
  dense = dense.selfadjointView<Eigen::Lower>();
  dense.row(300) = dense.row(301);
  dense.col(300) = dense.col(301);
  dense(300, 300) = dense(301, 301) * (1.0 + 1e-14);
  dense(300, 301) = dense(301, 301);
  dense(301, 300) = dense(301, 301);
  organ.Stiffness = StiffnessMatrix(dense.sparseView()).triangularView<Eigen::Lower>();
  organ.Loads.coeffRef(300, 0) = 1.0;
  Eigen::MatrixXd compliance;
  EXPECT_FALSE(organ.Condense(compliance).IsOk());
}
} // namespace
} // namespace palpate::stiffness_condensation_test
