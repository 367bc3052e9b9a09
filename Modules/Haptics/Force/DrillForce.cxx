#include "DrillForce.h"

#include "Units.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double MetersOfMillimeters = 1e-3;

Vector3 Drag(const DrillLaw& law, double push, const Vector3& along) noexcept
{
  const double speed = along.norm();
  const double size = std::min(law.Drag * push * speed, push);
  return speed > 0.0 ? Vector3(-size / speed * along) : Vector3::Zero();
}

// Within -1 and 1.
double Swing(double frequency, double time) noexcept
{
  const double turns = frequency * time;
  return std::sin(2.0 * Pi * (turns - std::floor(turns)));
}
} // namespace

double FeedRate(const DrillLaw& law, const DrillMotion& motion, double push) noexcept
{
  const double rubbing = 2.0 * Pi * motion.Radius * motion.Turns * MetersOfMillimeters; // m/s
  return law.Wear * rubbing * std::max(push, 0.0);
}

Vector3 DrillForce(const DrillLaw& law, const DrillMotion& motion, double push,
                   const Vector3& normal, const Vector3& velocity, double recession,
                   double time) noexcept
{
  const double feed = FeedRate(law, motion, push);
  if (!(feed > 0.0))
  {
    return Vector3::Zero();
  }
  const double removing = std::clamp(recession / feed, 0.0, 1.0);
  const double swing = law.Vibration * push * removing * Swing(motion.VibrationFrequency, time);
  return Drag(law, push, velocity - velocity.dot(normal) * normal) + swing * normal;
}
} // namespace palpate
