#pragma once

#include "CoarseHarmonicModel.h"
#include "ContactCases.h"
#include "OnDemandDegrees.h"
#include "OnDemandHarmonicModel.h"
#include "ServoRun.h"

#include <memory>
#include <vector>

namespace palpate::test
{
/// Rough organs on a lattice, each within reach of some of the others, whole and on demand.
class HarmonicCrowd
{
public:
  static constexpr double Tick = 0.001; // s
  static constexpr double Apart = 50.0; // mm

  /// `part` of all of them may be at hand at once.
  HarmonicCrowd(const OnDemandHarmonics::Settings& settings, double part,
                const SurfaceFriction& friction = {}, std::uint64_t seed = 6300)
  {
    Random random(seed);
    std::size_t all = 0;
    std::size_t largest = 0;
    for (int n = 0; n < 8; ++n)
    {
      const Vector3 corner(n & 1, n >> 1 & 1, n >> 2 & 1);
      const SphericalHarmonicModel organ = RandomOrgan(random, 12);
      const auto model = Shared(SphericalHarmonicModel(
          organ.Degree(), organ.Coefficients(),
          Apart * corner - Vector3::Constant(0.5 * Apart) + RandomDirection(random)));
      this->Models.push_back(model);
      std::shared_ptr<OnDemandHarmonics> harmonics;
      const Status made = OnDemandHarmonics::Make(model, settings, harmonics);
      EXPECT_TRUE(made.IsOk()) << made.Message();
      all += harmonics->BytesAtHand();
      largest = std::max(largest, harmonics->BytesAtHand());
      this->Structures.push_back(harmonics);
      this->Whole.Structures.push_back(this->StructureOf(model, settings, friction));
      this->OnDemand.Structures.push_back(this->StructureOf(harmonics, friction));
    }
    this->Whole.Tool = this->OnDemand.Tool = settings.Tool;
    this->OnDemand.Probe = this->Probe;
    OnDemandDegrees::Settings degrees;
    degrees.ToolRadius = settings.Tool.BoundingRadius();
    degrees.Room = std::max(largest, static_cast<std::size_t>(part * static_cast<double>(all)));
    this->Degrees = std::make_unique<OnDemandDegrees>(this->Structures, degrees);
  }

  /// As a thread does that looks every 5 ms, and is ready as fast as it may be slow.
  void Look(int tick, const Vector3& place)
  {
    if (tick % 5 == 0)
    {
      this->Degrees->Look({Tick * tick, place}, [tick] { return Tick * tick + 0.01; });
    }
  }

  std::vector<std::shared_ptr<const SphericalHarmonicModel>> Models;
  std::vector<std::shared_ptr<OnDemandHarmonics>> Structures;
  std::shared_ptr<LatestValue<PlainVector3>> Probe = std::make_shared<LatestValue<PlainVector3>>();
  TouchScene Whole;
  TouchScene OnDemand;
  std::unique_ptr<OnDemandDegrees> Degrees;

private:
  static constexpr ContactLaw Law{0.3, 0.001};

  static TouchStructure StructureOf(const std::shared_ptr<const SphericalHarmonicModel>& model,
                                    const OnDemandHarmonics::Settings& settings,
                                    const SurfaceFriction& friction)
  {
    TouchStructure structure{"organ", HarmonicContact(*model, settings.Mode, settings.Precision),
                             Law, friction};
    for (const int degree : settings.StandIns)
    {
      structure.Coarser.push_back(
          {HarmonicContact(model->WithDegree(degree), settings.Mode, settings.Precision), {}, ""});
    }
    return structure;
  }
  static TouchStructure StructureOf(const std::shared_ptr<OnDemandHarmonics>& harmonics,
                                    const SurfaceFriction& friction)
  {
    TouchStructure structure{"organ", std::make_shared<OnDemandHarmonicModel>(harmonics, 0), Law,
                             friction};
    for (std::size_t rung = 1; rung < harmonics->RungCount(); ++rung)
    {
      structure.Coarser.push_back(
          {std::make_shared<OnDemandHarmonicModel>(harmonics, rung), {}, ""});
    }
    structure.Beneath = std::make_shared<CoarseHarmonicModel>(harmonics);
    return structure;
  }
};

/// From far above a crowd, at one speed (mm/s) straight to places among it, one after the other.
class CrowdHand
{
public:
  CrowdHand(double speed, std::uint64_t seed) : Step(speed * HarmonicCrowd::Tick), Turn(seed) {}
  const Vector3& Next()
  {
    if ((this->Aim - this->Place).norm() <= this->Step)
    {
      this->Aim = 60.0 * RandomDirection(this->Turn);
    }
    this->Place += this->Step * (this->Aim - this->Place).normalized();
    return this->Place;
  }
  const Vector3& Here() const { return this->Place; }

private:
  double Step;
  Random Turn;
  Vector3 Place{0.0, 0.0, 120.0};
  Vector3 Aim = Vector3::Zero();
};
} // namespace palpate::test
