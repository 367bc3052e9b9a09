#include "QuarteredCells.h"

#include "RandomShapes.h"
#include "SphericalTriangle.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace palpate::quartered_cells_test
{
namespace
{
using test::Random;

constexpr std::size_t Groups = 64;
constexpr std::size_t Whole = 5; // groups of the 20 faces of an icosahedron
using Cells = QuarteredCells<Groups>;

// The triangles of cells that are not quartered, as a user of the numbers keeps them.
class Tiling
{
public:
  Tiling() : Triangles(Cells::Capacity), IsTile(Cells::Capacity, false)
  {
    this->Numbers.Begin(Whole);
    const std::vector<SphericalTriangle> faces = SphericalTriangle::Icosahedron();
    std::copy(faces.begin(), faces.end(), this->Triangles.begin());
    std::fill_n(this->IsTile.begin(), faces.size(), true);
  }

  bool Quarter(std::size_t cell)
  {
    const std::size_t group = this->Numbers.Quarter(cell);
    if (group == Cells::None)
    {
      return false;
    }
    const auto parts = this->Triangles[cell].Split();
    this->IsTile[cell] = false;
    for (std::size_t part = 0; part < 4; ++part)
    {
      EXPECT_FALSE(this->IsTile[4 * group + part]) << "used twice";
      this->Triangles[4 * group + part] = parts[part];
      this->IsTile[4 * group + part] = true;
    }
    return true;
  }

  template <typename MayJoin>
  void Join(const MayJoin& mayJoin)
  {
    this->Numbers.Join(mayJoin,
                       [&](std::size_t cell, std::size_t group)
                       {
                         EXPECT_FALSE(this->IsTile[cell]);
                         this->IsTile[cell] = true;
                         for (std::size_t part = 4 * group; part < 4 * group + 4; ++part)
                         {
                           EXPECT_TRUE(this->IsTile[part]) << "joined although quartered";
                           this->IsTile[part] = false;
                         }
                       });
  }

  // How many tiles contain a direction, by the planes of their sides.
  int TilesAt(const Vector3& direction) const
  {
    int count = 0;
    for (std::size_t cell = 0; cell < Cells::Capacity; ++cell)
    {
      const auto& [a, b, c] = this->Triangles[cell].Corners;
      const double side = a.dot(b.cross(c));
      count += this->IsTile[cell] && side * direction.dot(a.cross(b)) >= 0.0 &&
               side * direction.dot(b.cross(c)) >= 0.0 && side * direction.dot(c.cross(a)) >= 0.0;
    }
    return count;
  }

  std::size_t Count() const
  {
    return static_cast<std::size_t>(std::count(this->IsTile.begin(), this->IsTile.end(), true));
  }
  std::size_t RandomTile(Random& random) const
  {
    std::size_t cell = random() % Cells::Capacity;
    while (!this->IsTile[cell])
    {
      cell = (cell + 1) % Cells::Capacity;
    }
    return cell;
  }
  const Cells& Numbered() const { return this->Numbers; }

private:
  Cells Numbers;
  std::vector<SphericalTriangle> Triangles;
  std::vector<bool> IsTile;
};

TEST(QuarteredCells, CoverTheSphereOnceHoweverTheyAreQuarteredAndJoined)
{
  Random random(9411);
  Tiling tiling;
  int full = 0;
  for (int step = 0; step < 2000; ++step)
  {
    full += tiling.Quarter(tiling.RandomTile(random)) ? 0 : 1;
    if (random() % 40 == 0)
    {
      const std::size_t kept = random() % 4;
      tiling.Join([&](std::size_t group) { return group % 4 != kept; });
    }
    if (step % 20 == 0)
    {
      ASSERT_EQ(tiling.TilesAt(test::RandomDirection(random)), 1) << step;
    }
    // Each quartered cell takes a group and gives three more tiles.
    ASSERT_EQ(tiling.Count(), 20 + 3 * (Groups - Whole - tiling.Numbered().FreeGroups())) << step;
  }
  EXPECT_GT(full, 10);
}

TEST(QuarteredCells, JoinedAgainAllAreWhole)
{
  Random random(9412);
  Tiling tiling;
  while (tiling.Quarter(tiling.RandomTile(random)))
  {
  }
  EXPECT_EQ(tiling.Numbered().FreeGroups(), 0);
  for (int pass = 0; pass < 64 && tiling.Count() > 20; ++pass)
  {
    tiling.Join([](std::size_t) { return true; });
  }
  EXPECT_EQ(tiling.Count(), 20);
  EXPECT_EQ(tiling.Numbered().FreeGroups(), Groups - Whole);
}
} // namespace
} // namespace palpate::quartered_cells_test
