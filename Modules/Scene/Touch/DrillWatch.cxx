#include "DrillWatch.h"

#include "DecimalText.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
std::string AlarmText(const DrillApproach& one)
{
  const double alarm = one.AlarmDistance;
  return one.Distance < 0.0
             ? "The drill touches " + one.Name + " (" + FixedText(-one.Distance, 1) + " mm inside)."
             : "The drill is " + TextAgainstLimit(one.Distance, alarm, 1) + " mm from " + one.Name +
                   ", within the alarm distance of " + TextAgainstLimit(alarm, alarm, 1) + " mm.";
}
} // namespace

DrillWatch::DrillWatch(std::shared_ptr<DrillContext> context) : Context(std::move(context))
{
  if (this->Context == nullptr)
  {
    return;
  }
  for (const DrillProtection& one : this->Context->Forbidden())
  {
    DrillApproach approach;
    approach.Name = one.Name;
    approach.AlarmDistance = one.AlarmDistance;
    this->Known.push_back(std::move(approach));
  }
}

std::vector<std::string> DrillWatch::Look(double time, const TouchState& state)
{
  std::vector<std::string> said;
  if (this->Known.empty() || !state.HasSample)
  {
    return said;
  }
  const std::array<double, 4>& q = state.Sample.Orientation;
  const ToolPose pose{state.ProxyWorld, Eigen::Quaterniond(q[3], q[0], q[1], q[2])};
  const std::vector<double> distances = this->Context->Distances(pose);
  for (std::size_t n = 0; n < this->Known.size(); ++n)
  {
    DrillApproach& one = this->Known[n];
    const bool wasAlarmed = one.IsAlarmed;
    one.AlarmSeconds += wasAlarmed ? time - this->Last : 0.0;
    one.Distance = distances[n];
    one.IsAlarmed = distances[n] < one.AlarmDistance;
    if (!this->HasLooked || distances[n] < one.Least)
    {
      one.Least = distances[n];
      one.LeastTime = time;
    }
    if (one.IsAlarmed && !wasAlarmed)
    {
      said.push_back(AlarmText(one));
    }
  }
  this->Last = time;
  this->HasLooked = true;
  return said;
}
} // namespace palpate
