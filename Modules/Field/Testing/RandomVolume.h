#pragma once

#include "FieldCases.h"
#include "RayOracle.h"

#include <memory>
#include <random>
#include <vector>

namespace palpate::test
{
/// A random volume with a field and the data for the oracle.
struct RandomVolume
{
  FieldGrid Grid;
  std::vector<double> Samples;
  double Iso;
  FieldInterpolation Method;
  std::shared_ptr<const ScalarField> Field;
  DenseReference Reference;

  static FieldGrid RandomGrid(std::mt19937_64& random)
  {
    return PlainGrid({2 + static_cast<int>(random() % 20), 2 + static_cast<int>(random() % 9),
                      2 + static_cast<int>(random() % 12)});
  }
  /// Steps with plateaus at the iso-value, noise, or a few bumps in empty space.
  static std::vector<double> RandomSamples(const FieldGrid& grid, std::mt19937_64& random)
  {
    const auto kind = random() % 3;
    std::vector<double> samples = RandomSteps(grid, random, kind == 1 ? 1000 : 3);
    for (double& sample : samples)
    {
      sample = kind == 2 && random() % 50 != 0 ? 0.0 : sample;
    }
    samples.front() = 0.0;
    samples.back() = kind == 1 ? 999.0 : 2.0;
    return samples;
  }

  RandomVolume(FieldInterpolation method, std::mt19937_64& random)
      : Grid(RandomGrid(random)), Samples(RandomSamples(Grid, random)),
        Iso(Samples.back() > 2.0 ? 499.5
            : random() % 2 == 0  ? 1.0
                                 : 0.5),
        Method(method), Field(MakeField(Grid, Samples, Iso, method)),
        Reference(Grid.Size(), Samples, method)
  {
  }
  RayOracle Oracle() const
  {
    // Coefficients are kept in float.
    const double tolerance =
        (this->Method == FieldInterpolation::Trilinear ? 1e-13 : 1e-5) * this->Samples.back();
    return {this->Grid.Size(), {{&this->Reference, this->Iso}}, this->Method, tolerance};
  }
};
} // namespace palpate::test
