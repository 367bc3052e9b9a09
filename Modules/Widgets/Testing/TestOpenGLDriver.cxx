#include "OpenGLDriver.h"

#include "WindowTest.h"

#include <QMenu>

namespace palpate::open_gl_driver_test
{
namespace
{
using OpenGLDriverTest = test::WindowTest;

TEST_F(OpenGLDriverTest, TellsGraphicsCardsFromSoftware)
{
  EXPECT_TRUE(IsGraphicsCard("NVIDIA RTX A4000/PCIe/SSE2"));
  EXPECT_TRUE(IsGraphicsCard("Mesa Intel(R) UHD Graphics 620 (KBL GT2)"));
  EXPECT_FALSE(IsGraphicsCard("llvmpipe (LLVM 15.0.6, 256 bits)"));
  EXPECT_FALSE(IsGraphicsCard("softpipe"));
  EXPECT_FALSE(IsGraphicsCard("Software Rasterizer"));
  EXPECT_FALSE(IsGraphicsCard(""));
}

TEST_F(OpenGLDriverTest, IsNamed)
{
  EXPECT_FALSE(OpenGLDriver().isEmpty());
}

TEST_F(OpenGLDriverTest, EffectsAreOnEverywhereAndWaitForRestWithoutAGraphicsCard)
{
  SpacePane* space = this->Window->Views()->Space();
  EXPECT_TRUE(this->Action("Smooth edges")->isChecked());
  EXPECT_TRUE(this->Action("Ambient occlusion")->isChecked());
  EXPECT_TRUE(space->View()->GetAntialiasing());
  EXPECT_TRUE(space->View()->GetAmbientOcclusion());
  space->RequestRender();
  EXPECT_EQ(space->View()->GetMoving(), !IsGraphicsCard(OpenGLDriver()));
}

TEST_F(OpenGLDriverTest, GroundIsKept)
{
  QMenu* grounds = this->Action("Background of 3-D")->menu();
  ASSERT_EQ(grounds->actions().size(), 4);
  EXPECT_TRUE(grounds->actions().front()->isChecked()) << "that of the theme";
  grounds->actions().back()->trigger();
  EXPECT_EQ(this->Window->Views()->Space()->Renderer()->GetBackground()[0], 1.0);
  const MainWindow next(*this->Study);
  EXPECT_EQ(next.Views()->Space()->Renderer()->GetBackground()[0], 1.0);
}

TEST_F(OpenGLDriverTest, SmoothEdgesAreKept)
{
  QAction* smooth = this->Action("Smooth edges");
  const bool before = smooth->isChecked();
  smooth->trigger();
  EXPECT_NE(this->Window->Views()->Space()->View()->GetAntialiasing(), before);
  const MainWindow next(*this->Study);
  EXPECT_NE(next.Views()->Space()->View()->GetAntialiasing(), before);
}

TEST_F(OpenGLDriverTest, ShadowOfTheToolIsShownByDefaultAndItsSwitchIsKept)
{
  QAction* shadow = this->Action("Shadow of the tool");
  EXPECT_TRUE(shadow->isChecked());
  EXPECT_TRUE(this->Window->Views()->Space()->View()->GetToolShadow());
  shadow->trigger();
  EXPECT_FALSE(this->Window->Views()->Space()->View()->GetToolShadow());
  const MainWindow next(*this->Study);
  EXPECT_FALSE(next.Views()->Space()->View()->GetToolShadow());
}
} // namespace
} // namespace palpate::open_gl_driver_test
