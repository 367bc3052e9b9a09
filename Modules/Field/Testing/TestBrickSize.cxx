#include "BeamClearance.h"
#include "CellBox.h"
#include "FieldCases.h"
#include "FieldSampler.h"
#include "MaterialVolume.h"
#include "RandomRays.h"
#include "RayCaster.h"
#include "SameBits.h"

#include <algorithm>

namespace palpate
{
namespace
{
using test::MaterialVolume;
using test::RandomPointNear;
using test::SameBits;

constexpr FieldInterpolation Methods[] = {FieldInterpolation::Trilinear,
                                          FieldInterpolation::TricubicBSpline};
constexpr BrickSize OtherSizes[] = {BrickSize::Cells4, BrickSize::Cells16};

void ExpectSameSamples(const ScalarField& field, const FieldGradientSample& a,
                       const FieldGradientSample& b)
{
  ASSERT_EQ(a.Kind, b.Kind);
  ASSERT_EQ(a.Value, b.Value);
  ASSERT_EQ(a.Gradient, b.Gradient) << field.Layout().Cells;
}

TEST(BrickSize, ChangesNoValueAndNoGradientInAnyBit)
{
  std::mt19937_64 random(31);
  constexpr double Everywhere = 1e6; // mm, so that all bricks are stored
  for (int round = 0; round < 12; ++round)
  {
    const MaterialVolume volume(random);
    for (const FieldInterpolation method : Methods)
    {
      const FieldSampler usual(volume.Make(method, Everywhere));
      for (const BrickSize size : OtherSizes)
      {
        const FieldSampler other(volume.Make({method, size}, Everywhere));
        for (int point = 0; point < 300; ++point)
        {
          const Vector3 p = RandomPointNear(volume.Grid, random);
          const int channel = point % 2;
          ExpectSameSamples(other.Field(), usual.ValueAndGradientIndex(channel, p),
                            other.ValueAndGradientIndex(channel, p));
        }
      }
    }
  }
}

TEST(BrickSize, ChangesNothingOfWhatIsInside)
{
  std::mt19937_64 random(32);
  for (int round = 0; round < 12; ++round)
  {
    const MaterialVolume volume(random);
    std::vector<Vector3> points;
    points.reserve(301);
    for (int point = 0; point < 301; ++point)
    {
      points.push_back(volume.Grid.PointWorld(RandomPointNear(volume.Grid, random)));
    }
    for (const FieldInterpolation method : Methods)
    {
      const FieldSampler usual(volume.Make(method));
      for (const BrickSize size : OtherSizes)
      {
        const auto field = volume.Make({method, size});
        for (const InstructionSet set : {InstructionSet::Portable, FastestInstructionSet()})
        {
          const FieldSampler other(field, set);
          for (int material = 0; material < 3; ++material)
          {
            std::vector<unsigned char> expected(points.size());
            std::vector<unsigned char> answers(points.size());
            usual.AreInsideWorld(material, points.data(), points.size(), expected.data());
            other.AreInsideWorld(material, points.data(), points.size(), answers.data());
            ASSERT_EQ(answers, expected) << field->Layout().Cells;
            ASSERT_EQ(other.IsInsideWorld(material, points[0]), expected[0] != 0);
          }
        }
      }
    }
  }
}

TEST(BrickSize, ChangesNoHitInAnyBit)
{
  std::mt19937_64 random(33);
  for (int round = 0; round < 16; ++round)
  {
    const MaterialVolume volume(random);
    std::vector<FieldRay> rays;
    for (int n = 0; n < 150; ++n)
    {
      const FieldRay ray = test::RandomRay(volume.Grid, random);
      rays.push_back({volume.Grid.PointWorld(ray.Origin), volume.Grid.VectorWorld(ray.Direction)});
    }
    for (const FieldInterpolation method : Methods)
    {
      const RayCaster usual(volume.Make(method));
      for (const BrickSize size : OtherSizes)
      {
        const auto field = volume.Make({method, size});
        for (const MaterialSet wanted : {AllMaterials, OnlyMaterial(0), OnlyMaterial(1)})
        {
          std::vector<FieldHit> expected(rays.size());
          std::vector<FieldHit> hits(rays.size());
          usual.CastAllWorld(rays.data(), rays.size(), 0.0, 200.0, expected.data(), wanted);
          RayCaster(field).CastAllWorld(rays.data(), rays.size(), 0.0, 200.0, hits.data(), wanted);
          for (std::size_t ray = 0; ray < rays.size(); ++ray)
          {
            ASSERT_TRUE(SameBits(hits[ray], expected[ray])) << field->Layout().Cells;
            ASSERT_TRUE(
                SameBits(RayCaster(field).CastWorld(rays[ray], 0.0, 200.0, wanted), expected[ray]))
                << field->Layout().Cells;
          }
        }
      }
    }
  }
}

TEST(BrickSize, ChangesNotWhichCellsASurfaceMayPass)
{
  std::mt19937_64 random(34);
  for (int round = 0; round < 10; ++round)
  {
    const MaterialVolume volume(random);
    for (const FieldInterpolation method : Methods)
    {
      const auto sorted = [&](BrickSize size)
      {
        auto cells = volume.Make({method, size})->SurfaceCells();
        std::sort(cells.begin(), cells.end());
        return cells;
      };
      const auto expected = sorted(BrickSize::Cells8);
      ASSERT_EQ(sorted(BrickSize::Cells4), expected);
      ASSERT_EQ(sorted(BrickSize::Cells16), expected);
    }
  }
}

// A box is free of a material that fills no brick exactly where it has no cell of the surface.
TEST(BrickSize, ChangesNotWhichBoxesOfCellsAreFree)
{
  std::mt19937_64 random(35);
  int free = 0;
  for (int round = 0; round < 30; ++round)
  {
    const FieldGrid grid = test::PlainGrid({40, 37, 35});
    std::vector<float> samples(grid.NodeCount(), 0.0f);
    for (int bump = 0; bump < 40; ++bump)
    {
      samples[random() % samples.size()] = 1.0f;
    }
    for (const BrickSize size : BrickSizes)
    {
      FieldBuilder builder(grid);
      builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), grid)), 0.5});
      builder.SetBrickSize(size);
      std::shared_ptr<const ScalarField> field;
      ASSERT_TRUE(builder.Build(field).IsOk());
      const auto cells = field->SurfaceCells();
      for (int trial = 0; trial < 60; ++trial)
      {
        CellBox box{};
        for (int axis = 0; axis < 3; ++axis)
        {
          const auto count = static_cast<unsigned>(grid.Size()[static_cast<std::size_t>(axis)]) - 1;
          box.First[axis] = static_cast<int>(random() % count);
          box.Last[axis] = std::min(static_cast<int>(count) - 1,
                                    box.First[axis] + static_cast<int>(random() % 14));
        }
        const bool isFree =
            std::none_of(cells.begin(), cells.end(),
                         [&box](const std::array<int, 3>& cell)
                         {
                           bool isIn = true;
                           for (int axis = 0; axis < 3; ++axis)
                           {
                             const int at = cell[static_cast<std::size_t>(axis)];
                             isIn = isIn && at >= box.First[axis] && at <= box.Last[axis];
                           }
                           return isIn;
                         });
        free += isFree ? 1 : 0;
        ASSERT_EQ(box.IsFree(*field), isFree) << field->Layout().Cells;
      }
    }
  }
  EXPECT_GT(free, 500) << "hardly any box was free, so that little was tested";
}

TEST(BrickSize, SmallerBricksKeepFewerNodesOfASmoothSurfaceButOfTheApronMore)
{
  const FieldGrid grid = test::PlainGrid({129, 129, 129});
  std::vector<float> samples(grid.NodeCount());
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const Vector3 at = test::NodeIndex(grid.Size(), n) - Vector3(64.0, 64.0, 64.0);
    samples[n] = static_cast<float>(40.0 - at.norm());
  }
  const auto nodesOf = [&](BrickSize size)
  {
    FieldBuilder builder(grid);
    builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), grid)), 0.0});
    builder.SetBrickSize(size);
    std::shared_ptr<const ScalarField> field;
    EXPECT_TRUE(builder.Build(field).IsOk());
    EXPECT_EQ(field->Layout().Cells, 1 << static_cast<int>(size));
    return field->Memory().StoredBlocks * field->Layout().NodesOfBrick();
  };
  const std::size_t usual = nodesOf(BrickSize::Cells8);
  EXPECT_LT(nodesOf(BrickSize::Cells4), usual);
  EXPECT_GT(nodesOf(BrickSize::Cells16), usual);
}
} // namespace
} // namespace palpate
