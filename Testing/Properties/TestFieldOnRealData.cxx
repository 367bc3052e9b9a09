#include "FieldBuilder.h"
#include "FieldSampler.h"
#include "LabelField.h"
#include "RandomShapes.h"
#include "RayCaster.h"
#include "SegmentationFile.h"
#include "TestData.h"
#include "VolumeFile.h"

#include "vtkDataArray.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <cmath>

namespace palpate::field_on_real_data_test
{
namespace
{
const char* const SmallMask = "prostate/picai/whole_gland_11412_1001436.nii.gz";
const char* const Oblique = "prostate/whole_gland_oblique_label.nrrd";
const char* const Volume0 = "prostate/promise12_0_t2.nii.gz";

FieldGrid GridOf(vtkImageData* image)
{
  std::array<int, 3> size{};
  image->GetDimensions(size.data());
  Matrix3 direction;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      direction(row, column) = image->GetDirectionMatrix()->GetElement(row, column);
    }
  }
  return {size, Vector3(image->GetOrigin()), Vector3(image->GetSpacing()), direction};
}

FieldSamples SamplesOf(vtkImageData* image, const FieldGrid& grid)
{
  FieldSamples samples;
  const auto describe = [&samples, &grid](const auto* data)
  { samples = SamplesOfGrid(data, grid); };
  switch (image->GetScalarType())
  {
    vtkTemplateMacro(describe(static_cast<const VTK_TT*>(image->GetScalarPointer())));
  default:
    break;
  }
  return samples;
}

// A ray from outside through the grid's centre exits as often as it enters.
void ExpectClosed(const RayCaster& caster, test::Random& random)
{
  const FieldGrid& grid = caster.Field().Grid();
  const Vector3 middle =
      grid.PointWorld(0.5 * Vector3(grid.Size()[0] - 1, grid.Size()[1] - 1, grid.Size()[2] - 1));
  for (int r = 0; r < 300; ++r)
  {
    const Vector3 u = test::RandomDirection(random);
    const Vector3 shift = 20.0 * test::RandomDirection(random);
    const FieldRay ray{middle + shift - 1e3 * u, u};
    bool isInside = false;
    FieldHit hit = caster.CastWorld(ray, 0.0, 3e3);
    while (hit.Kind != HitKind::Missed)
    {
      ASSERT_NE(hit.IsEntering, isInside);
      isInside = hit.IsEntering;
      hit = caster.CastWorld(ray, std::nextafter(hit.T, 1e9), 3e3);
    }
    ASSERT_FALSE(isInside);
  }
}

void ExpectLabelAsInTheMask(const char* file)
{
  PALPATE_REQUIRE_FILE(test::DataPath(file));
  const Segmentation segmentation = ReadSegmentation(test::DataPath(file));
  vtkImageData* image = segmentation.Layers.front();
  const Segment& segment = segmentation.Segments.front();
  const FieldGrid grid = GridOf(image);
  LabelField label;
  Status status = LabelField::Make(SamplesOf(image, grid), grid, segment.Value, 0.0, label);
  ASSERT_TRUE(status.IsOk()) << status.Message();
  FieldBuilder builder(grid);
  builder.AddMaterial({builder.AddChannel(label.Samples()), 0.0});
  std::shared_ptr<const ScalarField> field;
  status = builder.Build(field);
  ASSERT_TRUE(status.IsOk()) << status.Message();
  const FieldSampler sampler(field);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  for (vtkIdType n = 0; n < scalars->GetNumberOfTuples(); ++n)
  {
    double world[3];
    image->GetPoint(n, world);
    const bool isLabelled = static_cast<int>(scalars->GetTuple1(n)) == segment.Value;
    if (isLabelled || n % 7 == 0)
    {
      // On the grid's border, rounding decides whether a point is in the grid.
      const Vector3 index = grid.PointIndex(Vector3(world)).array().round();
      ASSERT_EQ(sampler.IsInsideIndex(0, index), isLabelled) << index.transpose();
      ASSERT_LE((grid.PointWorld(index) - Vector3(world)).norm(), 1e-9);
    }
  }
  test::Random random(91);
  ExpectClosed(RayCaster(field), random);
}

TEST(FieldOnRealData, LabelKeepsTheSideOfEveryVoxelInThickSlices)
{
  ExpectLabelAsInTheMask(SmallMask);
}

TEST(FieldOnRealData, LabelKeepsTheSideOfEveryVoxelInAnObliqueGrid)
{
  ExpectLabelAsInTheMask(Oblique);
}

TEST(FieldOnRealData, IsoSurfaceOfAnMrVolumeIsClosedInBothInterpolations)
{
  PALPATE_REQUIRE_FILE(test::DataPath(Volume0));
  const Volume volume = ReadVolume(test::DataPath(Volume0));
  const FieldGrid grid = GridOf(volume.Image);
  double range[2];
  volume.Image->GetScalarRange(range);
  for (const auto method : {FieldInterpolation::Trilinear, FieldInterpolation::TricubicBSpline})
  {
    FieldBuilder builder(grid);
    builder.AddMaterial(
        {builder.AddChannel(SamplesOf(volume.Image, grid)), 0.7 * range[0] + 0.3 * range[1]});
    builder.SetInterpolation(method);
    std::shared_ptr<const ScalarField> field;
    const Status status = builder.Build(field);
    ASSERT_TRUE(status.IsOk()) << status.Message();
    test::Random random(92);
    ExpectClosed(RayCaster(field), random);
  }
}
} // namespace
} // namespace palpate::field_on_real_data_test
