#include "TouchTicksFile.h"

#include "InputError.h"
#include "Progress.h"
#include "TemporaryFolder.h"
#include "TouchRecording.h"
#include "WholeFile.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace palpate::touch_ticks_file_test
{
namespace
{
// One second at 1 kHz with increasing pressure.
TouchRecording Recording()
{
  TouchRecording recording;
  for (int n = 0; n < 1000; ++n)
  {
    TouchState tick;
    tick.Tick.Number = static_cast<std::uint64_t>(n);
    tick.Tick.Started = 1'000'000 * n;
    tick.Structure = 0;
    tick.Depth = 1e-3 * n;
    tick.ForceDevice.X = 2e-3 * n;
    recording.Ticks.push_back(tick);
  }
  return recording;
}

class TouchTicksFileTest : public testing::Test
{
protected:
  std::string Text(const std::string& name)
  {
    ExportTouch(Recording(), this->Folder / name);
    return ReadWholeFile(this->Folder / name, 1 << 24);
  }

  const test::TemporaryFolder Folder;
};

TEST_F(TouchTicksFileTest, CsvHasOneLinePerTick)
{
  const std::string text = this->Text("ticks.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1001);
}

TEST_F(TouchTicksFileTest, CancelledExportLeavesNothing)
{
  int reports = 0;
  const auto cancel = [&reports](double, const std::string&) { return ++reports < 1; };
  EXPECT_THROW(ExportTouch(Recording(), this->Folder / "ticks.csv", cancel), Cancelled);
  EXPECT_EQ(reports, 1);
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "ticks.csv"));
}

TEST_F(TouchTicksFileTest, RejectsOtherEndings)
{
  EXPECT_THROW(ExportTouch(Recording(), this->Folder / "plots.svg"), InputError);
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "plots.svg"));
}
} // namespace
} // namespace palpate::touch_ticks_file_test
