#include "BodyAxes.h"

#include "LabelImages.h"

#include <gtest/gtest.h>

namespace palpate::body_axes_test
{
namespace
{
// A sagittal series: columns run to posterior, rows to inferior, slices to left; rotated by 10
// degrees about the body's long axis.
vtkSmartPointer<vtkImageData> SagittalSeries()
{
  const double c = std::cos(M_PI / 18.0);
  const double s = std::sin(M_PI / 18.0);
  palpate::test::LabelGrid grid;
  grid.Direction = {{-s, 0, c, c, 0, s, 0, -1, 0}};
  return palpate::test::MakeLabelImage(grid, [](double, double, double) { return true; });
}

TEST(BodyAxes, FindsAxesOfSagittalSeries)
{
  const BodyAxes body{ImageAxes(SagittalSeries())};
  EXPECT_EQ(body.Axis, (std::array<int, 3>{{2, 0, 1}}));
  EXPECT_EQ(body.Sign, (std::array<double, 3>{{1.0, 1.0, -1.0}}));
}

TEST(BodyAxes, NearestDirectionKeepsSign)
{
  const auto image = SagittalSeries();
  const ImageAxes axes(image);
  const BodyAxes body(axes);
  for (int part = 0; part < 3; ++part)
  {
    for (const double side : {-1.0, 1.0})
    {
      const Vector3 wanted = side * Vector3::Unit(part);
      // 10 degrees off at most.
      EXPECT_GE(body.NearestWorld(axes, wanted).dot(wanted), std::cos(M_PI / 18.0) - 1e-12);
    }
  }
}
} // namespace
} // namespace palpate::body_axes_test
