#include "ShapeAlignment.h"

#include "ModelMeasures.h"
#include "RandomOrientation.h"
#include "RandomShapes.h"
#include "SurfacePhantoms.h"
#include "TurnedModel.h"
#include "WorstCase.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::shape_alignment_test
{
namespace
{
using test::Random;
using test::WorstCase;

RadialModel Align(const RadialModel& model, AlignmentAxes axes)
{
  RadialModel aligned;
  const Status status = AlignShape(model, axes, aligned);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return aligned;
}

TEST(ShapeAlignment, PatientAxesOnlyMoveTheCentre)
{
  Random random(1);
  const RadialModel model = test::RandomOrgan(random, 7);
  const RadialModel aligned = Align(model, AlignmentAxes::Patient);
  EXPECT_EQ(aligned.Coefficients(), model.Coefficients());
  EXPECT_EQ(aligned.CenterWorld(), Vector3::Zero());
}

TEST(ShapeAlignment, RotatedCopiesAlign)
{
  Random random(2);
  WorstCase worst;
  for (int trial = 0; trial < 50; ++trial)
  {
    const RadialModel model = test::RandomOrgan(random, 2 + trial % 9);
    const RadialModel aligned = Align(model, AlignmentAxes::Ellipsoid);
    const RadialModel copy =
        Align(test::TurnedModel(model, test::RandomOrientation(random), {5.0, -70.0, 11.0}),
              AlignmentAxes::Ellipsoid);
    for (std::size_t k = 0; k < aligned.Coefficients().size(); ++k)
    {
      worst.Add(copy.Coefficients()[k] - aligned.Coefficients()[k]);
    }
  }
  // mm; axes are off by rounding over the relative difference of second moments, at least 1 % here.
  EXPECT_LE(worst.Value(), 1e-9);
}

TEST(ShapeAlignment, ExtendsMostAlongXAndLeastAlongZ)
{
  Random random(3);
  for (int trial = 0; trial < 20; ++trial)
  {
    BodyMoments body;
    ASSERT_TRUE(
        MeasureBody(Align(test::RandomOrgan(random, 6), AlignmentAxes::Ellipsoid), body).IsOk());
    const Matrix3 off = body.SecondMoments / body.SecondMoments.trace();
    EXPECT_GE(off(0, 0), off(1, 1));
    EXPECT_GE(off(1, 1), off(2, 2));
    // Rounding of moments, relative.
    EXPECT_LE(off.cwiseAbs().sum() - off.trace(), 1e-10);
  }
}

// Slow reference for the third moment: a sum over thin shells of a grid of voxels.
double ThirdMoment(const RadialModel& model, int axis)
{
  BodyMoments body;
  EXPECT_TRUE(MeasureBody(model, body).IsOk());
  double sum = 0.0;
  constexpr int Half = 40;
  for (int i = -Half; i <= Half; ++i)
  {
    for (int j = -Half; j <= Half; ++j)
    {
      for (int k = -Half; k <= Half; ++k)
      {
        const Vector3 point(i, j, k);
        const double length = point.norm();
        const bool inside = length == 0.0 || length < model.Radius(point / length);
        sum += inside ? std::pow(point[axis] - body.CentroidWorld[axis], 3) : 0.0;
      }
    }
  }
  return sum;
}

TEST(ShapeAlignment, MostSkewedAxesPointToLongerTail)
{
  Random random(4);
  for (int trial = 0; trial < 5; ++trial)
  {
    const RadialModel aligned = Align(test::RandomOrgan(random, 4), AlignmentAxes::Ellipsoid);
    int positive = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      positive += ThirdMoment(aligned, axis) > 0.0 ? 1 : 0;
    }
    EXPECT_GE(positive, 2);
  }
}

SurfaceModel Align(const SurfaceModel& surface, AlignmentAxes axes)
{
  SurfaceModel aligned = surface;
  const Status status = AlignShape(surface, axes, aligned);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return aligned;
}

double LargestDifference(const SurfaceModel& a, const SurfaceModel& b)
{
  WorstCase worst;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (std::size_t k = 0; k < a.Coefficients(axis).size(); ++k)
    {
      worst.Add(a.Coefficients(axis)[k] - b.Coefficients(axis)[k]);
    }
  }
  return worst.Value();
}

TEST(ShapeAlignment, SurfaceModelsAlignLikeTheStarShapedOnesTheyAre)
{
  Random random(5);
  for (int trial = 0; trial < 5; ++trial)
  {
    const RadialModel model = test::RandomOrgan(random, 4);
    const SurfaceModel aligned = Align(SurfaceModel::FromModel(model), AlignmentAxes::Ellipsoid);
    BodyMoments body;
    BodyMoments mapped;
    ASSERT_TRUE(MeasureBody(Align(model, AlignmentAxes::Ellipsoid), body).IsOk());
    ASSERT_TRUE(MeasureBody(aligned, mapped).IsOk());
    EXPECT_LT((body.SecondMoments - mapped.SecondMoments).norm(), 1e-9 * body.SecondMoments.norm());
    EXPECT_LT(mapped.CentroidWorld.norm(), 1e-9);
    // The same signs: the point of a direction of the radial one lies on the other.
    const RadialModel star = Align(model, AlignmentAxes::Ellipsoid);
    const Vector3 along = star.PointWorld(Vector3::UnitX()) - body.CentroidWorld;
    EXPECT_LT((aligned.Point(Vector3::UnitX()) - along).norm(), 1e-9);
  }
}

TEST(ShapeAlignment, RotatedCopiesOfSurfaceModelsAlign)
{
  Random random(6);
  double worst = 0.0;
  for (int trial = 0; trial < 5; ++trial)
  {
    const SurfaceModel tube = test::BumpyTube(random, 8);
    const Matrix3 turn = test::RandomOrientation(random);
    const SurfaceModel copy =
        tube.Transformed(turn, Vector3(7.0, -31.0, 12.0)).Reparametrized(turn.transpose());
    worst = std::max(worst, LargestDifference(Align(tube, AlignmentAxes::Ellipsoid),
                                              Align(copy, AlignmentAxes::Ellipsoid)));
  }
  EXPECT_LE(worst, 1e-8); // mm; as for radial ones, coefficients are larger
}

TEST(ShapeAlignment, RejectsModelWithoutVolume)
{
  RadialModel aligned;
  EXPECT_FALSE(AlignShape(RadialModel(), AlignmentAxes::Patient, aligned).IsOk());
  const RadialModel broken(0, {std::numeric_limits<double>::quiet_NaN()}, Vector3::Zero());
  EXPECT_FALSE(AlignShape(broken, AlignmentAxes::Ellipsoid, aligned).IsOk());
}
} // namespace
} // namespace palpate::shape_alignment_test
