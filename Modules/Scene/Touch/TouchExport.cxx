#include "TouchExport.h"

#include "Refusal.h"
#include "TouchPlots.h"
#include "TouchRecording.h"
#include "TouchTicksFile.h"

namespace palpate
{
void ExportTouch(const TouchRecording& recording, const std::filesystem::path& file)
{
  if (file.extension() == ".csv")
  {
    WriteTouchTicks(recording.Ticks, file);
  }
  else if (!IsTouchPlots(file))
  {
    Refuse(file, "does not say how a recorded touch is to be written",
           "end its name in .csv for a line a tick, or in .svg for plots");
  }
  else if (recording.Ticks.empty())
  {
    Refuse(file, "would have nothing to plot: no tick was recorded", "record the touch again");
  }
  else
  {
    WriteTouchPlots(recording.Ticks, file);
  }
}

bool ExportTouch(const std::filesystem::path& recording, const std::filesystem::path& file)
{
  TouchRecording read;
  RequireInput(ReadTouchRecording(recording.string(), read));
  ExportTouch(read, file);
  return read.WasCutOff;
}
} // namespace palpate
