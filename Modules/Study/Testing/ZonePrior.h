#pragma once

#include "ShapePrior.h"
#include "SurfacePrior.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate::test
{
/// Small nearly round bodies 5 mm behind known balls of about 9 mm, as a prior. The balls are
/// called `name`.
inline SurfacePrior ZonePrior(const std::string& name)
{
  std::mt19937 random(64);
  std::normal_distribution<double> normal;
  std::vector<SurfacePrior::Case> cases;
  for (int n = 0; n < 24; ++n)
  {
    const double size = std::exp(0.1 * normal(random));
    LogSurface known{Eigen::VectorXd::Zero(169), Vector3(3.0 * n, -2.0, 4.0)};
    known.Coefficients[0] = std::log(9.0 * size) / ShapePrior::ConstantHarmonic;
    for (Eigen::Index k = 1; k < OrganRelation::ScoreCount; ++k)
    {
      known.Coefficients[k] = 0.02 * normal(random);
    }
    std::vector<double> radii(9, 0.0);
    radii[0] = 4.0 * size / ShapePrior::ConstantHarmonic;
    for (std::size_t k = 4; k < radii.size(); ++k)
    {
      radii[k] = 0.4 * normal(random);
    }
    const RadialModel body(2, radii, Vector3::Zero());
    const Vector3 behind(0.3 * normal(random), 5.0 * size + 0.3 * normal(random), 0.0);
    cases.push_back({SurfaceModel::FromModel(body), known.CenterWorld + behind, known});
  }
  SurfacePrior prior;
  EXPECT_TRUE(SurfacePrior::OfGroup(cases, prior).IsOk());
  prior.Relation->Name = name;
  return prior;
}
} // namespace palpate::test
