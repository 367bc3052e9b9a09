#include "ProbeInSlice.h"

#include "RandomOrientation.h"
#include "vtkProbeRepresentation.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace palpate::probe_in_slice_test
{
namespace
{
TEST(ProbeInSlice, SphereCrossSectionIsCircleOfItsDepth)
{
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  vtkNew<vtkProbeRepresentation> probe;
  probe->SetToolSphere(5.0);
  for (int trial = 0; trial < 100; ++trial)
  {
    const Vector3 place = 80.0 * Vector3(unit(random), unit(random), unit(random));
    const Eigen::Quaterniond turn(palpate::test::RandomOrientation(random));
    const double wxyz[4] = {turn.w(), turn.x(), turn.y(), turn.z()};
    probe->SetProxyPose(place.data(), wxyz);
    const Vector3 normal = palpate::test::RandomOrientation(random).col(0);
    const double height = 4.5 * unit(random);
    const auto curves =
        ToolSection(probe->GetTool(), probe->GetProxyMatrix(), place + height * normal, normal);
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_TRUE(curves.front().IsClosed);
    const double radius = std::sqrt(25.0 - height * height);
    for (const Vector3& point : curves.front().Points)
    {
      ASSERT_NEAR(normal.dot(point - place), height, 1e-10);
      // Facets of 32 x 32 lie up to 5 (1 - cos^2(pi / 32)) = 0.05 mm within the sphere, which near
      // its end, at 4.5 mm, is 0.05 * 5 / 2.2 mm of the circle.
      const double distance = (point - place - height * normal).norm();
      ASSERT_LE(distance, radius + 1e-6);
      ASSERT_GE(distance, radius - 0.12);
    }
  }
}

TEST(ProbeInSlice, DistantToolIsNotCut)
{
  vtkNew<vtkProbeRepresentation> probe;
  probe->SetToolSphere(2.0);
  probe->SetProxyPosition(0.0, 0.0, 3.0);
  EXPECT_TRUE(
      ToolSection(probe->GetTool(), probe->GetProxyMatrix(), Vector3::Zero(), Vector3::UnitZ())
          .empty());
}

TEST(ProbeInSlice, TextChangesSideWhereTheViewEnds)
{
  palpate::SlicePosition slice;
  slice.Frame = palpate::FrameOf(palpate::ViewSide::Anterior);
  slice.Width = 400;
  slice.PixelMillimeters = 0.5;
  const Vector3 right = slice.Frame.RightWorld;
  EXPECT_TRUE(palpate::HasRoomAtRight(slice, slice.CenterWorld));
  EXPECT_TRUE(palpate::HasRoomAtRight(slice, slice.CenterWorld + 39.0 * right)); // 78 + 120 pixels
  EXPECT_FALSE(palpate::HasRoomAtRight(slice, slice.CenterWorld + 41.0 * right));
  slice.PointPixels = 2.0;
  EXPECT_FALSE(palpate::HasRoomAtRight(slice, slice.CenterWorld));
}

TEST(ProbeInSlice, ArrowEndsAtItsVectorsTip)
{
  const auto arrow =
      FlatArrow(Vector3(1.0, 2.0, 3.0), Vector3(0.0, 6.0, 0.0), Vector3::UnitZ(), 2.0);
  ASSERT_EQ(arrow.size(), 2U);
  EXPECT_EQ(arrow[0].Points.front(), Vector3(1.0, 2.0, 3.0));
  EXPECT_EQ(arrow[0].Points.back(), Vector3(1.0, 8.0, 3.0));
  EXPECT_EQ(arrow[1].Points[1], Vector3(1.0, 8.0, 3.0));
  EXPECT_EQ(arrow[1].Points[0].z(), 3.0);
  EXPECT_EQ(arrow[1].Points[0].y(), 6.0);
  EXPECT_TRUE(FlatArrow(Vector3::Zero(), Vector3::Zero(), Vector3::UnitZ(), 2.0).empty());
}

TEST(vtkProbeRepresentation, IgnoresNonFiniteNumbers)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkProbeRepresentation> probe;
  probe->SetProbePosition(1.0, 2.0, 3.0);
  probe->SetForce(0.0, 1.0, 0.0);
  const vtkMTimeType time = probe->GetMTime();
  probe->SetProbePosition(nan, 0.0, 0.0);
  probe->SetForce(0.0, nan, 0.0);
  EXPECT_EQ(probe->GetMTime(), time);
  EXPECT_EQ(probe->GetProbeMatrix()->GetElement(2, 3), 3.0);
  EXPECT_EQ(probe->GetForce()[1], 1.0);
}

TEST(vtkProbeRepresentation, DrawsPointAsSmallSphere)
{
  vtkNew<vtkProbeRepresentation> probe;
  for (const double radius : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
  {
    probe->SetToolSphere(radius);
    EXPECT_NEAR(probe->GetToolRadius(), 0.5, 1e-6); // points are floats
  }
  probe->SetToolSphere(3.0);
  EXPECT_NEAR(probe->GetToolRadius(), 3.0, 1e-6);
}
} // namespace
} // namespace palpate::probe_in_slice_test
