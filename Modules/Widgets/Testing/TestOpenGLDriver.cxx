#include "OpenGLDriver.h"

#include "WindowTest.h"

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

TEST_F(OpenGLDriverTest, OnlyAGraphicsCardIsOfferedOcclusionAndSmoothsByDefault)
{
  const bool hasCard = IsGraphicsCard(OpenGLDriver());
  int occlusions = 0;
  for (const QAction* action : this->Window->findChildren<QAction*>())
  {
    occlusions += action->text().contains("occlusion") ? 1 : 0;
  }
  EXPECT_EQ(occlusions, hasCard ? 1 : 0);
  EXPECT_EQ(this->Action("Smooth edges")->isChecked(), hasCard);
  EXPECT_EQ(this->Window->Views()->Space()->View()->GetAntialiasing(), hasCard);
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
