#include "DevicesCommand.h"

#include "Console.h"
#include "DecimalText.h"
#include "DeviceHoming.h"
#include "DeviceList.h"
#include "DeviceOption.h"
#include "FileType.h"
#include "Interruption.h"
#include "JsonSchema.h"
#include "ScreenText.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

namespace palpate::cli
{
namespace
{
nlohmann::ordered_json AsJson(const DeviceReport& report)
{
  nlohmann::ordered_json object{{JsonSchemaKey, JsonSchemaVersion},  {"name", report.Name},
                                {"description", report.Description}, {"there", report.IsThere},
                                {"untried", report.IsUntried},       {"details", report.Details}};
  if (report.IsThere)
  {
    const DeviceCapabilities& device = report.Capabilities;
    const Vector3 size = device.Workspace.sizes();
    object["device"] = device.Name;
    object["degrees_of_freedom"] = device.DegreesOfFreedom;
    object["workspace_mm"] = {size[0], size[1], size[2]};
    object["force_max_n"] = device.MaximumForce;
    object["torque_max_n_mm"] = device.MaximumTorque;
    object["stiffness_max_n_per_mm"] = device.MaximumStiffness;
    object["resolution_mm"] = device.Resolution;
    object["rate_hz"] = device.Rate;
  }
  return object;
}

void Print(const DeviceReport& report, std::ostream& out)
{
  out << Printable(report.Name + ": " + report.Description) << '\n';
  out << "  " << Printable(StateLine(report)) << '\n';
  if (!report.IsThere)
  {
    return;
  }
  const DeviceCapabilities& device = report.Capabilities;
  const Vector3 size = device.Workspace.sizes();
  out << "  " << device.DegreesOfFreedom << " degrees of freedom, " << size[0] << " x " << size[1]
      << " x " << size[2] << " mm; at most " << device.MaximumForce << " N, "
      << (device.MaximumTorque > 0.0 ? SignificantText(device.MaximumTorque) + " N mm"
                                     : "no torque")
      << ", " << device.MaximumStiffness << " N/mm; positions to " << device.Resolution << " mm, "
      << device.Rate << " Hz\n";
}

double Milliseconds(std::int64_t nanoseconds)
{
  return 1e-6 * static_cast<double>(nanoseconds);
}

double SamplesPerSecond(const HomingReport& report)
{
  const double mean = report.Periods.Mean();
  return mean > 0.0 ? 1e9 / mean : 0.0;
}

nlohmann::ordered_json AsJson(const HomingReport& report)
{
  constexpr double Almost = 0.99;
  return {{JsonSchemaKey, JsonSchemaVersion},
          {"state", NameOf(report.State)},
          {"problem", report.Problem},
          {"seconds", report.Seconds},
          {"homed_after_s", report.HomedAfter},
          {"samples", report.Periods.Count()},
          {"rate_hz", SamplesPerSecond(report)},
          {"period_median_ms", Milliseconds(report.Periods.Median())},
          {"period_p99_ms", Milliseconds(report.Periods.Quantile(Almost))},
          {"period_max_ms", Milliseconds(report.Periods.Max())},
          {"connection", report.ConnectionReport}};
}

void Print(const HomingReport& report, std::ostream& out)
{
  constexpr double Almost = 0.99;
  out << std::fixed << std::setprecision(2) << NameOf(report.State);
  if (report.HomedAfter > 0.0)
  {
    out << ", homed after " << report.HomedAfter << " s";
  }
  out << '\n'
      << std::lround(SamplesPerSecond(report)) << " samples a second over " << report.Seconds
      << " s; from one to the next " << Milliseconds(report.Periods.Median())
      << " ms (median), 99 % at most " << Milliseconds(report.Periods.Quantile(Almost))
      << " ms, longest " << Milliseconds(report.Periods.Max()) << " ms\n";
  if (!report.ConnectionReport.empty())
  {
    out << Printable(report.ConnectionReport) << '\n';
  }
}

// Short, since a line that wraps cannot be overwritten; the instruction stands above it.
std::string LiveLine(const HomingView& view)
{
  const DeviceSample& sample = view.Sample;
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << NameOf(view.State) << "  x " << sample.Position.X
       << "  y " << sample.Position.Y << "  z " << sample.Position.Z << " mm  "
       << std::lround(view.Rate) << " Hz";
  return text.str();
}
} // namespace

std::string DevicesCommand::Examples() const
{
  return "  palpate devices                           list devices\n"
         "  palpate devices --json                    one JSON object per device\n"
         "  palpate devices --home                    home the device, and measure its loop\n"
         "  palpate devices --home --device falcon --firmware FILE";
}

void DevicesCommand::DeclareOptions(CLI::App& app)
{
  app.add_flag("--json", this->Json, "Print one JSON object per line instead of text");
  CLI::Option* const home =
      app.add_flag("--home", this->IsHoming,
                   "Guide the homing of a device, without force, and measure its loop");
  app.add_option("--device", this->Device, "Which one to home (default: the first plugged in)")
      ->type_name("NAME")
      ->needs(home);
  app.add_option("--firmware", this->Firmware, "Firmware file, for devices that need it")
      ->type_name("FILE")
      ->check(FileType::Input("file"))
      ->needs(home);
}

int DevicesCommand::List(Console& console) const
{
  for (const DeviceReport& report : ListDevices())
  {
    if (this->Json)
    {
      console.Output() << AsJson(report).dump() << '\n';
    }
    else
    {
      Print(report, console.Output());
    }
  }
  return 0;
}

int DevicesCommand::Home(Console& console) const
{
  constexpr double LeastSeconds = 2.0; // for meaningful numbers of the loop
  const Interruption interruption;
  const std::string device = this->Device.empty() ? FirstDevicePluggedIn() : this->Device;
  std::string said;
  const HomingReport report = HomeDevice(
      this->Firmware.empty() ? device : WithDeviceOption(device, "firmware", this->Firmware),
      LeastSeconds,
      [&](const HomingView& view)
      {
        if (view.Guidance != said && !view.Guidance.empty())
        {
          console.Note(view.Guidance);
        }
        said = view.Guidance;
        console.Live(LiveLine(view));
        return !Interruption::WasAsked();
      });
  console.EndProgress();
  if (this->Json)
  {
    console.Output() << AsJson(report).dump() << '\n';
  }
  else
  {
    Print(report, console.Output());
  }
  if (!report.ThreadAdvice.empty())
  {
    console.Note(report.ThreadAdvice);
  }
  if (!report.Problem.empty())
  {
    console.Error(report.Problem);
  }
  return report.State == DeviceState::Ready ? 0 : 1;
}

int DevicesCommand::Run(Console& console)
{
  return this->IsHoming ? this->Home(console) : this->List(console);
}
} // namespace palpate::cli
