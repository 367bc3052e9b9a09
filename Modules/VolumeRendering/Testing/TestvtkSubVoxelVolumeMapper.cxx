#include "vtkSubVoxelVolumeMapper.h"

#include "ContactMark.h"
#include "FieldRenderer.h"
#include "OffScreenTest.h"
#include "vtkSubVoxelPicker.h"
#include "vtkSubVoxelVolume.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkSphereSource.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

namespace palpate::vtk_sub_voxel_volume_mapper_test
{
namespace
{
constexpr int Side = 200; // pixels
constexpr double Radius = 6.0;

// Minus the distance (mm) from the point (0.5, -0.3, 0.2) on a rotated grid that extends 8 mm
// around it: a sphere of 6 mm at the iso-value -6.
vtkSmartPointer<vtkImageData> SphereImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(33, 33, 21);
  image->SetSpacing(0.5, 0.5, 0.8);
  const double c = std::cos(0.4);
  const double s = std::sin(0.4);
  image->SetDirectionMatrix(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0);
  const Eigen::Matrix3d axes = Eigen::AngleAxisd(0.4, Vector3::UnitZ()).toRotationMatrix();
  const Vector3 center(0.5, -0.3, 0.2);
  const Vector3 origin = center - axes * Vector3(8.0, 8.0, 8.0);
  image->SetOrigin(origin.data());
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    Vector3 point;
    image->GetPoint(i, point.data());
    values[i] = static_cast<float>(-(point - center).norm());
  }
  return image;
}

const Vector3 Center(0.5, -0.3, 0.2);

// A sphere, rendered off screen along -z in parallel projection, 20 mm across the image.
class SubVoxelVolumeMapper : public palpate::test::OffScreenTest
{
protected:
  SubVoxelVolumeMapper() : OffScreenTest(Side) {}
  void SetUp() override
  {
    OffScreenTest::SetUp();
    if (IsSkipped())
    {
      return;
    }
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 30.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(10.0);
    camera->SetClippingRange(5.0, 55.0);
    this->Mapper->SetInputData(SphereImage());
    this->Mapper->SetIsoValue(0, -Radius);
    this->Mapper->SetMaterialColor(0, 1.0, 0.0, 0.0);
    this->Volume->SetMapper(this->Mapper);
    this->Volume->GetProperty()->ShadeOff();
    this->Renderer->AddVolume(this->Volume);
  }

  void Render()
  {
    this->Window->Render();
    this->Window->GetRGBACharPixelData(0, 0, Side - 1, Side - 1, 0, this->Pixels);
  }
  std::array<int, 3> ColorAt(int column, int row)
  {
    const vtkIdType pixel = static_cast<vtkIdType>(row) * Side + column;
    return {static_cast<int>(this->Pixels->GetTypedComponent(pixel, 0)),
            static_cast<int>(this->Pixels->GetTypedComponent(pixel, 1)),
            static_cast<int>(this->Pixels->GetTypedComponent(pixel, 2))};
  }
  // A polygonal sphere of 2 mm; its centre in mm.
  vtkActor* AddPolygons(double x, double y, double z)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(2.0);
    sphere->SetCenter(x, y, z);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.0, 0.0, 1.0);
    actor->GetProperty()->LightingOff();
    this->Renderer->AddActor(actor);
    return actor;
  }
  void UseSubVoxelVolume()
  {
    this->Renderer->RemoveVolume(this->Volume);
    this->Volume = vtkSmartPointer<vtkSubVoxelVolume>::New();
    this->Volume->SetMapper(this->Mapper);
    this->Volume->GetProperty()->ShadeOff();
    this->Renderer->AddVolume(this->Volume);
  }

  vtkSmartPointer<vtkVolume> Volume = vtkSmartPointer<vtkVolume>::New();
  vtkNew<vtkSubVoxelVolumeMapper> Mapper;
  vtkNew<vtkUnsignedCharArray> Pixels;
};

constexpr std::array<int, 3> Red{{255, 0, 0}};
constexpr std::array<int, 3> Blue{{0, 0, 255}};
constexpr std::array<int, 3> Black{{0, 0, 0}};

TEST_F(SubVoxelVolumeMapper, DrawsSphereAtItsPosition)
{
  this->Render();
  int red = 0;
  for (int row = 0; row < Side; ++row)
  {
    for (int column = 0; column < Side; ++column)
    {
      const double x = (column + 0.5) / 10.0 - 10.0 - Center[0];
      const double y = (row + 0.5) / 10.0 - 10.0 - Center[1];
      const double distance = std::hypot(x, y);
      // Trilinear interpolation of a distance has an error of at most spacing^2 / 8 R times 3,
      // 0.02 mm, plus half a pixel.
      if (std::abs(distance - Radius) > 0.07)
      {
        ASSERT_EQ(this->ColorAt(column, row), distance < Radius ? Red : Black)
            << column << ", " << row;
      }
      red += this->ColorAt(column, row) == Red ? 1 : 0;
    }
  }
  EXPECT_NEAR(red, M_PI * Radius * Radius * 100.0, 150.0);
}

TEST_F(SubVoxelVolumeMapper, OccludesAndIsOccludedByPolygons)
{
  this->AddPolygons(-2.0, 0.0, 8.0); // in front
  this->AddPolygons(5.0, 0.0, -7.0); // behind, partly visible at the side
  for (const bool isSubVoxelVolume : {false, true})
  {
    if (isSubVoxelVolume)
    {
      this->UseSubVoxelVolume();
    }
    this->Render();
    EXPECT_EQ(this->ColorAt(80, 100), Blue);
    EXPECT_EQ(this->ColorAt(140, 100), Red);
    EXPECT_EQ(this->ColorAt(167, 100), Blue);
  }
}

TEST_F(SubVoxelVolumeMapper, IntersectsPolygonsAtCorrectDepth)
{
  // Half of the polygonal sphere protrudes from the side that faces the viewer, at z = 6.2.
  this->AddPolygons(Center[0], Center[1], Center[2] + Radius);
  this->Render();
  // The spheres intersect where the distance from the axis is r^2 = 2^2 - h^2 with h = 2^2 / 12.
  const double rim = std::sqrt(4.0 - 1.0 / 9.0);
  const int row = 97; // y = -0.25
  EXPECT_EQ(this->ColorAt(static_cast<int>(100 + 10 * (Center[0] + rim - 0.15)), row), Blue);
  EXPECT_EQ(this->ColorAt(static_cast<int>(100 + 10 * (Center[0] + rim + 0.15)), row), Red);
}

TEST_F(SubVoxelVolumeMapper, BlendsTranslucentPolygonsInFront)
{
  this->UseSubVoxelVolume();
  this->AddPolygons(0.0, 0.0, 9.0)->GetProperty()->SetOpacity(0.5);
  this->Render();
  // Two layers of half blue over red.
  const std::array<int, 3> color = this->ColorAt(100, 100);
  EXPECT_NEAR(color[0], 64, 2);
  EXPECT_NEAR(color[2], 191, 2);
}

TEST_F(SubVoxelVolumeMapper, TranslucentMaterialsEndAtPolygonsInside)
{
  this->Mapper->SetMaterialOpacity(0, 0.5);
  this->AddPolygons(Center[0], Center[1], Center[2]);
  for (const bool isSubVoxelVolume : {false, true})
  {
    if (isSubVoxelVolume)
    {
      this->UseSubVoxelVolume();
    }
    this->Render();
    const std::array<int, 3> over = this->ColorAt(105, 97);
    EXPECT_NEAR(over[0], 128, 1);
    EXPECT_NEAR(over[2], 128, 1);
    EXPECT_NEAR(this->ColorAt(140, 97)[0], 191, 1); // front and back
  }
}

TEST_F(SubVoxelVolumeMapper, WritesDepthBuffer)
{
  this->Mapper->KeepHitsOn();
  this->Render();
  const palpate::FieldImage& raster = *this->Mapper->GetImage();
  const palpate::PixelRays& rays = this->Mapper->GetFieldRenderer()->View().Rays;
  for (const int column : {60, 100, 140})
  {
    const palpate::FieldHit& hit = raster.Hits[raster.Pixel(column, 90)];
    ASSERT_EQ(hit.Material, 0);
    // Depths are floats, and the buffer has at least 24 bits.
    EXPECT_NEAR(this->Window->GetZbufferDataAtPoint(column, 90), rays.Depth(hit.Position), 2e-7);
  }
}

TEST_F(SubVoxelVolumeMapper, HitsEqualHapticQueriesBitForBit)
{
  this->Mapper->KeepHitsOn();
  this->Renderer->GetActiveCamera()->ParallelProjectionOff();
  this->Renderer->GetActiveCamera()->Azimuth(33.0);
  this->Renderer->GetActiveCamera()->Elevation(21.0);
  this->Render();
  const palpate::FieldImage& raster = *this->Mapper->GetImage();
  const palpate::PixelRays& rays = this->Mapper->GetFieldRenderer()->View().Rays;
  const palpate::RayCaster hand(this->Mapper->GetField());
  int hits = 0;
  for (int row = 0; row < raster.Height; ++row)
  {
    for (int column = 0; column < raster.Width; ++column)
    {
      const palpate::FieldHit felt = hand.CastWorld(rays.OfPixel(column, row), 0.0, 1.0);
      const palpate::FieldHit& seen = raster.Hits[raster.Pixel(column, row)];
      ASSERT_EQ(seen.Kind, felt.Kind);
      ASSERT_EQ(seen.Material, felt.Material);
      ASSERT_EQ(seen.T, felt.T);
      ASSERT_EQ(seen.Position, felt.Position);
      ASSERT_EQ(seen.Gradient, felt.Gradient);
      hits += seen.Material == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(hits, 2000);
}

TEST_F(SubVoxelVolumeMapper, PickerFindsVisiblePoint)
{
  this->Mapper->KeepHitsOn();
  this->Render();
  const palpate::FieldImage& raster = *this->Mapper->GetImage();
  vtkNew<vtkSubVoxelPicker> picker;
  ASSERT_EQ(picker->Pick(77.0, 91.0, 0.0, this->Renderer), 1);
  const palpate::FieldHit& seen = raster.Hits[raster.Pixel(77, 91)];
  EXPECT_EQ(Vector3(picker->GetPickPosition()), seen.Position);
  EXPECT_EQ(picker->GetMaterial(), 0);
  EXPECT_EQ(picker->GetViewProp(), this->Volume.Get());
  const Vector3 outwards = (seen.Position - Center).normalized();
  // The gradient of trilinear interpolation has an error of spacing / 2R.
  EXPECT_LT((Vector3(picker->GetNormal()) - outwards).norm(), 0.1);
  EXPECT_EQ(picker->Pick(2.0, 2.0, 0.0, this->Renderer), 0);
  EXPECT_EQ(picker->GetMaterial(), -1);
}

TEST_F(SubVoxelVolumeMapper, PicksMovedVolumeWhereDrawn)
{
  this->Volume->SetPosition(3.0, -1.0, 2.0);
  this->Volume->SetScale(0.5, 0.5, 0.5);
  this->Render();
  const Vector3 center = Vector3(3.0, -1.0, 2.0) + 0.5 * Center;
  EXPECT_EQ(this->ColorAt(static_cast<int>(100 + 10 * (center[0] + 2.8)), 87), Red);
  EXPECT_EQ(this->ColorAt(static_cast<int>(100 + 10 * (center[0] + 3.2)), 87), Black);
  vtkNew<vtkSubVoxelPicker> picker;
  ASSERT_EQ(picker->Pick(130.0, 90.0, 0.0, this->Renderer), 1);
  EXPECT_NEAR((Vector3(picker->GetPickPosition()) - center).norm(), 3.0, 0.02);
}

TEST_F(SubVoxelVolumeMapper, DrawsAndPicksInViewport)
{
  this->Renderer->SetViewport(0.5, 0.25, 1.0, 1.0);          // 100 x 150 pixels from (100, 50)
  this->Renderer->GetActiveCamera()->SetParallelScale(10.0); // 7.5 pixels per mm
  for (const double opacity : {1.0, 0.5})
  {
    this->Mapper->SetMaterialOpacity(0, opacity);
    this->Render();
    const int x = static_cast<int>(150.0 + 7.5 * Center[0]);
    const int y = static_cast<int>(125.0 + 7.5 * Center[1]);
    EXPECT_GT(this->ColorAt(x, y)[0], 180);
    EXPECT_EQ(this->ColorAt(x, y + 48), Black);
    EXPECT_EQ(this->ColorAt(x - 60, y), Black);
    vtkNew<vtkSubVoxelPicker> picker;
    ASSERT_EQ(picker->Pick(x, y, 0.0, this->Renderer), 1);
    // The pixel's centre is within one pixel of the axis through the centre.
    EXPECT_LT((Vector3(picker->GetPickPosition()) - Center).head<2>().norm(), 0.2);
  }
}

TEST_F(SubVoxelVolumeMapper, ClippingPlanesAreInWorldCoordinates)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(1.0, 0.0, 0.0);
  plane->SetNormal(-1.0, 0.0, 0.0);
  this->Mapper->AddClippingPlane(plane);
  this->Render();
  EXPECT_EQ(this->ColorAt(109, 100), Red);
  EXPECT_EQ(this->ColorAt(111, 100), Black);
}

TEST_F(SubVoxelVolumeMapper, CastsFewerRaysIfTimeIsShort)
{
  this->Render(); // to measure the time of a ray
  EXPECT_EQ(this->Mapper->GetImageSampleDistance(), 1.0);
  this->Window->SetDesiredUpdateRate(1e5);
  this->Render();
  EXPECT_EQ(this->Mapper->GetImageSampleDistance(), 4.0);
  EXPECT_EQ(this->Mapper->GetImage()->Width, Side / 4);
  EXPECT_EQ(this->ColorAt(100, 100), Red);
  this->Window->SetDesiredUpdateRate(1e-4);
  this->Render();
  EXPECT_EQ(this->Mapper->GetImage()->Width, Side);
}

TEST_F(SubVoxelVolumeMapper, ImageIsIndependentOfThreads)
{
  this->Volume->GetProperty()->ShadeOn();
  this->Render();
  const std::vector<std::uint8_t> many = this->Mapper->GetImage()->Colors;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{1, "Sequential", false}, [&] { this->Render(); });
  EXPECT_EQ(many, this->Mapper->GetImage()->Colors);
}

TEST_F(SubVoxelVolumeMapper, ContactColoursOnlyItsNeighbourhood)
{
  palpate::ContactMark contact;
  contact.PlaceWorld = Center + Vector3(0.0, 0.0, Radius); // closest to the viewer
  contact.Radius = 3.0;
  contact.Strength = 0.8;
  contact.Color = Vector3(0.0, 0.0, 1.0);
  this->Mapper->SetContact(contact);
  this->Render();
  int marked = 0;
  for (int row = 0; row < Side; ++row)
  {
    for (int column = 0; column < Side; ++column)
    {
      const double x = (column + 0.5) / 10.0 - 10.0 - Center[0];
      const double y = (row + 0.5) / 10.0 - 10.0 - Center[1];
      const double flat = x * x + y * y;
      if (std::sqrt(flat) > Radius - 0.1)
      {
        continue; // the outline is covered by another test
      }
      const double height = std::sqrt(Radius * Radius - flat);
      const Vector3 point = Center + Vector3(x, y, height);
      const double share = contact.ShareAt(point);
      // The surface lies up to 0.02 mm off the sphere, more along an oblique view: the share falls
      // by 0.8 * 1.5 / 1.5 mm at most. Colours are rounded to bytes.
      const double error = 255.0 * 0.8 * 0.02 * Radius / height + 1.0;
      EXPECT_NEAR(this->ColorAt(column, row)[0], 255.0 * (1.0 - share), error);
      EXPECT_NEAR(this->ColorAt(column, row)[2], 255.0 * share, error);
      marked += share > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(marked, 1000);
  this->Mapper->SetContact({});
  this->Render();
  EXPECT_EQ(this->ColorAt(105, 97), Red);
}

TEST_F(SubVoxelVolumeMapper, ContactIsInSceneCoordinates)
{
  palpate::ContactMark contact;
  contact.PlaceWorld = Center + Vector3(3.0, 0.0, Radius);
  contact.Radius = 2.0;
  contact.Color = Vector3(0.0, 0.0, 1.0);
  this->Mapper->SetContact(contact);
  this->Volume->SetPosition(3.0, 0.0, 0.0);
  this->Render();
  EXPECT_EQ(this->ColorAt(135, 97), Blue);
  EXPECT_EQ(this->ColorAt(105, 97), Red);
}

TEST_F(SubVoxelVolumeMapper, RedrawsAfterIsoValueChange)
{
  this->Render();
  EXPECT_EQ(this->ColorAt(150, 97), Red);
  this->Mapper->SetIsoValue(0, -3.0);
  this->Render();
  EXPECT_EQ(this->ColorAt(150, 97), Black);
  this->Mapper->SetInterpolation(vtkSubVoxelVolumeMapper::TRICUBIC);
  EXPECT_EQ(this->Mapper->GetField()->Interpolation(),
            palpate::FieldInterpolation::TricubicBSpline);
}

TEST_F(SubVoxelVolumeMapper, DrawsGivenFieldWithoutImage)
{
  const auto field = this->Mapper->GetField();
  vtkNew<vtkSubVoxelVolumeMapper> other;
  other->SetField(field);
  other->SetMaterialColor(0, 1.0, 0.0, 0.0);
  this->Volume->SetMapper(other);
  this->Render();
  EXPECT_EQ(this->ColorAt(100, 100), Red);
  // The box of the cells that the sphere passes through, along the rotated grid's axes: it holds
  // the sphere, and exceeds the box around it by at most a cell's diagonal (1.1 mm) at each corner.
  double bounds[6];
  other->GetBounds(bounds);
  const double turned = (Radius + 1.1) * (std::cos(0.4) + std::sin(0.4));
  for (int axis = 0; axis < 3; ++axis)
  {
    const double largest = axis == 2 ? Radius + 1.1 : turned;
    EXPECT_LE(bounds[2 * axis], Center[axis] - Radius + 0.02);
    EXPECT_GE(bounds[2 * axis], Center[axis] - largest);
    EXPECT_GE(bounds[2 * axis + 1], Center[axis] + Radius - 0.02);
    EXPECT_LE(bounds[2 * axis + 1], Center[axis] + largest);
  }
}

TEST_F(SubVoxelVolumeMapper, EmptyIsoValueRaisesErrorAndDrawsNothing)
{
  vtkNew<vtkTest::ErrorObserver> errors;
  this->Mapper->AddObserver(vtkCommand::ErrorEvent, errors);
  this->Mapper->SetIsoValue(0, 7.0);
  this->Render();
  EXPECT_NE(errors->GetErrorMessage().find('7'), std::string::npos) << errors->GetErrorMessage();
  EXPECT_EQ(this->ColorAt(100, 100), Black);
}

// Aborts a window's frames while it is observing.
vtkSmartPointer<vtkCommand> AbortingCommand()
{
  auto abort = vtkSmartPointer<vtkCallbackCommand>::New();
  abort->SetCallback([](vtkObject* window, unsigned long, void*, void*)
                     { static_cast<vtkRenderWindow*>(window)->SetAbortRender(1); });
  return abort;
}

TEST_F(SubVoxelVolumeMapper, AbortedFrameDrawsNothing)
{
  ASSERT_NE(this->Mapper->GetField(), nullptr);
  this->Window->AddObserver(vtkCommand::AbortCheckEvent, AbortingCommand());
  this->Render();
  EXPECT_EQ(this->ColorAt(100, 100), Black);
}

TEST_F(SubVoxelVolumeMapper, AbortedFrameDefersFieldBuild)
{
  vtkNew<vtkTest::ErrorObserver> errors;
  this->Mapper->AddObserver(vtkCommand::ErrorEvent, errors);
  const unsigned long tag =
      this->Window->AddObserver(vtkCommand::AbortCheckEvent, AbortingCommand());
  this->Render();
  EXPECT_EQ(this->Mapper->GetImage()->Width, 0) << "the image was made despite the abort";
  this->Window->RemoveObserver(tag);
  this->Render();
  EXPECT_NE(this->ColorAt(100, 100), Black);
  EXPECT_FALSE(errors->GetError()) << errors->GetErrorMessage();
}

TEST_F(SubVoxelVolumeMapper, RestartsAbortedFieldBuild)
{
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* mapper, unsigned long, void*, void*)
                     { static_cast<vtkAlgorithm*>(mapper)->SetAbortExecute(1); });
  const unsigned long tag = this->Mapper->AddObserver(vtkCommand::ProgressEvent, abort);
  EXPECT_EQ(this->Mapper->GetField(), nullptr);
  this->Mapper->RemoveObserver(tag);
  EXPECT_NE(this->Mapper->GetField(), nullptr);
}
} // namespace
} // namespace palpate::vtk_sub_voxel_volume_mapper_test
