#include "ViewerOptions.h"

#include <QCoreApplication>

#include <gtest/gtest.h>

namespace palpate::viewer_options_test
{
namespace
{
ViewerOptions Parse(const QStringList& arguments)
{
  char name[] = "palpate-viewer";
  char* all[] = {name, nullptr};
  int count = 1;
  const QCoreApplication application(count, all);
  return ParseViewerOptions(QStringList{"palpate-viewer"} + arguments);
}

TEST(ViewerOptions, ParsesFilesSwitchesAndSize)
{
  const ViewerOptions options =
      Parse({"a.nii.gz", "--touch", "--screenshot", "p.png", "--size", "1600x1000", "b.nrrd"});
  EXPECT_EQ(options.Problem, "");
  EXPECT_EQ(options.Files, (QStringList{"a.nii.gz", "b.nrrd"}));
  EXPECT_TRUE(options.StartsTouch);
  EXPECT_FALSE(options.ShowsDemo);
  EXPECT_EQ(options.Screenshot, "p.png");
  EXPECT_EQ(options.Size, QSize(1600, 1000));
}

TEST(ViewerOptions, HaveDefaults)
{
  const ViewerOptions options = Parse({});
  EXPECT_EQ(options.Size, QSize(1280, 800));
  EXPECT_TRUE(options.Screenshot.isEmpty());
  EXPECT_TRUE(options.UsesCache);
  EXPECT_FALSE(Parse({"--no-cache"}).UsesCache);
  EXPECT_TRUE(options.Answer.isEmpty());
  EXPECT_TRUE(Parse({"--help"}).Answer.contains("--screenshot"));
}

TEST(ViewerOptions, ReportErrors)
{
  EXPECT_TRUE(Parse({"--no-such-thing"}).Problem.contains("no-such-thing"));
  for (const char* bad : {"12", "axb", "0x0", "-1x5", "100x", "1e3x100", "99999x100"})
  {
    EXPECT_TRUE(Parse({QString("--size=") + bad}).Problem.contains(bad)) << bad;
  }
}
} // namespace
} // namespace palpate::viewer_options_test
