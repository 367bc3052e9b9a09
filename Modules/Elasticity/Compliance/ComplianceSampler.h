#pragma once

#include "HertzPatch.h"
#include "HexElasticity.h"
#include "LocalCompliance.h"
#include "PatchCompliance.h"
#include "RadialModel.h"
#include "ReducedCompliance.h"

namespace palpate
{
/// The compliance of an organ to Hertz bumps, place by place: long waves by harmonics, the rest
/// locally. Queries allocate, and are for one thread.
class ComplianceSampler
{
public:
  /// Keeps the addresses, which must outlive it.
  ComplianceSampler(const RadialModel& model, const ElasticSolid& solid,
                    const ReducedCompliance& reduced);

  /// A patch of radius `radius` (mm) on the surface in a direction.
  HertzPatch PatchAt(const Vector3& direction, double radius) const noexcept;
  /// mm/N.
  double Compliance(const HertzPatch& patch) const;
  /// Of all patches up to a radius (mm) in a direction.
  PatchCompliance At(const Vector3& direction, double largestRadius) const;

private:
  const RadialModel* Model;
  const ReducedCompliance* Reduced;
  LocalCompliance Local;
};
} // namespace palpate
