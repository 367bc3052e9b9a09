#include "StudyMeasuring.h"

#include "RadialModel.h"
#include "SurfaceGeodesics.h"

#include "Bodies.h"

#include "vtkNew.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

namespace palpate::study_measuring_test
{
namespace
{
constexpr double Radius = 30.0;

// Spheres 1 around the origin and 2, of 10 mm, around (60, 0, 0).
class Measuring : public testing::Test
{
protected:
  Measuring()
  {
    this->State.Structures.resize(2);
    this->State.Structures[0].Id = 1;
    this->State.Structures[0].Name = "large";
    this->State.Structures[1].Id = 2;
    this->Surfaces.Show({{1, this->Large}, {2, this->Small}});
  }
  Status Add(MeasurementKind kind, const Vector3& place, int id = 0)
  {
    return AddPoint(this->State, kind, {place, id}, this->Surfaces);
  }
  const StudyMeasurement& Last() const { return this->State.Measurements.back(); }

  vtkSmartPointer<vtkPolyData> Large = test::MakeSphere(Radius, Vector3::Zero());
  vtkSmartPointer<vtkPolyData> Small = test::MakeSphere(10.0, Vector3(60.0, 0.0, 0.0));
  StudyJobs Jobs;
  MeasuredSurfaces Surfaces{this->Jobs};
  StudyState State;
};

TEST_F(Measuring, LineAngleAndPlaneEndWithTheirLastPoint)
{
  const std::vector<Vector3> places{{3.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 4.0, 0.0}};
  for (const MeasurementKind kind :
       {MeasurementKind::Line, MeasurementKind::Angle, MeasurementKind::Plane})
  {
    const std::size_t before = this->State.Measurements.size();
    for (std::size_t i = 0; i < PointCountOf(kind); ++i)
    {
      ASSERT_TRUE(this->Add(kind, places[i]).IsOk());
      EXPECT_EQ(this->Last().IsOpen, i + 1 < PointCountOf(kind));
    }
    EXPECT_EQ(this->State.Measurements.size(), before + 1);
    EXPECT_TRUE(HasValidPoints(this->Last()));
  }
  EXPECT_EQ(OpenMeasurement(this->State), nullptr);
}

TEST_F(Measuring, SurfaceOfManyTrianglesIsMeasuredWhenItIsPrepared)
{
  vtkNew<vtkSphereSource> fine;
  fine->SetRadius(Radius);
  fine->SetThetaResolution(200);
  fine->SetPhiResolution(200);
  fine->Update();
  ASSERT_GT(fine->GetOutput()->GetNumberOfPolys(), MeasuredSurfaces::MostTrianglesAtOnce);
  this->Surfaces.Show({{1, fine->GetOutput()}, {2, this->Small}});
  const Vector3 top(0.0, 0.0, Radius);
  EXPECT_FALSE(this->Add(MeasurementKind::Thickness, top).IsOk());
  EXPECT_TRUE(this->Surfaces.IsPreparing());
  EXPECT_FALSE(this->Surfaces.Nearest(top, 40.0).has_value()) << "not that of the other sphere";
  ASSERT_TRUE(this->Jobs.WaitForResult());
  this->Jobs.Deliver();
  EXPECT_FALSE(this->Surfaces.IsPreparing());
  ASSERT_TRUE(this->Add(MeasurementKind::Thickness, top).IsOk());
  EXPECT_NEAR(*ValueOf(this->Last()), 2.0 * Radius, 1e-6); // between the poles
}

TEST_F(Measuring, SurfaceThatGoesEndsItsPreparation)
{
  vtkNew<vtkSphereSource> fine;
  fine->SetThetaResolution(200);
  fine->SetPhiResolution(200);
  fine->Update();
  this->Surfaces.Show({{1, fine->GetOutput()}});
  EXPECT_FALSE(this->Add(MeasurementKind::Thickness, Vector3(0.0, 0.0, 0.5)).IsOk());
  ASSERT_TRUE(this->Surfaces.IsPreparing());
  this->Surfaces.Show({});
  EXPECT_FALSE(this->Surfaces.IsPreparing());
  this->Jobs.WaitForResult();
  EXPECT_EQ(this->Jobs.Deliver(), 0U);
}

TEST_F(Measuring, CurvesGoOnUntilTheyAreEnded)
{
  for (int i = 0; i < 4; ++i)
  {
    ASSERT_TRUE(this->Add(MeasurementKind::Curve, Vector3(i, 0.0, 0.0)).IsOk());
  }
  EXPECT_EQ(OpenMeasurement(this->State), &this->Last());
  EXPECT_EQ(ValueOf(this->Last()), 3.0);
  EXPECT_TRUE(EndMeasurement(this->State));
  EXPECT_FALSE(EndMeasurement(this->State));
  ASSERT_EQ(this->State.Measurements.size(), 1U);
  ASSERT_TRUE(this->Add(MeasurementKind::Curve, Vector3::Zero()).IsOk());
  EXPECT_EQ(this->State.Measurements.size(), 2U) << "another one";
  EXPECT_NE(this->State.Measurements[0].Name, this->State.Measurements[1].Name);
}

TEST_F(Measuring, AnotherKindEndsTheOpenOneAndDropsItIfIncomplete)
{
  ASSERT_TRUE(this->Add(MeasurementKind::Curve, Vector3::Zero()).IsOk());
  ASSERT_TRUE(this->Add(MeasurementKind::Curve, Vector3::UnitX()).IsOk());
  ASSERT_TRUE(this->Add(MeasurementKind::Angle, Vector3::Zero()).IsOk());
  ASSERT_TRUE(this->Add(MeasurementKind::Line, Vector3::Zero()).IsOk());
  ASSERT_EQ(this->State.Measurements.size(), 2U);
  EXPECT_EQ(this->State.Measurements[0].Kind, MeasurementKind::Curve);
  EXPECT_FALSE(this->State.Measurements[0].IsOpen);
  EXPECT_EQ(this->State.Measurements[1].Kind, MeasurementKind::Line);
}

// A quarter of a great circle and an eighth, placed 2 mm off the surface.
TEST_F(Measuring, SurfaceCurveIsAsLongAsTheArcs)
{
  const Vector3 places[]{{0.0, Radius + 2.0, 0.0},
                         {0.0, 0.0, Radius - 2.0},
                         (Radius + 1.0) * Vector3(0.0, -1.0, 1.0).normalized()};
  for (const Vector3& place : places)
  {
    ASSERT_TRUE(this->Add(MeasurementKind::SurfaceCurve, place).IsOk());
  }
  // Within 0.1 % for edges of 0.07 rad (SurfacePaths).
  EXPECT_NEAR(*ValueOf(this->Last()), Radius * 0.75 * M_PI, 1e-3 * Radius * 0.75 * M_PI);
  EXPECT_EQ(this->Last().PointsWorld.size(), 3U);
  EXPECT_EQ(this->Last().StructureId, 1);
  EXPECT_EQ(this->Last().Name, "Curve on large, 1");
}

// A ball that is drawn as an icosahedron: the model counts, once a point is placed.
TEST_F(Measuring, CurveOnAModelHasTheLengthOnTheModel)
{
  const auto ball = std::make_shared<const OrganModel>(
      RadialModel(0, {Radius * std::sqrt(4.0 * M_PI)}, Vector3::Zero()));
  vtkNew<vtkSphereSource> coarse;
  coarse->SetRadius(Radius);
  coarse->SetThetaResolution(6);
  coarse->SetPhiResolution(5);
  coarse->Update();
  this->Surfaces.Show({{1, coarse->GetOutput()}}, {{1, ball}});
  ASSERT_TRUE(this->Add(MeasurementKind::SurfaceCurve, {0.0, 0.0, Radius}).IsOk());
  ASSERT_TRUE(this->Add(MeasurementKind::SurfaceCurve, {Radius, 0.0, 0.0}).IsOk());
  const std::vector<Vector3> places = this->Last().PointsWorld;
  SurfaceGeodesics same;
  ASSERT_TRUE(SurfaceGeodesics::OfModel(*ball, same).IsOk());
  SurfaceGeodesics::Length length;
  ASSERT_TRUE(same.Find(places[0], places[1], {}, length).IsOk());
  EXPECT_EQ(ValueOf(this->Last()), length.Along);
  const double angle = std::acos(places[0].normalized().dot(places[1].normalized()));
  EXPECT_NEAR(length.Along, Radius * angle, 1e-4 * Radius * angle) << "a great circle";
  EXPECT_EQ(this->Last().PathWorld.size(), length.Points.size());
  // As it is previewed, and goes on.
  StudyMeasurement preview = this->Last();
  ASSERT_TRUE(AddPoint(preview, {{0.0, Radius, 0.0}, 0}, this->Surfaces,
                       MeasuredSurfaces::PathOn::Triangles)
                  .IsOk());
  const double drawn = *ValueOf(preview);
  ASSERT_TRUE(this->Add(MeasurementKind::SurfaceCurve, {0.0, Radius, 0.0}).IsOk());
  EXPECT_GT(*ValueOf(this->Last()), 1.01 * drawn) << "triangles are inside";
  ASSERT_TRUE(same.Find(places[1], this->Last().PointsWorld[2], {}, length).IsOk());
  EXPECT_NEAR(*ValueOf(this->Last()), Radius * angle + length.Along, 1e-4 * Radius);
}

TEST_F(Measuring, SurfaceCurveStaysOnItsSurface)
{
  ASSERT_TRUE(this->Add(MeasurementKind::SurfaceCurve, {Radius, 0.0, 0.0}).IsOk());
  const StudyState before = this->State;
  const Status status = this->Add(MeasurementKind::SurfaceCurve, {60.0, 10.0, 0.0}, 2);
  EXPECT_NE(status.Message().find("10 mm"), std::string::npos);
  EXPECT_EQ(this->State, before);
}

TEST_F(Measuring, GapIsThatOfTheTwoSurfaces)
{
  ASSERT_TRUE(this->Add(MeasurementKind::Gap, {0.0, Radius, 0.0}).IsOk());
  EXPECT_FALSE(this->Add(MeasurementKind::Gap, {0.0, 0.0, Radius}).IsOk()) << "the same one";
  ASSERT_TRUE(this->Add(MeasurementKind::Gap, {60.0, 10.0, 0.0}).IsOk());
  EXPECT_NEAR(*ValueOf(this->Last()), 20.0, 0.05) << "inscribed polyhedra";
  EXPECT_LT((this->Last().PointsWorld[0] - Vector3(Radius, 0.0, 0.0)).norm(), 2.5);
  EXPECT_FALSE(this->Last().IsOpen);
}

TEST_F(Measuring, ThicknessNeedsOnePoint)
{
  ASSERT_TRUE(this->Add(MeasurementKind::Thickness, {0.0, Radius + 1.0, 0.0}).IsOk());
  EXPECT_NEAR(*ValueOf(this->Last()), 2.0 * Radius, 0.1);
  EXPECT_FALSE(this->Last().IsOpen);
}

TEST_F(Measuring, PointsTooFarFromSurfacesAreRefused)
{
  for (const MeasurementKind kind :
       {MeasurementKind::SurfaceCurve, MeasurementKind::Gap, MeasurementKind::Thickness})
  {
    const Status status = this->Add(kind, {0.0, Radius + 11.0, 0.0});
    EXPECT_NE(status.Message().find("10 mm"), std::string::npos);
  }
  EXPECT_TRUE(this->State.Measurements.empty());
}

// What the tool touches is meant, even if another surface is nearer.
TEST_F(Measuring, TouchedStructureIsMeasured)
{
  this->Surfaces.Show({{1, this->Large}, {2, test::MakeSphere(Radius - 1.0, Vector3::Zero())}});
  ASSERT_TRUE(this->Add(MeasurementKind::Thickness, {0.0, Radius, 0.0}, 2).IsOk());
  EXPECT_NEAR(*ValueOf(this->Last()), 2.0 * Radius - 2.0, 0.1);
}

TEST_F(Measuring, FollowsASurfaceThatChanges)
{
  ASSERT_TRUE(this->Add(MeasurementKind::Thickness, {0.0, Radius, 0.0}).IsOk());
  this->Large->ShallowCopy(test::MakeSphere(20.0, Vector3::Zero()));
  this->Surfaces.Show({{1, this->Large}});
  ASSERT_TRUE(this->Add(MeasurementKind::Thickness, {0.0, 20.0, 0.0}).IsOk());
  EXPECT_NEAR(*ValueOf(this->Last()), 40.0, 0.1);
}
} // namespace
} // namespace palpate::study_measuring_test
