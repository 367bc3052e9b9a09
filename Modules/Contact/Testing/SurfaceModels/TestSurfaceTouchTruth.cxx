#include "SurfacePhantoms.h"
#include "SurfaceTouchTruth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

// The judge of touch is itself judged where the answer is known in closed form: at ellipsoids,
// where the place of contact of every path that comes down along a normal is its foot.

namespace palpate::surface_touch_truth_test
{
namespace
{
using test::SurfaceTouchTruth;

const Vector3 Middle(12.0, -7.0, 40.0); // of EllipsoidPhantom, mm

std::shared_ptr<const TouchableSurfaceModel> JudgedEllipsoid(const Vector3& axes)
{
  std::shared_ptr<const TouchableSurfaceModel> touch;
  const Status status = TouchableSurfaceModel::Make(test::EllipsoidPhantom(axes), touch);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return touch;
}

Contact ReportedAt(const Vector3& proxy)
{
  Contact contact;
  contact.IsValid = true;
  contact.IsTouching = true;
  contact.ProxyWorld = proxy;
  return contact;
}

Contact NoContactAt(const Vector3& probe)
{
  Contact contact = ReportedAt(probe);
  contact.IsTouching = false;
  return contact;
}

// A tool that comes down on an ellipsoid along its normal at one place, in the given ticks.
class Descent
{
public:
  Descent(const Vector3& axes, const Vector3& parameter, double toolRadius)
      : Foot(Middle + axes.cwiseProduct(parameter)),
        Normal(parameter.cwiseQuotient(axes).normalized()), ToolRadius(toolRadius),
        Truth(JudgedEllipsoid(axes), toolRadius)
  {
    EXPECT_TRUE(this->Truth.Begin(this->At(-0.3)));
  }

  /// Of the tool's centre, so deep (mm) below where it touches.
  Vector3 At(double depth) const { return this->Foot + (this->ToolRadius - depth) * this->Normal; }
  void Judge(double depth, const Contact& contact)
  {
    this->Truth.Judge(this->At(depth), contact, this->Counts);
  }
  /// The exact contact, off by so much (mm) along the surface.
  Contact Exact(double depth, double error = 0.0) const
  {
    const Vector3 aside = error * this->Normal.unitOrthogonal();
    return depth > 0.0 ? ReportedAt(this->At(0.0) + aside) : NoContactAt(this->At(depth));
  }
  /// With exact contacts up to there.
  void PressTo(double depth)
  {
    for (double at = -0.2; at < depth; at += 0.1)
    {
      this->Judge(at, this->Exact(at));
    }
  }

  Vector3 Foot;
  Vector3 Normal;
  double ToolRadius;
  SurfaceTouchTruth Truth;
  SurfaceTouchTruth::Counts Counts;
};

const Vector3 Axes(9.0, 12.0, 16.0);
const Vector3 Aside = Vector3(0.6, 0.48, 0.64);

TEST(SurfaceTouchTruth, ExactContactsAreRight)
{
  for (const double toolRadius : {0.0, 1.0, 4.0})
  {
    Descent descent(Axes, Aside, toolRadius);
    descent.PressTo(1.55);
    const auto& counts = descent.Counts;
    EXPECT_EQ(counts.Ticks, 18) << toolRadius;
    EXPECT_EQ(counts.Touching, 15) << toolRadius;
    EXPECT_EQ(counts.Unique, 15) << toolRadius;
    EXPECT_EQ(counts.Inexact + counts.Late + counts.Early + counts.Overlaps + counts.Ended, 0)
        << toolRadius;
    EXPECT_LE(counts.Error.Value(), 1e-10) << toolRadius; // N, of a search that ends at 1e-10 rad
  }
}

TEST(SurfaceTouchTruth, AForceThatIsOffIsInexactByAsMuch)
{
  constexpr double Slightly = 1e-6; // mm
  Descent descent(Axes, Aside, 1.0);
  descent.PressTo(0.45);
  descent.Judge(0.5, descent.Exact(0.5, Slightly));
  EXPECT_EQ(descent.Counts.Inexact, 1);
  EXPECT_EQ(descent.Counts.Wrong, 0);
  EXPECT_NEAR(descent.Counts.Error.Value(), SurfaceTouchTruth::Stiffness * Slightly, 1e-10);
  descent.Judge(0.55, descent.Exact(0.55, 0.06));
  EXPECT_EQ(descent.Counts.Inexact, 2);
  EXPECT_EQ(descent.Counts.Wrong, 1);
}

TEST(SurfaceTouchTruth, MissingContactIsLateByTheDepth)
{
  Descent descent(Axes, Aside, 4.0);
  descent.PressTo(0.0);
  descent.Judge(0.25, NoContactAt(descent.At(0.25)));
  EXPECT_EQ(descent.Counts.Late, 1);
  EXPECT_NEAR(descent.Counts.LateDepth.Value(), 0.25, 1e-9);
}

TEST(SurfaceTouchTruth, ContactOfAFreeToolIsEarlyByTheGap)
{
  Descent descent(Axes, Aside, 4.0);
  descent.Judge(-0.2, ReportedAt(descent.At(0.0)));
  EXPECT_EQ(descent.Counts.Early, 1);
  EXPECT_EQ(descent.Counts.Ended, 0);
  EXPECT_NEAR(descent.Counts.EarlyGap.Value(), 0.2, 1e-9);
  EXPECT_EQ(descent.Counts.Unique, 0);
}

TEST(SurfaceTouchTruth, AProxyInTheSurfaceOverlapsByTheDepth)
{
  Descent descent(Axes, Aside, 1.0);
  descent.PressTo(0.45);
  descent.Judge(0.5, ReportedAt(descent.At(0.03)));
  EXPECT_EQ(descent.Counts.Overlaps, 1);
  EXPECT_NEAR(descent.Counts.Overlap.Value(), 0.03, 2e-5); // without what counts as contact
}

TEST(SurfaceTouchTruth, NoPathBeginsInside)
{
  SurfaceTouchTruth truth(JudgedEllipsoid(Axes), 1.0);
  EXPECT_FALSE(truth.Begin(Middle));
  EXPECT_FALSE(truth.Begin(Middle + Vector3(0.0, 0.0, Axes[2] + 0.99)));
  EXPECT_TRUE(truth.Begin(Middle + Vector3(0.0, 0.0, Axes[2] + 1.01)));
}

// A disc of 4 mm, into which the probe is pressed by more than half.
const Vector3 Thin(20.0, 20.0, 2.0);

TEST(SurfaceTouchTruth, TheMetWallOfAThinDiscIsKeptBeyondItsMiddle)
{
  Descent descent(Thin, Vector3::UnitZ(), 0.0);
  descent.PressTo(3.05);
  EXPECT_EQ(descent.Counts.Unique, 30);
  EXPECT_EQ(descent.Counts.Other, 10); // the other side is nearer
  EXPECT_EQ(descent.Counts.Inexact + descent.Counts.Late + descent.Counts.Early, 0);
}

// Moved on beyond the rim, behind the disc, the minimum of the met wall ends: then either answer is
// right, until the tool is free by both.
TEST(SurfaceTouchTruth, BehindAThinDiscContactIsNotJudgedAfterTheMetMinimumHasEnded)
{
  Descent descent(Thin, Vector3::UnitZ(), 0.0);
  descent.PressTo(3.45);
  const Vector3 goal = Middle + Vector3(25.0, 0.0, -1.5);
  for (Vector3 probe = descent.At(3.5); probe[0] < goal[0]; probe[0] += 0.1)
  {
    descent.Truth.Judge(probe, ReportedAt(probe), descent.Counts);
  }
  EXPECT_GT(descent.Counts.Ended, 0);
  EXPECT_EQ(descent.Counts.Early, 0);
  const long ended = descent.Counts.Ended;
  descent.Truth.Judge(goal, NoContactAt(goal), descent.Counts);
  descent.Truth.Judge(goal, ReportedAt(goal), descent.Counts);
  EXPECT_EQ(descent.Counts.Ended, ended);
  EXPECT_EQ(descent.Counts.Early, 1);
}
} // namespace
} // namespace palpate::surface_touch_truth_test
