#pragma once

#include "ClosestPointSearch.h"
#include "ComplianceAtlas.h"
#include "ElasticForce.h"
#include "OrganSoftening.h"

#include <optional>

namespace palpate::test
{
/// How finely an organ is computed; enough for a bumpy organ in a tenth of a second.
struct CoarseNumbers
{
  int ElementsAcross = 6;
  int Degree = 6;
  int MapDegree = 8;
};

/// An organ that yields, made as `palpate soften` makes it, and the force on a ball in it.
class ElasticOrgan
{
public:
  /// Throws std::runtime_error if it cannot be made, or would not be read from a file.
  ElasticOrgan(const RadialModel& model, const ElasticSolid& solid,
               const CoarseNumbers& numbers = {});

  const RadialModel& Model() const { return this->Search.Model(); }
  const ComplianceMaps& Maps() const { return this->Values; }

  /// mm/N, under a Hertz bump (mm).
  double Compliance(const Vector3& direction, double patchRadius) const;
  /// Where a ball's centre is that has been pressed in by `depth`.
  Vector3 CenterAbove(const Vector3& direction, double ballRadius, double depth) const;
  /// On a ball whose centre is at a place, from the nearest point.
  ElasticForce ForceAt(const Vector3& centerWorld, double ballRadius) const;
  /// On a ball at a depth below the place in a direction.
  ElasticForce Press(const Vector3& direction, double ballRadius, double depth) const;

private:
  ClosestPointSearch Search;
  ComplianceMaps Values;
  std::optional<ComplianceAtlas> Atlas;
};
} // namespace palpate::test
