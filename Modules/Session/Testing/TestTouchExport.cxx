#include "TouchExport.h"

#include "InputError.h"
#include "MarkupCheck.h"
#include "TemporaryFolder.h"
#include "TouchRecording.h"
#include "WholeFile.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate
{
namespace
{
// A second at 1 kHz, pressed harder and harder.
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

class TouchExportTest : public testing::Test
{
protected:
  std::string Text(const std::string& name)
  {
    ExportTouch(Recording(), this->Folder / name);
    return ReadWholeFile(this->Folder / name, 1 << 24);
  }

  const test::TemporaryFolder Folder;
};

TEST_F(TouchExportTest, ATableHasALineATick)
{
  const std::string text = this->Text("ticks.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1001);
}

TEST_F(TouchExportTest, PlotsAreOneSvgOfAllCharts)
{
  const std::string svg = this->Text("plots.svg");
  EXPECT_EQ(svg.rfind("<svg xmlns=", 0), 0U);
  EXPECT_EQ(test::MarkupError(svg), "");
  for (const char* label : {"force, N", "depth, mm", "period, "})
  {
    EXPECT_NE(svg.find(label), std::string::npos) << label;
  }
}

// The curve of force rises from the lower left to the upper right of its chart.
TEST_F(TouchExportTest, PlotsAsPixelsHaveTheCurve)
{
  this->Text("plots.png");
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((this->Folder / "plots.png").c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  const int* size = image->GetDimensions();
  EXPECT_EQ(size[0], 3 * 390);
  EXPECT_EQ(size[1], 3 * 3 * 240);
  // Of the first chart: whether there is the curve's blue in a column, and how high (pixels).
  const auto heightIn = [&](int column)
  {
    for (int row = size[1] - 1; row >= 2 * size[1] / 3; --row)
    {
      const auto* rgb = static_cast<const unsigned char*>(image->GetScalarPointer(column, row, 0));
      if (rgb[0] < 80 && rgb[2] > 130)
      {
        return row - 2 * size[1] / 3;
      }
    }
    return -1;
  };
  const int left = heightIn(3 * 100);
  const int right = heightIn(3 * 340);
  EXPECT_GT(left, 3 * 46); // above the axis
  EXPECT_GT(right, left + 3 * 100);
}

TEST_F(TouchExportTest, AnotherEndingAndNoTicksAreRefused)
{
  EXPECT_THROW(ExportTouch(Recording(), this->Folder / "plots.bmp"), InputError);
  EXPECT_THROW(ExportTouch(TouchRecording(), this->Folder / "plots.svg"), InputError);
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "plots.svg"));
}
} // namespace
} // namespace palpate
