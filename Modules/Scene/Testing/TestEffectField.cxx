#include "EffectField.h"

#include "FieldSampler.h"
#include "InputError.h"
#include "SceneSettings.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::effect_field_test
{
namespace
{
bool GoOn(double, const std::string&)
{
  return true;
}

// An oblique image: 100 where x is positive, with voxels of 1, 1.5 and 2 mm along turned axes.
Volume StepAlongX()
{
  constexpr int Size = 48;
  const double c = std::cos(0.5);
  const double s = std::sin(0.5);
  Volume volume;
  volume.Source = "step.nrrd";
  volume.Image = vtkSmartPointer<vtkImageData>::New();
  volume.Image->SetDimensions(Size, Size, Size);
  volume.Image->SetSpacing(1.0, 1.5, 2.0);
  volume.Image->SetDirectionMatrix(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0);
  const double half[3] = {0.5 * (Size - 1), 0.75 * (Size - 1), Size - 1.0};
  volume.Image->SetOrigin(-c * half[0] + s * half[1], -s * half[0] - c * half[1], -half[2]);
  volume.Image->AllocateScalars(VTK_SHORT, 1);
  for (int n = 0; n < Size * Size * Size; ++n)
  {
    const int i = n % Size;
    const int j = n / Size % Size;
    const int k = n / Size / Size;
    double world[3];
    volume.Image->TransformIndexToPhysicalPoint(i, j, k, world);
    volume.Image->SetScalarComponentFromDouble(i, j, k, 0, world[0] > 0.0 ? 100.0 : 0.0);
  }
  return volume;
}

SceneEffectSource SourceOf(const SceneStructure& structure, const Volume& image)
{
  return {structure, &image, {Vector3::Constant(-5.0), Vector3::Constant(5.0)}, 1.0};
}

// In mm, whatever the voxels; to a third of one, by which the step itself is rounded.
TEST(EffectField, SmoothsByAGaussianInMillimetres)
{
  const Volume image = StepAlongX();
  const SceneStructure structure;
  EffectFieldSettings settings;
  settings.Margin = 12.0;
  settings.Smoothing = 3.0;
  settings.Interpolation = FieldInterpolation::TricubicBSpline;
  const FieldSampler sampler(FieldAround(SourceOf(structure, image), settings, GoOn));
  for (double x = -5.0; x <= 5.0; x += 0.5)
  {
    const double expected = 50.0 * (1.0 + std::erf(x / (3.0 * std::sqrt(2.0))));
    EXPECT_NEAR(sampler.ValueWorld(0, {x, 1.0, -2.0}).Value, expected, 100.0 / 3.0 / 7.5) << x;
  }
}

TEST(EffectField, KeepsTheStructureWithItsMarginAndLittleMore)
{
  const Volume image = StepAlongX();
  const SceneStructure structure;
  const FieldSampler sampler(FieldAround(SourceOf(structure, image), {"image", 4.0}, GoOn));
  EXPECT_EQ(sampler.ValueWorld(0, {9.9, 9.9, 9.9}).Kind, SampleKind::Sampled);
  EXPECT_EQ(sampler.ValueWorld(0, {-9.9, 9.9, -9.9}).Kind, SampleKind::Sampled);
  EXPECT_LT(sampler.Field().Grid().NodeCount(), 35U * 25U * 17U);
}

TEST(EffectField, RejectsImagesElsewhere)
{
  Volume image = StepAlongX();
  image.Image->SetOrigin(500.0, 0.0, 0.0);
  const SceneStructure structure;
  try
  {
    FieldAround(SourceOf(structure, image), {}, GoOn);
    ADD_FAILURE() << "accepted";
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("step.nrrd does not reach"), std::string::npos)
        << error.what();
  }
}
} // namespace
} // namespace palpate::effect_field_test
