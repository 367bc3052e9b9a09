#include "BaselineImage.h"
#include "DisplayTest.h"
#include "PhantomViews.h"
#include "WindowImage.h"

#include <gtest/gtest.h>

namespace palpate::four_views_test
{
namespace
{
class FourViewsTest : public palpate::test::DisplayTest
{
};

TEST_F(FourViewsTest, MatchBaseline)
{
  palpate::test::PhantomViews scene(960, 600);
  scene.Views.Render();
  palpate::test::ExpectLikeBaseline(palpate::ReadWindow(scene.Views.Window),
                                    std::filesystem::path(PALPATE_BASELINES) / "FourViews.png");
}
} // namespace
} // namespace palpate::four_views_test
