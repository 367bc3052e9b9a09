#include "GreyWindow.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <gtest/gtest.h>
#include <limits>
#include <numeric>

namespace palpate::grey_window_test
{
namespace
{
TEST(GreyWindow, WindowExcludesExtremes)
{
  std::vector<float> values(100000);
  std::iota(values.begin(), values.end(), 0.0F);
  values.push_back(std::numeric_limits<float>::quiet_NaN());
  const palpate::GreyWindow window = palpate::FindWindow({values});
  // Percentiles of every fifth value: at most five off.
  EXPECT_NEAR(window.Low, 1000.0, 5.0);
  EXPECT_NEAR(window.High, 99500.0, 5.0);
  const palpate::GreyWindow flat = palpate::FindWindow({std::vector<float>(100, 3.0F)});
  EXPECT_LT(flat.Low, flat.High);
}

TEST(GreyWindow, WindowOfImageEqualsThatOfValues)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(100, 100, 1);
  image->AllocateScalars(VTK_SHORT, 1);
  auto* values = static_cast<short*>(image->GetScalarPointer());
  std::iota(values, values + 10000, short{-5000});
  const palpate::GreyWindow window = palpate::WindowOf(image);
  // As above.
  EXPECT_NEAR(window.Low, -4900.0, 5.0);
  EXPECT_NEAR(window.High, 4950.0, 5.0);
}
} // namespace
} // namespace palpate::grey_window_test
