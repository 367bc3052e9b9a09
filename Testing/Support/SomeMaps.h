#pragma once

#include "ComplianceMaps.h"
#include "LayeredSphere.h"
#include "SphericalHarmonicBasis.h"

#include <array>
#include <cmath>

namespace palpate::test
{
/// Maps of a sphere of 20 mm on a bed, in closed form, made a tenth softer towards +x so that they
/// have slopes. Without finite elements, hence quickly.
inline ComplianceMaps SomeMaps(int degree = 2)
{
  constexpr double SphereRadius = 20.0; // mm
  const LayeredSphere sphere({{SphereRadius, 0.02}}, 0.49, 1e-3);
  const double root = std::sqrt(4.0 * 3.14159265358979323846);
  ComplianceMaps maps;
  maps.Degree = degree;
  maps.LargestPatch = ComplianceMaps::DefaultPatch * SphereRadius;
  maps.PoissonRatio = 0.49;
  std::array<double, PatchCompliance::Terms> values = PatchCompliance::Nodes(maps.LargestPatch);
  for (double& value : values)
  {
    value *= sphere.Compliance(value);
  }
  const std::array<double, PatchCompliance::Terms> terms = PatchCompliance::Interpolate(values);
  const std::size_t count = SphericalHarmonicBasis::CoefficientCount(degree);
  for (std::size_t term = 0; term < PatchCompliance::Terms; ++term)
  {
    maps.Coefficients[term].assign(count, 0.0);
    maps.Coefficients[term][0] = root * terms[term];
    maps.Coefficients[term][3] = 0.1 / std::sqrt(3.0) * root * terms[term];
  }
  maps.Coefficients.back().assign(count, 0.0);
  maps.Coefficients.back()[0] = root / SphereRadius;
  maps.FitError = {0.01, 0.05, Vector3::UnitX(), 0.4 * maps.LargestPatch};
  return maps;
}

/// The sphere of those maps, around a place.
inline RadialModel SomeElasticModel()
{
  return {0, {20.0 * std::sqrt(4.0 * 3.14159265358979323846)}, Vector3(1.0, 2.0, 3.0)};
}
} // namespace palpate::test
