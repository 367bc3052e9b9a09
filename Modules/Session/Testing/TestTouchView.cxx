#include "TouchView.h"

#include "DisplayTest.h"
#include "SyntheticFit.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
// Pixels of the tool, which is blue.
int ToolPixels(const Picture& picture)
{
  int count = 0;
  for (int row = 0; row < picture.Height; ++row)
  {
    for (int column = 0; column < picture.Width; ++column)
    {
      const std::uint8_t* pixel = picture.Pixel(column, row);
      count += pixel[2] > pixel[0] + 40 ? 1 : 0;
    }
  }
  return count;
}

class TouchViewTest : public test::DisplayTest
{
};

TEST_F(TouchViewTest, DrawsTheToolWhereItsProxyIs)
{
  const test::SyntheticFit fit;
  PreparedTouch touch;
  TouchableStructure structure;
  structure.Looks.Surface = fit.Result.Surface;
  touch.Structures.push_back(structure);
  auto scene = std::make_shared<TouchScene>();
  scene->Tool = ToolShape::Sphere(3.0);
  touch.Scene = scene;
  TouchView view(touch);
  const Vector3 middle = test::SyntheticFit::Center;
  // At time 0 it is seen from the front, which is towards smaller y.
  const Picture before = view.Draw(0.0, middle - Vector3(0.0, 60.0, 0.0));
  const Picture behind = view.Draw(0.0, middle + Vector3(0.0, 60.0, 0.0));
  const Picture turned = view.Draw(6.0, middle + Vector3(0.0, 60.0, 0.0));
  EXPECT_EQ(before.Width, TouchView::Width);
  EXPECT_GT(ToolPixels(before), 100);
  EXPECT_EQ(ToolPixels(behind), 0); // hidden
  EXPECT_GT(ToolPixels(turned), 100);
}
} // namespace
} // namespace palpate
