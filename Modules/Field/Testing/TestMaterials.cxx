#include "DenseReference.h"
#include "FieldCases.h"
#include "FieldSampler.h"
#include "ProceduralFields.h"
#include "RandomRays.h"
#include "RayOracle.h"

#include <limits>

namespace palpate::materials_test
{
namespace
{
using test::DenseReference;
using test::PlainGrid;

const double Infinity = std::numeric_limits<double>::infinity();

// Two channels of noise and plateaus on one grid, with the material where both reach their
// iso-values.
struct Conjunction
{
  FieldGrid Grid;
  std::vector<double> First;
  std::vector<double> Second;
  double SecondIso;
  std::shared_ptr<const ScalarField> Field;

  Conjunction(FieldInterpolation method, std::mt19937_64& random)
      : Grid(PlainGrid(
            {3 + static_cast<int>(random() % 17), 3 + static_cast<int>(random() % 9), 11})),
        First(test::RandomSteps(Grid, random, 4)), Second(test::RandomSteps(Grid, random, 3)),
        SecondIso(random() % 2 == 0 ? 1.0 : 0.5)
  {
    FieldBuilder builder(this->Grid);
    const int first = builder.AddChannel(SamplesOfGrid(this->First.data(), this->Grid));
    const int second = builder.AddChannel(SamplesOfGrid(this->Second.data(), this->Grid));
    builder.AddMaterial({first, 1.5}, {second, this->SecondIso});
    builder.SetInterpolation(method);
    const Status status = builder.Build(this->Field);
    EXPECT_TRUE(status.IsOk()) << status.Message();
  }
};

TEST(Materials, TwoConditionsAgreeWithTheOracle)
{
  for (const auto method : {FieldInterpolation::Trilinear, FieldInterpolation::TricubicBSpline})
  {
    std::mt19937_64 random(71);
    int hits = 0;
    for (int v = 0; v < 40; ++v)
    {
      const Conjunction c(method, random);
      const RayCaster caster(c.Field);
      const DenseReference first(c.Grid.Size(), c.First, method);
      const DenseReference second(c.Grid.Size(), c.Second, method);
      const double tolerance = method == FieldInterpolation::Trilinear ? 1e-13 : 1e-5;
      const test::RayOracle oracle(c.Grid.Size(), {{&first, 1.5}, {&second, c.SecondIso}}, method,
                                   tolerance);
      for (int r = 0; r < 60; ++r)
      {
        const FieldRay ray = test::RandomRay(c.Grid, random);
        double tMin = -Infinity;
        for (int crossing = 0; crossing < 4; ++crossing)
        {
          const FieldHit hit = caster.CastIndex(ray, tMin, Infinity);
          ASSERT_EQ(oracle.Fault(ray, tMin, Infinity, hit), "")
              << "volume " << v << " ray " << r << " crossing " << crossing;
          if (hit.Kind == HitKind::Missed)
          {
            break;
          }
          ++hits;
          tMin = std::nextafter(hit.T, Infinity);
        }
      }
    }
    EXPECT_GE(hits, 500);
  }
}

// Three nested objects and a separate one, on two channels.
struct Scene
{
  FieldGrid Grid = PlainGrid({60, 40, 40});
  test::SphereField Sphere{{20, 20, 20}, 0.0};
  std::vector<double> Distances = test::SampleAtIndices(Grid.Size(), Sphere);
  std::vector<double> Height = test::SampleAtIndices(Grid.Size(), test::PlaneField{{1, 0, 0}, 0.0});
  std::shared_ptr<const ScalarField> Field;

  Scene()
  {
    FieldBuilder builder(this->Grid);
    const int distances = builder.AddChannel(SamplesOfGrid(this->Distances.data(), this->Grid));
    const int height = builder.AddChannel(SamplesOfGrid(this->Height.data(), this->Grid));
    builder.AddMaterial({distances, -15.0});                                     // 0: a sphere
    builder.AddMaterial({distances, -8.0});                                      // 1: in it
    builder.AddMaterial({height, 45.0});                                         // 2: a wall
    builder.AddMaterial({distances, -15.0}, {height, 20.0, FieldSense::AtMost}); // 3: half a sphere
    const Status status = builder.Build(this->Field);
    EXPECT_TRUE(status.IsOk()) << status.Message();
  }
};

TEST(Materials, HitNamesItsMaterial)
{
  const Scene scene;
  const RayCaster caster(scene.Field);
  const FieldRay ray{{-10, 20, 20}, {1, 0, 0}};
  struct Expected
  {
    int Material;
    bool IsEntering;
    double T;
    MaterialSet StartsInside;
  };
  // Material 3 shares the first boundary with material 0, the lower number, which is reported.
  const Expected expected[] = {
      {0, true, 15, 0b0000},  {1, true, 22, 0b1001}, {3, false, 30, 0b1011}, {1, false, 38, 0b0011},
      {0, false, 45, 0b0001}, {2, true, 55, 0b0000}, {2, false, 69, 0b0100}};
  double tMin = 0.0;
  for (const Expected& e : expected)
  {
    const FieldHit hit = caster.CastIndex(ray, tMin, Infinity);
    ASSERT_NE(hit.Kind, HitKind::Missed) << e.T;
    EXPECT_EQ(hit.Material, e.Material) << e.T;
    EXPECT_EQ(hit.IsEntering, e.IsEntering) << e.T;
    EXPECT_NEAR(hit.T, e.T, 0.02) << e.T; // chords of the sphere
    EXPECT_EQ(hit.StartsInside, e.StartsInside) << e.T;
    EXPECT_EQ(hit.Kind, e.T < 69 ? HitKind::Surface : HitKind::Border);
    tMin = std::nextafter(hit.T, Infinity);
  }
  EXPECT_EQ(caster.CastIndex(ray, tMin, Infinity).Kind, HitKind::Missed);
}

TEST(Materials, HitsOnlyRequestedMaterials)
{
  const Scene scene;
  const RayCaster caster(scene.Field);
  const FieldRay ray{{-10, 20, 20}, {1, 0, 0}};
  EXPECT_EQ(caster.CastIndex(ray, 0, Infinity, OnlyMaterial(1)).Material, 1);
  EXPECT_EQ(caster.CastIndex(ray, 0, Infinity, OnlyMaterial(2)).Material, 2);
  EXPECT_EQ(caster.CastIndex(ray, 0, Infinity, OnlyMaterial(3)).Material, 3);
  EXPECT_EQ(caster.CastIndex(ray, 0, 54, OnlyMaterial(2)).Kind, HitKind::Missed);
  EXPECT_EQ(caster.CastIndex(ray, 0, Infinity, 0).Kind, HitKind::Missed);
  const FieldHit inside = caster.CastIndex({{20, 20, 20}, {1, 0, 0}}, 0, 1e-3, OnlyMaterial(0));
  EXPECT_EQ(inside.Kind, HitKind::Missed);
  EXPECT_EQ(inside.StartsInside, OnlyMaterial(0));
}

TEST(Materials, NormalPointsOutwardsForEitherSense)
{
  const Scene scene;
  const RayCaster caster(scene.Field);
  // Leaves material 3 across its plane, with the condition "at most".
  const FieldHit hit =
      caster.CastIndex({{15, 20.5, 20.5}, {1, 0, 0}}, 0, Infinity, OnlyMaterial(3));
  EXPECT_FALSE(hit.IsEntering);
  EXPECT_NEAR(hit.T, 5.0, 1e-13); // roundings of 20 voxels
  EXPECT_EQ(-hit.Gradient, Vector3(1, 0, 0));
}

TEST(Materials, SamplerFindsAllMaterials)
{
  const Scene scene;
  const FieldSampler sampler(scene.Field);
  EXPECT_EQ(test::MaterialsAt(sampler, {19, 20, 20}), 0b1011u);
  EXPECT_EQ(test::MaterialsAt(sampler, {21, 20, 20}), 0b0011u);
  EXPECT_EQ(test::MaterialsAt(sampler, {20, 20, 20}), 0b1011u); // at most 20 is closed too
  EXPECT_EQ(test::MaterialsAt(sampler, {8, 20, 20}), 0b1001u);
  EXPECT_EQ(test::MaterialsAt(sampler, {50, 1, 1}), 0b0100u);
  EXPECT_EQ(test::MaterialsAt(sampler, {40, 1, 1}), 0u);
  EXPECT_EQ(test::MaterialsAt(sampler, {60, 1, 1}), 0u);
}

TEST(Materials, StoresSurfacesOfMaterialsNotChannels)
{
  const FieldGrid grid = PlainGrid({129, 33, 33});
  const auto distances = test::SampleAtIndices<std::int16_t>(grid.Size(), test::GyroidField{6.0});
  const auto height =
      test::SampleAtIndices<std::int16_t>(grid.Size(), test::PlaneField{{1, 0, 0}, 0.0});
  FieldBuilder builder(grid);
  const int everywhere = builder.AddChannel(SamplesOfGrid(distances.data(), grid));
  const int right = builder.AddChannel(SamplesOfGrid(height.data(), grid));
  builder.AddMaterial({everywhere, 1.0}, {right, 100.5});
  std::shared_ptr<const ScalarField> field;
  ASSERT_TRUE(builder.Build(field).IsOk());
  EXPECT_LE(field->Channel(everywhere).BlockCount(), 4u * 4u * 4u); // bricks from i = 96 on
}
} // namespace
} // namespace palpate::materials_test
