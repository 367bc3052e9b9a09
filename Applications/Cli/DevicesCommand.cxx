#include "DevicesCommand.h"

#include "Console.h"
#include "DeviceList.h"
#include "ScreenText.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>

namespace palpate::cli
{
namespace
{
nlohmann::ordered_json AsJson(const DeviceReport& report)
{
  nlohmann::ordered_json object{{"name", report.Name},
                                {"description", report.Description},
                                {"there", report.IsThere},
                                {"says", report.Says}};
  if (report.IsThere)
  {
    const DeviceCapabilities& device = report.Capabilities;
    const Vector3 size = device.Workspace.sizes();
    object["device"] = device.Name;
    object["degrees_of_freedom"] = device.DegreesOfFreedom;
    object["workspace_mm"] = {size[0], size[1], size[2]};
    object["force_max_n"] = device.MaximumForce;
    object["stiffness_max_n_per_mm"] = device.MaximumStiffness;
    object["resolution_mm"] = device.Resolution;
    object["rate_hz"] = device.Rate;
  }
  return object;
}

void Print(const DeviceReport& report, std::ostream& out)
{
  out << report.Name << ": " << report.Description << '\n';
  if (!report.IsThere)
  {
    out << "  " << Printable(report.Says) << '\n';
    return;
  }
  const DeviceCapabilities& device = report.Capabilities;
  const Vector3 size = device.Workspace.sizes();
  out << "  " << device.Name << ", " << report.Says << "; " << device.DegreesOfFreedom
      << " degrees of freedom, " << size[0] << " x " << size[1] << " x " << size[2] << " mm\n"
      << "  at most " << device.MaximumForce << " N and " << device.MaximumStiffness
      << " N/mm; positions to " << device.Resolution << " mm, " << device.Rate << " Hz\n";
}
} // namespace

std::string DevicesCommand::Examples() const
{
  return "  palpate devices         what there is\n"
         "  palpate devices --json  one JSON object a device";
}

void DevicesCommand::DeclareOptions(CLI::App& app)
{
  app.add_flag("--json", this->Json, "One JSON object a line instead of text");
}

int DevicesCommand::Run(Console& console)
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
} // namespace palpate::cli
