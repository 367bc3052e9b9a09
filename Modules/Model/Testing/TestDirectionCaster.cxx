#include "DirectionCaster.h"

#include "MeshShapes.h"
#include "RandomShapes.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace palpate::direction_caster_test
{
namespace
{

// Solves center + distance d = a + u (b - a) + v (c - a) for every triangle.
std::vector<double> CrossingsByElimination(const IndexedMesh& mesh, const Vector3& center,
                                           const Vector3& d)
{
  std::vector<double> distances;
  for (const auto& t : mesh.Triangles)
  {
    const Vector3& a = mesh.Points[static_cast<std::size_t>(t[0])];
    Eigen::Matrix3d system;
    system.col(0) = d;
    system.col(1) = a - mesh.Points[static_cast<std::size_t>(t[1])];
    system.col(2) = a - mesh.Points[static_cast<std::size_t>(t[2])];
    const Vector3 solution = system.fullPivLu().solve(a - center);
    if (solution[0] > 0.0 && solution[1] >= 0.0 && solution[2] >= 0.0 &&
        solution[1] + solution[2] <= 1.0)
    {
      distances.push_back(solution[0]);
    }
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

// A star-shaped body with deep dents, so that rays from off-centre cross it several times.
IndexedMesh DentedBody(palpate::test::Random& random, int frequency)
{
  const Vector3 axis = palpate::test::RandomDirection(random);
  IndexedMesh mesh = test::Sphere(frequency);
  for (Vector3& u : mesh.Points)
  {
    u *= 10.0 + 6.0 * std::sin(8.0 * axis.dot(u));
  }
  return mesh;
}

TEST(DirectionCaster, AgreesWithEliminationFromInsideAndOutside)
{
  palpate::test::Random random(11);
  std::uniform_real_distribution<double> place(-15.0, 15.0);
  for (int round = 0; round < 12; ++round)
  {
    const IndexedMesh mesh = DentedBody(random, 6);
    const Vector3 center(place(random), place(random), place(random));
    const auto directions = palpate::test::RandomDirections(random, 200);
    const auto found = DirectionCaster(directions).Cast(mesh, center);
    for (std::size_t i = 0; i < directions.size(); ++i)
    {
      const auto expected = CrossingsByElimination(mesh, center, directions[i]);
      ASSERT_EQ(found[i].size(), expected.size()) << "round " << round << ", ray " << i;
      for (std::size_t k = 0; k < expected.size(); ++k)
      {
        // Rays are rotated by 1e-11; a grazing crossing moves by a large multiple of that.
        ASSERT_NEAR(found[i][k].Distance, expected[k], 1e-7);
      }
    }
  }
}

TEST(DirectionCaster, RaysThroughVerticesCrossOnce)
{
  const IndexedMesh mesh = test::Sphere(12, 5.0);
  std::vector<Vector3> directions;
  for (const auto& t : mesh.Triangles)
  {
    const Vector3& a = mesh.Points[static_cast<std::size_t>(t[0])];
    const Vector3& b = mesh.Points[static_cast<std::size_t>(t[1])];
    directions.push_back(a.normalized());       // a vertex
    directions.push_back((a + b).normalized()); // an edge
  }
  for (const auto& list : DirectionCaster(directions).Cast(mesh, Vector3::Zero()))
  {
    ASSERT_EQ(list.size(), 1U);
  }
}

TEST(DirectionCaster, CrossesClosedMeshEvenlyFromOutside)
{
  palpate::test::Random random(3);
  const IndexedMesh mesh = DentedBody(random, 10);
  const auto directions = palpate::IcosahedronDirections(15).Directions();
  for (const auto& list : DirectionCaster(directions).Cast(mesh, Vector3(20.0, 3.0, -2.0)))
  {
    ASSERT_EQ(list.size() % 2, 0U);
  }
}

TEST(DirectionCaster, FindsTrianglesThatFillHalfTheSphere)
{
  IndexedMesh mesh; // a large tetrahedron around the centre
  mesh.Points = {{100, 100, 100}, {100, -100, -100}, {-100, 100, -100}, {-100, -100, 100}};
  mesh.Triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  const auto directions = palpate::IcosahedronDirections(20).Directions();
  for (const auto& list : DirectionCaster(directions).Cast(mesh, Vector3(1.0, 2.0, 3.0)))
  {
    ASSERT_EQ(list.size(), 1U);
  }
}

TEST(DirectionCaster, CountsNearerTrianglesExceptTheOwn)
{
  // Two spheres in a row, seen from the origin.
  IndexedMesh mesh = test::Sphere(6, 1.0, {5.0, 0.0, 0.0});
  const auto own = static_cast<int>(mesh.Triangles.size());
  mesh.Points.insert(mesh.Points.end(), {{20, -1, -1}, {20, 1, -1}, {20, 0, 1}});
  const auto last = static_cast<int>(mesh.Points.size());
  mesh.Triangles.push_back({last - 3, last - 2, last - 1});
  const DirectionCaster caster({Vector3(1.0, 0.01, 0.007).normalized()});
  EXPECT_EQ(caster.CountNearer(mesh, Vector3::Zero(), {own}, {20.0}), std::vector<int>{2});
  EXPECT_EQ(caster.CountNearer(mesh, Vector3::Zero(), {own}, {5.0}), std::vector<int>{1});
}
} // namespace
} // namespace palpate::direction_caster_test
