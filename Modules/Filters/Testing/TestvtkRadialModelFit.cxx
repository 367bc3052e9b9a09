#include "vtkRadialModelFit.h"

#include "Bodies.h"
#include "ErrorLog.h"
#include "ModelTable.h"
#include "RadialModel.h"
#include "RandomShapes.h"
#include "WorstCase.h"
#include "vtkRadialModelSurface.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::vtk_spherical_harmonic_fit_test
{
namespace
{

RadialModel RandomModel(int degree)
{
  palpate::test::Random random(99);
  std::vector<double> coefficients = palpate::test::RandomCoefficients(random, degree, 2.0);
  coefficients[0] = 20.0 * std::sqrt(4.0 * M_PI);
  return {degree, coefficients, Vector3(10.0, -20.0, 30.0)};
}

// Noise-free samples of a model, as vtkRadialSampler would write them.
vtkSmartPointer<vtkPolyData> SamplesOf(const RadialModel& model, int frequency)
{
  auto samples = palpate::test::MakeBody(frequency, [&model](const Vector3& u)
                                         { return model.PointWorld(u); });
  vtkNew<vtkDoubleArray> directions;
  directions->SetName("Direction");
  directions->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radius");
  const palpate::IcosahedronDirections sphere(frequency);
  for (const Vector3& u : sphere.Directions())
  {
    directions->InsertNextTuple(u.data());
    radii->InsertNextValue(model.Radius(u));
  }
  vtkNew<vtkDoubleArray> center;
  center->SetName("Center");
  center->SetNumberOfComponents(3);
  center->InsertNextTuple(model.CenterWorld().data());
  samples->GetPointData()->AddArray(directions);
  samples->GetPointData()->AddArray(radii);
  samples->GetFieldData()->AddArray(center);
  return samples;
}

vtkSmartPointer<vtkRadialModelFit> Fit(vtkPolyData* samples)
{
  auto fit = vtkSmartPointer<vtkRadialModelFit>::New();
  fit->SetInputData(samples);
  return fit;
}

TEST(RadialModelFitFilter, RecoversModelFromNoiseFreeSamples)
{
  const RadialModel truth = RandomModel(12);
  auto fit = Fit(SamplesOf(truth, 20));
  fit->Update();
  RadialModel found;
  ASSERT_TRUE(palpate::FromTable(fit->GetOutput(), found));
  EXPECT_EQ(found.CenterWorld(), truth.CenterWorld());
  palpate::test::WorstCase error;
  for (std::size_t i = 0; i < truth.Coefficients().size(); ++i)
  {
    error.Add(found.Coefficients()[i] - truth.Coefficients()[i]);
  }
  EXPECT_LT(error.Value(), 1e-10 * truth.Coefficients()[0]);
}

TEST(RadialModelFitFilter, FindsSmallestDegreeWithinTolerance)
{
  const RadialModel truth = RandomModel(15);
  auto fit = Fit(SamplesOf(truth, 20));
  fit->SetTolerance(1e-9);
  fit->Update();
  EXPECT_EQ(fit->GetFittedDegree(), 15);
  fit->SetTolerance(0.1);
  fit->Update();
  const int degree = fit->GetFittedDegree();
  EXPECT_LE(fit->GetRms(), 0.1);
  EXPECT_GT(fit->GetRmsOfDegree(degree - 1), 0.1);
}

TEST(RadialModelFitFilter, RaisesErrorIfNoDegreeMeetsTolerance)
{
  auto fit = Fit(SamplesOf(RandomModel(15), 20));
  fit->SetTolerance(1e-9);
  fit->SetMaximumDegree(10);
  const palpate::test::ErrorLog errors(fit);
  fit->Update();
  EXPECT_TRUE(errors.Contains("no degree up to 10"));
  EXPECT_EQ(fit->GetOutput()->GetNumberOfRows(), 0);
}

TEST(RadialModelFitFilter, RaisesErrorForTooFewSamples)
{
  auto fit = Fit(SamplesOf(RandomModel(2), 3)); // 92 samples
  const palpate::test::ErrorLog errors(fit);
  fit->Update();
  EXPECT_TRUE(errors.Contains("92 samples cannot determine the 169 coefficients"));
}

TEST(RadialModelFitFilter, RaisesErrorForInputWithoutSamples)
{
  auto fit = Fit(palpate::test::MakeSphere(1.0, {0, 0, 0}));
  const palpate::test::ErrorLog errors(fit);
  fit->Update();
  EXPECT_TRUE(errors.Contains("has no samples"));
}

TEST(SphericalHarmonicSurface, HasPointsAndNormalsOfModel)
{
  const RadialModel model = RandomModel(8);
  vtkNew<vtkTable> table;
  palpate::ToTable(model, table);
  vtkNew<vtkRadialModelSurface> surface;
  surface->SetInputData(table);
  surface->SetFrequency(9);
  surface->Update();
  vtkPolyData* output = surface->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 812);
  ASSERT_EQ(output->GetNumberOfPolys(), 1620);
  const palpate::IcosahedronDirections sphere(9);
  const std::vector<Vector3>& directions = sphere.Directions();
  for (vtkIdType id = 0; id < 812; ++id)
  {
    const Vector3& u = directions[static_cast<std::size_t>(id)];
    ASSERT_EQ(Vector3(output->GetPoint(id)), model.PointWorld(u));
    ASSERT_EQ(Vector3(output->GetPointData()->GetNormals()->GetTuple3(id)), model.Normal(u));
  }
}

TEST(SphericalHarmonicSurface, DistancesToOriginalAreSigned)
{
  const RadialModel model(0, {20.0 * std::sqrt(4.0 * M_PI)}, Vector3(1, 2, 3));
  vtkNew<vtkTable> table;
  palpate::ToTable(model, table);
  for (const double radius : {19.0, 21.5})
  {
    vtkNew<vtkRadialModelSurface> surface;
    surface->SetInputData(table);
    surface->SetOriginalData(palpate::test::MakeSphere(radius, {1, 2, 3}, 40));
    surface->Update();
    double distances[2];
    double residuals[2];
    surface->GetOutput()->GetPointData()->GetArray("DistanceToSurface")->GetRange(distances);
    surface->GetOutput()->GetPointData()->GetArray("Residual")->GetRange(residuals);
    // The original's facets lie up to 0.004 mm inside its sphere.
    EXPECT_NEAR(distances[0], 20.0 - radius, 0.005);
    EXPECT_NEAR(distances[1], 20.0 - radius, 0.005);
    EXPECT_NEAR(residuals[0], radius - 20.0, 0.005);
  }
}

TEST(SphericalHarmonicSurface, ReportsRadiusDeviation)
{
  palpate::test::Random random(17);
  std::normal_distribution<double> noise(0.0, 0.3);
  auto samples = SamplesOf(RandomModel(6), 20);
  auto* radii = vtkDoubleArray::SafeDownCast(samples->GetPointData()->GetArray("Radius"));
  for (vtkIdType id = 0; id < radii->GetNumberOfValues(); ++id)
  {
    radii->SetValue(id, radii->GetValue(id) + noise(random));
  }
  auto fit = Fit(samples);
  vtkNew<vtkRadialModelSurface> surface;
  surface->SetInputConnection(fit->GetOutputPort());
  surface->Update();
  double range[2];
  surface->GetOutput()->GetPointData()->GetArray("RadiusDeviation")->GetRange(range);
  // 169 coefficients from 4,002 even samples: 0.3 sqrt(169 / 4002) = 0.062 mm on average; even
  // weights on an icosahedron keep it within a few percent of that everywhere, and the noise
  // estimate has an error of 1 / sqrt(2 * 3833) = 1.1 %.
  EXPECT_NEAR(range[0], 0.0616, 0.01);
  EXPECT_NEAR(range[1], 0.0616, 0.01);
}

TEST(SphericalHarmonicSurface, RaisesErrorForTableWithoutModel)
{
  vtkNew<vtkTable> table;
  vtkNew<vtkRadialModelSurface> surface;
  surface->SetInputData(table);
  const palpate::test::ErrorLog errors(surface);
  surface->Update();
  EXPECT_TRUE(errors.Contains("not a spherical-harmonic model"));
}
} // namespace
} // namespace palpate::vtk_spherical_harmonic_fit_test
