#include "BeamClearance.h"

#include "FieldCases.h"
#include "ProceduralFields.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::beam_clearance_test
{
namespace
{
Vector3 RandomVector(std::mt19937_64& random, double size)
{
  std::uniform_real_distribution<double> part(-size, size);
  const double x = part(random);
  const double y = part(random);
  return {x, y, part(random)};
}

// Rays of an image tile: four corners.
struct Bundle
{
  FieldRay Corners[4];

  FieldRay At(double a, double b) const
  {
    const auto mix = [&](const auto& of)
    {
      return Vector3((1 - b) * ((1 - a) * of(this->Corners[0]) + a * of(this->Corners[1])) +
                     b * ((1 - a) * of(this->Corners[2]) + a * of(this->Corners[3])));
    };
    return {mix([](const FieldRay& ray) { return ray.Origin; }),
            mix([](const FieldRay& ray) { return ray.Direction; })};
  }
};

// Perspective, parallel, or along an axis.
Bundle RandomBundle(std::mt19937_64& random, const FieldGrid& grid, double width)
{
  const Vector3 size(grid.Size()[0], grid.Size()[1], grid.Size()[2]);
  const Vector3 aim = 0.5 * size + RandomVector(random, 60.0);
  const auto kind = random() % 3;
  const Vector3 eye =
      kind == 2 ? Vector3(aim + (random() % 2 == 0 ? 100.0 : -100.0) *
                                    Vector3::Unit(static_cast<Eigen::Index>(random() % 3)))
                : Vector3(0.5 * size + RandomVector(random, 80.0));
  const Vector3 across = RandomVector(random, width);
  const Vector3 up = RandomVector(random, width);
  // The image's near plane, beyond which some rays are already in the grid.
  const double near = std::uniform_real_distribution<double>(0.0, 1.0)(random);
  Bundle bundle;
  for (int corner = 0; corner < 4; ++corner)
  {
    const Vector3 offset = (corner % 2) * across + (corner / 2) * up;
    const Vector3 target = aim + offset;
    bundle.Corners[corner] = kind == 0
                                 ? FieldRay{eye + near * (target - eye), 2.0 * (target - eye)}
                                 : FieldRay{eye + near * (aim - eye) + offset, 2.0 * (aim - eye)};
  }
  return bundle;
}

FieldHit Cast(const RayCaster& caster, const FieldRay& ray, double from)
{
  return caster.CastIndex(ray, from, 1.0);
}

void ExpectSameHits(const std::shared_ptr<const ScalarField>& field, std::mt19937_64& random,
                    int& skipped)
{
  const RayCaster caster(field);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int i = 0; i < 300; ++i)
  {
    const Bundle bundle = RandomBundle(random, field->Grid(), i % 3 == 0 ? 0.0 : 0.1 * i);
    const double clear = ClearUntil(*field, BeamOf(bundle.Corners), 0.0, 1.0);
    ASSERT_GE(clear, 0.0);
    ASSERT_LE(clear, 1.0);
    skipped += clear > 0.0 ? 1 : 0;
    for (int r = 0; r < 20; ++r)
    {
      const FieldRay ray = bundle.At(part(random), part(random));
      const FieldHit whole = Cast(caster, ray, 0.0);
      const FieldHit rest = Cast(caster, ray, clear);
      ASSERT_EQ(whole.Kind, rest.Kind) << "bundle " << i;
      ASSERT_EQ(whole.T, rest.T);
      ASSERT_EQ(whole.IsEntering, rest.IsEntering);
    }
  }
}

// Small spheres far apart.
struct SpheresField
{
  std::vector<test::SphereField> Spheres;

  double Value(const Vector3& p) const
  {
    double most = -1e3;
    for (const test::SphereField& sphere : this->Spheres)
    {
      most = std::max(most, sphere.Value(p));
    }
    return most;
  }
};

TEST(BeamClearance, SkipsNoneOfManySpheres)
{
  std::mt19937_64 random(73);
  int skipped = 0;
  const FieldGrid grid = test::PlainGrid({120, 110, 130});
  SpheresField spheres;
  for (int sphere = 0; sphere < 25; ++sphere)
  {
    spheres.Spheres.push_back({Vector3(60.0, 55.0, 65.0) + RandomVector(random, 50.0), 2.5});
  }
  const auto samples = test::SampleAtIndices(grid.Size(), spheres);
  const auto field = test::MakeField(grid, samples, 0.0);
  for (int round = 0; round < 30; ++round)
  {
    ExpectSameHits(field, random, skipped);
  }
  EXPECT_GT(skipped, 900);
}

TEST(BeamClearance, SkipsNoHitOfAnyRay)
{
  std::mt19937_64 random(71);
  int skipped = 0;
  const FieldGrid grid = test::PlainGrid({70, 61, 83});
  const test::SphereField sphere{{30.0, 28.0, 40.0}, 9.0};
  ExpectSameHits(test::MakeField(grid, test::SampleAtIndices(grid.Size(), sphere), 0.0), random,
                 skipped);
  ExpectSameHits(
      test::MakeField(grid, test::SampleAtIndices(grid.Size(), test::GyroidField{40.0}), 0.0),
      random, skipped);
  EXPECT_GT(skipped, 300);
}

TEST(BeamClearance, SkipsNoMaterialAtTheGridBorder)
{
  std::mt19937_64 random(72);
  int skipped = 0;
  const FieldGrid grid = test::PlainGrid({70, 61, 83});
  // A plane: everything on one side is inside, up to the border.
  const test::PlaneField plane{{0.36, 0.48, -0.8}, -5.0};
  ExpectSameHits(test::MakeField(grid, test::SampleAtIndices(grid.Size(), plane), 0.0), random,
                 skipped);
  EXPECT_GT(skipped, 30);
}

// Bricks that each contain some surface: only cells are skipped.
TEST(BeamClearance, SkipsNoSheetBetweenFreeCells)
{
  std::mt19937_64 random(74);
  const FieldGrid grid = test::PlainGrid({70, 61, 83});
  SpheresField spheres;
  for (int sphere = 0; sphere < 400; ++sphere)
  {
    spheres.Spheres.push_back({Vector3(35.0, 30.0, 41.0) + RandomVector(random, 40.0), 0.9});
  }
  int skipped = 0;
  const auto samples = test::SampleAtIndices(grid.Size(), spheres);
  const auto field = test::MakeField(grid, samples, 0.0);
  for (int round = 0; round < 30; ++round)
  {
    ExpectSameHits(field, random, skipped);
  }
  EXPECT_GT(skipped, 300);
}

// The beam is wider than the region known to be empty around its centre.
TEST(BeamClearance, SkipsNothingOffTheCentralRay)
{
  const FieldGrid grid = test::PlainGrid({120, 120, 120});
  const test::SphereField sphere{{20.0, 60.0, 60.0}, 6.0};
  const auto field = test::MakeField(grid, test::SampleAtIndices(grid.Size(), sphere), 0.0);
  FieldRay corners[4];
  for (int corner = 0; corner < 4; ++corner)
  {
    const Vector3 origin(corner % 2 == 0 ? 16.0 : 104.0, corner / 2 == 0 ? 50.0 : 70.0, -30.0);
    corners[corner] = {origin, Vector3::UnitZ()};
  }
  // The ray above the sphere's centre meets it at z = 54.
  EXPECT_LE(ClearUntil(*field, BeamOf(corners), 0.0, 1000.0), 84.0);
}

TEST(BeamClearance, IsTheWholeIntervalWithoutSurface)
{
  const FieldGrid grid = test::PlainGrid({70, 70, 70});
  const test::SphereField sphere{{20.0, 20.0, 20.0}, 6.0};
  const auto field = test::MakeField(grid, test::SampleAtIndices(grid.Size(), sphere), 0.0);
  const FieldRay past[4] = {{{60.0, 60.0, -50.0}, Vector3::UnitZ()},
                            {{61.0, 60.0, -50.0}, Vector3::UnitZ()},
                            {{60.0, 61.0, -50.0}, Vector3::UnitZ()},
                            {{61.0, 61.0, -50.0}, Vector3::UnitZ()}};
  EXPECT_EQ(ClearUntil(*field, BeamOf(past), 0.0, 1000.0), 1000.0);
  const FieldRay away[4] = {{{20.0, 20.0, -50.0}, -Vector3::UnitZ()},
                            {{20.0, 20.0, -50.0}, -Vector3::UnitZ()},
                            {{20.0, 20.0, -50.0}, -Vector3::UnitZ()},
                            {{20.0, 20.0, -50.0}, -Vector3::UnitZ()}};
  EXPECT_EQ(ClearUntil(*field, BeamOf(away), 0.0, 1000.0), 1000.0);
}

TEST(BeamClearance, EndsNearTheSurface)
{
  const FieldGrid grid = test::PlainGrid({70, 70, 70});
  const test::SphereField sphere{{35.0, 35.0, 35.0}, 6.0};
  const auto field = test::MakeField(grid, test::SampleAtIndices(grid.Size(), sphere), 0.0);
  const FieldRay ray{{35.0, 35.0, -50.0}, Vector3::UnitZ()};
  const FieldRay corners[4] = {ray, ray, ray, ray};
  const double clear = ClearUntil(*field, BeamOf(corners), 0.0, 1000.0);
  // The surface is at z = 29, where the first cell with a surface begins.
  EXPECT_LE(clear, 79.0);
  EXPECT_GE(clear, 50.0 + 28.0 - 1e-3);
}
} // namespace
} // namespace palpate::beam_clearance_test
