#include "vtkImageDisplay.h"

#include "SlicePainter.h"
#include "SliceViewTest.h"
#include "vtkLandmarks.h"
#include "vtkSurfaceDisplay.h"

#include "vtkPolyData.h"
#include "vtkTestErrorObserver.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::vtk_image_display_test
{
namespace
{
TEST(vtkImageDisplay, NewVolumeResetsWindow)
{
  vtkNew<vtkImageDisplay> display;
  const auto image = palpate::test::RampImage(palpate::test::SkewTurn());
  display->SetImage(image);
  double range[2];
  image->GetScalarRange(range);
  EXPECT_GT(display->GetWindow(), 0.5 * (range[1] - range[0]));
  EXPECT_LT(display->GetWindow(), range[1] - range[0]);
  EXPECT_NEAR(display->GetLevel(), 100.0, 5.0); // the ramp is symmetric about its centre
  EXPECT_EQ(display->GetWindow(), display->GetChosenWindow());
}

TEST(vtkImageDisplay, WindowStaysPositiveAndFinite)
{
  vtkNew<vtkImageDisplay> display;
  display->SetImage(palpate::test::RampImage(palpate::test::SkewTurn()));
  display->SetWindowLevel(-50.0, 20.0);
  EXPECT_GT(display->GetWindow(), 0.0);
  EXPECT_NEAR(display->GetLevel(), 20.0, 1e-12);
  display->SetWindowLevel(std::nan(""), 20.0);
  display->SetWindowLevel(10.0, std::nan(""));
  EXPECT_GT(display->GetWindow(), 0.0);
  EXPECT_NEAR(display->GetLevel(), 20.0, 1e-12);
}

TEST(vtkImageDisplay, NewVolumeEndsMarkedValues)
{
  vtkNew<vtkImageDisplay> display;
  display->SetImage(palpate::test::RampImage(palpate::test::SkewTurn()));
  const vtkMTimeType before = display->GetMTime();
  display->MarkValues(50.0, HUGE_VAL);
  EXPECT_TRUE(display->HasMarkedValues());
  EXPECT_GT(display->GetMTime(), before) << "views draw it";
  display->MarkValues(std::nan(""), 60.0);
  EXPECT_EQ(display->GetContent().Band->Low, 50.0);
  display->SetImage(palpate::test::RampImage(palpate::test::SkewTurn()));
  EXPECT_FALSE(display->HasMarkedValues());
}

TEST(vtkImageDisplay, CenterEqualsVolumeCenter)
{
  vtkNew<vtkImageDisplay> display;
  double center[3];
  EXPECT_FALSE(display->GetCenterWorld(center));
  display->SetImage(palpate::test::RampImage(palpate::test::SkewTurn()));
  ASSERT_TRUE(display->GetCenterWorld(center));
  EXPECT_NEAR(Vector3(center).norm(), 0.0, 1e-12);
}

TEST(vtkImageDisplay, MTimeIncludesImages)
{
  vtkNew<vtkImageDisplay> display;
  const auto image = palpate::test::RampImage(palpate::test::SkewTurn());
  const auto labels = palpate::test::RampImage(palpate::test::SkewTurn());
  display->SetImage(image);
  display->AddLabels(labels);
  for (vtkImageData* data : {image.Get(), labels.Get()})
  {
    const vtkMTimeType before = display->GetMTime();
    data->Modified();
    EXPECT_GT(display->GetMTime(), before);
  }
}

TEST(vtkImageDisplay, RejectsColorOfUnknownLayer)
{
  vtkNew<vtkTest::ErrorObserver> errors;
  vtkNew<vtkImageDisplay> display;
  display->AddObserver(vtkCommand::ErrorEvent, errors);
  display->SetLabelColor(0, 1, 1.0, 0.0, 0.0, 1.0);
  EXPECT_TRUE(errors->GetError());
}

TEST(vtkSurfaceDisplay, MTimeIncludesSurface)
{
  vtkNew<vtkSurfaceDisplay> display;
  vtkNew<vtkPolyData> surface;
  display->SetSurface(surface);
  const vtkMTimeType before = display->GetMTime();
  surface->Modified();
  EXPECT_GT(display->GetMTime(), before);
}

TEST(vtkLandmarks, RejectsNonFinitePositionsAndUnknownNumbers)
{
  vtkNew<vtkLandmarks> landmarks;
  EXPECT_EQ(landmarks->AddLandmark("a", 1.0, 2.0, 3.0), 0);
  EXPECT_EQ(landmarks->AddLandmark("b", 1.0, std::nan(""), 3.0), -1);
  EXPECT_EQ(landmarks->AddLandmark(nullptr, 4.0, 2.0, 3.0), 1);
  EXPECT_TRUE(landmarks->AddDistance(0, 1));
  EXPECT_FALSE(landmarks->AddDistance(0, 2));
  EXPECT_FALSE(landmarks->AddDistance(-1, 0));
  ASSERT_EQ(landmarks->GetCurves().size(), 1U);
  EXPECT_EQ(landmarks->GetCurves()[0].Label, "3.0 mm");
  landmarks->RemoveAll();
  EXPECT_EQ(landmarks->GetNumberOfLandmarks(), 0);
  EXPECT_TRUE(landmarks->GetCurves().empty());
}

TEST(vtkLandmarks, CurveNeedsTwoFinitePoints)
{
  vtkNew<vtkLandmarks> landmarks;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(1.0, 2.0, 3.0);
  const double place[3] = {1.0, 2.0, 3.0};
  EXPECT_FALSE(landmarks->AddCurve("a", place, points, false));
  EXPECT_FALSE(landmarks->AddCurve("a", place, nullptr, false));
  points->InsertNextPoint(4.0, 2.0, std::nan(""));
  EXPECT_FALSE(landmarks->AddCurve("a", place, points, false));
  points->SetPoint(1, 4.0, 2.0, 3.0);
  EXPECT_TRUE(landmarks->AddCurve(nullptr, place, points, true));
  const double nowhere[3] = {1.0, 2.0, std::nan("")};
  EXPECT_FALSE(landmarks->AddCurve("a", nowhere, points, false));
  EXPECT_EQ(landmarks->GetCurves().size(), 1U);
}
} // namespace
} // namespace palpate::vtk_image_display_test
