#include "TouchTicksFile.h"

#include "DecimalText.h"
#include "Progress.h"
#include "Refusal.h"
#include "TouchRecording.h"
#include "Units.h"
#include "WholeFile.h"

#include <cstddef>
#include <string>

namespace palpate
{
namespace
{
constexpr const char* Columns =
    "tick,due_s,began_s,state,fault,buttons,x_mm,y_mm,z_mm,qx,qy,qz,qw,"
    "probe_world_x_mm,probe_world_y_mm,probe_world_z_mm,"
    "proxy_world_x_mm,proxy_world_y_mm,proxy_world_z_mm,force_x_n,force_y_n,force_z_n,"
    "force_world_x_n,force_world_y_n,force_world_z_n,structure,depth_mm,energy_n_mm,"
    "patch_mm,elastic_energy_n_mm,beyond_linear,torque_x_n_mm,torque_y_n_mm,torque_z_n_mm,"
    "probe_qx,probe_qy,probe_qz,probe_qw,proxy_qx,proxy_qy,proxy_qz,proxy_qw\n";

void Append(std::string& text, double number)
{
  text += ',' + ExactText(number);
}

void Append(std::string& text, const PlainVector3& v)
{
  Append(text, v.X);
  Append(text, v.Y);
  Append(text, v.Z);
}

void Append(std::string& text, const TouchState& state, std::int64_t start)
{
  text += std::to_string(state.Tick.Number);
  Append(text, SecondsPerNanosecond * static_cast<double>(state.Tick.Scheduled - start));
  Append(text, SecondsPerNanosecond * static_cast<double>(state.Tick.Started - start));
  text += ',' + std::string(NameOf(state.State)) + ',' +
          std::to_string(static_cast<int>(state.Safety.Fault)) + ',' +
          std::to_string(state.Sample.Buttons);
  Append(text, state.Sample.Position);
  for (const double number : state.Sample.Orientation)
  {
    Append(text, number);
  }
  Append(text, state.ProbeWorld);
  Append(text, state.ProxyWorld);
  Append(text, state.ForceDevice);
  Append(text, state.ForceWorld);
  text += ',' + std::to_string(state.Structure);
  Append(text, state.Depth);
  Append(text, state.Safety.Energy);
  Append(text, state.PatchRadius);
  Append(text, state.ElasticEnergy);
  text += state.IsBeyondLinear ? ",1" : ",0";
  Append(text, state.TorqueDevice);
  for (const auto* orientation : {&state.ProbeOrientation, &state.ProxyOrientation})
  {
    for (const double number : *orientation)
    {
      Append(text, number);
    }
  }
  text += '\n';
}
} // namespace

bool IsTouchRecording(const std::filesystem::path& path)
{
  return path.extension() == ".touch" || path.extension() == ".part";
}

void ExportTouch(const TouchRecording& recording, const std::filesystem::path& file,
                 const ProgressFunction& progress)
{
  if (file.extension() != ".csv")
  {
    Refuse(file, "has no ending of a format for recorded touches",
           "use .csv for one line per tick");
  }
  std::string text = Columns;
  const std::vector<TouchState>& ticks = recording.Ticks;
  const std::int64_t start = ticks.empty() ? 0 : ticks.front().Tick.Scheduled;
  for (std::size_t tick = 0; tick < ticks.size(); ++tick)
  {
    constexpr std::size_t TicksAReport = 4096;
    if (tick % TicksAReport == 0)
    {
      ReportProgress(progress, static_cast<double>(tick) / static_cast<double>(ticks.size()),
                     "Writing ticks");
    }
    Append(text, ticks[tick], start);
  }
  WriteWholeFile(file, text);
}

bool ExportTouch(const std::filesystem::path& recording, const std::filesystem::path& file,
                 const ProgressFunction& progress)
{
  TouchRecording read;
  RequireInput(ReadTouchRecording(recording.string(), read));
  ExportTouch(read, file, progress);
  return read.WasCutOff;
}
} // namespace palpate
