#include "TouchView.h"

#include "DisplayTest.h"
#include "DrillBlock.h"
#include "SyntheticFit.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
// Pixels of the tool, which is blue.
int ToolPixels(const RasterImage& image)
{
  int count = 0;
  for (int row = 0; row < image.Height; ++row)
  {
    for (int column = 0; column < image.Width; ++column)
    {
      const std::uint8_t* pixel = image.Pixel(column, row);
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
  BuiltStructure structure;
  structure.Looks.Surface = fit.Result.Surface;
  touch.Structures.push_back(structure);
  auto scene = std::make_shared<TouchScene>();
  scene->Tool = ToolShape::Sphere(3.0);
  touch.Scene = scene;
  TouchView view(touch);
  const Vector3 middle = test::SyntheticFit::Center;
  // At time 0 the view is from the front, towards smaller y.
  const RasterImage before = view.Draw(0.0, middle - Vector3(0.0, 60.0, 0.0));
  const RasterImage behind = view.Draw(0.0, middle + Vector3(0.0, 60.0, 0.0));
  const RasterImage turned = view.Draw(6.0, middle + Vector3(0.0, 60.0, 0.0));
  EXPECT_EQ(before.Width, TouchView::Width);
  EXPECT_GT(ToolPixels(before), 100);
  EXPECT_EQ(ToolPixels(behind), 0); // hidden
  EXPECT_GT(ToolPixels(turned), 100);
}

TEST_F(TouchViewTest, ShowsTheCurrentDrilledState)
{
  const test::DrillBlock block;
  // From the front, as in the view.
  TouchScript script;
  script.Path = HandPath({{0.0, {0.0, -12.0, 0.0}},
                          {0.5, {0.0, -9.0, 0.0}},
                          {2.5, {0.0, -4.0, 0.0}},
                          {3.0, {0.0, -12.0, 0.0}}});
  script.Actions = {{0.2, DrillAction::Kind::Start}, {2.7, DrillAction::Kind::Stop}};
  script.IsSeen = true;
  const PreparedTouch touch = test::Prepare(block.Settings(), script);
  TouchView view(touch);
  const Vector3 away(0.0, 0.0, 500.0); // the tool
  const RasterImage before = view.Draw(0.0, away);
  ASSERT_GT(RunTouch(touch, {}, test::NeverCancels).RemovedVolumes[0], 10.0);
  EXPECT_NE(view.Draw(0.0, away).Rgba, before.Rgba);
  // And as before again.
  const Status status = touch.Drill->Editor().Restore({RemovedDistances::None(
      touch.Drill->Editor().Site(0).Now().Grid(), touch.Drill->Editor().Site(0).Now().Band())});
  EXPECT_TRUE(status.IsOk()) << status.Message();
  EXPECT_EQ(view.Draw(0.0, away).Rgba, before.Rgba);
}
} // namespace
} // namespace palpate
