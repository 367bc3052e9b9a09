#pragma once

#include "BallFraction.h"
#include "ComplianceAtlas.h"
#include "ComplianceSampler.h"
#include "HexElasticity.h"
#include "HexahedronShape.h"
#include "LayeredSphere.h"
#include "RandomShapes.h"
#include "ReducedCompliance.h"
#include "SphericalHarmonicProjection.h"
#include "StarMesh.h"
#include "Units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace palpate::test
{
constexpr double Radius = 25.0;  // mm
constexpr double Tissue = 0.02;  // N/mm^2
constexpr double Stiffer = 0.08; // N/mm^2
constexpr double Poisson = 0.49;
constexpr double Bed = 1e-3; // N/mm^3

inline RadialModel SphereModel(double radius = Radius)
{
  return {0, {radius * std::sqrt(4.0 * Pi)}, Vector3(3.0, -2.0, 5.0)};
}

/// A bumpy star shape.
inline RadialModel RandomModel(std::mt19937_64& random, int degree = 4, double roughness = 0.06)
{
  std::normal_distribution<double> normal;
  std::vector<double> coefficients(SphericalHarmonicBasis::CoefficientCount(degree), 0.0);
  coefficients[0] = Radius * std::sqrt(4.0 * Pi);
  for (std::size_t i = 4; i < coefficients.size(); ++i)
  {
    coefficients[i] = roughness * Radius * normal(random);
  }
  return {degree, coefficients, Vector3(3.0, -2.0, 5.0)};
}

/// The direction of HollowModel's hollow.
inline Vector3 HollowDirection()
{
  return Vector3(1.0, -2.0, 1.0).normalized();
}

/// With a deep hollow, into which no ball fits that is used as a tool.
inline RadialModel HollowModel()
{
  const auto radius = [](const Vector3& d)
  { return 24.0 - 9.0 * std::exp(12.0 * (d.dot(HollowDirection()) - 1.0)); };
  return {12, ProjectOnHarmonics(12, 30, radius), Vector3(1.0, 2.0, 3.0)};
}

/// Of the elements, mm^3.
inline double FilledVolume(const StarMesh& mesh)
{
  double volume = 0.0;
  for (const StarMesh::Element& element : mesh.Elements())
  {
    const HexahedronShape shape(mesh.Nodes(), element);
    for (const HexahedronShape::Point& point : shape.Points())
    {
      volume += point.Volume;
    }
  }
  return volume;
}

inline ElasticSolid PlainSolid()
{
  return {TissueMap(Tissue), Poisson, ElasticBed(Bed)};
}

/// A model with its solid and what is made of them.
struct ElasticCase
{
  RadialModel Model;
  ElasticSolid Solid = PlainSolid();
  StarMesh Mesh;
  StiffnessMatrix Stiffness;
  ReducedCompliance Reduced;

  void Build(int elementsAcross, int degree)
  {
    Status status = StarMesh::Make(this->Model, elementsAcross, this->Mesh);
    ASSERT_TRUE(status.IsOk()) << status.Message();
    status = AssembleStiffness(this->Mesh, this->Model.CenterWorld(), this->Solid, this->Stiffness);
    ASSERT_TRUE(status.IsOk()) << status.Message();
    status = ReducedCompliance::Make(this->Mesh, this->Stiffness, degree, {}, this->Reduced);
    ASSERT_TRUE(status.IsOk()) << status.Message();
  }
};

inline std::unique_ptr<ElasticCase> MakeSphereCase(double coreDepth)
{
  auto result = std::make_unique<ElasticCase>();
  result->Model = SphereModel();
  if (coreDepth > 0.0)
  {
    result->Solid.Tissue.AddInclusion(BallFraction(result->Model.CenterWorld(), Radius - coreDepth),
                                      Stiffer);
  }
  result->Build(16, 12);
  return result;
}

/// The sphere with a core that begins 5 mm down, or without one (0), in elements of 2.4 mm. Made
/// once, which takes seconds.
inline const ElasticCase& SphereCase(double depth)
{
  if (depth > 0.0)
  {
    static const std::unique_ptr<ElasticCase> cored = MakeSphereCase(5.0);
    return *cored;
  }
  static const std::unique_ptr<ElasticCase> plain = MakeSphereCase(0.0);
  return *plain;
}

inline LayeredSphere SphereTruth(double depth)
{
  return depth > 0.0 ? LayeredSphere({{Radius - depth, Stiffer}, {Radius, Tissue}}, Poisson, Bed)
                     : LayeredSphere({{Radius, Tissue}}, Poisson, Bed);
}
} // namespace palpate::test
