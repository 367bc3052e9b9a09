#include "EvaluationBenchmarks.h"

#include "EvaluationAlternatives.h"
#include "EvaluationRuns.h"
#include "RandomShapes.h"
#include "SphericalHarmonicModel.h"

#include <memory>

namespace palpate::bench
{
namespace
{
using Doubles = SphericalHarmonicEvaluator<double>;
using Floats = SphericalHarmonicEvaluator<float>;

// Latitudes and longitudes of libsharp's grid; it has no pole, where GSL stops the program.
constexpr int Latitudes = 46;
constexpr int Longitudes = 87;

SphericalHarmonicModel MakeModel(int degree)
{
  test::Random random(static_cast<unsigned>(degree));
  return test::RandomOrgan(random, degree);
}

Doubles MakeEvaluator(const SphericalHarmonicModel& model, EvaluationFormulation formulation,
                      InstructionSet set = FastestInstructionSet())
{
  return {model.Degree(), model.Coefficients(), formulation, set};
}

// One degree: a model, everything that evaluates it, and the points of the grid in random order.
struct Subject
{
  explicit Subject(int degree)
      : Model(MakeModel(degree)), Fast(MakeEvaluator(Model, EvaluationFormulation::Automatic)),
        Portable(MakeEvaluator(Model, EvaluationFormulation::Automatic, InstructionSet::Portable)),
        Recurrence(MakeEvaluator(Model, EvaluationFormulation::Recurrence)),
        Float(degree, Model.Coefficients()), OfGsl(Model), OfStandard(Model),
        OfSharp(Model, Latitudes, Longitudes), Shuffled(OfSharp.Directions())
  {
    test::Random random(13);
    std::shuffle(this->Shuffled.begin(), this->Shuffled.end(), random);
    for (const Vector3& u : this->Shuffled)
    {
      this->ShuffledFloats.push_back(u.cast<float>());
    }
  }
  const std::vector<Vector3>& Directions(double) const { return this->Shuffled; }
  const std::vector<Eigen::Vector3f>& Directions(float) const { return this->ShuffledFloats; }

  SphericalHarmonicModel Model;
  Doubles Fast;
  Doubles Portable;
  Doubles Recurrence;
  Floats Float;
  GslEvaluator OfGsl;
  StandardEvaluator OfStandard;
  SharpGrid OfSharp;
  std::vector<Vector3> Shuffled;
  std::vector<Eigen::Vector3f> ShuffledFloats;
};

using SubjectPointer = std::shared_ptr<Subject>;

// Radii of 20 mm and slopes of a few: rounding, and in float its own.
constexpr double Tolerance = 1e-10;
constexpr double FloatTolerance = 1e-2;

// `ours` and `theirs` fill a vector of results each, of these types.
template <typename OurResult, typename TheirResult, typename Ours, typename Theirs>
PairedBenchmark Pair(const std::string& name, const std::string& against,
                     const SubjectPointer& subject, const Ours& ours, const Theirs& theirs,
                     double tolerance = Tolerance)
{
  const std::size_t count = subject->Shuffled.size();
  const auto our = std::make_shared<std::vector<OurResult>>(count);
  const auto their = std::make_shared<std::vector<TheirResult>>(count);
  return {name,
          against,
          [=] { ours(*subject, *our); },
          [=] { theirs(*subject, *their); },
          [=] { return Disagreement(*our, *their, tolerance); },
          static_cast<double>(count)};
}

// Makes of one call a run over all points in random order.
template <typename Real = double, typename Call>
auto Independently(const Call& call)
{
  return [call](Subject& s, auto& results)
  { RunIndependent(s.Directions(Real()), results, [&](const auto& u) { return call(s, u); }); };
}
template <typename Real = double, typename Call>
auto Chained(const Call& call)
{
  return [call](Subject& s, auto& results)
  { RunChained(s.Directions(Real()), results, [&](const auto& u) { return call(s, u); }); };
}

// The calls, by the evaluators of Subject.
template <auto Evaluator>
const auto Radius = [](Subject& s, const auto& u) { return (s.*Evaluator).Radius(u); };
template <auto Evaluator>
const auto Gradient = [](Subject& s, const auto& u) { return (s.*Evaluator).Evaluate(u); };
template <auto Evaluator>
const auto Hessian = [](Subject& s, const auto& u)
{ return (s.*Evaluator).EvaluateSecondOrder(u); };

template <auto Evaluator, typename Real = double>
const auto RadiusBatch = [](Subject& s, auto& radii)
{
  const auto& directions = s.Directions(Real());
  (s.*Evaluator).RadiusBatch(directions.data(), directions.size(), radii.data());
};
template <auto Evaluator, typename Real = double>
const auto GradientBatch = [](Subject& s, auto& samples)
{
  const auto& directions = s.Directions(Real());
  (s.*Evaluator).EvaluateBatch(directions.data(), directions.size(), samples.data());
};
template <auto Evaluator, typename Real = double>
const auto HessianBatch = [](Subject& s, auto& samples)
{
  const auto& directions = s.Directions(Real());
  (s.*Evaluator).EvaluateSecondOrderBatch(directions.data(), directions.size(), samples.data());
};

using Sample = Doubles::Sample;
using SecondOrder = Doubles::SecondOrderSample;
constexpr auto Fast = &Subject::Fast;
constexpr auto Portable = &Subject::Portable;
constexpr auto Recurrence = &Subject::Recurrence;
constexpr auto Float = &Subject::Float;
constexpr auto OfGsl = &Subject::OfGsl;
constexpr auto OfStandard = &Subject::OfStandard;
const char* const Gsl = "GSL gsl_sf_legendre_array";
const char* const OurRecurrence = "our normalised recurrence";
const char* const OurDouble = "the same in double";

using Pairs = std::vector<PairedBenchmark>;

void AddValues(const SubjectPointer& s, Pairs& pairs)
{
  const std::string name = "sh/value/degree12/";
  pairs.push_back(Pair<double, double>(name + "chained", Gsl, s, Chained(Radius<Fast>),
                                       Chained(Radius<OfGsl>)));
  pairs.push_back(Pair<double, double>(name + "independent", Gsl, s, Independently(Radius<Fast>),
                                       Independently(Radius<OfGsl>)));
  pairs.push_back(Pair<double, double>(name + "independent/std", "std::sph_legendre", s,
                                       Independently(Radius<Fast>),
                                       Independently(Radius<OfStandard>)));
  pairs.push_back(Pair<double, double>(name + "batch", Gsl, s, RadiusBatch<Fast>,
                                       Independently(Radius<OfGsl>)));
}

void AddGradients(const SubjectPointer& s, Pairs& pairs)
{
  const std::string name = "sh/gradient/degree12/";
  pairs.push_back(Pair<Sample, Sample>(name + "chained", Gsl, s, Chained(Gradient<Fast>),
                                       Chained(Gradient<OfGsl>)));
  pairs.push_back(Pair<Sample, Sample>(name + "independent", Gsl, s, Independently(Gradient<Fast>),
                                       Independently(Gradient<OfGsl>)));
  pairs.push_back(Pair<Sample, Sample>(name + "independent/std", "std::sph_legendre", s,
                                       Independently(Gradient<Fast>),
                                       Independently(Gradient<OfStandard>)));
  pairs.push_back(Pair<Sample, Sample>(name + "independent/recurrence", OurRecurrence, s,
                                       Independently(Gradient<Fast>),
                                       Independently(Gradient<Recurrence>)));
  pairs.push_back(Pair<Sample, Sample>(name + "batch", Gsl, s, GradientBatch<Fast>,
                                       Independently(Gradient<OfGsl>)));
  pairs.push_back(Pair<Sample, Sample>(name + "portable", Gsl, s, Independently(Gradient<Portable>),
                                       Independently(Gradient<OfGsl>)));
}

void AddHessians(const SubjectPointer& s, Pairs& pairs)
{
  const std::string name = "sh/hessian/degree12/";
  pairs.push_back(Pair<SecondOrder, SecondOrder>(
      name + "chained", OurRecurrence, s, Chained(Hessian<Fast>), Chained(Hessian<Recurrence>)));
  pairs.push_back(Pair<SecondOrder, SecondOrder>(name + "independent", OurRecurrence, s,
                                                 Independently(Hessian<Fast>),
                                                 Independently(Hessian<Recurrence>)));
  pairs.push_back(Pair<SecondOrder, SecondOrder>(name + "batch", OurRecurrence, s,
                                                 HessianBatch<Fast>, HessianBatch<Recurrence>));
}

void AddFloats(const SubjectPointer& s, Pairs& pairs)
{
  using FloatSample = Floats::Sample;
  using FloatSecondOrder = Floats::SecondOrderSample;
  const std::string name = "sh/float/";
  pairs.push_back(Pair<float, double>(name + "value/degree12/batch", OurDouble, s,
                                      RadiusBatch<Float, float>, RadiusBatch<Fast>,
                                      FloatTolerance));
  pairs.push_back(Pair<FloatSample, Sample>(name + "gradient/degree12/chained", OurDouble, s,
                                            Chained<float>(Gradient<Float>),
                                            Chained(Gradient<Fast>), FloatTolerance));
  pairs.push_back(Pair<FloatSample, Sample>(name + "gradient/degree12/independent", OurDouble, s,
                                            Independently<float>(Gradient<Float>),
                                            Independently(Gradient<Fast>), FloatTolerance));
  pairs.push_back(Pair<FloatSample, Sample>(name + "gradient/degree12/batch", OurDouble, s,
                                            GradientBatch<Float, float>, GradientBatch<Fast>,
                                            FloatTolerance));
  pairs.push_back(Pair<FloatSecondOrder, SecondOrder>(name + "hessian/degree12/batch", OurDouble, s,
                                                      HessianBatch<Float, float>,
                                                      HessianBatch<Fast>, FloatTolerance));
}

// Against libsharp, which wants the points of its grid in its own order.
void AddGrid(const SubjectPointer& s, Pairs& pairs)
{
  const char* const sharp = "libsharp on a 46 x 87 Gauss grid";
  const std::size_t count = s->Shuffled.size();
  const auto radii = std::make_shared<std::vector<double>>(count);
  const auto samples = std::make_shared<std::vector<Sample>>(count);
  const auto points = [](const Subject& subject) { return subject.OfSharp.Directions().data(); };
  pairs.push_back({"sh/value/degree12/batch/libsharp", sharp,
                   [=] { s->Fast.RadiusBatch(points(*s), count, radii->data()); },
                   [=] { s->OfSharp.Synthesise(); },
                   [=] { return Disagreement(*radii, s->OfSharp.Radii(), Tolerance); },
                   static_cast<double>(count)});
  pairs.push_back({"sh/gradient/degree12/batch/libsharp", sharp,
                   [=] { s->Fast.EvaluateBatch(points(*s), count, samples->data()); },
                   [=] { s->OfSharp.SynthesiseWithSlopes(); },
                   [=]
                   {
                     std::vector<Sample> theirs;
                     for (std::size_t i = 0; i < count; ++i)
                     {
                       theirs.push_back(s->OfSharp.SampleAt(i));
                     }
                     return Disagreement(*samples, theirs, Tolerance);
                   },
                   static_cast<double>(count)});
}

// How the time grows with the degree.
void AddDegree(int degree, Pairs& pairs)
{
  const auto s = std::make_shared<Subject>(degree);
  const std::string of = "degree" + std::to_string(degree) + '/';
  pairs.push_back(Pair<double, double>("sh/value/" + of + "independent", Gsl, s,
                                       Independently(Radius<Fast>), Independently(Radius<OfGsl>)));
  pairs.push_back(Pair<Sample, Sample>("sh/gradient/" + of + "independent", Gsl, s,
                                       Independently(Gradient<Fast>),
                                       Independently(Gradient<OfGsl>)));
  pairs.push_back(Pair<Sample, Sample>("sh/gradient/" + of + "batch", Gsl, s, GradientBatch<Fast>,
                                       Independently(Gradient<OfGsl>)));
  pairs.push_back(Pair<Floats::Sample, Sample>("sh/float/gradient/" + of + "batch", OurDouble, s,
                                               GradientBatch<Float, float>, GradientBatch<Fast>,
                                               FloatTolerance));
}
} // namespace

std::vector<PairedBenchmark> EvaluationBenchmarks()
{
  const auto degree12 = std::make_shared<Subject>(12);
  Pairs pairs;
  AddValues(degree12, pairs);
  AddGradients(degree12, pairs);
  AddHessians(degree12, pairs);
  AddFloats(degree12, pairs);
  AddGrid(degree12, pairs);
  for (const int degree : {4, 8, 16, 20, 40, 64})
  {
    AddDegree(degree, pairs);
  }
  return pairs;
}
} // namespace palpate::bench
