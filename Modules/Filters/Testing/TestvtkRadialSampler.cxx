#include "vtkRadialSampler.h"

#include "Bodies.h"
#include "ErrorLog.h"
#include "vtkIcosahedronDirections.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::vtk_radial_sampler_test
{
namespace
{

vtkSmartPointer<vtkRadialSampler> Sample(vtkPolyData* surface)
{
  vtkNew<vtkIcosahedronDirections> directions;
  auto sampler = vtkSmartPointer<vtkRadialSampler>::New();
  sampler->SetInputData(0, surface);
  sampler->SetDirectionsConnection(directions->GetOutputPort());
  return sampler;
}

double SumOf(vtkRadialSampler* sampler, const char* array)
{
  vtkDataArray* values = sampler->GetOutput()->GetPointData()->GetArray(array);
  double sum = 0.0;
  for (vtkIdType id = 0; id < values->GetNumberOfTuples(); ++id)
  {
    sum += values->GetTuple1(id);
  }
  return sum;
}

TEST(IcosahedronDirectionsSource, HasPublishedCounts)
{
  vtkNew<vtkIcosahedronDirections> directions;
  directions->Update();
  EXPECT_EQ(directions->GetOutput()->GetNumberOfPoints(), 4002);
  EXPECT_EQ(directions->GetOutput()->GetNumberOfPolys(), 8000);
}

TEST(RadialSampler, MeasuresRadiusOfSphere)
{
  auto sampler = Sample(palpate::test::MakeSphere(12.0, {3, -4, 50}, 40));
  sampler->Update();
  EXPECT_TRUE(sampler->GetStarShaped());
  EXPECT_DOUBLE_EQ(sampler->GetMultiplePercent(), 0.0);
  EXPECT_DOUBLE_EQ(sampler->GetMissedPercent(), 0.0);
  EXPECT_NEAR(sampler->GetCenter()[2], 50.0, 1e-9);
  vtkDataArray* radii = sampler->GetOutput()->GetPointData()->GetArray("Radius");
  double range[2];
  radii->GetRange(range);
  // Facets of side h = 0.35 mm lie up to h^2 / (6 r) inside the sphere.
  EXPECT_GT(range[0], 12.0 - 0.003);
  EXPECT_LE(range[1], 12.0 + 1e-9);
}

TEST(RadialSampler, SolidAnglesAndAreasSumToSphere)
{
  auto sampler = Sample(palpate::test::MakeSphere(12.0, {0, 0, 0}, 40));
  sampler->Update();
  EXPECT_NEAR(SumOf(sampler, "SolidAngle"), 4.0 * M_PI, 1e-9);
  EXPECT_NEAR(SumOf(sampler, "AreaWeight"), 4.0 * M_PI * 144.0, 1e-3 * 1810.0);
}

TEST(RadialSampler, PointsLieOnSurfaceAlongDirection)
{
  auto sampler = Sample(palpate::test::MakeSphere(12.0, {3, -4, 50}));
  sampler->SetCenterMode(vtkRadialSampler::GIVEN);
  sampler->SetCenter(5.0, 0.0, 47.0);
  sampler->Update();
  vtkPolyData* samples = sampler->GetOutput();
  vtkDataArray* radii = samples->GetPointData()->GetArray("Radius");
  vtkDataArray* directions = samples->GetPointData()->GetArray("Direction");
  EXPECT_DOUBLE_EQ(samples->GetFieldData()->GetArray("Center")->GetComponent(0, 1), 0.0);
  for (vtkIdType id = 0; id < samples->GetNumberOfPoints(); ++id)
  {
    const Vector3 point(samples->GetPoint(id));
    const Vector3 direction(directions->GetTuple3(id));
    EXPECT_LT((point - Vector3(5, 0, 47) - radii->GetTuple1(id) * direction).norm(), 1e-9);
    ASSERT_NEAR((point - Vector3(3, -4, 50)).norm(), 12.0, 0.02);
  }
}

TEST(RadialSampler, OutsideCentreMissesOrCrossesTwice)
{
  auto sampler = Sample(palpate::test::MakeSphere(10.0, {0, 0, 0}));
  sampler->SetCenterMode(vtkRadialSampler::GIVEN);
  sampler->SetCenter(20.0, 0.0, 0.0);
  sampler->Update();
  EXPECT_FALSE(sampler->GetStarShaped());
  // The sphere fills a cone of half angle asin(10 / 20): (1 - cos 30 deg) / 2 of all directions.
  const double cone = 50.0 * (1.0 - std::cos(M_PI / 6.0));
  EXPECT_NEAR(sampler->GetMultiplePercent(), cone, 0.2); // 4,002 directions resolve 0.1 %
  EXPECT_NEAR(sampler->GetMissedPercent(), 100.0 - cone, 0.2);
  // The density of directions varies by a tenth, and some on the boundary fall either way.
  EXPECT_NEAR(SumOf(sampler, "Valid"), 4002.0 * cone / 100.0, 0.1 * 268.0);
}

TEST(RadialSampler, OutermostAndInnermostDifferOnMultiples)
{
  auto sampler = Sample(palpate::test::MakeSphere(10.0, {0, 0, 0}));
  sampler->SetCenterMode(vtkRadialSampler::GIVEN);
  sampler->SetCenter(20.0, 0.0, 0.0);
  sampler->Update();
  const double outermost = SumOf(sampler, "Radius");
  sampler->UseOutermostOff();
  sampler->Update();
  EXPECT_GT(outermost, 1.2 * SumOf(sampler, "Radius"));
}

TEST(RadialSampler, RaisesErrorWithoutSurface)
{
  vtkNew<vtkPolyData> nothing;
  auto sampler = Sample(nothing);
  const palpate::test::ErrorLog errors(sampler);
  sampler->Update();
  EXPECT_TRUE(errors.Contains("needs a surface"));
}
} // namespace
} // namespace palpate::vtk_radial_sampler_test
