#include "HandSkill.h"

#include "InputError.h"

#include <cmath>

namespace palpate
{
namespace
{
// From 0.049 mm held still to 0.133 mm actuating (Riviere 1997), if that takes a newton.
constexpr double MoreTremor = 0.084; // mm/N
constexpr double PersonDeviation = 0.2;
} // namespace

HandSkill HandSkill::Novice()
{
  HandSkill skill;
  skill.Tremor = Vector3(0.144, 0.258, 0.285); // pointing, PMC3989364
  skill.TremorPerNewton = MoreTremor;
  skill.MovementDeviation = 0.04;
  skill.AimDeviation = 1.0;
  skill.SightDepthDeviation = 2.0;
  skill.PressDeviation = 0.2;
  skill.DriftDeviation = 0.8;
  skill.SeenErrorDeviation = 0.6;
  skill.PullDeviation = 1.0;
  skill.SeenTurnDeviation = 3.0;
  skill.PerceptDeviation = 1.0;
  skill.Speed = 40.0;
  skill.FollowingSpeed = 15.0;
  skill.TouchDelay = 0.20;
  skill.SightDelay = 0.35;
  skill.Sweeps = 1;
  skill.Returns = 4;
  return skill;
}

HandSkill HandSkill::Expert()
{
  HandSkill skill;
  skill.Tremor = Vector3::Constant(0.049); // eye surgeons, held still, Riviere 1997
  skill.TremorPerNewton = MoreTremor;
  skill.MovementDeviation = 0.02;
  skill.AimDeviation = 0.5;
  skill.SightDepthDeviation = 1.0;
  skill.PressDeviation = 0.1;
  skill.DriftDeviation = 0.4;
  skill.SeenErrorDeviation = 0.3;
  skill.PullDeviation = 0.5;
  skill.SeenTurnDeviation = 1.5;
  skill.PerceptDeviation = 1.0;
  return skill;
}

const std::vector<std::string>& HandSkill::Levels()
{
  static const std::vector<std::string> levels{"novice", "expert"};
  return levels;
}

HandSkill HandSkill::OfLevel(const std::string& level)
{
  if (level == Levels()[0])
  {
    return Novice();
  }
  if (level == Levels()[1])
  {
    return Expert();
  }
  throw InputError("a simulated hand is a novice or an expert, not " + level + "; choose one.");
}

HandSkill HandSkill::OnePerson(std::mt19937_64& random) const
{
  std::normal_distribution<double> normal(0.0, PersonDeviation);
  const double factor = std::exp(normal(random));
  HandSkill person = *this;
  person.Tremor *= factor;
  for (double HandSkill::*error :
       {&HandSkill::TremorPerNewton, &HandSkill::MovementDeviation, &HandSkill::AimDeviation,
        &HandSkill::SightDepthDeviation, &HandSkill::PressDeviation, &HandSkill::DriftDeviation,
        &HandSkill::SeenErrorDeviation, &HandSkill::PullDeviation, &HandSkill::SeenTurnDeviation,
        &HandSkill::PerceptDeviation})
  {
    person.*error *= factor;
  }
  return person;
}
} // namespace palpate
