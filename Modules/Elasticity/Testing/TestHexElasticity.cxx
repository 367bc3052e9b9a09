#include "ElasticCases.h"

#include <gtest/gtest.h>

#include <limits>

namespace palpate::hex_elasticity_test
{
namespace
{
double EnergyOf(const StiffnessMatrix& stiffness, const StarMesh& mesh, const Matrix3& slope,
                const Vector3& shift)
{
  Eigen::VectorXd moved(stiffness.rows());
  for (std::size_t i = 0; i < mesh.Nodes().size(); ++i)
  {
    moved.segment<3>(static_cast<Eigen::Index>(3 * i)) = slope * mesh.Nodes()[i] + shift;
  }
  return 0.5 * moved.dot(stiffness.selfadjointView<Eigen::Lower>() * moved);
}

class HexElasticity : public ::testing::Test
{
protected:
  void SetUp() override
  {
    std::mt19937_64 random(5);
    this->Model = test::RandomModel(random);
    ASSERT_TRUE(StarMesh::Make(this->Model, 6, this->Mesh).IsOk());
  }
  StiffnessMatrix Assembled(const ElasticSolid& solid) const
  {
    StiffnessMatrix stiffness;
    const Status status =
        AssembleStiffness(this->Mesh, this->Model.CenterWorld(), solid, stiffness);
    EXPECT_TRUE(status.IsOk()) << status.Message();
    return stiffness;
  }

  RadialModel Model;
  StarMesh Mesh;
};

// The patch test: the energy density of Hooke's law, exactly.
TEST_F(HexElasticity, UniformStrainHasHookesEnergy)
{
  const Matrix3 slope = (Matrix3() << 0.3, 0.2, -0.1, 0.4, -0.2, 0.5, 0.1, 0.0, 0.7).finished();
  const Matrix3 strain = 0.5 * (slope + slope.transpose());
  for (const double nu : {0.0, 0.3, 0.49, 0.4999})
  {
    const StiffnessMatrix stiffness = this->Assembled({TissueMap(0.02), nu, ElasticBed(0.0)});
    const double shear = 0.01 / (1.0 + nu);
    const double lame = 0.02 * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
    const double wanted =
        test::FilledVolume(this->Mesh) *
        (shear * strain.squaredNorm() + 0.5 * lame * strain.trace() * strain.trace());
    EXPECT_NEAR(EnergyOf(stiffness, this->Mesh, slope, Vector3::Zero()), wanted, 1e-10 * wanted)
        << nu;
  }
}

TEST_F(HexElasticity, RigidMotionStrainsNothing)
{
  const StiffnessMatrix stiffness = this->Assembled({TissueMap(0.02), 0.49, ElasticBed(0.0)});
  const Matrix3 turn = (Matrix3() << 0, -1, 2, 1, 0, -3, -2, 3, 0).finished();
  const double strained = EnergyOf(stiffness, this->Mesh, Matrix3::Identity(), Vector3::Zero());
  EXPECT_LE(std::abs(EnergyOf(stiffness, this->Mesh, turn, Vector3(1, 2, 3))), 1e-10 * strained);
}

TEST_F(HexElasticity, BedResistsTranslationByItsArea)
{
  const double bed = 1e-3;
  const StiffnessMatrix stiffness = this->Assembled({TissueMap(0.02), 0.49, ElasticBed(bed)});
  double area = 0.0;
  for (const StarMesh::Face& face : this->Mesh.Faces())
  {
    const auto node = [&](std::size_t i) -> const Vector3&
    { return this->Mesh.Nodes()[static_cast<std::size_t>(face.Nodes[i])]; };
    area += 0.5 * (node(2) - node(0)).cross(node(3) - node(1)).norm();
  }
  const double energy = EnergyOf(stiffness, this->Mesh, Matrix3::Zero(), Vector3(0.0, 0.0, 2.0));
  // Bilinear faces are not flat, so the area differs a little.
  EXPECT_NEAR(energy, 0.5 * bed * area * 4.0, 2e-3 * energy);
}

TEST_F(HexElasticity, ModulusScalesTheStiffness)
{
  const Matrix3 slope = Vector3(0.1, -0.3, 0.2).asDiagonal();
  const double once = EnergyOf(this->Assembled({TissueMap(0.02), 0.3, ElasticBed(0.0)}), this->Mesh,
                               slope, Vector3::Zero());
  ElasticSolid filled{TissueMap(0.5), 0.3, ElasticBed(0.0)};
  filled.Tissue.AddInclusion(test::BallFraction(this->Model.CenterWorld(), 60.0, 4.0), 0.06);
  const double thrice = EnergyOf(this->Assembled(filled), this->Mesh, slope, Vector3::Zero());
  EXPECT_NEAR(thrice, 3.0 * once, 1e-6 * once);
}

TEST_F(HexElasticity, RefusesImpossibleMaterials)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  StiffnessMatrix stiffness;
  const auto refuses = [&](const ElasticSolid& solid)
  {
    const Status status =
        AssembleStiffness(this->Mesh, this->Model.CenterWorld(), solid, stiffness);
    return !status.IsOk() && !status.Message().empty();
  };
  for (const double nu : {-0.1, 0.5, 0.49995, nan})
  {
    EXPECT_TRUE(refuses({TissueMap(0.02), nu, ElasticBed(1e-3)})) << nu;
  }
  for (const double modulus : {0.0, -0.02, 1e9, nan})
  {
    EXPECT_TRUE(refuses({TissueMap(modulus), 0.49, ElasticBed(1e-3)})) << modulus;
    ElasticSolid lesion = test::PlainSolid();
    lesion.Tissue.AddInclusion(test::BallFraction(Vector3::Zero(), 3.0), modulus);
    EXPECT_TRUE(refuses(lesion)) << modulus;
  }
  for (const double bed : {-1e-3, 1e9, nan})
  {
    EXPECT_TRUE(refuses({TissueMap(0.02), 0.49, ElasticBed(bed)})) << bed;
  }
}
} // namespace
} // namespace palpate::hex_elasticity_test
