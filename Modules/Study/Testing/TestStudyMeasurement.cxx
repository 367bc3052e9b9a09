#include "StudyMeasurement.h"

#include <gtest/gtest.h>

namespace palpate::study_measurement_test
{
namespace
{
StudyMeasurement Measurement(MeasurementKind kind, const std::vector<Vector3>& points)
{
  StudyMeasurement measurement;
  measurement.Kind = kind;
  measurement.PointsWorld = points;
  return measurement;
}

const std::vector<Vector3> Hook{{3.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 4.0, 0.0}};

TEST(StudyMeasurement, HasLengthInMillimetresAndAngleInDegrees)
{
  EXPECT_EQ(ValueOf(Measurement(MeasurementKind::Line, {Hook[0], Hook[2]})), 5.0);
  EXPECT_EQ(ValueOf(Measurement(MeasurementKind::Curve, Hook)), 7.0);
  EXPECT_NEAR(*ValueOf(Measurement(MeasurementKind::Angle, Hook)), 90.0, 1e-12);
  EXPECT_FALSE(ValueOf(Measurement(MeasurementKind::Plane, Hook)));
  EXPECT_EQ(ValueText(Measurement(MeasurementKind::Angle, Hook)), "90.0\u00B0");
  EXPECT_EQ(ValueText(Measurement(MeasurementKind::Curve, Hook)), "7.0 mm");
}

TEST(StudyMeasurement, HasNoValueUntilItHasThePoints)
{
  EXPECT_FALSE(ValueOf(Measurement(MeasurementKind::Line, {Hook[0]})));
  EXPECT_FALSE(ValueOf(Measurement(MeasurementKind::Angle, {Hook[0], Hook[1]})));
  EXPECT_EQ(ValueText(Measurement(MeasurementKind::Line, {Hook[0]})), "");
}

TEST(StudyMeasurement, SurfaceCurveIsAsLongAsItsPath)
{
  StudyMeasurement curve = Measurement(MeasurementKind::SurfaceCurve, {Hook[0], Hook[2]});
  curve.PathWorld = Hook;
  EXPECT_EQ(ValueOf(curve), 7.0);
}

TEST(StudyMeasurement, KindTellsTheNumberOfPoints)
{
  for (int k = 0; k < MeasurementKindCount; ++k)
  {
    StudyMeasurement one = Measurement(static_cast<MeasurementKind>(k), {});
    const std::size_t wanted = PointCountOf(one.Kind) == 0 ? 2 : PointCountOf(one.Kind);
    EXPECT_FALSE(HasValidPoints(one));
    one.PointsWorld.resize(wanted, Vector3::Zero());
    EXPECT_TRUE(HasValidPoints(one)) << NameOf(one.Kind);
    one.IsOpen = true;
    EXPECT_EQ(HasValidPoints(one), PointCountOf(one.Kind) == 0) << NameOf(one.Kind);
    one.PointsWorld.resize(1);
    EXPECT_TRUE(HasValidPoints(one)) << NameOf(one.Kind);
  }
}

TEST(StudyMeasurement, LabelIsAtTheAngleOrHalfway)
{
  EXPECT_EQ(LabelPlaceOf(Measurement(MeasurementKind::Angle, Hook)), Hook[1]);
  EXPECT_EQ(LabelPlaceOf(Measurement(MeasurementKind::Curve, Hook)), Vector3(0.0, 0.5, 0.0));
  EXPECT_LT((LabelPlaceOf(Measurement(MeasurementKind::Plane, Hook)) - Vector3(1.0, 4.0 / 3.0, 0.0))
                .norm(),
            1e-12);
}
} // namespace
} // namespace palpate::study_measurement_test
