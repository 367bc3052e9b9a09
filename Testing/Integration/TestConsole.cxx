#include "Console.h"

#include <cmath>
#include <gtest/gtest.h>
#include <sstream>

namespace palpate::console_test
{
namespace
{
using palpate::cli::Console;

TEST(Console, ResultsAndRemarksUseTheirStreams)
{
  std::ostringstream out;
  std::ostringstream err;
  Console console(out, err, false);
  console.Output() << "result\n";
  console.Note("remark");
  console.Error("sentence");
  EXPECT_EQ(out.str(), "result\n");
  EXPECT_EQ(err.str(), "remark\npalpate: sentence\n");
}

TEST(Console, NoProgressWithoutTerminal)
{
  std::ostringstream out;
  std::ostringstream err;
  Console console(out, err, false);
  console.Progress(0.5, "fit");
  console.EndProgress();
  EXPECT_EQ(err.str() + out.str(), "");
}

TEST(Console, DrawsProgressAtOnceAndClearsIt)
{
  std::ostringstream out;
  std::ostringstream err;
  Console console(out, err, true);
  console.Progress(0.5, "fit");
  EXPECT_NE(err.str().find("############............]  50 %  fit"), std::string::npos) << err.str();
  console.EndProgress();
  const std::string wipe = "\r\x1b[K";
  EXPECT_EQ(err.str().substr(err.str().size() - wipe.size()), wipe);
  EXPECT_EQ(out.str(), "");
}

TEST(Console, WritesProgressForSlicer)
{
  std::ostringstream out;
  std::ostringstream err;
  Console console(out, err, true);
  console.StartSlicerProgress("palpate fit");
  console.Progress(0.5, "case <1>");
  console.Live("not for Slicer");
  console.EndProgress();
  console.EndSlicerProgress();
  console.EndSlicerProgress();
  EXPECT_EQ(out.str(), "<filter-start><filter-name>palpate fit</filter-name></filter-start>\n"
                       "<filter-comment>case (1)</filter-comment>\n"
                       "<filter-progress>0.500</filter-progress>\n"
                       "<filter-end><filter-name>palpate fit</filter-name>"
                       "<filter-time>0.0</filter-time></filter-end>\n");
  EXPECT_EQ(err.str(), "");
}

TEST(Console, QuietSuppressesProgressForSlicer)
{
  std::ostringstream out;
  std::ostringstream err;
  Console console(out, err, true);
  console.SetQuiet(true);
  console.StartSlicerProgress("palpate fit");
  console.Progress(0.5, "fit");
  console.EndSlicerProgress();
  EXPECT_EQ(out.str() + err.str(), "");
}

TEST(Console, DrawsAndReplacesLiveLineOnTerminal)
{
  std::ostringstream out;
  std::ostringstream err;
  Console console(out, err, true);
  console.Live("grip");
  console.Live("too soon to be drawn");
  console.Note("remark");
  EXPECT_EQ(err.str(), "\r\x1b[Kgrip\r\x1b[Kremark\n");
  std::ostringstream file;
  Console(out, file, false).Live("grip");
  EXPECT_EQ(file.str() + out.str(), "");
}

TEST(Console, DrawsManyStepsRarely)
{
  std::ostringstream out;
  std::ostringstream err;
  Console console(out, err, true);
  console.Progress(0.0, "fit");
  const std::size_t once = err.str().size();
  for (int i = 0; i < 100; ++i)
  {
    console.Progress(i / 100.0, "fit");
  }
  // A hundred calls take far less than a hundred drawing intervals of a tenth of a second.
  EXPECT_LT(err.str().size(), 50 * once);
}

TEST(Console, DrawsOutOfRangeAndNanFractions)
{
  for (const double fraction : {-1.0, 2.0, std::nan("")})
  {
    std::ostringstream out;
    std::ostringstream err;
    Console console(out, err, true);
    console.Progress(fraction, "fit");
    EXPECT_NE(err.str().find(" %  fit"), std::string::npos);
  }
}

TEST(Console, QuietKeepsErrorsOnly)
{
  std::ostringstream out;
  std::ostringstream err;
  Console console(out, err, true);
  console.SetQuiet(true);
  console.Note("remark");
  console.Progress(0.5, "fit");
  console.Error("sentence");
  EXPECT_EQ(err.str(), "palpate: sentence\n");
}

TEST(Console, RemarkClearsProgressLine)
{
  std::ostringstream out;
  std::ostringstream err;
  Console console(out, err, true);
  console.Progress(0.5, "fit");
  console.Note("remark");
  EXPECT_NE(err.str().find("\r\x1b[Kremark\n"), std::string::npos);
}

TEST(Console, NamesWithLineBreaksStayOnOneLine)
{
  std::ostringstream out;
  std::ostringstream err;
  Console console(out, err, false);
  console.Error("bad\nname.nii is empty; write it again.");
  console.Note("turned \u202eround");
  EXPECT_EQ(err.str(), "palpate: bad\\x0aname.nii is empty; write it again.\n"
                       "turned \\xe2\\x80\\xaeround\n");
}
} // namespace
} // namespace palpate::console_test
