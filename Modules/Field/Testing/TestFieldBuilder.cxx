#include "FieldCases.h"
#include "FieldSampler.h"
#include "ProceduralFields.h"

#include <cstdint>
#include <limits>

namespace palpate::field_builder_test
{
namespace
{
using test::MakeField;
using test::PlainGrid;
using test::RefusalOf;

const FieldGrid Cube = PlainGrid({6, 6, 6});

std::vector<double> Ramp()
{
  return test::SampleAtIndices({6, 6, 6}, test::PlaneField{{1, 0, 0}, 0.0});
}

bool Details(const std::string& message, const std::string& part)
{
  return message.find(part) != std::string::npos;
}

std::string RefusalOfIso(double iso)
{
  const std::vector<double> ramp = Ramp();
  FieldBuilder builder(Cube);
  builder.AddMaterial({builder.AddChannel(SamplesOfGrid(ramp.data(), Cube)), iso});
  return RefusalOf(builder);
}

TEST(FieldBuilder, RejectsIsoValuesWithoutSurface)
{
  EXPECT_EQ(RefusalOfIso(2.5), "");
  EXPECT_EQ(RefusalOfIso(5.0), ""); // the iso-value itself is inside
  EXPECT_TRUE(Details(RefusalOfIso(5.5), "samples run from 0 to 5"));
  EXPECT_TRUE(Details(RefusalOfIso(0.0), "samples run from 0 to 5"));
  EXPECT_TRUE(Details(RefusalOfIso(std::numeric_limits<double>::quiet_NaN()), "no surface"));
}

TEST(FieldBuilder, RejectsNonFiniteSamples)
{
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    std::vector<double> ramp = Ramp();
    ramp[6 * 6 * 3 + 6 * 2 + 1] = bad;
    FieldBuilder builder(Cube);
    builder.AddMaterial({builder.AddChannel(SamplesOfGrid(ramp.data(), Cube)), 2.5});
    EXPECT_TRUE(Details(RefusalOf(builder), "index (1, 2, 3)"));
  }
}

std::string RefusalOfScaledRamp(double scale, double shift, FieldInterpolation interpolation)
{
  std::vector<double> ramp = Ramp();
  for (double& sample : ramp)
  {
    sample = sample * scale + shift;
  }
  FieldBuilder builder(Cube);
  builder.AddMaterial({builder.AddChannel(SamplesOfGrid(ramp.data(), Cube)), 2.5 * scale + shift});
  builder.SetInterpolation(interpolation);
  return RefusalOf(builder);
}

TEST(FieldBuilder, RejectsSamplesOutOfRange)
{
  const auto trilinear = FieldInterpolation::Trilinear;
  const auto tricubic = FieldInterpolation::TricubicBSpline;
  EXPECT_EQ(RefusalOfScaledRamp(1e139, 0.0, trilinear), "");
  EXPECT_EQ(RefusalOfScaledRamp(1e-139, 0.0, trilinear), "");
  EXPECT_TRUE(Details(RefusalOfScaledRamp(1e140, 0.0, trilinear), "from 0 to 5e+140"));
  EXPECT_TRUE(Details(RefusalOfScaledRamp(1e-141, 0.0, trilinear), "from 0 to 5e-141"));
  EXPECT_TRUE(Details(RefusalOfScaledRamp(-3e307, 1.5e308, trilinear), "rescale them"));
  EXPECT_EQ(RefusalOfScaledRamp(1e35, 0.0, tricubic), "");
  EXPECT_EQ(RefusalOfScaledRamp(1e-29, 0.0, tricubic), "");
  EXPECT_TRUE(Details(RefusalOfScaledRamp(1e36, 0.0, tricubic), "from 0 to 5e+36"));
  EXPECT_TRUE(Details(RefusalOfScaledRamp(1e-31, 0.0, tricubic), "from 0 to 5e-31"));
}

TEST(FieldBuilder, RejectsSingleSliceVolume)
{
  const FieldGrid slice = PlainGrid({6, 6, 1});
  const std::vector<double> ramp = Ramp();
  FieldBuilder builder(slice);
  builder.AddMaterial({builder.AddChannel(SamplesOfGrid(ramp.data(), slice)), 2.5});
  EXPECT_TRUE(Details(RefusalOf(builder), "1 samples along axis 2"));
}

TEST(FieldBuilder, NeedsNoMaterialIfAllIsKept)
{
  const std::vector<double> constant(6 * 6 * 6, 7.5);
  FieldBuilder builder(Cube);
  builder.AddChannel(SamplesOfGrid(constant.data(), Cube));
  builder.KeepAll();
  std::shared_ptr<const ScalarField> field;
  ASSERT_TRUE(builder.Build(field).IsOk());
  const FieldSample sample = FieldSampler(field).ValueIndex(0, {2.5, 1.0, 4.25});
  EXPECT_EQ(sample.Kind, SampleKind::Sampled);
  EXPECT_EQ(sample.Value, 7.5);
}

TEST(FieldBuilder, RejectsInvalidMaterials)
{
  const std::vector<double> ramp = Ramp();
  FieldBuilder none(Cube);
  none.AddChannel(SamplesOfGrid(ramp.data(), Cube));
  EXPECT_TRUE(Details(RefusalOf(none), "1 to 32 materials"));
  FieldBuilder unknown(Cube);
  unknown.AddMaterial({unknown.AddChannel(SamplesOfGrid(ramp.data(), Cube)) + 1, 2.5});
  EXPECT_TRUE(Details(RefusalOf(unknown), "channel 1"));
  FieldBuilder contradiction(Cube);
  const int channel = contradiction.AddChannel(SamplesOfGrid(ramp.data(), Cube));
  contradiction.AddMaterial({channel, 4.0}, {channel, 1.0, FieldSense::AtMost});
  EXPECT_TRUE(Details(RefusalOf(contradiction), "Material 0 has no surface"));
}

TEST(FieldBuilder, RejectsMissingOrOutlyingSamples)
{
  const std::vector<double> ramp = Ramp();
  FieldSamples absent = SamplesOfGrid(ramp.data(), Cube);
  absent.Data = nullptr;
  FieldSamples nearby = SamplesOfGrid(ramp.data(), Cube);
  nearby.StartIndex[1] = 1;
  for (const FieldSamples& samples : {absent, nearby})
  {
    FieldBuilder builder(Cube);
    builder.AddMaterial({builder.AddChannel(samples), 2.5});
    EXPECT_NE(RefusalOf(builder), "");
  }
}

TEST(FieldBuilder, StopsWhenCancelled)
{
  const std::vector<double> ramp = Ramp();
  FieldBuilder builder(Cube);
  builder.AddMaterial({builder.AddChannel(SamplesOfGrid(ramp.data(), Cube)), 2.5});
  std::shared_ptr<const ScalarField> field;
  for (const double stopAt : {0.0, 0.5})
  {
    const Status status = builder.Build(field, [stopAt](double done) { return done < stopAt; });
    EXPECT_TRUE(Details(status.Message(), "cancelled"));
    EXPECT_EQ(field, nullptr);
  }
}

template <typename T>
ScalarType StoredAs(T low, T high)
{
  std::vector<T> samples(Cube.NodeCount(), low);
  samples.back() = high;
  const auto field = MakeField(Cube, samples, static_cast<double>(high));
  return field->Channel(0).StoredType();
}

TEST(FieldBuilder, StoresSamplesInTheSmallestLosslessType)
{
  EXPECT_EQ(StoredAs<std::int8_t>(-5, 5), ScalarType::Int8);
  EXPECT_EQ(StoredAs<std::uint8_t>(0, 255), ScalarType::UInt8);
  EXPECT_EQ(StoredAs<std::int16_t>(-1024, 3071), ScalarType::Int16);
  EXPECT_EQ(StoredAs<std::uint16_t>(0, 65535), ScalarType::UInt16);
  EXPECT_EQ(StoredAs<std::int32_t>(-1024, 3071), ScalarType::Float32);
  EXPECT_EQ(StoredAs<std::int32_t>(0, (1 << 24) + 1), ScalarType::Float64);
  EXPECT_EQ(StoredAs<std::uint32_t>(0, 4000000000u), ScalarType::Float32); // has zeros at its end
  EXPECT_EQ(StoredAs<std::int64_t>(0, 7), ScalarType::Float32);
  EXPECT_EQ(StoredAs<std::uint64_t>(0, (1u << 24) + 1), ScalarType::Float64);
  EXPECT_EQ(StoredAs<float>(0.1f, 0.2f), ScalarType::Float32);
  EXPECT_EQ(StoredAs<double>(0.1, 0.2), ScalarType::Float64);
  EXPECT_EQ(StoredAs<double>(0.0, 1e139), ScalarType::Float64);
}

TEST(FieldBuilder, StoresOnlyBricksNearTheSurface)
{
  const FieldGrid grid = PlainGrid({129, 129, 129});
  const test::SphereField sphere{{64, 64, 64}, 40.0};
  const auto samples = test::SampleAtIndices<std::int16_t>(grid.Size(), sphere);
  const auto field = MakeField(grid, samples, 0.5);
  const std::size_t bricks = test::SurfaceBricks(*field);
  EXPECT_EQ(field->Layout().BrickCount(), 16u * 16u * 16u);
  EXPECT_EQ(field->Channel(0).BlockCount(), bricks);
  // The surface is 4 pi 40^2 = 20,000 square voxels; a brick contains at least some dozens of them.
  EXPECT_LE(bricks, 700u);
  EXPECT_GE(bricks, 200u);
  EXPECT_LE(field->Bytes(), grid.NodeCount() * sizeof(float) / 5);
}

TEST(FieldBuilder, KeepAllStoresEveryBrick)
{
  const FieldGrid grid = PlainGrid({65, 65, 65});
  std::vector<double> samples(grid.NodeCount(), 0.0);
  samples[(32 * 65 + 32) * 65 + 36] = 1.0;
  FieldBuilder builder(grid);
  builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), grid)), 0.5});
  builder.KeepAll();
  std::shared_ptr<const ScalarField> field;
  ASSERT_TRUE(builder.Build(field).IsOk());
  EXPECT_EQ(field->Channel(0).BlockCount(), field->Layout().BrickCount());
}

TEST(FieldBuilder, LeapsAreChessboardDistancesToTheNextSurface)
{
  const FieldGrid grid = PlainGrid({8 * 9 + 1, 8 * 7 + 1, 8 * 5 + 1});
  std::mt19937_64 random(4);
  std::vector<std::int16_t> samples(grid.NodeCount(), 0);
  for (int bump = 0; bump < 3; ++bump)
  {
    samples[random() % samples.size()] = 1;
  }
  const auto field = MakeField(grid, samples, 0.5);
  const BrickLayout& layout = field->Layout();
  std::vector<std::array<int, 3>> places;
  for (std::size_t n = 0; n < layout.BrickCount(); ++n)
  {
    places.push_back({static_cast<int>(n) % layout.Bricks[0],
                      static_cast<int>(n) / layout.Bricks[0] % layout.Bricks[1],
                      static_cast<int>(n) / layout.Bricks[0] / layout.Bricks[1]});
  }
  for (std::size_t a = 0; a < places.size(); ++a)
  {
    int nearest = 255;
    for (std::size_t b = 0; b < places.size(); ++b)
    {
      if (field->Directory()[b].Leap == 0)
      {
        nearest = std::min(nearest, std::max({std::abs(places[a][0] - places[b][0]),
                                              std::abs(places[a][1] - places[b][1]),
                                              std::abs(places[a][2] - places[b][2])}));
      }
    }
    ASSERT_EQ(field->Directory()[a].Leap, static_cast<unsigned>(nearest));
  }
}

TEST(FieldBuilder, SurfaceCellsAreThoseWithCornersOnBothSides)
{
  const FieldGrid grid = test::PlainGrid({21, 24, 30});
  const test::SphereField sphere{{10.2, 11.5, 14.0}, 7.3};
  const auto field = test::MakeField(grid, test::SampleAtIndices(grid.Size(), sphere), 0.0);
  std::vector<std::array<int, 3>> found = field->SurfaceCells();
  std::sort(found.begin(), found.end());
  std::vector<std::array<int, 3>> expected;
  for (int cell = 0; cell < 20 * 23 * 29; ++cell)
  {
    const std::array<int, 3> lowest{cell / 29 / 23, cell / 29 % 23, cell % 29};
    int inside = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vector3 node(lowest[0] + (corner & 1), lowest[1] + (corner >> 1 & 1),
                         lowest[2] + (corner >> 2));
      inside += sphere.Value(node) >= 0.0 ? 1 : 0;
    }
    if (inside != 0 && inside != 8)
    {
      expected.push_back(lowest);
    }
  }
  EXPECT_EQ(found, expected);
}
TEST(FieldBuilder, KeepInsideDoesNotChangeResults)
{
  const FieldGrid grid = PlainGrid({66, 20, 18});
  const auto samples = test::SampleAtIndices(grid.Size(), test::PlaneField{{0.5, 0.1, 0.0}, 12.2});
  FieldBuilder builder(grid);
  const int material =
      builder.AddMaterial({builder.AddChannel(SamplesOfGrid(samples.data(), grid)), 0.0});
  std::shared_ptr<const ScalarField> plain;
  std::shared_ptr<const ScalarField> kept;
  ASSERT_TRUE(builder.Build(plain).IsOk());
  builder.KeepInside(material);
  ASSERT_TRUE(builder.Build(kept).IsOk());
  std::size_t filled = 0;
  for (std::size_t brick = 0; brick < plain->Layout().BrickCount(); ++brick)
  {
    const bool isFilled = plain->Map(0)[brick] == MaterialMap::Filled;
    filled += isFilled ? 1 : 0;
    const bool isStored = kept->Channel(0).SlotOf(brick).Block != BrickedChannel::NotStored;
    EXPECT_EQ(isStored, isFilled || plain->Directory()[brick].HasSurface());
  }
  EXPECT_GT(filled, std::size_t{5});
  EXPECT_EQ(kept->Channel(0).BlockCount(), plain->Channel(0).BlockCount() + filled);
  EXPECT_EQ(kept->SurfaceCells(), plain->SurfaceCells());
}
} // namespace
} // namespace palpate::field_builder_test
