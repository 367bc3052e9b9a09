#include "FalconCalibration.h"

#include "DecimalText.h"
#include "FalconKinematics.h"
#include "PositiveNumber.h"

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr char Head[] = "palpate-falcon-calibration 1";
constexpr double RadiansPerDegree = M_PI / 180.0;

// An entry of the file, and the variable that it sets.
struct Entry
{
  const char* Name;
  double* Value;
  double Unit; // one unit of the file in the program's unit
};

std::vector<Entry> EntriesOf(FalconCalibration& c)
{
  FalconGeometry& g = c.Geometry;
  return {{"thigh", &g.Thigh, 1.0},
          {"shin", &g.Shin, 1.0},
          {"knee-offset", &g.KneeOffset, 1.0},
          {"ankle-offset", &g.AnkleOffset, 1.0},
          {"platform-radial", &g.PlatformRadial, 1.0},
          {"platform-tangential", &g.PlatformTangential, 1.0},
          {"base-radial", &g.BaseRadial, 1.0},
          {"base-tangential", &g.BaseTangential, 1.0},
          {"leg-direction-1", &g.LegDirections[0], RadiansPerDegree},
          {"leg-direction-2", &g.LegDirections[1], RadiansPerDegree},
          {"leg-direction-3", &g.LegDirections[2], RadiansPerDegree},
          {"home-angle-1", &g.HomeAngles[0], RadiansPerDegree},
          {"home-angle-2", &g.HomeAngles[1], RadiansPerDegree},
          {"home-angle-3", &g.HomeAngles[2], RadiansPerDegree},
          {"angle-per-count", &g.AnglePerCount, RadiansPerDegree},
          {"middle-height", &g.CenterHeight, 1.0},
          {"lowest-angle", &g.LowestAngle, RadiansPerDegree},
          {"highest-angle", &g.HighestAngle, RadiansPerDegree},
          {"counts-per-newton-millimeter", &c.CountsPerNewtonMillimeter, 1.0},
          {"carried-mass", &c.CarriedMass, 1.0}};
}

// Parses one line; returns an error message, or an empty text on success.
std::string TakeLine(const std::string& line, const std::vector<Entry>& entries)
{
  std::istringstream words(line.substr(0, line.find('#')));
  std::string name;
  std::string value;
  std::string more;
  if (!(words >> name))
  {
    return "";
  }
  for (const Entry& entry : entries)
  {
    if (name == entry.Name)
    {
      const std::optional<double> number =
          words >> value ? ParseNumber(value) : std::optional<double>();
      if (!number || words >> more)
      {
        return name + " is not followed by one number";
      }
      *entry.Value = *number * entry.Unit;
      return "";
    }
  }
  return name + " is not known";
}
} // namespace

Status Check(const FalconCalibration& calibration)
{
  const FalconGeometry& g = calibration.Geometry;
  for (const double positive :
       {g.Thigh, g.Shin, g.AnglePerCount, calibration.CountsPerNewtonMillimeter})
  {
    if (!IsPositive(positive))
    {
      return Status::Failure("A Falcon's lengths, its angle per count and its torque scale must be "
                             "positive numbers.");
    }
  }
  if (!(calibration.CarriedMass >= 0.0 && calibration.CarriedMass < 1.0))
  {
    return Status::Failure("The mass that a Falcon carries must be from 0 to below 1 kg.");
  }
  const FalconKinematics kinematics(g);
  Vector3 angles;
  if (!kinematics.AnglesAt(kinematics.Center(), angles))
  {
    return Status::Failure("With these lengths a Falcon's legs do not reach its middle.");
  }
  return Status::Success();
}

Status ParseCalibration(const std::string& text, const std::string& name,
                        FalconCalibration& calibration)
{
  std::istringstream lines(text);
  std::string line;
  if (!std::getline(lines, line) || line != Head)
  {
    return Status::Failure(name + " is not a Falcon's calibration: its first line is not \"" +
                           Head + "\".");
  }
  FalconCalibration found;
  const std::vector<Entry> entries = EntriesOf(found);
  while (std::getline(lines, line))
  {
    const std::string fault = TakeLine(line, entries);
    if (!fault.empty())
    {
      std::string message = name + " is not a Falcon's calibration: ";
      message.append(fault).append(".");
      return Status::Failure(std::move(message));
    }
  }
  const Status status = Check(found);
  if (!status.IsOk())
  {
    return Status::Failure(name + " cannot be used: " + status.Message());
  }
  calibration = found;
  return Status::Success();
}

Status ReadCalibration(const std::string& path, FalconCalibration& calibration)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    return Status::Failure(path + ", the Falcon's calibration, cannot be opened.");
  }
  constexpr std::size_t LargestSize = 1U << 16;
  std::string text(LargestSize + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > LargestSize)
  {
    return Status::Failure(path + " is not a Falcon's calibration: it is too long.");
  }
  return ParseCalibration(text, path, calibration);
}
} // namespace palpate
