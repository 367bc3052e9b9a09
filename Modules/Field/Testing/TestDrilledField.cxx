#include "DrilledCases.h"
#include "FieldSampler.h"
#include "RandomRays.h"
#include "RayCaster.h"
#include "RemovalBytes.h"
#include "SameBits.h"

#include <cmath>
#include <limits>

namespace palpate::drilled_field_test
{
namespace
{
using test::CutPath;
using test::Drill;
using test::SameBits;
using test::SamplesNow;
using test::ScannedBone;
using test::VersionOf;

// An oblique grid whose voxels are not cubes, with a sphere of bone in it.
class DrilledFieldTest : public testing::Test
{
protected:
  Vector3 RandomPoint()
  {
    std::uniform_real_distribution<double> part(-1.1, 1.1);
    return this->Bone.Center +
           Vector3(part(this->Random), part(this->Random), part(this->Random)) * Radius;
  }
  // With one of several tools, through bone or next to it.
  void CutSomewhere(DrilledField& drilled)
  {
    const std::vector<CutTool> tools{CutTool::Sphere(1.5), CutTool::Sphere(2.5),
                                     CutTool::Cylinder(1.0, 6.0)};
    const Vector3 from = this->RandomPoint();
    const Vector3 path = 0.3 * (this->RandomPoint() - this->Bone.Center);
    const CutPose start{from, Eigen::Quaterniond(test::RandomOrientation(this->Random))};
    const CutPose end{from + path, start.Orientation};
    ASSERT_TRUE(drilled.Cut(tools[this->Random() % tools.size()], start, end).IsOk());
  }

  void ExpectSameHits(const std::shared_ptr<const ScalarField>& one,
                      const std::shared_ptr<const ScalarField>& other, int rays)
  {
    const RayCaster a(one);
    const RayCaster b(other);
    const FieldSampler c(one);
    const FieldSampler d(other);
    for (int n = 0; n < rays; ++n)
    {
      const FieldRay ray = test::RandomRay(this->Bone.Grid, this->Random);
      ASSERT_TRUE(SameBits(a.CastIndex(ray, 0.0, 1e3), b.CastIndex(ray, 0.0, 1e3)));
      const Vector3 p = this->Bone.Grid.PointIndex(this->RandomPoint());
      ASSERT_EQ(test::MaterialsAt(c, p), test::MaterialsAt(d, p));
    }
  }

  static constexpr double Radius = 9.0;
  std::mt19937_64 Random{21};
  ScannedBone Bone{
      {{44, 40, 36}, {3.0, -4.0, 5.0}, {0.6, 0.7, 0.8}, test::RandomOrientation(Random)},
      Radius,
      0.7};
};

TEST_F(DrilledFieldTest, VersionHasTheBitsOfANewlyBuiltField)
{
  const auto drilled = Drill(*this->Bone.Make(this->Bone.Bone));
  for (int round = 0; round < 10; ++round)
  {
    for (int n = 0; n < 1 + round % 4; ++n)
    {
      this->CutSomewhere(*drilled);
    }
    const auto afresh = this->Bone.Make(SamplesNow(*drilled, this->Bone));
    const auto version = VersionOf(*drilled);
    this->ExpectSameHits(version, afresh, 400);
    ASSERT_EQ(version->SurfaceCells(), afresh->SurfaceCells());
    ASSERT_EQ(test::SurfaceBricks(*version), test::SurfaceBricks(*afresh));
  }
}

TEST_F(DrilledFieldTest, FullyStoredFieldHasSameValuesAndGradients)
{
  const auto drilled = Drill(*this->Bone.Make(this->Bone.Bone, true));
  for (int round = 0; round < 6; ++round)
  {
    this->CutSomewhere(*drilled);
    const FieldSampler now(VersionOf(*drilled));
    const FieldSampler afresh(this->Bone.Make(SamplesNow(*drilled, this->Bone), true));
    for (int n = 0; n < 1000; ++n)
    {
      const Vector3 p = this->Bone.Grid.PointIndex(this->RandomPoint());
      const FieldGradientSample a = now.ValueAndGradientIndex(0, p);
      const FieldGradientSample b = afresh.ValueAndGradientIndex(0, p);
      ASSERT_EQ(a.Kind, b.Kind);
      ASSERT_EQ(a.Value, b.Value);
      ASSERT_EQ(a.Gradient, b.Gradient);
    }
  }
}

// Oracle of a node's value, from the sweeps alone.
TEST_F(DrilledFieldTest, SamplesFollowFromDistances)
{
  const auto drilled = Drill(*this->Bone.Make());
  for (int n = 0; n < 5; ++n)
  {
    this->CutSomewhere(*drilled);
  }
  const std::vector<float> now = SamplesNow(*drilled, this->Bone);
  const RemovedDistances& removed = drilled->Now();
  const std::array<int, 3>& size = this->Bone.Grid.Size();
  int changed = 0;
  for (std::size_t n = 0; n < now.size(); ++n)
  {
    const Vector3 index = test::NodeIndex(size, n);
    const std::array<int, 3> at{static_cast<int>(index[0]), static_cast<int>(index[1]),
                                static_cast<int>(index[2])};
    const auto distance = [&removed](const std::array<int, 3>& node)
    { return removed.At(node[0], node[1], node[2]); };
    float around[6];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      std::array<int, 3> before = at;
      std::array<int, 3> after = at;
      const bool isFirst = --before[axis] < 0;
      const bool isLast = ++after[axis] == size[axis];
      around[2 * axis] = isFirst ? 2.0f * distance(at) - distance(after) : distance(before);
      around[2 * axis + 1] = isLast ? 2.0f * distance(at) - distance(before) : distance(after);
    }
    const float expected =
        drilled->Law().Apply(this->Bone.Bone[n], InterpolatedDistance(distance(at), around));
    ASSERT_EQ(now[n], expected);
    changed += expected != this->Bone.Bone[n] ? 1 : 0;
  }
  EXPECT_GT(changed, 500);
}

TEST_F(DrilledFieldTest, ForbiddenMaterialNeverChanges)
{
  const auto field = this->Bone.Make();
  const auto drilled = Drill(*field);
  const FieldSampler before(field);
  for (int n = 0; n < 12; ++n)
  {
    this->CutSomewhere(*drilled);
  }
  CutPath(*drilled, CutTool::Sphere(3.0), this->Bone.Center - Vector3(8.0, 0.0, 0.0),
          this->Bone.Center + Vector3(8.0, 0.0, 0.0));
  const auto version = VersionOf(*drilled);
  const FieldSampler after(version);
  for (int n = 0; n < 3000; ++n)
  {
    const Vector3 p = this->Bone.Grid.PointIndex(this->RandomPoint());
    ASSERT_EQ(before.IsInsideIndex(1, p), after.IsInsideIndex(1, p));
    const FieldRay ray = test::RandomRay(this->Bone.Grid, this->Random);
    ASSERT_TRUE(SameBits(RayCaster(field).CastIndex(ray, 0.0, 1e3, OnlyMaterial(1)),
                         RayCaster(version).CastIndex(ray, 0.0, 1e3, OnlyMaterial(1))));
  }
}

TEST_F(DrilledFieldTest, UndoAndRedoVisitTheSameStates)
{
  const auto drilled = Drill(*this->Bone.Make());
  std::vector<std::vector<float>> states{SamplesNow(*drilled, this->Bone)};
  std::vector<double> volumes{drilled->RemovedVolume()};
  for (int stroke = 0; stroke < 5; ++stroke)
  {
    for (int n = 0; n < 3; ++n)
    {
      this->CutSomewhere(*drilled);
    }
    drilled->EndStroke();
    states.push_back(SamplesNow(*drilled, this->Bone));
    volumes.push_back(drilled->RemovedVolume());
  }
  const auto expectState = [&](std::size_t n)
  {
    EXPECT_EQ(SamplesNow(*drilled, this->Bone), states[n]);
    EXPECT_EQ(drilled->RemovedVolume(), volumes[n]);
    this->ExpectSameHits(VersionOf(*drilled), this->Bone.Make(states[n]), 100);
  };
  for (const int step : {-1, -1, -1, 1, 1, -1, -1, -1, -1, 1, 1, 1, 1, 1})
  {
    static_cast<void>(step < 0 ? drilled->Undo() : drilled->Redo());
  }
  EXPECT_FALSE(drilled->CanRedo());
  expectState(5);
  for (std::size_t n = 5; n-- > 0;)
  {
    EXPECT_TRUE(drilled->CanUndo());
    drilled->Undo();
    expectState(n);
  }
  EXPECT_FALSE(drilled->CanUndo());
  drilled->Undo();
  expectState(0);
  for (std::size_t n = 1; n <= 5; ++n)
  {
    drilled->Redo();
    expectState(n);
  }
}

TEST_F(DrilledFieldTest, UndoRevertsAnOpenStroke)
{
  const auto drilled = Drill(*this->Bone.Make());
  this->CutSomewhere(*drilled);
  drilled->EndStroke();
  const std::vector<float> state = SamplesNow(*drilled, this->Bone);
  CutPath(*drilled, CutTool::Sphere(2.0), this->Bone.Center, this->Bone.Center);
  drilled->Undo();
  EXPECT_EQ(SamplesNow(*drilled, this->Bone), state);
  drilled->Redo();
  EXPECT_NE(SamplesNow(*drilled, this->Bone), state);
}

TEST_F(DrilledFieldTest, CutAfterUndoDiscardsRedo)
{
  const auto drilled = Drill(*this->Bone.Make());
  CutPath(*drilled, CutTool::Sphere(2.0), this->Bone.Center, this->Bone.Center);
  drilled->Undo();
  EXPECT_TRUE(drilled->CanRedo());
  const Vector3 nearby = this->Bone.Center + Vector3(4.0, 0.0, 0.0);
  CutPath(*drilled, CutTool::Sphere(2.0), nearby, nearby);
  EXPECT_FALSE(drilled->CanRedo());
  const double volume = drilled->RemovedVolume();
  drilled->Redo();
  EXPECT_EQ(drilled->RemovedVolume(), volume);
}

TEST_F(DrilledFieldTest, ResetRestoresTheStartAndCanBeUndone)
{
  const auto field = this->Bone.Make();
  const auto drilled = Drill(*field);
  for (int n = 0; n < 4; ++n)
  {
    this->CutSomewhere(*drilled);
  }
  const std::vector<float> state = SamplesNow(*drilled, this->Bone);
  drilled->Reset();
  EXPECT_EQ(SamplesNow(*drilled, this->Bone), this->Bone.Bone);
  EXPECT_EQ(drilled->RemovedVolume(), 0.0);
  this->ExpectSameHits(VersionOf(*drilled), field, 200);
  drilled->Undo();
  EXPECT_EQ(SamplesNow(*drilled, this->Bone), state);
}

TEST_F(DrilledFieldTest, StrokeCostsOnlyChangedMemory)
{
  const auto drilled = Drill(*this->Bone.Make());
  std::size_t before = drilled->HistoryBytes();
  for (int stroke = 0; stroke < 6; ++stroke)
  {
    CutPath(*drilled, CutTool::Sphere(1.0), this->Bone.Center, this->RandomPoint());
    drilled->EndStroke();
    const std::size_t bytes = drilled->HistoryBytes();
    // Previous copies of the changed blocks, and pages of pointers to them: of the whole grid at
    // most, here 150 blocks of 2 kB and one page of 8 kB.
    EXPECT_LE(bytes - before, std::size_t{150} * 2056 + 8200 + 1024);
    before = bytes;
  }
}

TEST_F(DrilledFieldTest, LimitedHistoryDiscardsTheOldestStrokes)
{
  const auto drilled = Drill(*this->Bone.Make());
  constexpr std::size_t Most = 400000;
  drilled->SetHistoryBytes(Most);
  for (int stroke = 0; stroke < 60; ++stroke)
  {
    this->CutSomewhere(*drilled);
    drilled->EndStroke();
    ASSERT_LE(drilled->HistoryBytes(), Most);
  }
  int undone = 0;
  for (; drilled->CanUndo(); ++undone)
  {
    drilled->Undo();
  }
  EXPECT_GT(undone, 0);
  EXPECT_LT(undone, 60);
}

TEST_F(DrilledFieldTest, RemovedVolumeIsIndependentOfOrderAndQueries)
{
  constexpr int Paths = 8;
  std::vector<std::pair<Vector3, Vector3>> paths;
  paths.reserve(Paths);
  for (int n = 0; n < Paths; ++n)
  {
    paths.emplace_back(this->RandomPoint(), this->RandomPoint());
  }
  const auto field = this->Bone.Make();
  const auto forwards = Drill(*field);
  const auto backwards = Drill(*field);
  const CutTool tool = CutTool::Sphere(1.5);
  for (std::size_t n = 0; n < paths.size(); ++n)
  {
    CutPath(*forwards, tool, paths[n].first, paths[n].second);
    EXPECT_GE(forwards->RemovedVolume(), 0.0);
    const auto& path = paths[paths.size() - 1 - n];
    CutPath(*backwards, tool, path.first, path.second);
  }
  EXPECT_GT(forwards->RemovedVolume(), 100.0);
  EXPECT_EQ(forwards->RemovedVolume(), backwards->RemovedVolume());
}

TEST_F(DrilledFieldTest, RemovedVolumeIsTheSumOverCells)
{
  const auto drilled = Drill(*this->Bone.Make());
  const auto inside = [&](const std::vector<float>& samples)
  {
    const std::array<int, 3>& size = this->Bone.Grid.Size();
    double cells = 0.0;
    for (int cell = 0; cell < (size[0] - 1) * (size[1] - 1) * (size[2] - 1); ++cell)
    {
      const int i = cell % (size[0] - 1);
      const int j = cell / (size[0] - 1) % (size[1] - 1);
      const int k = cell / (size[0] - 1) / (size[1] - 1);
      CellCorners corners{};
      for (int n = 0; n < 8; ++n)
      {
        const int node = ((k + (n >> 2)) * size[1] + j + (n >> 1 & 1)) * size[0] + i + (n & 1);
        corners[static_cast<std::size_t>(n)] =
            static_cast<double>(samples[static_cast<std::size_t>(node)]) - ScannedBone::Iso;
      }
      cells += InsidePartOfCell(corners);
    }
    return cells * this->Bone.Grid.Spacing().prod();
  };
  for (int n = 0; n < 5; ++n)
  {
    this->CutSomewhere(*drilled);
    const double expected = inside(this->Bone.Bone) - inside(SamplesNow(*drilled, this->Bone));
    // Some ten thousand cells, each in units of 2^-32.
    EXPECT_NEAR(drilled->RemovedVolume(), expected, 1e-5);
  }
}

TEST_F(DrilledFieldTest, VersionWithoutCutIsTheSameObject)
{
  const auto drilled = Drill(*this->Bone.Make());
  const auto first = VersionOf(*drilled);
  EXPECT_EQ(VersionOf(*drilled), first);
  CutPath(*drilled, CutTool::Sphere(2.0), this->Bone.Center, this->Bone.Center);
  const auto second = VersionOf(*drilled);
  EXPECT_NE(second, first);
  CutPath(*drilled, CutTool::Sphere(2.0), this->Bone.Center, this->Bone.Center);
  EXPECT_EQ(VersionOf(*drilled), second) << "nothing more was there to be removed";
}

TEST_F(DrilledFieldTest, BytesRestoreAStateExactly)
{
  const auto field = this->Bone.Make();
  const auto drilled = Drill(*field);
  for (int n = 0; n < 5; ++n)
  {
    this->CutSomewhere(*drilled);
  }
  const std::vector<std::byte> bytes = BytesOf(*drilled->Removed());
  const auto other = Drill(*field);
  std::shared_ptr<const RemovedDistances> removed;
  ASSERT_TRUE(RemovedFromBytes(bytes, other->Now(), removed).IsOk());
  ASSERT_TRUE(other->Restore(removed).IsOk());
  EXPECT_EQ(SamplesNow(*other, this->Bone), SamplesNow(*drilled, this->Bone));
  EXPECT_EQ(other->RemovedVolume(), drilled->RemovedVolume());
  EXPECT_EQ(BytesOf(*other->Removed()), bytes);
  other->Undo();
  EXPECT_EQ(other->RemovedVolume(), 0.0);
}

TEST_F(DrilledFieldTest, RoundsOnlyIntegersThatACutChanges)
{
  const auto drilled = Drill(*this->Bone.Make());
  this->CutSomewhere(*drilled);
  CutPath(*drilled, CutTool::Sphere(2.0), this->Bone.Center, this->Bone.Center);
  const std::vector<std::int16_t> scan(this->Bone.Bone.begin(), this->Bone.Bone.end());
  std::vector<std::int16_t> rounded(scan.size());
  drilled->WriteSamples(SamplesOfGrid(scan.data(), this->Bone.Grid), rounded.data());
  const std::vector<float> exact = SamplesNow(*drilled, this->Bone);
  for (std::size_t n = 0; n < scan.size(); ++n)
  {
    ASSERT_LE(std::abs(static_cast<float>(rounded[n]) - exact[n]), 0.5f);
  }
}

TEST_F(DrilledFieldTest, WritesSamplesOfABoxWithTheValueOutside)
{
  const auto drilled = Drill(*this->Bone.Make());
  CutPath(*drilled, CutTool::Sphere(2.0), this->Bone.Center, this->Bone.Center);
  const std::array<int, 3> size = this->Bone.Grid.Size();
  FieldSamples box = SamplesOfGrid(this->Bone.Bone.data(), this->Bone.Grid);
  box.Size[2] = 20;
  box.Outside = 7.0;
  std::vector<float> now(this->Bone.Bone.size());
  drilled->WriteSamples(box, now.data());
  const std::vector<float> whole = SamplesNow(*drilled, this->Bone);
  const auto slices = static_cast<std::ptrdiff_t>(size[0] * size[1]) * 20;
  EXPECT_TRUE(std::equal(now.begin(), now.begin() + slices, whole.begin()));
  EXPECT_LE(*std::max_element(now.begin() + slices, now.end()), 7.0f);
}

TEST_F(DrilledFieldTest, DrillsAtMostConditions)
{
  std::vector<float> upsideDown;
  for (const float value : this->Bone.Bone)
  {
    upsideDown.push_back(2000.0f - value);
  }
  FieldBuilder builder(this->Bone.Grid);
  builder.KeepInside(
      builder.AddMaterial({builder.AddChannel(SamplesOfGrid(upsideDown.data(), this->Bone.Grid)),
                           2000.0 - ScannedBone::Iso, FieldSense::AtMost}));
  std::shared_ptr<const ScalarField> field;
  ASSERT_TRUE(builder.Build(field).IsOk());
  const auto below = Drill(*field);
  const auto above = Drill(*this->Bone.Make());
  for (const auto& drilled : {below.get(), above.get()})
  {
    CutPath(*drilled, CutTool::Sphere(3.0), this->Bone.Center, this->Bone.Center);
  }
  // mm^3 of 113; floats of some thousand.
  EXPECT_NEAR(below->RemovedVolume(), above->RemovedVolume(), 1e-2);
}

std::string RefusalOf(const ScalarField& field, int material)
{
  std::unique_ptr<DrilledField> drilled;
  const Status status = DrilledField::Make(field, material, drilled);
  EXPECT_EQ(status.IsOk(), drilled != nullptr);
  return status.Message();
}

TEST_F(DrilledFieldTest, RejectsFieldsThatCannotBeDrilled)
{
  EXPECT_NE(RefusalOf(*this->Bone.Make(), 2).find("no material 2"), std::string::npos);
  FieldBuilder builder(this->Bone.Grid);
  const int channel = builder.AddChannel(SamplesOfGrid(this->Bone.Bone.data(), this->Bone.Grid));
  builder.AddMaterial({channel, 300.0});
  std::shared_ptr<const ScalarField> field;
  ASSERT_TRUE(builder.Build(field).IsOk());
  EXPECT_NE(RefusalOf(*field, 0).find("no samples inside"), std::string::npos);
  builder.SetInterpolation(FieldInterpolation::TricubicBSpline);
  ASSERT_TRUE(builder.Build(field).IsOk());
  EXPECT_NE(RefusalOf(*field, 0).find("trilinear"), std::string::npos);
  builder.SetInterpolation(FieldInterpolation::Trilinear);
  builder.KeepInside(0);
  builder.AddMaterial({channel, 1000.0});
  ASSERT_TRUE(builder.Build(field).IsOk());
  EXPECT_NE(RefusalOf(*field, 0).find("other materials"), std::string::npos);
}

TEST_F(DrilledFieldTest, RejectsInvalidPosesAndStates)
{
  const auto drilled = Drill(*this->Bone.Make());
  CutPose pose;
  pose.PositionWorld[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(drilled->Cut(CutTool::Sphere(1.0), {}, pose).IsOk());
  EXPECT_FALSE(drilled->Cut(CutTool::Sphere(-1.0), {}, {}).IsOk());
  EXPECT_EQ(drilled->RemovedVolume(), 0.0);
  const auto other = RemovedDistances::None(test::PlainGrid({9, 9, 9}), drilled->Now().Band());
  EXPECT_FALSE(drilled->Restore(other).IsOk());
  EXPECT_FALSE(drilled->CanUndo());
}

TEST_F(DrilledFieldTest, VolumesCountTheIntersectionWithTheLimit)
{
  // Bone on one side of a plane only: half the sphere, and half of the drilled volume around its
  // centre.
  std::vector<float> side;
  for (std::size_t n = 0; n < this->Bone.Bone.size(); ++n)
  {
    const Vector3 p = this->Bone.Grid.PointWorld(test::NodeIndex(this->Bone.Grid.Size(), n));
    side.push_back(static_cast<float>((p - this->Bone.Center)[0]));
  }
  FieldBuilder builder(this->Bone.Grid);
  const int bone = builder.AddChannel(SamplesOfGrid(this->Bone.Bone.data(), this->Bone.Grid));
  const int half = builder.AddChannel(SamplesOfGrid(side.data(), this->Bone.Grid));
  builder.KeepInside(builder.AddMaterial({bone, ScannedBone::Iso}, {half, 0.0}));
  std::shared_ptr<const ScalarField> field;
  ASSERT_TRUE(builder.Build(field).IsOk());
  const auto drilled = Drill(*field);
  CutPath(*drilled, CutTool::Sphere(3.0), this->Bone.Center, this->Bone.Center);
  EXPECT_NEAR(drilled->RemovedVolume() / (2.0 / 3.0 * M_PI * 27.0), 1.0, 0.01);
}
} // namespace
} // namespace palpate::drilled_field_test
