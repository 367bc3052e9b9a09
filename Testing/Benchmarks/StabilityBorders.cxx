#include "StabilityBorders.h"

#include "BareTrial.h"
#include "ManualClock.h"
#include "PressableScenes.h"
#include "StabilityProbe.h"
#include "StiffnessAdvice.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace palpate::bench
{
namespace
{
struct Hand
{
  const char* Name;
  HandProperties Properties;
};

// Mass kg, stiffness N/mm, damping N s/mm.
const std::vector<Hand>& Hands()
{
  static const std::vector<Hand> hands{{"soft", {0.1, 0.1, 0.002, 0.0, 0.0}},
                                       {"usual", {0.25, 0.5, 0.005, 0.0, 0.0}},
                                       {"firm", {0.5, 2.0, 0.02, 0.0, 0.0}}};
  return hands;
}

struct Setting
{
  std::string Sweep;
  Hand Pressing = Hands()[1];
  double Rate = 1000.0;
  double DelayTicks = 0.0;
  double MechanismDamping = 0.01;
  double DampingShare = 0.0; // of the structure, relative to the mechanism's
  double Friction = 0.0;
  double Count = 0.0;
};

std::vector<Setting> Settings()
{
  std::vector<Setting> settings;
  for (const double rate : {500.0, 1000.0, 4000.0})
  {
    for (const double delay : {0.0, 1.0, 3.0})
    {
      for (const double mechanism : {0.002, 0.01})
      {
        for (const double share : {0.0, 0.5})
        {
          settings.push_back({"sampling", Hands()[1], rate, delay, mechanism, share, 0.0, 0.0});
        }
      }
    }
  }
  for (const double count : {0.01, 0.02, 0.045, 0.09})
  {
    for (const double friction : {0.05, 0.2})
    {
      settings.push_back({"counts", Hands()[1], 1000.0, 0.0, 0.02, 0.0, friction, count});
    }
  }
  for (const Hand& hand : Hands())
  {
    settings.push_back({"hands", hand, 1000.0, 0.0, 0.002, 0.0, 0.2, 0.045});
  }
  return settings;
}

// Without help from the safety chain.
StabilityTrial BareTrial(const Setting& setting, const Vector3& outward)
{
  StabilityTrial trial = test::BareTrial(outward, setting.Rate);
  trial.Device.Hand = setting.Pressing.Properties;
  trial.Device.Hand.Damping = setting.MechanismDamping;
  trial.Device.Hand.Friction = setting.Friction;
  trial.Device.Resolution = setting.Count;
  trial.Device.Delay = setting.DelayTicks / setting.Rate;
  return trial;
}

StabilityTrial SafeTrial(StabilityTrial trial)
{
  const SimulatedSettings device;
  const ServoSettings loop;
  trial.Device.MaximumForce = device.MaximumForce;
  trial.Device.MaximumDamping = device.MaximumDamping;
  trial.Loop.RampDuration = loop.RampDuration;
  trial.Loop.MaximumSlew = loop.MaximumSlew;
  return trial;
}

double Border(const TouchScene& scene, const StabilityTrial& trial, double claimed,
              bool (StabilityObservation::*isUnstable)() const noexcept)
{
  double border = 0.0;
  const Status status = FindStableBorder(
      scene, trial, claimed,
      [isUnstable](const StabilityObservation& seen) { return !(seen.*isUnstable)(); }, border);
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
  return border;
}

StabilityBorder Measure(const Setting& setting, test::PressableScene pressed)
{
  const double damping = setting.DampingShare * setting.MechanismDamping;
  pressed.Scene.Structures.front().Law.Damping = damping;
  const StabilityTrial trial = BareTrial(setting, pressed.Outward);
  ManualClock clock;
  const double claimed =
      StiffestStable(SimulatedDevice(clock, trial.Device).Capabilities(), setting.Rate, damping)
          .Largest;
  const bool isHand = setting.Sweep == "hands";
  return {setting.Sweep,
          pressed.Kind,
          setting.Pressing.Name,
          setting.Rate,
          trial.Device.Delay,
          setting.MechanismDamping,
          damping,
          setting.Friction,
          setting.Count,
          claimed,
          Border(pressed.Scene, trial, claimed, &StabilityObservation::GaveOutEnergy),
          Border(pressed.Scene, trial, claimed, &StabilityObservation::Vibrated),
          isHand ? Border(pressed.Scene, SafeTrial(trial), claimed, &StabilityObservation::Vibrated)
                 : 0.0};
}
} // namespace

std::vector<StabilityBorder> MeasureStability(const std::function<void(int, int)>& report)
{
  test::Random random(72);
  const std::vector<test::PressableScene> scenes = test::MakePressableScenes(random);
  const std::vector<Setting> settings = Settings();
  const auto count = static_cast<int>(scenes.size() * settings.size());
  std::vector<StabilityBorder> borders;
  for (const Setting& setting : settings)
  {
    for (const test::PressableScene& scene : scenes)
    {
      borders.push_back(Measure(setting, scene));
      report(static_cast<int>(borders.size()), count);
    }
  }
  return borders;
}

std::string ToJson(const std::vector<StabilityBorder>& borders)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const StabilityBorder& b : borders)
  {
    list.push_back({{"sweep", b.Sweep},
                    {"kind", b.Kind},
                    {"hand", b.Hand},
                    {"rate_hz", b.Rate},
                    {"delay_s", b.Delay},
                    {"mechanism_damping_ns_per_mm", b.MechanismDamping},
                    {"damping_ns_per_mm", b.Damping},
                    {"friction_n", b.Friction},
                    {"count_mm", b.Count},
                    {"claimed_n_per_mm", b.Claimed},
                    {"energy_n_per_mm", b.WithoutEnergy},
                    {"vibration_n_per_mm", b.WithoutVibration},
                    {"safety_n_per_mm", b.WithSafety}});
  }
  return list.dump(2);
}
} // namespace palpate::bench
