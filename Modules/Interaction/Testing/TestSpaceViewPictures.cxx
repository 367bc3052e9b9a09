// What the 3D view looks like at rest: small pictures, as they would be shown on a slide.
#include "BaselineImage.h"
#include "LabelImages.h"
#include "OffScreenTest.h"
#include "SurfaceMaterial.h"
#include "SyntheticFit.h"
#include "WindowImage.h"
#include "vtkLandmarks.h"
#include "vtkProbeRepresentation.h"
#include "vtkSpaceView.h"
#include "vtkSubVoxelVolume.h"
#include "vtkSubVoxelVolumeMapper.h"
#include "vtkSurfaceDisplay.h"

#include "vtkCamera.h"
#include "vtkPolyDataNormals.h"
#include "vtkSphereSource.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace palpate::space_view_pictures_test
{
namespace
{
constexpr int Side = 280; // pixels
const Vector3& Center = test::SyntheticFit::Center;

vtkSmartPointer<vtkPolyData> Sphere(const Vector3& center, double radius, int resolution = 60)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center.x(), center.y(), center.z());
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  sphere->Update();
  return sphere->GetOutput();
}

class SpaceViewPictures : public test::OffScreenTest
{
protected:
  SpaceViewPictures() : OffScreenTest(Side) {}
  void SetUp() override
  {
    OffScreenTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    this->Window->SetAlphaBitPlanes(1);
    this->View->SetRenderer(this->Renderer);
    this->View->AntialiasingOn();
    this->View->AmbientOcclusionOn();
    this->View->SetProbe(this->Probe);
    this->View->SetLandmarks(this->Landmarks);
    this->Probe->VisibilityOff();
    this->Renderer->GradientBackgroundOn();
  }
  // The grounds of the window.
  void OnDark()
  {
    this->Renderer->SetBackground(0.08, 0.09, 0.11);
    this->Renderer->SetBackground2(0.27, 0.30, 0.35);
  }
  void OnLight()
  {
    this->Renderer->SetBackground(0.76, 0.79, 0.83);
    this->Renderer->SetBackground2(0.95, 0.96, 0.97);
  }
  vtkSurfaceDisplay* Add(vtkPolyData* surface, const Vector3& color)
  {
    vtkNew<vtkSurfaceDisplay> shown;
    shown->SetSurface(surface);
    shown->SetColor(color.x(), color.y(), color.z());
    this->View->AddSurface(shown);
    return shown;
  }
  void Expect(const char* name)
  {
    this->View->ResetCamera();
    this->Window->Render();
    test::ExpectLikeBaseline(ReadWindow(this->Window),
                             std::filesystem::path(PALPATE_BASELINES) / name);
  }

  vtkNew<vtkSpaceView> View;
  vtkNew<vtkProbeRepresentation> Probe;
  vtkNew<vtkLandmarks> Landmarks;
};

TEST_F(SpaceViewPictures, ProstateWithLesion)
{
  const test::SyntheticFit fit;
  vtkSurfaceDisplay* gland = this->Add(fit.Result.ModelSurface, Vector3(0.90, 0.60, 0.40));
  gland->SetOpacity(0.45);
  const Vector3 lesion = Center + Vector3(-8.0, 6.0, -3.0);
  this->Add(Sphere(lesion, 5.0), Vector3(0.34, 0.71, 0.91))->HighlightOn();
  const Vector3 apex = fit.Result.Radial()->PointWorld(Vector3(0.4, -1.0, 0.2).normalized());
  this->Landmarks->AddLandmark("anterior", apex.data());
  this->Landmarks->AddLandmark("lesion", lesion.data());
  this->OnDark();
  this->Expect("LookProstateDark.png");
  this->OnLight();
  this->Expect("LookProstateLight.png");
}

// A shell of bone with a hole, and a protected nerve under it.
TEST_F(SpaceViewPictures, SkullWithHole)
{
  test::LabelGrid grid;
  grid.Size = {{70, 70, 70}};
  grid.CenterOnOrigin();
  auto image = test::MakeLabelImage<short>(
      grid, [](double, double, double) { return true; }, 1000);
  auto* voxel = static_cast<short*>(image->GetScalarPointer());
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    const Vector3 at(image->GetPoint(p));
    const double radius = std::hypot(at.x(), 0.85 * at.y(), at.z());
    const double wall = 2.5 - std::abs(radius - 24.5); // mm inside
    const double hole = at.y() < 0.0 ? std::hypot(at.x() - 10.0, at.z() - 8.0) - 9.0 : 20.0;
    *voxel++ = static_cast<short>(500.0 + 200.0 * std::clamp(std::min(wall, hole), -2.0, 2.0));
  }
  vtkNew<vtkSubVoxelVolumeMapper> mapper;
  mapper->SetInputData(image);
  mapper->SetIsoValue(0, 500.0);
  mapper->SetMaterialColor(0, 0.94, 0.89, 0.75);
  mapper->AutoAdjustSampleDistancesOff();
  vtkNew<vtkSubVoxelVolume> bone;
  bone->SetMapper(mapper);
  bone->GetProperty()->ShadeOn();
  SurfaceMaterial::Set(bone->GetProperty());
  this->Renderer->AddVolume(bone);
  vtkSurfaceDisplay* nerve =
      this->Add(Sphere(Vector3(6.0, -14.0, 6.0), 6.0), Vector3(0.94, 0.89, 0.26));
  nerve->VisibilityOff();
  nerve->ForbiddenOn();
  this->OnDark();
  this->Expect("LookSkullDark.png");
  this->OnLight();
  this->Expect("LookSkullLight.png");
}

TEST_F(SpaceViewPictures, MeanShapeWithMap)
{
  const test::SyntheticFit fit;
  vtkSurfaceDisplay* mean = this->Add(fit.Result.ModelSurface, Vector3(0.8, 0.47, 0.65));
  mean->SetColorArray("DistanceToSurface");
  mean->SetColorLimit(2.0);
  this->OnDark();
  this->Expect("LookMapDark.png");
  this->OnLight();
  this->Expect("LookMapLight.png");
}

TEST_F(SpaceViewPictures, ElasticDent)
{
  constexpr double Radius = 20.0;
  constexpr double Depth = 4.0;
  const Vector3 towards = Vector3(0.5, -1.0, 0.5).normalized();
  auto organ = Sphere(Vector3::Zero(), Radius, 120);
  for (vtkIdType p = 0; p < organ->GetNumberOfPoints(); ++p)
  {
    Vector3 point(organ->GetPoint(p));
    const double distance = (point - Radius * towards).norm();
    point -= Depth * std::exp(-distance * distance / 30.0) * towards;
    organ->GetPoints()->SetPoint(p, point.data());
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(organ);
  normals->SplittingOff();
  normals->Update();
  this->Add(normals->GetOutput(), Vector3(0.85, 0.45, 0.40));
  const Vector3 tool = (Radius - Depth + 3.0) * towards;
  this->Probe->SetToolSphere(3.0);
  this->Probe->SetProbePosition(tool.x(), tool.y(), tool.z());
  this->Probe->SetProxyPosition(tool.x(), tool.y(), tool.z());
  const Vector3 force = 1.2 * towards;
  this->Probe->SetForce(force.x(), force.y(), force.z());
  this->Probe->InContactOn();
  this->Probe->VisibilityOn();
  this->OnDark();
  this->Expect("LookDentDark.png");
  this->OnLight();
  this->Expect("LookDentLight.png");
}
} // namespace
} // namespace palpate::space_view_pictures_test
