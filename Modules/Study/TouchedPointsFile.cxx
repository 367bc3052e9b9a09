#include "TouchedPointsFile.h"

#include "CsvText.h"
#include "DecimalText.h"
#include "FileFormat.h"
#include "RecordedTouches.h"
#include "Refusal.h"
#include "StudyMarkupsReader.h"
#include "TableEncoding.h"
#include "TouchRecording.h"
#include "TouchTicksFile.h"
#include "WholeFile.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::uintmax_t LargestTouchFile = 16 << 20;
constexpr double LargestStroke = 1e6;
constexpr const char* TouchRemedy =
    "write a header x,y,z and a line of millimetres (LPS) for each point";

// A table of touches, line by line.
class TouchTable
{
public:
  TouchTable(const std::filesystem::path& file, double deviation, double side)
      : File(file), Deviation(deviation), Side(side)
  {
  }

  void Take(const CsvRecord& record)
  {
    ++this->Line;
    SurfaceTouch touch;
    touch.Deviation = this->NumberOf(record, "sd", this->Deviation);
    const bool hasUnit = record.Find("x_mm") != nullptr;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      const std::string name = std::string(1, "xyz"[axis]) + (hasUnit ? "_mm" : "");
      touch.PointWorld[axis] = this->SideOf(axis) * this->NumberOf(record, name);
    }
    const std::string* normal = record.Find("nx");
    if (normal != nullptr && !normal->empty())
    {
      touch.Normal = Vector3(this->NumberOf(record, "nx"), this->NumberOf(record, "ny"),
                             this->NumberOf(record, "nz"));
    }
    const double stroke = this->NumberOf(record, "stroke", 0.0);
    this->Require(stroke >= 0.0 && stroke < LargestStroke && stroke == std::floor(stroke),
                  "stroke");
    touch.Stroke = static_cast<int>(stroke);
    const double outside = this->NumberOf(record, "outside", 0.0);
    this->Require(outside == 0.0 || outside == 1.0, "outside");
    touch.IsOutside = outside == 1.0;
    this->Touches.push_back(touch);
  }

  std::vector<SurfaceTouch> Touches;

private:
  double SideOf(Eigen::Index axis) const { return axis < 2 ? this->Side : 1.0; }
  void Require(bool isFulfilled, const std::string& what) const
  {
    if (!isFulfilled)
    {
      Refuse(this->File, "has in point " + std::to_string(this->Line) + " no number for " + what,
             TouchRemedy);
    }
  }
  double NumberOf(const CsvRecord& record, const std::string& column) const
  {
    const std::string* cell = record.Find(column);
    this->Require(cell != nullptr, column);
    const std::optional<double> number = ParseNumber(*cell);
    this->Require(number && std::isfinite(*number), column);
    return *number;
  }
  double NumberOf(const CsvRecord& record, const std::string& column, double fallback) const
  {
    const std::string* cell = record.Find(column);
    return cell == nullptr || cell->empty() ? fallback : this->NumberOf(record, column);
  }

  const std::filesystem::path& File;
  double Deviation;
  double Side; // of x and y
  std::size_t Line = 0;
};

std::vector<SurfaceTouch> OfMarkups(const StudyMarkups& markups, double deviation)
{
  std::vector<SurfaceTouch> touches;
  for (const StudyLandmark& landmark : markups.Landmarks)
  {
    touches.push_back({landmark.PositionWorld, deviation});
  }
  int stroke = 0;
  for (const StudyMeasurement& measurement : markups.Measurements)
  {
    stroke += measurement.Kind == MeasurementKind::Curve ? 1 : 0;
    for (const Vector3& point : measurement.PointsWorld)
    {
      // A closed curve ends where it begins.
      const bool isAgain = &point == &measurement.PointsWorld.back() &&
                           measurement.PointsWorld.size() > 2 &&
                           point == measurement.PointsWorld.front();
      if (measurement.Kind == MeasurementKind::Curve && !isAgain)
      {
        touches.push_back({point, deviation, {}, stroke});
      }
    }
  }
  return touches;
}

std::vector<SurfaceTouch> OfRecording(const std::filesystem::path& file, double deviation,
                                      double toolRadius)
{
  TouchRecording recording;
  RequireInput(ReadTouchRecording(file.string(), recording));
  RecordedTouchSettings settings;
  settings.ToolRadius = toolRadius;
  settings.Deviation = deviation;
  std::vector<SurfaceTouch> touches = TouchesOf(recording, settings);
  if (touches.empty())
  {
    Refuse(file, "has no tick in which the tool touches a structure that does not yield",
           "record a touch of the organ");
  }
  return touches;
}

// The table in a .fcsv, whose header and frame are comments.
std::string TableOfFcsv(const std::string& text, double& side)
{
  side = -1.0; // RAS, which its older versions do not state
  std::istringstream lines(text);
  std::string head = "id,x,y,z";
  std::string rows;
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t value = line.find('=');
    if (line.rfind('#', 0) != 0)
    {
      rows += line + "\n";
    }
    else if (line.find("CoordinateSystem") != std::string::npos && value != std::string::npos)
    {
      const std::string frame = line.substr(value + 1);
      side = frame.find("LPS") != std::string::npos || frame.find('1') != std::string::npos ? 1.0
                                                                                            : -1.0;
    }
    else if (line.find("columns") != std::string::npos && value != std::string::npos)
    {
      head = line.substr(value + 1);
      head.erase(0, head.find_first_not_of(' '));
    }
  }
  return head + "\n" + rows;
}

std::string TableOf(const std::vector<SurfaceTouch>& touches)
{
  std::string text = "x,y,z,nx,ny,nz,sd,stroke,outside\n";
  for (const SurfaceTouch& touch : touches)
  {
    for (const double number : touch.PointWorld)
    {
      text += ExactText(number) + ",";
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      text += (touch.Normal ? ExactText((*touch.Normal)[axis]) : "") + ",";
    }
    text += ExactText(touch.Deviation) + "," + std::to_string(touch.Stroke) + "," +
            (touch.IsOutside ? "1" : "0") + "\n";
  }
  return text;
}

StudyMarkups MarkupsOfTouches(const std::vector<SurfaceTouch>& touches)
{
  StudyMarkups markups;
  int last = 0;
  for (const SurfaceTouch& touch : touches)
  {
    if (touch.Stroke == 0)
    {
      markups.Landmarks.push_back(
          {"T-" + std::to_string(markups.Landmarks.size() + 1), touch.PointWorld});
      continue;
    }
    if (touch.Stroke != last)
    {
      last = touch.Stroke;
      StudyMeasurement stroke;
      stroke.Kind = MeasurementKind::Curve;
      stroke.Name = "Stroke " + std::to_string(last);
      markups.Measurements.push_back(std::move(stroke));
    }
    markups.Measurements.back().PointsWorld.push_back(touch.PointWorld);
  }
  return markups;
}
} // namespace

std::vector<std::string> TouchedPointsEndings()
{
  return {".csv", ".mrk.json", ".fcsv", ".touch"};
}

std::vector<SurfaceTouch> ReadTouchedPoints(const std::filesystem::path& file, double deviation,
                                            double toolRadius)
{
  if (IsTouchRecording(file))
  {
    return OfRecording(file, deviation, toolRadius);
  }
  std::vector<SurfaceTouch> touches;
  if (IsMarkupsFile(file))
  {
    touches = OfMarkups(ReadMarkups(file), deviation);
  }
  else
  {
    std::string encoding;
    std::string text = TableAsUtf8(ReadWholeFile(file, LargestTouchFile), file.string(), encoding);
    double side = 1.0;
    if (!EndingOf(file, {".fcsv"}).empty())
    {
      text = TableOfFcsv(text, side);
    }
    TouchTable table(file, deviation, side);
    ForEachCsvRecord(text, [&table](const CsvRecord& record) { table.Take(record); });
    touches = std::move(table.Touches);
  }
  if (touches.empty())
  {
    Refuse(file, "has no points", TouchRemedy);
  }
  return touches;
}

void WriteTouchedPoints(const std::filesystem::path& file, const std::vector<SurfaceTouch>& touches)
{
  if (touches.empty())
  {
    Refuse(file, "was not written, since there are no touches", "touch the organ first");
  }
  if (!IsMarkupsFile(file))
  {
    WriteWholeFile(file, TableOf(touches));
    return;
  }
  if (std::any_of(touches.begin(), touches.end(),
                  [](const SurfaceTouch& touch) { return touch.IsOutside; }))
  {
    Refuse(file, "was not written: markups cannot say that a point is outside",
           "write a table, with the ending .csv");
  }
  WriteMarkups(file, MarkupsOfTouches(touches));
}
} // namespace palpate
