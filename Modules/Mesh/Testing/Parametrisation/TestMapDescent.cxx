#include "MapDescent.h"

#include "ClosedMeshes.h"
#include "SphereMapQuality.h"

#include <gtest/gtest.h>
#include <numeric>

namespace palpate::map_descent_test
{
namespace
{
// A closed mesh whose points have the directions of a sphere's.
struct MappedMesh
{
  explicit MappedMesh(const IndexedMesh& mesh, const IndexedMesh& sphere)
      : Triangles(mesh.Triangles), Present(mesh.Points.size())
  {
    EXPECT_TRUE(VertexRings::From(mesh, this->Rings).IsOk());
    for (std::size_t i = 0; i < mesh.Points.size(); ++i)
    {
      this->Vertices.push_back({mesh.Points[i], sphere.Points[i].normalized()});
    }
    std::iota(this->Present.begin(), this->Present.end(), 0);
  }

  bool IsOneToOne() const
  {
    std::vector<Vector3> directions;
    for (const MappedVertex& vertex : this->Vertices)
    {
      directions.push_back(vertex.Direction);
    }
    return IsBijective(this->Triangles, directions);
  }

  std::vector<std::array<int, 3>> Triangles;
  VertexRings Rings;
  std::vector<MappedVertex> Vertices;
  std::vector<int> Present;
};

TEST(MapDescent, EnergyOfASphereIsItsArea)
{
  const IndexedMesh sphere = test::SphereMesh(12);
  MappedMesh map(sphere, sphere);
  // 2^2.5 times the area, and the share of equilateral triangles; the flat triangles lack 1 %.
  const double whole = 16.0 * M_SQRT2 * M_PI;
  EXPECT_NEAR(MapDescent(map.Rings, map.Present, map.Vertices).Energy(),
              whole * std::pow(1.0 + 3.0 * 0.005, 1.5), 0.02 * whole);
}

TEST(MapDescent, KeepsTheMapOneToOneAndLowersItsEnergy)
{
  MappedMesh map(test::BentMesh(10, 6.0, 4.0), test::SphereMesh(10));
  MapDescent descent(map.Rings, map.Present, map.Vertices);
  const double before = descent.Energy();
  descent.Run(100);
  EXPECT_LT(descent.Energy(), 0.6 * before);
  EXPECT_TRUE(map.IsOneToOne());
}

TEST(MapDescent, ASecondDescentHardlyGoesOn)
{
  MappedMesh map(test::BentMesh(8, 4.0, 3.0), test::SphereMesh(8));
  MapDescent descent(map.Rings, map.Present, map.Vertices);
  descent.Run(1000);
  const double first = descent.Energy();
  MapDescent again(map.Rings, map.Present, map.Vertices);
  EXPECT_DOUBLE_EQ(again.Energy(), first);
  again.Run(1000);
  EXPECT_GT(again.Energy(), 0.98 * first);
}
} // namespace
} // namespace palpate::map_descent_test
