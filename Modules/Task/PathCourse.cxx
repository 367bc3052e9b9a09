#include "PathCourse.h"

#include "AlongLine.h"

namespace palpate
{
PathCourse::PathCourse(const TaskTarget& target) : Tolerance(target.Tolerance)
{
  std::vector<Vector3> path;
  for (const TaskPoint& point : target.Points)
  {
    path.push_back(point.PointWorld);
  }
  this->Places.push_back(path.front());
  AlongLine(path, false, [this](const Vector3& point, double) { this->Places.push_back(point); });
  this->Places.push_back(path.back());
}

void PathCourse::Take(const Vector3& toolWorld)
{
  while (this->Passed < this->Places.size() &&
         (toolWorld - this->Places[this->Passed]).norm() <= this->Tolerance)
  {
    ++this->Passed;
  }
}
} // namespace palpate
