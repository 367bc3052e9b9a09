#include "DentedSurface.h"
#include "ElasticCases.h"
#include "ElasticForce.h"
#include "GaussLegendre.h"
#include "IcosahedronDirections.h"

#include <gtest/gtest.h>

namespace palpate::dented_surface_test
{
namespace
{
constexpr double NormOf(int degree)
{
  return (2.0 * degree + 1.0) / (4.0 * Pi);
}

// Displacement (mm) of the closed form under a force on a Hertz bump about the z axis.
class ExactDent
{
public:
  ExactDent(const LayeredSphere& sphere, double force, double patchRadius)
  {
    constexpr int Degrees = 120;
    const GaussLegendre gauss(24);
    const double radius = sphere.Radius();
    for (int l = 0; l <= Degrees; ++l)
    {
      Eigen::Vector2d traction = Eigen::Vector2d::Zero();
      for (std::size_t i = 0; i < gauss.Nodes.size(); ++i)
      {
        const double s = 0.5 * (1.0 + gauss.Nodes[i]);
        const double sine = patchRadius * std::sqrt(1.0 - s * s) / radius;
        const double cosine = std::sqrt(1.0 - sine * sine);
        const double weight = 1.5 * gauss.Weights[i] * s * s;
        traction[0] -= weight * cosine * std::legendre(l, cosine);
        traction[1] += weight * sine * SlopeOf(l, cosine, sine);
      }
      const double product = std::max(1.0, static_cast<double>(l) * (l + 1));
      Eigen::Matrix2d response = sphere.Response(l);
      response.col(1) /= product;
      this->Terms.push_back(force * NormOf(l) / (radius * radius) * response * traction);
    }
  }

  Vector3 At(const Vector3& direction) const
  {
    const double cosine = std::clamp(direction.z(), -1.0, 1.0);
    const double sine = std::sqrt(std::max(1e-12, 1.0 - cosine * cosine));
    Eigen::Vector2d moved = Eigen::Vector2d::Zero();
    for (std::size_t l = 0; l < this->Terms.size(); ++l)
    {
      const int degree = static_cast<int>(l);
      moved[0] += this->Terms[l][0] * std::legendre(degree, cosine);
      moved[1] += this->Terms[l][1] * SlopeOf(degree, cosine, sine);
    }
    const Vector3 aside(direction.x(), direction.y(), 0.0);
    const Vector3 south = cosine / sine * aside - sine * Vector3::UnitZ();
    return moved[0] * direction + moved[1] * south;
  }

private:
  // By the polar angle.
  static double SlopeOf(int degree, double cosine, double sine)
  {
    return degree == 0
               ? 0.0
               : degree *
                     (cosine * std::legendre(degree, cosine) - std::legendre(degree - 1, cosine)) /
                     sine;
  }
  std::vector<Eigen::Vector2d> Terms;
};

struct DrawnSphere
{
  DrawnSphere(const test::ElasticCase& sphere, int frequency)
      : Mesh(frequency), Center(sphere.Model.CenterWorld())
  {
    const Status status =
        ComplianceMaps::Fit(sphere.Model, sphere.Solid, sphere.Reduced, {8, 0.0}, {}, this->Maps);
    EXPECT_TRUE(status.IsOk()) << status.Message();
    this->Surface =
        std::make_unique<DentedSurface>(sphere.Model, this->Maps, this->Mesh.Directions());
  }

  std::vector<Vector3> PressedAt(const Vector3& direction, double depth, double ball) const
  {
    return this->Surface->PointsWorld(this->Surface->PressedAt(direction, depth, ball));
  }

  IcosahedronDirections Mesh;
  ComplianceMaps Maps;
  std::unique_ptr<DentedSurface> Surface;
  Vector3 Center;
};

// Quick to make.
const test::ElasticCase& CoarseSphere()
{
  static const auto made = []
  {
    auto sphere = std::make_unique<test::ElasticCase>();
    sphere->Model = test::SphereModel();
    sphere->Build(6, 6);
    return sphere;
  }();
  return *made;
}

TEST(DentedSurface, IsThatOfTheExactSphere)
{
  for (const double core : {0.0, 5.0})
  {
    const DrawnSphere drawn(test::SphereCase(core), 12);
    for (const double depth : {1.0, 2.0, 4.0})
    {
      constexpr double Ball = 8.0;
      const ElasticForce force = ElasticForce::Of(
          ComplianceAtlas(drawn.Maps), test::SphereCase(core).Model, Vector3::UnitZ(), depth, Ball);
      const ExactDent exact(test::SphereTruth(core), force.ForceWorld.z(), force.PatchRadius);
      const auto points = drawn.PressedAt(Vector3::UnitZ(), depth, Ball);
      double square = 0.0;
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        const Vector3& direction = drawn.Mesh.Directions()[i];
        const Vector3 rest = drawn.Center + test::Radius * direction;
        square += (points[i] - rest - exact.At(direction)).squaredNorm();
      }
      EXPECT_LT(std::sqrt(square / static_cast<double>(points.size())), 0.05)
          << "core " << core << ", " << depth << " mm deep";
    }
  }
}

// Up to half of the ball's radius; with triangles of 1 mm, whose middles cut 0.05 mm off.
TEST(DentedSurface, KeepsOutOfTheBall)
{
  const DrawnSphere drawn(CoarseSphere(), 30);
  for (const double ball : {4.0, 8.0})
  {
    const Vector3 direction = Vector3(1.0, -2.0, 2.0).normalized();
    const auto points = drawn.PressedAt(direction, 0.5 * ball, ball);
    const Vector3 center = drawn.Center + (test::Radius + 0.5 * ball) * direction;
    for (const auto& triangle : drawn.Mesh.Triangles())
    {
      Vector3 middle = Vector3::Zero();
      for (const int corner : triangle)
      {
        const Vector3& point = points[static_cast<std::size_t>(corner)];
        EXPECT_GT((point - center).norm(), ball - 1e-9);
        middle += point / 3.0;
      }
      EXPECT_GT((middle - center).norm(), ball - 0.1);
    }
  }
}

TEST(DentedSurface, RestsWithoutDepth)
{
  const DrawnSphere drawn(CoarseSphere(), 6);
  EXPECT_EQ(drawn.PressedAt(Vector3::UnitX(), 0.0, 8.0), drawn.Surface->RestWorld());
  EXPECT_EQ(drawn.PressedAt(Vector3::UnitX(), -1.0, 8.0), drawn.Surface->RestWorld());
}

TEST(PackedCompliance, IsWithinHalfAThousandth)
{
  const ReducedCompliance kept = CoarseSphere().Reduced.Truncated(5);
  const PackedCompliance packed = PackedCompliance::Of(CoarseSphere().Reduced, 5);
  ASSERT_TRUE(packed.Check().IsOk());
  const Eigen::MatrixXd back = packed.Unpacked().Matrix();
  const Eigen::VectorXd roots = kept.Matrix().diagonal().cwiseSqrt();
  const Eigen::MatrixXd most = 0.5001e-3 * roots * roots.transpose();
  EXPECT_TRUE(((back - kept.Matrix()).cwiseAbs().array() <= most.array()).all());
}

TEST(PackedCompliance, RefusesWhatIsIncomplete)
{
  const PackedCompliance whole = PackedCompliance::Of(CoarseSphere().Reduced, 3);
  const auto refused = [&](const auto& change)
  {
    PackedCompliance packed = whole;
    change(packed);
    return !packed.Check().IsOk();
  };
  EXPECT_TRUE(refused([](PackedCompliance& p) { p.Roots.pop_back(); }));
  EXPECT_TRUE(refused([](PackedCompliance& p) { p.Relative.pop_back(); }));
  EXPECT_TRUE(refused([](PackedCompliance& p) { p.Relative[7] = 1001; }));
  EXPECT_TRUE(refused([](PackedCompliance& p) { p.Roots[3] = 0.0; }));
  EXPECT_TRUE(refused([](PackedCompliance& p) { p.Degree = ReducedCompliance::MostDegree + 1; }));
  EXPECT_TRUE(refused([](PackedCompliance& p) { p.Degree = 2; }));
}
} // namespace
} // namespace palpate::dented_surface_test
