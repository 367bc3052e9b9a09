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
    Refuse(file, "has no ending of a format for recorded touches",
           "use .csv for one line per tick, or .svg for plots");
  }
  else if (recording.Ticks.empty())
  {
    Refuse(file, "was not written, since no tick was recorded", "record the touch again");
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
