#include "TaskScore.h"

#include "AlongLine.h"
#include "PathCourse.h"
#include "PoseMap.h"
#include "Units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double NoValue = std::numeric_limits<double>::quiet_NaN();
using Point2 = Eigen::Vector2d;

std::vector<Vector3> PointsOf(const TaskTarget& target)
{
  std::vector<Vector3> points;
  for (const TaskPoint& point : target.Points)
  {
    points.push_back(point.PointWorld);
  }
  return points;
}

double SegmentDistance(const Vector3& point, const Vector3& a, const Vector3& b)
{
  const Vector3 along = b - a;
  const double length = along.squaredNorm();
  const double part = length > 0.0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (a + part * along - point).norm();
}

double LineDistance(const Vector3& point, const std::vector<Vector3>& line, bool isClosed)
{
  double least = (line.front() - point).norm();
  const std::size_t segments = line.size() - (isClosed ? 0 : 1);
  for (std::size_t i = 0; i < segments; ++i)
  {
    least = std::min(least, SegmentDistance(point, line[i], line[(i + 1) % line.size()]));
  }
  return least;
}

// Coordinates in the plane of a contour.
class ContourPlane
{
public:
  explicit ContourPlane(const std::vector<Vector3>& contour) : Origin(contour.front())
  {
    Vector3 normal = Vector3::Zero();
    for (std::size_t i = 0; i < contour.size(); ++i)
    {
      normal += (contour[i] - this->Origin).cross(contour[(i + 1) % contour.size()] - this->Origin);
    }
    normal.normalize();
    this->Right = normal.unitOrthogonal();
    this->Up = normal.cross(this->Right);
  }

  std::vector<Point2> Flat(const std::vector<Vector3>& points) const
  {
    std::vector<Point2> flat;
    for (const Vector3& point : points)
    {
      flat.emplace_back((point - this->Origin).dot(this->Right),
                        (point - this->Origin).dot(this->Up));
    }
    return flat;
  }
  std::vector<Vector3> Projected(const std::vector<Vector3>& points) const
  {
    std::vector<Vector3> projected;
    for (const Point2& point : this->Flat(points))
    {
      projected.emplace_back(this->Origin + point.x() * this->Right + point.y() * this->Up);
    }
    return projected;
  }

private:
  Vector3 Origin;
  Vector3 Right;
  Vector3 Up;
};

// Where a line of constant y crosses a polygon, ascending; an even number.
std::vector<double> Crossings(const std::vector<Point2>& polygon, double y)
{
  std::vector<double> crossings;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > y) != (b.y() > y))
    {
      crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

double LengthOf(const std::vector<double>& crossings)
{
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
  {
    length += crossings[i + 1] - crossings[i];
  }
  return length;
}

double SharedLength(const std::vector<double>& one, const std::vector<double>& other)
{
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < one.size(); i += 2)
  {
    for (std::size_t j = 0; j + 1 < other.size(); j += 2)
    {
      length += std::max(0.0, std::min(one[i + 1], other[j + 1]) - std::max(one[i], other[j]));
    }
  }
  return length;
}

// Of areas by the even-odd rule, summed over lines; 1 for equal polygons.
double PolygonDice(const std::vector<Point2>& one, const std::vector<Point2>& other)
{
  constexpr int Lines = 2000;
  double least = one.front().y();
  double most = least;
  for (const std::vector<Point2>* polygon : {&one, &other})
  {
    for (const Point2& point : *polygon)
    {
      least = std::min(least, point.y());
      most = std::max(most, point.y());
    }
  }
  double shared = 0.0;
  double sum = 0.0;
  for (int i = 0; i < Lines; ++i)
  {
    const double y = least + (most - least) * (i + 0.5) / Lines;
    const std::vector<double> a = Crossings(one, y);
    const std::vector<double> b = Crossings(other, y);
    shared += SharedLength(a, b);
    sum += LengthOf(a) + LengthOf(b);
  }
  return sum > 0.0 ? 2.0 * shared / sum : 0.0;
}

TaskScore NoduleScore(const TaskTarget& target, const TaskAnswer& answer)
{
  const bool isReported = !answer.PointsWorld.empty();
  TaskScore score{{isReported ? 1.0 : 0.0, NoValue, NoValue}, false};
  if (isReported && !target.Points.empty())
  {
    const Vector3 off = answer.PointsWorld.front() - target.Points.front().PointWorld;
    const Vector3 side = target.Side.normalized();
    score.Values[1] = (off - off.dot(side) * side).norm();
    score.Values[2] = answer.Diameter - target.Diameter;
  }
  score.IsSuccess = target.Points.empty() ? !isReported : score.Values[1] <= target.Tolerance;
  return score;
}

TaskScore LandmarkScore(const TaskTarget& target, const TaskAnswer& answer)
{
  double sum = 0.0;
  double most = 0.0;
  int marked = 0;
  for (std::size_t i = 0; i < std::min(target.Points.size(), answer.PointsWorld.size()); ++i)
  {
    const double error = (answer.PointsWorld[i] - target.Points[i].PointWorld).norm();
    if (std::isfinite(error))
    {
      sum += error;
      most = std::max(most, error);
      ++marked;
    }
  }
  const auto missing = static_cast<double>(target.Points.size()) - marked;
  return {{marked > 0 ? sum / marked : NoValue, marked > 0 ? most : NoValue, missing},
          missing == 0.0 && most <= target.Tolerance};
}

TaskScore OutlineScore(const TaskTarget& target, const TaskAnswer& answer)
{
  const std::vector<Vector3> truth = PointsOf(target);
  const ContourPlane plane(truth);
  if (answer.PointsWorld.size() < 3)
  {
    return {{0.0, NoValue}, false};
  }
  const std::vector<Vector3> drawn = plane.Projected(answer.PointsWorld);
  const double distance =
      0.5 * (MeanLineDistance(truth, drawn, true) + MeanLineDistance(drawn, truth, true));
  return {{PolygonDice(plane.Flat(truth), plane.Flat(answer.PointsWorld)), distance},
          distance <= target.Tolerance};
}

TaskScore DockScore(const TaskTarget& target, const TaskAnswer& answer)
{
  const double distance = (answer.Shift - target.Pose.Shift).norm();
  const double angle =
      TurnOf({answer.Shift, answer.Turn}).angularDistance(TurnOf(target.Pose)) * DegreesPerRadian;
  return {{distance, angle}, distance <= target.Tolerance && angle <= target.AngleTolerance};
}

TaskScore PathScore(const TaskTarget& target, const TaskAnswer& answer, const TaskConduct& conduct)
{
  const std::vector<Vector3> path = PointsOf(target);
  PathCourse course(target);
  double sum = 0.0;
  for (const Vector3& tool : answer.PointsWorld)
  {
    sum += LineDistance(tool, path, false);
    course.Take(tool);
  }
  const bool hasTrace = !answer.PointsWorld.empty();
  const double passed = course.Share();
  return {{static_cast<double>(conduct.Contacts), conduct.TouchedSeconds,
           hasTrace ? sum / static_cast<double>(answer.PointsWorld.size()) : NoValue, passed},
          conduct.Contacts == 0 && passed == 1.0};
}
} // namespace

const std::vector<std::string>& TaskMeasures(TaskKind kind)
{
  static const std::vector<std::vector<std::string>> names{
      {"reported", "distance_mm", "size_error_mm"},
      {"error_mean_mm", "error_max_mm", "missing"},
      {"dice", "distance_mean_mm"},
      {"dice", "distance_mean_mm"},
      {"shift_error_mm", "turn_error_degrees"},
      {"wall_contacts", "wall_s", "deviation_mean_mm", "passed"}};
  return names.at(static_cast<std::size_t>(kind));
}

const std::string& PrimaryMeasure(TaskKind kind)
{
  static const std::vector<std::string> names{"success",          "error_mean_mm",
                                              "distance_mean_mm", "distance_mean_mm",
                                              "shift_error_mm",   "wall_s"};
  return names.at(static_cast<std::size_t>(kind));
}

TaskScore ScoreOf(TaskKind kind, const TaskTarget& target, const TaskAnswer& answer,
                  const TaskConduct& conduct)
{
  TaskScore score;
  switch (kind)
  {
  case TaskKind::Nodule:
    score = NoduleScore(target, answer);
    break;
  case TaskKind::Landmarks:
    score = LandmarkScore(target, answer);
    break;
  case TaskKind::Outline:
    score = OutlineScore(target, answer);
    break;
  case TaskKind::Mask:
    score = {{answer.Dice, answer.MeanDistance}, answer.MeanDistance <= target.Tolerance};
    break;
  case TaskKind::Dock:
    score = DockScore(target, answer);
    break;
  case TaskKind::Path:
    score = PathScore(target, answer, conduct);
    break;
  }
  score.IsSuccess = score.IsSuccess && conduct.End == TaskEnd::Done;
  return score;
}

double MeanLineDistance(const std::vector<Vector3>& from, const std::vector<Vector3>& to,
                        bool isClosed)
{
  double sum = 0.0;
  double length = 0.0;
  AlongLine(from, isClosed,
            [&](const Vector3& point, double part)
            {
              sum += part * LineDistance(point, to, isClosed);
              length += part;
            });
  return length > 0.0 ? sum / length : LineDistance(from.front(), to, isClosed);
}
} // namespace palpate
