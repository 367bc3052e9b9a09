#include "DrillPhantom.h"

#include "FilterRun.h"
#include "InputError.h"
#include "IsoSurface.h"
#include "RandomOrientation.h"
#include "SceneIsoSurface.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate
{
namespace
{
bool GoOn(double, const std::string&)
{
  return true;
}

TEST(DrillPhantomTest, SurfaceEnclosesTheBlockWithoutTheCanal)
{
  std::mt19937_64 random(91);
  const double bone = 24.0 * 24.0 * 16.0 - M_PI * 4.0 * 16.0;
  for (const Matrix3& axes : {Matrix3(Matrix3::Identity()), test::RandomOrientation(random)})
  {
    const DrillPhantom phantom = MakeDrillPhantom(Vector3(0.3, 0.25, 0.35), axes, GoOn);
    ASSERT_EQ(phantom.Ct->GetScalarType(), VTK_SHORT);
    const auto surface = MakeIsoSurface(phantom.Ct, DrillPhantom::Iso, GoOn);
    // Edges are cut off by half a voxel.
    EXPECT_NEAR(MeasureEnclosed(surface).Volume, bone, 0.005 * bone);
  }
}

TEST(DrillPhantomTest, NerveIsACylinderAbsentFromTheCt)
{
  std::mt19937_64 random(92);
  // Oblique, so that each of its sections is sampled differently.
  const DrillPhantom phantom =
      MakeDrillPhantom(Vector3::Constant(0.25), test::RandomOrientation(random), GoOn);
  const auto* label = static_cast<const unsigned char*>(phantom.Nerve->GetScalarPointer());
  const auto* value = static_cast<const short*>(phantom.Ct->GetScalarPointer());
  int voxels = 0;
  for (vtkIdType n = 0; n < phantom.Nerve->GetNumberOfPoints(); ++n)
  {
    const Vector3 place(phantom.Nerve->GetPoint(n));
    ASSERT_EQ(label[n] != 0, DrillPhantom::NerveDistance(place) < 0.0);
    ASSERT_TRUE(label[n] == 0 || std::abs(place[1]) > 11.7 || value[n] == 1500);
    voxels += label[n];
  }
  const double nerve = M_PI * 24.0;
  EXPECT_NEAR(voxels * std::pow(0.25, 3), nerve, 0.02 * nerve);
}

TEST(DrillPhantomTest, RejectsTooFineGridAndCanBeCancelled)
{
  EXPECT_THROW(MakeDrillPhantom(Vector3::Constant(1e-3), Matrix3::Identity(), GoOn), InputError);
  EXPECT_THROW(MakeDrillPhantom(Vector3::Ones(), Matrix3::Identity(),
                                [](double, const std::string&) { return false; }),
               Cancelled);
}
} // namespace
} // namespace palpate
