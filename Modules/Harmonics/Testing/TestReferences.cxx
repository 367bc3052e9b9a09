#include "IcosahedronDirections.h"
#include "InstructionSets.h"
#include "RadialEvaluator.h"
#include "RadialModel.h"
#include "SphericalHarmonicBasis.h"
#include "SphericalHarmonicReferences.h"
#include "WorstCase.h"

#include <functional>
#include <gtest/gtest.h>
#include <numeric>
#include <optional>

namespace palpate::references_test
{
namespace
{
using test::NameOf;
using test::ReferenceKind;
using test::RunnableInstructionSets;
using test::SphericalHarmonicReference;
using Sample = RadialModel::Sample;
using Evaluation = std::function<Sample(const Vector3&)>;

// Largest errors, in units of ReferenceScale.
struct Errors
{
  test::WorstCase Radius;
  test::WorstCase Gradient;
  int Count = 0;
};

Vector3 Direction(const SphericalHarmonicReference& reference)
{
  return {reference.Direction[0], reference.Direction[1], reference.Direction[2]};
}

// Compares with every reference of a degree and kind; `make` returns the function for given
// coefficients.
Errors Compare(int degree, ReferenceKind kind,
               const std::function<Evaluation(const std::vector<double>&)>& make)
{
  Errors errors;
  std::optional<std::uint64_t> seed;
  std::vector<double> coefficients;
  Evaluation evaluate;
  for (const SphericalHarmonicReference& reference : test::SphericalHarmonicReferences)
  {
    if (reference.Degree != degree || reference.Kind != kind)
    {
      continue;
    }
    if (seed != reference.Seed)
    {
      seed = reference.Seed;
      coefficients = test::ReferenceCoefficients(degree, reference.Seed);
      evaluate = make(coefficients);
    }
    const test::ReferenceScale scale(degree, coefficients);
    const Sample sample = evaluate(Direction(reference));
    const Vector3 gradient(reference.Gradient[0], reference.Gradient[1], reference.Gradient[2]);
    errors.Radius.Add((sample.Radius - reference.Radius) / scale.Radius);
    errors.Gradient.Add((sample.SurfaceGradient - gradient).norm() / scale.Gradient);
    ++errors.Count;
  }
  return errors;
}

auto ByModel(int degree, RadialModel::Formulation formulation)
{
  return [=](const std::vector<double>& coefficients) -> Evaluation
  {
    const RadialModel model(degree, coefficients, Vector3::Zero(), formulation);
    return [model](const Vector3& direction) { return model.Evaluate(direction); };
  };
}

// Radius-only evaluation uses other kernels.
auto ByRadius(int degree, RadialModel::Formulation formulation)
{
  return [=](const std::vector<double>& coefficients) -> Evaluation
  {
    const RadialModel model(degree, coefficients, Vector3::Zero(), formulation);
    return [model](const Vector3& direction) {
      return Sample{model.Radius(direction), model.Evaluate(direction).SurfaceGradient};
    };
  };
}

auto ByInstructions(int degree, InstructionSet set)
{
  return [=](const std::vector<double>& coefficients) -> Evaluation
  {
    const RadialEvaluator evaluator(degree, coefficients, EvaluationFormulation::Automatic, set);
    return [evaluator](const Vector3& direction) { return evaluator.Evaluate(direction); };
  };
}

// As a full group of lanes, together with other directions.
auto ByBatch(int degree)
{
  return [degree](const std::vector<double>& coefficients) -> Evaluation
  {
    const RadialModel model(degree, coefficients, Vector3::Zero());
    return [model](const Vector3& direction)
    {
      std::vector<Vector3> directions = IcosahedronDirections(1).Directions();
      directions[5] = direction;
      std::vector<Sample> samples(directions.size());
      model.EvaluateBatch(directions.data(), directions.size(), samples.data());
      return samples[5];
    };
  };
}

const std::initializer_list<ReferenceKind> UnitKinds = {ReferenceKind::General, ReferenceKind::Pole,
                                                        ReferenceKind::NearPole};

const char* Name(ReferenceKind kind)
{
  switch (kind)
  {
  case ReferenceKind::General:
    return "general";
  case ReferenceKind::Pole:
    return "pole";
  case ReferenceKind::NearPole:
    return "near a pole";
  case ReferenceKind::Float:
    return "float";
  }
  return "";
}

// The bounds are Palpate's documented accuracy, not fitted to measurements.
constexpr double LowDegreeBound = 1e-14;
constexpr double HighDegreeBound = 1e-12;

void ExpectWithin(double bound, const Errors& errors, int degree, ReferenceKind kind)
{
  EXPECT_GT(errors.Count, 0) << "no reference of degree " << degree << ", " << Name(kind);
  EXPECT_LE(errors.Radius.Value(), bound) << "degree " << degree << ", " << Name(kind);
  EXPECT_LE(errors.Gradient.Value(), bound) << "degree " << degree << ", " << Name(kind);
}

// Radii, with and without gradients, in all places.
void ExpectTrue(double bound, int degree, RadialModel::Formulation formulation)
{
  for (const ReferenceKind kind : UnitKinds)
  {
    if (degree > 0 || kind != ReferenceKind::NearPole)
    {
      ExpectWithin(bound, Compare(degree, kind, ByModel(degree, formulation)), degree, kind);
      ExpectWithin(bound, Compare(degree, kind, ByRadius(degree, formulation)), degree, kind);
    }
  }
}

void ExpectTrueUpToDegree16(RadialModel::Formulation formulation)
{
  for (const int degree : {0, 1, 2, 12, 16})
  {
    ExpectTrue(LowDegreeBound, degree, formulation);
  }
}

TEST(References, PolynomialsHave14DigitsUpToDegree16)
{
  ExpectTrueUpToDegree16(RadialModel::Formulation::Automatic);
}

TEST(References, AllKernelsHave14DigitsAtDegree12)
{
  for (const ReferenceKind kind : UnitKinds)
  {
    for (const InstructionSet set : RunnableInstructionSets())
    {
      SCOPED_TRACE(NameOf(set));
      ExpectWithin(LowDegreeBound, Compare(12, kind, ByInstructions(12, set)), 12, kind);
    }
    ExpectWithin(LowDegreeBound, Compare(12, kind, ByBatch(12)), 12, kind);
  }
}

TEST(References, RecurrenceHas14DigitsUpToDegree16)
{
  ExpectTrueUpToDegree16(RadialModel::Formulation::Recurrence);
}

TEST(References, RecurrenceHas12DigitsUpToDegree1000)
{
  for (const int degree : {40, 100, 300, 1000})
  {
    ExpectTrue(HighDegreeBound, degree, RadialModel::Formulation::Automatic);
  }
}

TEST(References, BasisHas14DigitsAnd12AtDegree1000)
{
  for (const int degree : {0, 1, 2, 12, 16, 40, 100, 300, 1000})
  {
    const SphericalHarmonicBasis basis(degree);
    const auto byBasis = [&basis](const std::vector<double>& coefficients) -> Evaluation
    {
      return [&basis, coefficients](const Vector3& direction)
      {
        std::vector<double> values(basis.Size());
        basis.Evaluate(direction, values.data());
        // In long double, so that the rounding of this sum does not count.
        const long double sum =
            std::inner_product(values.begin(), values.end(), coefficients.begin(), 0.0L);
        return Sample{static_cast<double>(sum), Vector3::Zero()};
      };
    };
    for (const ReferenceKind kind : UnitKinds)
    {
      const Errors errors = Compare(degree, kind, byBasis);
      EXPECT_LE(errors.Radius.Value(), degree <= 16 ? LowDegreeBound : HighDegreeBound)
          << "degree " << degree << ", " << Name(kind);
    }
  }
}

TEST(References, AcceptsRoundedDirections)
{
  const auto normalised = [](const std::vector<double>& coefficients) -> Evaluation
  {
    const RadialModel model(12, coefficients, Vector3::Zero());
    return [model](const Vector3& direction) { return model.Evaluate(direction.normalized()); };
  };
  ExpectWithin(LowDegreeBound, Compare(12, ReferenceKind::Float, normalised), 12,
               ReferenceKind::Float);
}

TEST(References, HessiansHave14DigitsUpToDegree16And11UpToDegree1000)
{
  std::optional<RadialModel> model;
  std::optional<std::uint64_t> seed;
  for (const SphericalHarmonicReference& reference : test::SphericalHarmonicReferences)
  {
    const int degree = reference.Degree;
    if (!model || degree != model->Degree() || seed != reference.Seed)
    {
      seed = reference.Seed;
      model.emplace(degree, test::ReferenceCoefficients(degree, *seed), Vector3::Zero());
    }
    const Matrix3 found = model->EvaluateSecondOrder(Direction(reference)).SurfaceHessian;
    const auto& [xx, xy, xz, yy, yz, zz] = reference.Hessian;
    Matrix3 exact;
    exact << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    const double bound = degree <= 16 ? LowDegreeBound : 10.0 * HighDegreeBound;
    EXPECT_LE((found - exact).norm(),
              bound * test::ReferenceScale(degree, model->Coefficients()).Hessian)
        << "degree " << degree << ", " << Name(reference.Kind);
  }
}

TEST(References, TabulatedHessiansAreTangent)
{
  for (const SphericalHarmonicReference& reference : test::SphericalHarmonicReferences)
  {
    const std::array<double, 6>& h = reference.Hessian;
    Eigen::Matrix3d hessian;
    hessian << h[0], h[1], h[2], h[1], h[3], h[4], h[2], h[4], h[5];
    const std::vector<double> c = test::ReferenceCoefficients(reference.Degree, reference.Seed);
    const double scale = test::ReferenceScale(reference.Degree, c).Hessian;
    const Vector3 u = Direction(reference).normalized();
    // The normal direction and the table's numbers are rounded once each.
    EXPECT_LE((hessian * u).norm(), 4e-16 * scale);
  }
}
} // namespace
} // namespace palpate::references_test
