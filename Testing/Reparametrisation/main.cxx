#include "CohortGroup.h"
#include "InputError.h"
#include "ReparametrisationStudy.h"
#include "ShapeModelQuality.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>

// Measures what moved parameters do to the model of a fitted cohort:
//   PalpateReparametrisation FOLDER [DEGREE [NOISE [FOLDS [CASES [RANDOM]]]]]
// Left-out cases take no part in the descent, and are compared as surfaces.
namespace palpate
{
namespace
{
std::vector<OrganModel> Reparametrised(const std::vector<OrganModel>& models,
                                       const ReparametrisationSettings& settings,
                                       ReparametrisationResult& result)
{
  std::vector<SurfaceModel> surfaces;
  for (const OrganModel& model : models)
  {
    surfaces.push_back(std::get<SurfaceModel>(model));
  }
  const Status status = ReparametriseGroup(surfaces, settings, result);
  if (!status.IsOk())
  {
    throw InputError(status.Message());
  }
  return {result.Surfaces.begin(), result.Surfaces.end()};
}

void PrintModel(const char* name, const std::vector<OrganModel>& models)
{
  const ShapeModes modes = ModesOf(models);
  const ShapeModelQuality quality = MeasureShapeModel(modes, {});
  double sum = 0.0;
  Eigen::Index needed = 0;
  while (needed < modes.Explained.size() && sum < 0.95)
  {
    sum += modes.Explained[needed++];
  }
  std::cout << name << ": variance " << modes.Deviations.squaredNorm() / (4.0 * M_PI)
            << " mm^2, modes for 95 % " << needed << "; at equal parameters: ";
  for (const Eigen::Index k : {5, 10, 20, 40})
  {
    const Eigen::Index at = std::min(k, modes.Deviations.size());
    std::cout << at << " modes " << quality.Generalisation.Values[at] << " / "
              << quality.Specificity.Values[at] << " mm; ";
  }
  std::cout << '\n';
}

void PrintCases(const ReparametrisationResult& result)
{
  double turn = 0.0;
  double change = 0.0;
  double worst = 0.0;
  double largest = 0.0;
  double area = 1.0;
  int moved = 0;
  for (const ReparametrisedCase& one : result.Cases)
  {
    moved += one.IsMoved ? 1 : 0;
    turn += one.RmsTurn;
    change += one.RmsChange;
    worst = std::max(worst, one.RmsChange);
    largest = std::max(largest, one.LargestChange);
    area = std::min(area, one.LeastAreaRatio);
  }
  const auto count = static_cast<double>(std::max(moved, 1));
  std::cout << "length " << result.LengthBefore << " -> " << result.Lengths.back() << " -> "
            << result.LengthAfter << " after " << result.Lengths.size() - 1 << " rounds; variance "
            << result.VarianceBefore << " -> " << result.VarianceAfter << " mm^2; moved " << moved
            << " of " << result.Cases.size() << ", turn " << 180.0 / M_PI * turn / count
            << " deg, least area ratio " << area << "; change mean RMS " << change / count
            << ", worst " << worst << ", largest " << largest << " mm\n";
}

void CrossValidate(const std::vector<OrganModel>& all, std::size_t folds, int random,
                   const ReparametrisationSettings& settings)
{
  const std::vector<Eigen::Index> counts{10, 20};
  std::vector<std::vector<double>> differences(counts.size());
  std::vector<double> own(counts.size());
  std::vector<double> moved(counts.size());
  std::vector<double> ownRandom(counts.size());
  std::vector<double> movedRandom(counts.size());
  for (std::size_t fold = 0; fold < folds; ++fold)
  {
    std::vector<OrganModel> training;
    std::vector<OrganModel> left;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      (i % folds == fold ? left : training).push_back(all[i]);
    }
    ReparametrisationResult result;
    const std::vector<OrganModel> better = Reparametrised(training, settings, result);
    const ShapeModes before = ModesOf(training);
    const ShapeModes after = ModesOf(better);
    for (std::size_t k = 0; k < counts.size(); ++k)
    {
      for (const OrganModel& one : left)
      {
        const double first = DistanceFromModel(before, counts[k], one);
        const double second = DistanceFromModel(after, counts[k], one);
        own[k] += first / static_cast<double>(all.size());
        moved[k] += second / static_cast<double>(all.size());
        differences[k].push_back(second - first);
      }
      ownRandom[k] += SpecificityOf(before, counts[k], training, random) / double(folds);
      movedRandom[k] += SpecificityOf(after, counts[k], better, random) / double(folds);
    }
  }
  for (std::size_t k = 0; k < counts.size(); ++k)
  {
    double squares = 0.0;
    const double mean = moved[k] - own[k];
    for (const double one : differences[k])
    {
      squares += (one - mean) * (one - mean);
    }
    const auto count = static_cast<double>(differences[k].size());
    std::cout << counts[k] << " modes, surfaces: generalisation " << own[k] << " -> " << moved[k]
              << " mm (difference " << mean << " +- "
              << std::sqrt(squares / (count * (count - 1.0))) << "), specificity " << ownRandom[k]
              << " -> " << movedRandom[k] << " mm\n";
  }
}

int Run(int count, char** arguments)
{
  const auto number = [&](int at, double otherwise)
  { return at < count ? std::atof(arguments[at]) : otherwise; };
  const std::string folder = arguments[1];
  ReparametrisationSettings settings;
  settings.FieldDegree = static_cast<int>(number(2, settings.FieldDegree));
  settings.NoiseMillimeters = number(3, settings.NoiseMillimeters);
  const auto folds = static_cast<std::size_t>(number(4, 0));
  const CohortGroup group = MakeCohortGroup(CohortTable::Read(folder + "/cohort.csv"), folder, "",
                                            AlignmentAxes::Patient);
  std::vector<OrganModel> models = group.Models;
  models.resize(std::min(models.size(), static_cast<std::size_t>(number(5, 1e9))), models.front());
  settings.ToleranceMillimeters = number(7, settings.ToleranceMillimeters);
  settings.Damping = number(8, settings.Damping);
  const auto start = std::chrono::steady_clock::now();
  ReparametrisationResult result;
  const std::vector<OrganModel> better = Reparametrised(models, settings, result);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  std::cout << std::unitbuf << models.size() << " cases, field degree " << settings.FieldDegree
            << ", noise " << settings.NoiseMillimeters << " mm: " << took.count() << " s\n";
  PrintCases(result);
  PrintModel("before", models);
  PrintModel("after", better);
  if (folds > 1)
  {
    CrossValidate(models, folds, static_cast<int>(number(6, 100)), settings);
  }
  return 0;
}
} // namespace
} // namespace palpate

int main(int count, char** arguments)
{
  try
  {
    return palpate::Run(count, arguments);
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
