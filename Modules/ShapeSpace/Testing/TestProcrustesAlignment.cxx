#include "ProcrustesAlignment.h"

#include "ModelMeasures.h"
#include "RandomShapes.h"
#include "SphericalHarmonicProjection.h"
#include "SurfacePhantoms.h"
#include "WorstCase.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace palpate::procrustes_alignment_test
{
namespace
{
using test::Random;
using test::WorstCase;

const RadialModel& Radial(const OrganModel& shape)
{
  return std::get<RadialModel>(shape);
}

double LargestDifference(const OrganModel& a, const OrganModel& b)
{
  WorstCase worst;
  for (std::size_t k = 0; k < Radial(a).Coefficients().size(); ++k)
  {
    worst.Add(Radial(a).Coefficients()[k] - Radial(b).Coefficients()[k]);
  }
  return worst.Value();
}

OrganModel Organ(Random& random, int degree)
{
  const RadialModel organ = test::RandomOrgan(random, degree);
  return RadialModel(degree, organ.Coefficients(), Vector3::Zero());
}

/// The shape with a relief of `size` mm more, turned by up to 0.3 rad.
OrganModel Variant(Random& random, const OrganModel& shape, double size)
{
  std::vector<double> coefficients = Radial(shape).Coefficients();
  const std::vector<double> relief = test::RandomCoefficients(random, DegreeOf(shape), 1.0);
  for (std::size_t k = 1; k < relief.size(); ++k)
  {
    coefficients[k] += size * relief[k];
  }
  const RadialModel varied(DegreeOf(shape), coefficients, Vector3::Zero());
  std::uniform_real_distribution<double> angle(0.0, 0.3);
  return TurnShape(
      varied, {Matrix3::Identity(),
               Eigen::AngleAxisd(angle(random), test::RandomDirection(random)).toRotationMatrix()});
}

std::vector<OrganModel> Variants(Random& random, int count, double size)
{
  const OrganModel organ = Organ(random, 6);
  std::vector<OrganModel> shapes;
  for (int i = 0; i < count; ++i)
  {
    shapes.push_back(Variant(random, organ, size));
  }
  return shapes;
}

ProcrustesResult Align(const std::vector<OrganModel>& shapes, const OrganModel* reference = nullptr,
                       const ProcrustesSettings& settings = {})
{
  ProcrustesResult result;
  const Status status = AlignByProcrustes(shapes, reference, settings, result);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  EXPECT_TRUE(result.HasConverged);
  return result;
}

TEST(ProcrustesAlignment, TurnedCopiesBecomeOneShape)
{
  Random random(81);
  const ProcrustesResult result = Align(Variants(random, 6, 0.0));
  for (std::size_t i = 0; i < result.Aligned.size(); ++i)
  {
    // mm; rounding of the gradient over the curvature.
    EXPECT_LE(LargestDifference(result.Aligned[i], result.Aligned[0]), 1e-7);
    EXPECT_LE(result.Cases[i].Residual, 1e-7);
    EXPECT_FALSE(result.Cases[i].IsAmbiguous());
    EXPECT_FALSE(result.Cases[i].IsMirrored());
  }
}

TEST(ProcrustesAlignment, OrderOfCasesDoesNotMatter)
{
  Random random(82);
  std::vector<OrganModel> shapes = Variants(random, 7, 0.4);
  const ProcrustesResult result = Align(shapes);
  std::reverse(shapes.begin(), shapes.end());
  const ProcrustesResult reversed = Align(shapes);
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    EXPECT_LE(LargestDifference(result.Aligned[i], reversed.Aligned[shapes.size() - 1 - i]), 1e-7);
  }
}

TEST(ProcrustesAlignment, VariesLessThanInThePatientsAxes)
{
  Random random(83);
  const std::vector<OrganModel> shapes = Variants(random, 7, 0.4);
  const ProcrustesResult result = Align(shapes);
  const ShapeSuperposition mean(result.Mean);
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    // At the optimum the shape needs no turn.
    const SuperposedShape again = mean.Fit(result.Aligned[i], {});
    EXPECT_LE((again.Rotation.Parameters - Matrix3::Identity()).norm(), 1e-6);
    EXPECT_NEAR(again.Residual, result.Cases[i].Residual, 1e-6);
    EXPECT_LT(result.Cases[i].Residual, 1.0);
  }
}

TEST(ProcrustesAlignment, ReferenceKeepsCasesFromChangingEachOther)
{
  Random random(84);
  std::vector<OrganModel> shapes = Variants(random, 5, 0.4);
  const OrganModel reference = Align(shapes).Mean;
  const ProcrustesSettings scaled{true};
  const ProcrustesResult five = Align(shapes, &reference, scaled);
  shapes.push_back(Variant(random, shapes.front(), 1.5));
  const ProcrustesResult six = Align(shapes, &reference, scaled);
  for (std::size_t i = 0; i < 5; ++i)
  {
    EXPECT_EQ(LargestDifference(five.Aligned[i], six.Aligned[i]), 0.0);
  }
}

TEST(ProcrustesAlignment, ScaledCopiesHaveTheMeanSize)
{
  Random random(85);
  const OrganModel organ = Organ(random, 4);
  std::vector<OrganModel> shapes;
  for (const double size : {0.8, 1.0, 1.5})
  {
    std::vector<double> coefficients = Radial(organ).Coefficients();
    for (double& c : coefficients)
    {
      c *= size;
    }
    shapes.emplace_back(RadialModel(4, coefficients, Vector3::Zero()));
  }
  const ProcrustesResult result = Align(shapes, nullptr, {true});
  EXPECT_NEAR(result.Cases[0].Scale, 1.1 / 0.8, 1e-12);
  EXPECT_LE(LargestDifference(result.Aligned[0], result.Aligned[2]), 1e-9);
  EXPECT_NEAR(RmsSizeOf(result.Mean), 1.1 * RmsSizeOf(organ), 1e-9);
}

TEST(ProcrustesAlignment, MirroredShapeIsReportedAndNotTurnedInto)
{
  Random random(86);
  std::vector<OrganModel> shapes = Variants(random, 8, 0.1);
  const Matrix3 mirror = Vector3(-1.0, 1.0, 1.0).asDiagonal();
  shapes.push_back(TurnShape(Align(shapes).Mean, {Matrix3::Identity(), mirror}));
  const ProcrustesResult result = Align(shapes);
  EXPECT_TRUE(result.Cases.back().IsMirrored());
  EXPECT_NEAR(result.Cases.back().Rotation.Parameters.determinant(), 1.0, 1e-9);
  for (std::size_t i = 0; i < 8; ++i)
  {
    EXPECT_FALSE(result.Cases[i].IsMirrored()) << i;
  }
}

// Half a turn about any of its axes leaves an ellipsoid as it is.
TEST(ProcrustesAlignment, SymmetricBodiesAreAmbiguous)
{
  std::vector<OrganModel> shapes;
  for (const double x : {29.0, 30.0, 31.0})
  {
    const auto radius = [&](const Vector3& u)
    { return 1.0 / u.cwiseQuotient(Vector3(x, 22.0, 17.0)).norm(); };
    shapes.emplace_back(RadialModel(8, ProjectOnHarmonics(8, 40, radius), Vector3::Zero()));
  }
  for (const ProcrustesCase& one : Align(shapes).Cases)
  {
    EXPECT_NEAR(one.FlipRatio(), 1.0, 1e-6);
    EXPECT_TRUE(one.IsAmbiguous());
  }
}

// Against the patients' axes: half a turn stays half a turn, and is reported as better.
TEST(ProcrustesAlignment, FlippedCaseIsReported)
{
  Random random(87);
  std::vector<OrganModel> shapes = Variants(random, 8, 0.1);
  const ProcrustesResult before = Align(shapes);
  const Matrix3 flip = Eigen::AngleAxisd(M_PI, Vector3::UnitZ()).toRotationMatrix();
  shapes.push_back(TurnShape(before.Aligned[0], {Matrix3::Identity(), flip}));
  const ProcrustesResult result = Align(shapes, &before.Mean);
  EXPECT_TRUE(result.Cases.back().IsAmbiguous());
  EXPECT_FALSE(result.Cases.front().IsAmbiguous());
}

TEST(ProcrustesAlignment, SurfaceModelsWithOtherParametersBecomeOneShape)
{
  Random random(88);
  const SurfaceModel tube = test::BumpyTube(random, 5);
  BodyMoments body;
  ASSERT_TRUE(MeasureBody(tube, body).IsOk());
  const OrganModel centred = tube.Transformed(Matrix3::Identity(), -body.CentroidWorld);
  std::vector<OrganModel> shapes;
  for (int i = 0; i < 5; ++i)
  {
    const auto turn = [&](double angle)
    { return Eigen::AngleAxisd(angle, test::RandomDirection(random)).toRotationMatrix(); };
    shapes.push_back(TurnShape(centred, {turn(0.2), turn(0.3)}));
  }
  for (const ProcrustesCase& one : Align(shapes).Cases)
  {
    EXPECT_LE(one.Residual, 1e-7); // mm
    EXPECT_FALSE(one.IsAmbiguous());
  }
}

TEST(ProcrustesAlignment, SizeDoesNotHideHowWellAShapeFits)
{
  Random random(92);
  const OrganModel reference = Organ(random, 5);
  const OrganModel small = Variant(random, reference, 0.4);
  std::vector<double> coefficients = Radial(small).Coefficients();
  for (double& c : coefficients)
  {
    c *= 1.4;
  }
  const RadialModel large(5, coefficients, Vector3::Zero());
  const ProcrustesResult result = Align({small, large}, &reference);
  EXPECT_GT(result.Cases[1].Residual, result.Cases[0].Residual + 5.0); // mm
  EXPECT_NEAR(result.Cases[1].ShapeResidual, result.Cases[0].ShapeResidual, 1e-7);
  EXPECT_NEAR(result.Cases[1].FlipRatio(), result.Cases[0].FlipRatio(), 1e-6);
}

// After half a turn these climb back to where they were, which is no other orientation.
TEST(ProcrustesAlignment, HalfTurnThatLeadsBackIsNotAmbiguous)
{
  Random random(90);
  const SurfaceModel tube = test::BumpyTube(random, 8);
  std::vector<OrganModel> shapes;
  for (int i = 0; i < 6; ++i)
  {
    std::array<std::vector<double>, 3> coefficients;
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::vector<double> relief = test::RandomCoefficients(random, 8, 1.5);
      std::vector<double>& sums = coefficients[static_cast<std::size_t>(axis)];
      sums = tube.Coefficients(axis);
      std::transform(sums.begin(), sums.end(), relief.begin(), sums.begin(), std::plus<>());
      sums[0] = 0.0;
    }
    shapes.emplace_back(SurfaceModel(8, coefficients));
  }
  for (const ProcrustesCase& one : Align(shapes).Cases)
  {
    EXPECT_LT(one.FlipRatio(), AmbiguousRatio);
    EXPECT_GT(one.FlippedResidual, one.Residual);
  }
}

TEST(ProcrustesAlignment, ProgressGrowsAndCancels)
{
  Random random(93);
  const std::vector<OrganModel> shapes = Variants(random, 5, 0.4);
  double last = -1.0;
  bool grows = true;
  const KernelProgress watch = [&](double done)
  {
    grows = grows && done >= last && done <= 1.0;
    last = done;
    return true;
  };
  ProcrustesResult result;
  EXPECT_TRUE(AlignByProcrustes(shapes, nullptr, {}, result, watch).IsOk());
  EXPECT_TRUE(grows);
  EXPECT_GT(last, 0.9);
  for (const double end : {0.0, 0.3, 0.8})
  {
    const KernelProgress until = [end](double done) { return done < end; };
    EXPECT_FALSE(AlignByProcrustes(shapes, nullptr, {}, result, until).IsOk()) << end;
  }
}

TEST(ProcrustesAlignment, RejectsWhatCannotBeAligned)
{
  Random random(89);
  const OrganModel organ = Organ(random, 3);
  const OrganModel finer = Organ(random, 4);
  const OrganModel tube = test::BumpyTube(random, 3);
  ProcrustesResult result;
  EXPECT_FALSE(AlignByProcrustes({}, nullptr, {}, result).IsOk());
  EXPECT_FALSE(AlignByProcrustes({organ}, &tube, {}, result).IsOk());
  EXPECT_FALSE(AlignByProcrustes({organ}, &finer, {}, result).IsOk());
  EXPECT_FALSE(AlignByProcrustes({organ, RadialModel()}, nullptr, {}, result).IsOk());
}
} // namespace
} // namespace palpate::procrustes_alignment_test
