#pragma once

#include "InstructionSets.h"
#include "RadialEvaluator.h"
#include "RandomShapes.h"

#include <cmath>
#include <vector>

namespace palpate::test
{
/// White coefficients of a degree, so that every term contributes; and directions everywhere, at
/// and near both poles.
struct EvaluatorCase
{
  explicit EvaluatorCase(int degree) : Degree(degree)
  {
    Random random(static_cast<unsigned>(500 + degree));
    this->Coefficients = RandomCoefficients(random, degree);
    this->Directions = RandomDirections(random, 53); // no multiple of two, four or eight
    for (const double z : {1.0, -1.0})
    {
      this->Directions.emplace_back(0.0, 0.0, z);
      for (const double off : {1e-2, 1e-4, 1e-8, 1e-15, 1e-160})
      {
        this->Directions.emplace_back(Vector3(off, -0.5 * off, z).normalized());
      }
    }
    this->Directions.emplace_back(1.0, 0.0, 0.0);
    this->Directions.emplace_back(0.0, -1.0, 0.0);
  }

  /// The largest radius that coefficients of this length can reach, by the addition theorem.
  double Scale() const
  {
    double squares = 0.0;
    for (const double c : this->Coefficients)
    {
      squares += c * c;
    }
    return std::sqrt(squares / (4.0 * M_PI)) * (this->Degree + 1);
  }
  /// The same for slopes and second derivatives, up to a factor of about 1.
  double GradientScale() const { return this->Scale() * std::sqrt(this->Eigenvalue() / 2.0); }
  double HessianScale() const { return this->Scale() * this->Eigenvalue(); }

  int Degree;
  std::vector<double> Coefficients;
  std::vector<Vector3> Directions;

private:
  // l (l + 1) of the highest degree; degree 0 is measured by its radius.
  double Eigenvalue() const
  {
    return this->Degree == 0 ? 1.0 : this->Degree * (this->Degree + 1.0);
  }
};

/// One configuration of the evaluator, for messages and loops.
struct EvaluatorKind
{
  EvaluationFormulation Formulation;
  InstructionSet Set;

  std::string Name() const
  {
    return std::string(NameOf(this->Set)) +
           (this->Formulation == EvaluationFormulation::Recurrence ? " recurrence" : "");
  }
};

inline std::vector<EvaluatorKind> AllEvaluatorKinds()
{
  std::vector<EvaluatorKind> kinds;
  for (const InstructionSet set : RunnableInstructionSets())
  {
    kinds.push_back({EvaluationFormulation::Automatic, set});
    kinds.push_back({EvaluationFormulation::Recurrence, set});
  }
  return kinds;
}
} // namespace palpate::test
