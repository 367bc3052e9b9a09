#include "vtkSpaceView.h"

#include "AnatomicalView.h"
#include "ImageAxes.h"
#include "SpaceViewTest.h"
#include "vtkLandmarks.h"
#include "vtkProbeRepresentation.h"
#include "vtkSubVoxelVolume.h"
#include "vtkSubVoxelVolumeMapper.h"
#include "vtkSurfaceDisplay.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkSphereSource.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate::vtk_space_view_test
{
namespace
{
using namespace palpate::test::space_view;

class vtkSpaceViewTest : public SpaceViewTest
{
};

TEST_F(vtkSpaceViewTest, DrawsSurfaceAtItsPositionInItsColor)
{
  this->Surface->SetSurface(Sphere(Vector3(8.0, 0.0, 0.0), 10.0));
  this->View->AddSurface(this->Surface);
  const RasterImage raster = this->Draw();
  EXPECT_TRUE(IsBlue(PixelAt(raster, 8.0, 0.0)));
  EXPECT_TRUE(IsBlue(PixelAt(raster, 17.0, 0.0)));
  EXPECT_TRUE(IsBlack(PixelAt(raster, 19.0, 0.0)));
  EXPECT_TRUE(IsBlack(PixelAt(raster, -3.0, 0.0)));
  this->Surface->VisibilityOff();
  EXPECT_TRUE(IsBlack(PixelAt(this->Draw(), 8.0, 0.0)));
  this->Surface->VisibilityOn();
  this->View->RemoveSurface(this->Surface);
  EXPECT_TRUE(IsBlack(PixelAt(this->Draw(), 8.0, 0.0)));
}

TEST_F(vtkSpaceViewTest, ArrayColorsSurfaceBySign)
{
  const auto sphere = Sphere(Vector3::Zero(), 15.0);
  vtkNew<vtkDoubleArray> distances;
  distances->SetName("DistanceToSurface");
  for (vtkIdType p = 0; p < sphere->GetNumberOfPoints(); ++p)
  {
    distances->InsertNextValue(sphere->GetPoint(p)[0]);
  }
  sphere->GetPointData()->AddArray(distances);
  this->Surface->SetSurface(sphere);
  this->Surface->SetColorArray("DistanceToSurface");
  this->View->AddSurface(this->Surface);
  RasterImage raster = this->Draw();
  EXPECT_TRUE(IsRed(PixelAt(raster, 12.0, 0.0)));
  EXPECT_GT(PixelAt(raster, -12.0, 0.0)[2], PixelAt(raster, -12.0, 0.0)[0] + 40);
  this->Surface->SetColorArray("");
  raster = this->Draw();
  EXPECT_TRUE(IsBlue(PixelAt(raster, 12.0, 0.0)));
  this->Surface->SetColorArray("nothing of this name");
  EXPECT_TRUE(IsBlue(PixelAt(this->Draw(), 12.0, 0.0)));
}

TEST_F(vtkSpaceViewTest, SurfacesOfOneArrayShareScale)
{
  const auto measured = [](const Vector3& middle, double number)
  {
    const auto sphere = Sphere(middle, 8.0);
    vtkNew<vtkDoubleArray> distances;
    distances->SetName("DistanceToSurface");
    distances->SetNumberOfTuples(sphere->GetNumberOfPoints());
    distances->Fill(number);
    sphere->GetPointData()->AddArray(distances);
    return sphere;
  };
  const auto colorfulness = [](const std::uint8_t* pixel) { return pixel[0] - pixel[2]; };
  this->Surface->SetSurface(measured(Vector3(-10.0, 0.0, 0.0), 0.2));
  this->Surface->SetColorArray("DistanceToSurface");
  this->View->AddSurface(this->Surface);
  EXPECT_TRUE(IsRed(PixelAt(this->Draw(), -10.0, 0.0))) << "alone it fills its scale";
  this->Surface->SetColorLimit(2.0);
  EXPECT_LT(colorfulness(PixelAt(this->Draw(), -10.0, 0.0)), 40) << "a tenth of the limit";
  this->Surface->SetColorLimit(0.0);
  vtkNew<vtkSurfaceDisplay> other;
  other->SetSurface(measured(Vector3(10.0, 0.0, 0.0), 2.0));
  other->SetColorArray("DistanceToSurface");
  this->View->AddSurface(other);
  const RasterImage raster = this->Draw();
  EXPECT_TRUE(IsRed(PixelAt(raster, 10.0, 0.0)));
  EXPECT_LT(colorfulness(PixelAt(raster, -10.0, 0.0)), 40) << "a tenth of the other";
  other->VisibilityOff();
  EXPECT_TRUE(IsRed(PixelAt(this->Draw(), -10.0, 0.0)));
}

TEST_F(vtkSpaceViewTest, LookFromShowsThatSide)
{
  this->Surface->SetSurface(Sphere(Vector3(3.0, 4.0, 5.0), 10.0));
  this->View->AddSurface(this->Surface);
  for (const palpate::ViewSide side : palpate::AllViewSides)
  {
    this->View->LookFrom(static_cast<int>(side));
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const palpate::ViewFrame frame = palpate::FrameOf(side);
    // The camera's own arithmetic.
    EXPECT_NEAR((Vector3(camera->GetDirectionOfProjection()) + frame.TowardsViewerWorld).norm(),
                0.0, 1e-9);
    EXPECT_NEAR((Vector3(camera->GetViewUp()) - frame.UpWorld).norm(), 0.0, 1e-9);
    EXPECT_NEAR((Vector3(camera->GetFocalPoint()) - Vector3(3.0, 4.0, 5.0)).norm(), 0.0, 0.1);
  }
}

TEST_F(vtkSpaceViewTest, LooksObliquelyAlsoIfResetBeforeTheFirstFrame)
{
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 10.0));
  this->View->AddSurface(this->Surface);
  this->View->ResetCamera();
  this->Window->Render();
  EXPECT_LT((this->Sight() + palpate::ObliqueFrame().TowardsViewerWorld).norm(), 1e-6);
}

TEST_F(vtkSpaceViewTest, KeepsASideThatWasChosenBeforeThereWasAnything)
{
  this->View->LookFrom(vtkSpaceView::LEFT);
  this->Window->Render();
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 10.0));
  this->View->AddSurface(this->Surface);
  this->Window->Render();
  EXPECT_LT((this->Sight() + Vector3::UnitX()).norm(), 1e-6);
}

TEST_F(vtkSpaceViewTest, SlicesShowVolumeAtItsPosition)
{
  const auto image = palpate::test::RampImage(palpate::test::SkewTurn());
  vtkNew<vtkImageDisplay> display;
  display->SetImage(image);
  display->SetWindowLevel(300.0, 100.0);
  this->View->SetImageDisplay(display);
  this->View->AlongImageOff(); // so that the plane is seen face on, and its edge is a polygon
  this->View->SetSliceVisibility(vtkSliceView::AXIAL, false);
  this->View->SetSliceVisibility(vtkSliceView::SAGITTAL, false);
  for (const double depth : {0.0, 12.0})
  {
    this->Crosshair->SetPositionWorld(0.0, depth, 0.0);
    const RasterImage raster = this->Draw();
    for (int place = 0; place < 30 * 30; ++place)
    {
      const int step = place / 30;
      const double x = -25.0 + 1.7 * step;
      const double z = -25.0 + 1.7 * (place % 30);
      // Of the pixel's centre.
      const double column = std::floor(0.5 * Side + x / PixelMillimeters) + 0.5;
      const double row = std::floor(0.5 * Side - z / PixelMillimeters) + 0.5;
      const Vector3 world((column - 0.5 * Side) * PixelMillimeters, depth,
                          (0.5 * Side - row) * PixelMillimeters);
      // Two roundings to levels and the graphics system's interpolation between them.
      ASSERT_NEAR(PixelAt(raster, x, z)[0], 255.0 * (palpate::test::Ramp(world) + 50.0) / 300.0,
                  1.6);
    }
  }
}

TEST_F(vtkSpaceViewTest, DoesNotDrawSliceOutsideVolume)
{
  vtkNew<vtkImageDisplay> display;
  display->SetImage(palpate::test::RampImage(palpate::Matrix3::Identity()));
  this->View->SetImageDisplay(display);
  this->View->SetSliceVisibility(vtkSliceView::AXIAL, false);
  this->View->SetSliceVisibility(vtkSliceView::SAGITTAL, false);
  this->Crosshair->SetPositionWorld(0.0, 0.0, 0.0);
  EXPECT_FALSE(IsBlack(PixelAt(this->Draw(), 1.0, 1.0)));
  this->Crosshair->SetPositionWorld(0.0, 200.0, 0.0);
  EXPECT_TRUE(IsBlack(PixelAt(this->Draw(), 1.0, 1.0)));
}

TEST_F(vtkSpaceViewTest, PickedPointLiesOnSurfaceUnderPointer)
{
  const Vector3 center(4.0, 6.0, -3.0);
  this->Surface->SetSurface(Sphere(center, 12.0));
  this->View->AddSurface(this->Surface);
  this->Draw();
  Vector3 world;
  ASSERT_TRUE(this->PickAt(9.0, -1.0, world));
  // Facets of 100 x 100 lie up to 12 (1 - cos^2(pi / 100)) = 0.012 mm within.
  EXPECT_NEAR((world - center).norm(), 12.0, 0.02);
  EXPECT_LT(world.y(), center.y()) << "the nearer side";
  EXPECT_NEAR(world.x(), 9.0, PixelMillimeters);
  EXPECT_NEAR(world.z(), -1.0, PixelMillimeters);
  EXPECT_FALSE(this->PickAt(25.0, 25.0, world));
}

TEST_F(vtkSpaceViewTest, PicksNearerOfPolygonsAndSubVoxelSurfaces)
{
  // The ramp is high at the patient's front; from the back its surface is visible, not the border.
  vtkNew<vtkSubVoxelVolumeMapper> mapper;
  mapper->SetInputData(palpate::test::RampImage(palpate::test::SkewTurn()));
  mapper->SetIsoValue(0, 100.0);
  vtkNew<vtkSubVoxelVolume> volume;
  volume->SetMapper(mapper);
  this->Renderer->AddVolume(volume);
  this->Draw(vtkSpaceView::POSTERIOR);
  Vector3 seen;
  ASSERT_TRUE(this->PickAt(2.0, 3.0, seen));
  EXPECT_NEAR(palpate::test::Ramp(seen), 100.0, 1e-4); // voxels are floats
  this->Surface->SetSurface(Sphere(seen + Vector3(0.0, 20.0, 0.0), 3.0));
  this->View->AddSurface(this->Surface);
  this->Draw(vtkSpaceView::POSTERIOR);
  Vector3 nearer;
  ASSERT_TRUE(this->PickAt(2.0, 3.0, nearer));
  EXPECT_NEAR(nearer.y(), seen.y() + 23.0, 0.1);
  this->Surface->SetSurface(Sphere(seen - Vector3(0.0, 20.0, 0.0), 3.0));
  this->Draw(vtkSpaceView::POSTERIOR);
  ASSERT_TRUE(this->PickAt(2.0, 3.0, nearer));
  EXPECT_NEAR((nearer - seen).norm(), 0.0, 1e-9);
}

TEST_F(vtkSpaceViewTest, PickTellsWhichObjectWasHit)
{
  vtkNew<vtkSurfaceDisplay> other;
  this->Surface->SetSurface(Sphere(Vector3(-10.0, 0.0, 0.0), 5.0));
  other->SetSurface(Sphere(Vector3(10.0, 0.0, 0.0), 5.0));
  this->View->AddSurface(this->Surface);
  this->View->AddSurface(other);
  this->Draw();
  const auto pick = [this](double x)
  {
    Vector3 world;
    return this->View->PickObject(std::floor(0.5 * Side + x / PixelMillimeters), 0.5 * Side,
                                  world.data());
  };
  EXPECT_EQ(pick(-10.0), this->Surface);
  EXPECT_EQ(pick(10.0), other);
  EXPECT_EQ(pick(0.0), nullptr);
  other->SetOpacity(0.0);
  this->Draw();
  EXPECT_EQ(pick(10.0), nullptr) << "it is invisible";
}

TEST_F(vtkSpaceViewTest, WireframeShowsEdgesThatAreNeitherPickedNorFitted)
{
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 9.0));
  this->View->AddSurface(this->Surface);
  this->Window->Render();
  this->View->LookFrom(vtkSpaceView::ANTERIOR);
  const double distance = this->Renderer->GetActiveCamera()->GetDistance();
  std::array<Vector3, 8> corners;
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    corners[c] = Vector3((c & 1U) != 0 ? 20.0 : -20.0, (c & 2U) != 0 ? 20.0 : -20.0,
                         (c & 4U) != 0 ? 20.0 : -20.0);
  }
  vtkNew<vtkSurfaceDisplay> box;
  box->SetSurface(palpate::MakeBox(corners));
  box->SetColor(1.0, 0.0, 0.0);
  box->WireframeOn();
  this->View->AddSurface(box);
  this->View->LookFrom(vtkSpaceView::ANTERIOR);
  EXPECT_NEAR(this->Renderer->GetActiveCamera()->GetDistance(), distance, 1e-9); // roundings
  const RasterImage raster = this->Draw();
  EXPECT_TRUE(IsBlue(PixelAt(raster, 0.0, 0.0))) << "there are no faces";
  EXPECT_TRUE(IsBlack(PixelAt(raster, 15.0, 5.0)));
  bool isEdgeSeen = false;
  for (int column = -2; column <= 2; ++column)
  {
    isEdgeSeen = isEdgeSeen || IsRed(PixelAt(raster, 20.0 + column * PixelMillimeters, 5.0));
  }
  EXPECT_TRUE(isEdgeSeen);
  Vector3 world;
  EXPECT_FALSE(this->PickAt(15.0, 5.0, world));
}

TEST_F(vtkSpaceViewTest, ContactRegionHasContactColor)
{
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 15.0));
  this->View->AddSurface(this->Surface);
  vtkNew<vtkProbeRepresentation> probe;
  this->View->SetProbe(probe);
  probe->SetToolSphere(0.5);
  probe->SetColor(0.0, 1.0, 0.0);
  probe->SetContactColor(1.0, 0.0, 0.0);
  probe->SetContactRadius(5.0);
  // At the front, 5 mm to the left.
  const Vector3 outward = Vector3(5.0, -std::sqrt(200.0), 0.0) / 15.0;
  const Vector3 place = 15.5 * outward;
  probe->SetProbePosition(place.x(), place.y(), place.z());
  probe->SetProxyPosition(place.x(), place.y(), place.z());
  EXPECT_TRUE(IsBlue(PixelAt(this->Draw(), 5.0, 1.8))) << "without contact";
  probe->InContactOn();
  RasterImage raster = this->Draw();
  EXPECT_TRUE(IsRed(PixelAt(raster, 5.0, 1.8)));
  EXPECT_TRUE(IsRed(PixelAt(raster, 3.5, 0.0)));
  EXPECT_TRUE(IsBlue(PixelAt(raster, 5.0, 6.0)));
  EXPECT_TRUE(IsBlue(PixelAt(raster, -3.0, 0.0)));
  // The region is fixed to the surface, whatever the camera; from the left, y increases to the
  // right.
  raster = this->Draw(vtkSpaceView::LEFT);
  EXPECT_TRUE(IsRed(PixelAt(raster, -13.8, 1.0)));
  EXPECT_TRUE(IsBlue(PixelAt(raster, -13.8, 5.0)));
  EXPECT_TRUE(IsBlue(PixelAt(raster, 0.0, 0.0)));
  probe->InContactOff();
  EXPECT_TRUE(IsBlue(PixelAt(this->Draw(), 5.0, 1.8)));
}

TEST_F(vtkSpaceViewTest, LineTellsTheDepthOfAToolWithoutContact)
{
  vtkNew<vtkProbeRepresentation> probe;
  this->View->SetProbe(probe);
  probe->SetToolSphere(1.0);
  probe->SetColor(1.0, 0.0, 0.0);
  probe->SetProbePosition(-10.0, 0.0, 0.0);
  probe->SetProxyPosition(-10.0, 0.0, 0.0);
  const auto isSeen = [this]
  {
    const RasterImage raster = this->Draw();
    bool isLine = false;
    for (double up = -0.6; up < 0.7; up += PixelMillimeters)
    {
      isLine = isLine || IsRed(PixelAt(raster, 4.0, up));
    }
    return isLine;
  };
  EXPECT_FALSE(isSeen());
  probe->SetNearestPoint(10.0, 0.0, 0.0);
  EXPECT_TRUE(isSeen());
  probe->InContactOn();
  EXPECT_FALSE(isSeen());
  probe->InContactOff();
  probe->ClearNearestPoint();
  EXPECT_FALSE(isSeen());
}

TEST_F(vtkSpaceViewTest, SubVoxelContactRegionHasContactColor)
{
  vtkNew<vtkSubVoxelVolumeMapper> mapper;
  mapper->SetInputData(palpate::test::RampImage(palpate::test::SkewTurn()));
  mapper->SetIsoValue(0, 100.0);
  mapper->SetMaterialColor(0, 0.0, 0.0, 1.0);
  vtkNew<vtkSubVoxelVolume> volume;
  volume->SetMapper(mapper);
  this->Renderer->AddVolume(volume);
  vtkNew<vtkProbeRepresentation> probe;
  this->View->SetProbe(probe);
  probe->SetToolSphere(0.5);
  probe->SetContactColor(1.0, 0.0, 0.0);
  probe->SetContactRadius(5.0);
  Vector3 touched;
  this->Draw(vtkSpaceView::POSTERIOR);
  ASSERT_TRUE(this->PickAt(2.0, 3.0, touched));
  // The tool is in front of the surface, which pushes it towards the viewer.
  probe->SetForce(0.0, 1.0, 0.0);
  probe->SetForceScale(0.0); // no arrow in front of it
  probe->SetProxyPosition(touched.x(), touched.y() + 0.5, touched.z());
  probe->SetProbePosition(touched.x(), touched.y() + 0.5, touched.z());
  RasterImage raster = this->Draw(vtkSpaceView::POSTERIOR);
  EXPECT_TRUE(IsBlue(PixelAt(raster, 2.0, 4.2))) << "without contact";
  probe->InContactOn();
  raster = this->Draw(vtkSpaceView::POSTERIOR);
  EXPECT_TRUE(IsRed(PixelAt(raster, 2.0, 4.2)));
  EXPECT_TRUE(IsBlue(PixelAt(raster, 2.0, -4.0))) << "7 mm away";
  probe->InContactOff();
  raster = this->Draw(vtkSpaceView::POSTERIOR);
  EXPECT_TRUE(IsBlue(PixelAt(raster, 2.0, 4.2)));
}

TEST_F(vtkSpaceViewTest, ToolIsSolidAtProxyAndTranslucentAtProbe)
{
  vtkNew<vtkProbeRepresentation> probe;
  this->View->SetProbe(probe);
  probe->SetToolSphere(4.0);
  probe->SetColor(0.0, 0.0, 1.0);
  probe->SetProxyPosition(-10.0, 0.0, 0.0);
  probe->SetProbePosition(10.0, 0.0, 0.0);
  const RasterImage raster = this->Draw();
  const int solid = PixelAt(raster, -10.0, 0.0)[2];
  const int translucent = PixelAt(raster, 10.0, 0.0)[2];
  EXPECT_GT(solid, 150);
  EXPECT_GT(translucent, 30);
  EXPECT_LT(translucent, solid - 50);
  probe->VisibilityOff();
  EXPECT_TRUE(IsBlack(PixelAt(this->Draw(), -10.0, 0.0)));
}

TEST_F(vtkSpaceViewTest, ArrowLengthFollowsForce)
{
  vtkNew<vtkProbeRepresentation> probe;
  this->View->SetProbe(probe);
  probe->SetToolSphere(0.5);
  probe->SetColor(0.0, 0.0, 1.0);
  probe->SetContactColor(1.0, 0.0, 0.0);
  probe->SetForce(0.0, 0.0, 2.0);
  probe->SetForceScale(8.0);
  RasterImage raster = this->Draw();
  EXPECT_TRUE(IsRed(PixelAt(raster, 0.0, 8.0)));
  EXPECT_TRUE(IsRed(PixelAt(raster, 0.0, 15.0)));
  EXPECT_TRUE(IsBlack(PixelAt(raster, 0.0, 16.5)));
  EXPECT_TRUE(IsBlack(PixelAt(raster, 0.0, -4.0)));
  probe->SetForce(0.0, 0.0, 0.0);
  raster = this->Draw();
  EXPECT_TRUE(IsBlack(PixelAt(raster, 0.0, 8.0)));
}

TEST_F(vtkSpaceViewTest, DrawsLandmarksAsSpheresAndDistancesAsLines)
{
  vtkNew<vtkLandmarks> landmarks;
  landmarks->SetColor(0.0, 0.0, 1.0);
  landmarks->SetRadius(3.0);
  landmarks->AddLandmark("", -12.0, 0.0, 0.0);
  landmarks->AddLandmark("", 12.0, 0.0, 0.0);
  this->View->SetLandmarks(landmarks);
  const auto isLine = [this]
  {
    const RasterImage raster = this->Draw();
    bool isSeen = false;
    for (int row = -2; row <= 2; ++row)
    {
      isSeen = isSeen || IsBlue(PixelAt(raster, -4.0, row * PixelMillimeters));
    }
    EXPECT_TRUE(IsBlue(PixelAt(raster, -12.0, 2.0)));
    EXPECT_TRUE(IsBlue(PixelAt(raster, 12.0, -2.0)));
    return isSeen;
  };
  EXPECT_FALSE(isLine());
  landmarks->AddDistance(0, 1);
  EXPECT_TRUE(isLine());
}

// Its line lies in the surface, as a path along it does.
TEST_F(vtkSpaceViewTest, DrawsCurvesThatLieInASurface)
{
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 15.0));
  this->Surface->SetColor(1.0, 0.0, 0.0);
  this->View->AddSurface(this->Surface);
  vtkNew<vtkLandmarks> landmarks;
  landmarks->SetColor(0.0, 0.0, 1.0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  constexpr double Below = 14.99; // mm
  for (double angle = -0.3; angle <= 0.3; angle += 0.02)
  {
    points->InsertNextPoint(0.0, -Below * std::cos(angle), Below * std::sin(angle));
  }
  ASSERT_TRUE(landmarks->AddCurve("", points->GetPoint(0), points, false));
  this->View->SetLandmarks(landmarks);
  const RasterImage raster = this->Draw();
  EXPECT_TRUE(IsBlue(PixelAt(raster, 0.0, 0.0)));
  EXPECT_TRUE(IsRed(PixelAt(raster, 2.0, 0.0)));
}

TEST_F(vtkSpaceViewTest, AntialiasingChangesOnlyEdges)
{
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 15.0));
  this->View->AddSurface(this->Surface);
  const RasterImage rough = this->Draw();
  this->View->AntialiasingOn();
  const RasterImage smooth = this->Draw();
  int changed = 0;
  for (int row = 0; row < Side; ++row)
  {
    for (int column = 0; column < Side; ++column)
    {
      const double radius =
          PixelMillimeters * std::hypot(column + 0.5 - 0.5 * Side, row + 0.5 - 0.5 * Side);
      const bool isOther = rough.Pixel(column, row)[2] != smooth.Pixel(column, row)[2];
      changed += isOther ? 1 : 0;
      EXPECT_FALSE(isOther && std::abs(radius - 15.0) > 1.0) << column << ", " << row;
    }
  }
  EXPECT_GT(changed, 100) << "of some 300 pixels of the edge";
}

TEST_F(vtkSpaceViewTest, AmbientOcclusionDarkensClefts)
{
  this->Surface->SetSurface(Sphere(Vector3(-9.0, 0.0, 0.0), 10.0));
  this->View->AddSurface(this->Surface);
  vtkNew<vtkSurfaceDisplay> other;
  other->SetSurface(Sphere(Vector3(9.0, 0.0, 0.0), 10.0));
  other->SetColor(0.0, 0.0, 1.0);
  this->View->AddSurface(other);
  const RasterImage plain = this->Draw();
  this->View->AmbientOcclusionOn();
  const RasterImage occluded = this->Draw();
  const auto share = [&](double x)
  { return static_cast<double>(PixelAt(occluded, x, 0.0)[2]) / PixelAt(plain, x, 0.0)[2]; };
  EXPECT_LT(share(0.6), 0.9) << "between the spheres";
  EXPECT_GT(share(9.0), 0.95) << "in front of one";
  this->View->AmbientOcclusionOff();
  EXPECT_EQ(this->Draw().Rgba, plain.Rgba);
}

TEST_F(vtkSpaceViewTest, ReleasedRendererIsEmpty)
{
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 9.0));
  this->View->AddSurface(this->Surface);
  this->Draw();
  this->View->SetRenderer(nullptr);
  EXPECT_EQ(this->Renderer->GetViewProps()->GetNumberOfItems(), 0);
  EXPECT_FALSE(this->Renderer->HasObserver(vtkCommand::StartEvent));
}

TEST_F(vtkSpaceViewTest, MayOutliveItsWindow)
{
  this->Surface->SetSurface(Sphere(Vector3::Zero(), 9.0));
  this->View->AddSurface(this->Surface);
  this->Draw();
  this->Window = nullptr;
  this->View->SetRenderer(nullptr);
  EXPECT_EQ(this->Renderer->GetViewProps()->GetNumberOfItems(), 0);
}
} // namespace
} // namespace palpate::vtk_space_view_test
