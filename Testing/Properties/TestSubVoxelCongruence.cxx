#include "DisplayTest.h"
#include "FieldRenderer.h"
#include "HeadCt.h"
#include "SceneField.h"
#include "SegmentationFile.h"
#include "TemporaryFolder.h"
#include "TestData.h"
#include "VolumeFile.h"
#include "vtkSubVoxelVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <gtest/gtest.h>

namespace palpate::sub_voxel_congruence_test
{
namespace
{
// Visible and touched surface agree: every pixel's hit in a rendered image of real data, and the
// hit of a haptic query along the same ray, have the same bits.

using namespace palpate::test;

class SubVoxelCongruence : public DisplayTest
{
protected:
  // Several views, perspective and parallel.
  static void ExpectCongruence(const std::shared_ptr<const ScalarField>& field)
  {
    vtkNew<vtkSubVoxelVolumeMapper> mapper;
    mapper->SetField(field);
    mapper->KeepHitsOn();
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    vtkNew<vtkRenderer> renderer;
    renderer->AddVolume(volume);
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetSize(160, 120);
    window->AddRenderer(renderer);
    vtkCamera* camera = renderer->GetActiveCamera();
    std::array<double, 6> bounds = SurfaceBounds(*field);
    for (int view = 0; view < 4; ++view)
    {
      camera->SetParallelProjection(view % 2);
      camera->Azimuth(71.0);
      camera->Elevation(-17.0 + 11.0 * view);
      camera->OrthogonalizeViewUp();
      renderer->ResetCamera(bounds.data());
      renderer->ResetCameraClippingRange();
      window->Render();
      ComparePixels(*mapper, field);
    }
  }

private:
  static std::array<double, 6> SurfaceBounds(const ScalarField& field)
  {
    Eigen::AlignedBox3d box;
    for (const std::array<int, 3>& cell : field.SurfaceCells())
    {
      box.extend(field.Grid().PointWorld(Vector3(cell[0], cell[1], cell[2])));
    }
    return {box.min()[0], box.max()[0], box.min()[1], box.max()[1], box.min()[2], box.max()[2]};
  }
  static void ComparePixels(const vtkSubVoxelVolumeMapper& mapper,
                            const std::shared_ptr<const ScalarField>& field)
  {
    const FieldImage& raster = *mapper.GetImage();
    const PixelRays& rays = mapper.GetFieldRenderer()->View().Rays;
    const RayCaster hand(field);
    int hits = 0;
    for (int row = 0; row < raster.Height; ++row)
    {
      for (int column = 0; column < raster.Width; ++column)
      {
        const FieldHit& seen = raster.Hits[raster.Pixel(column, row)];
        const FieldRay ray = rays.OfPixel(column, row);
        ExpectSame(seen, hand.CastWorld(ray, 0.0, 1.0), column, row);
        if (seen.Material >= 0)
        {
          // The haptic query covers only a part of the ray.
          ExpectSame(seen, hand.CastWorld(ray, seen.T - 1e-3, seen.T + 1e-3), column, row);
          ++hits;
        }
        if (testing::Test::HasFailure())
        {
          return;
        }
      }
    }
    EXPECT_GT(hits, 1000);
  }
  static void ExpectSame(const FieldHit& seen, const FieldHit& felt, int column, int row)
  {
    EXPECT_TRUE(seen.Kind == felt.Kind && seen.Material == felt.Material && seen.T == felt.T &&
                seen.Position == felt.Position && seen.Gradient == felt.Gradient &&
                seen.IsEntering == felt.IsEntering)
        << "pixel " << column << ", " << row << ": T " << seen.T << " and " << felt.T;
  }
};

bool GoOn(double, const std::string&)
{
  return true;
}

TEST_F(SubVoxelCongruence, OfTheSkullInAHeadCt)
{
  PALPATE_REQUIRE_FILE(HeadCtProject);
  const TemporaryFolder folder;
  ASSERT_TRUE(ConvertHeadCt(folder / "head.nrrd"));
  const Volume head = ReadVolume(folder / "head.nrrd");
  ExpectCongruence(MakeIsoField(head.Image, {300.0}, FieldInterpolation::Trilinear, GoOn));
}

TEST_F(SubVoxelCongruence, OfTwoIsoValuesInAnMrHead)
{
  const std::filesystem::path path = "/usr/share/mricron/templates/ch2.nii.gz";
  PALPATE_REQUIRE_FILE(path);
  const Volume head = ReadVolume(path);
  ExpectCongruence(MakeIsoField(head.Image, {60.0, 110.0}, FieldInterpolation::Trilinear, GoOn));
}

TEST_F(SubVoxelCongruence, OfAProstateBetweenThickSlicesByCubicInterpolation)
{
  const std::filesystem::path path = DataPath("prostate/whole_gland_oblique_label.nrrd");
  PALPATE_REQUIRE_FILE(path);
  const Segmentation gland = ReadSegmentation(path);
  ExpectCongruence(
      MakeSegmentField(gland, gland.Segments, FieldInterpolation::TricubicBSpline, 0.5, GoOn));
}
} // namespace
} // namespace palpate::sub_voxel_congruence_test
