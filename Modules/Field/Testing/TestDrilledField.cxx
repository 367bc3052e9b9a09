#include "DrilledCases.h"
#include "FieldSampler.h"
#include "RandomRays.h"
#include "RayCaster.h"
#include "SameBits.h"

namespace palpate
{
namespace
{
using test::CutWay;
using test::Drill;
using test::SameBits;
using test::ScannedBone;
using test::VersionOf;

// An oblique grid whose voxels are not cubes, with a ball of bone in it.
class DrilledFieldTest : public testing::Test
{
protected:
  Vector3 RandomPoint()
  {
    std::uniform_real_distribution<double> part(-1.1, 1.1);
    return this->Bone.Middle +
           Vector3(part(this->Random), part(this->Random), part(this->Random)) * Radius;
  }
  // Of one of several tools, through bone or beside it.
  void CutSomewhere(DrilledField& drilled)
  {
    const std::vector<CutTool> tools{CutTool::Sphere(1.5), CutTool::Sphere(2.5),
                                     CutTool::Cylinder(1.0, 6.0)};
    const Vector3 from = this->RandomPoint();
    const Vector3 way = 0.3 * (this->RandomPoint() - this->Bone.Middle);
    const CutPose start{from, Eigen::Quaterniond(test::RandomOrientation(this->Random))};
    const CutPose end{from + way, start.Orientation};
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
      ASSERT_EQ(c.IsInsideIndex(0, p), d.IsInsideIndex(0, p));
      ASSERT_EQ(c.IsInsideIndex(1, p), d.IsInsideIndex(1, p));
    }
  }

  static constexpr double Radius = 9.0;
  std::mt19937_64 Random{21};
  ScannedBone Bone{
      {{44, 40, 36}, {3.0, -4.0, 5.0}, {0.6, 0.7, 0.8}, test::RandomOrientation(Random)},
      Radius,
      0.7};
};

TEST_F(DrilledFieldTest, AVersionHasTheBitsOfAFieldBuiltAfresh)
{
  for (const BrickSize size : BrickSizes)
  {
    const auto drilled = Drill(*this->Bone.Make(this->Bone.Bone, size));
    for (int round = 0; round < 10; ++round)
    {
      for (int n = 0; n < 1 + round % 4; ++n)
      {
        this->CutSomewhere(*drilled);
      }
      const auto afresh = this->Bone.Make(test::SamplesNow(*drilled, this->Bone), size);
      const auto version = VersionOf(*drilled);
      this->ExpectSameHits(version, afresh, 400);
      ASSERT_EQ(version->SurfaceCells(), afresh->SurfaceCells());
      ASSERT_EQ(version->Memory().SurfaceBricks, afresh->Memory().SurfaceBricks);
    }
  }
}
} // namespace
} // namespace palpate
