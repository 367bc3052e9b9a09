#include "SideModels.h"

#include "ErrorText.h"
#include "InputError.h"
#include "ModelHandle.h"
#include "ProcrustesAlignment.h"
#include "ShapeAlignment.h"
#include "ShapeVector.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
void RequireShapes(const Status& status)
{
  if (!status.IsOk())
  {
    throw InputError(status.Message());
  }
}

// About the origin. Throws what the caller's guard tells.
void AddShapes(const palpate_model* const* models, std::size_t count,
               std::vector<OrganModel>& shapes)
{
  for (std::size_t i = 0; models != nullptr && i < count; ++i)
  {
    if (models[i] == nullptr)
    {
      throw InputError("a model is NULL");
    }
    OrganModel aligned = models[i]->Document.Surface;
    RequireShapes(AlignShape(models[i]->Document.Surface, AlignmentAxes::Patient, aligned));
    shapes.push_back(std::move(aligned));
  }
}

// The highest degree for all, as in a cohort.
void MakeAlike(std::vector<OrganModel>& shapes)
{
  int degree = 0;
  for (const OrganModel& shape : shapes)
  {
    degree = std::max(degree, DegreeOf(shape));
    if (shape.index() != shapes.front().index())
    {
      throw InputError("radial and surface models cannot be compared");
    }
  }
  for (OrganModel& shape : shapes)
  {
    shape = WithDegree(shape, degree);
  }
}

void CopyNumbers(const Eigen::VectorXd& values, double* numbers)
{
  if (numbers != nullptr)
  {
    std::copy(values.begin(), values.end(), numbers);
  }
}

void TakeAsymmetry(const ShapeAsymmetry& made, palpate_asymmetry& found)
{
  const SideAnova::Effect effects[3] = {made.Anova.Individual, made.Anova.Side,
                                        made.Anova.Interaction};
  for (std::size_t k = 0; k < 3; ++k)
  {
    found.squares[k] = effects[k].Squares;
    found.degrees[k] = effects[k].Degrees;
  }
  found.f = made.Anova.SideF();
  found.p = made.Points.WholeP;
  CopyNumbers(Eigen::Map<const Eigen::VectorXd>(made.Individuals.data(),
                                                static_cast<Eigen::Index>(made.Individuals.size())),
              found.individuals);
  CopyNumbers(made.Points.Mean, found.mean);
  CopyNumbers(made.Points.Deviation, found.deviations);
  CopyNumbers(made.Points.Statistic, found.statistic);
  CopyNumbers(made.Points.P, found.point_p);
  CopyNumbers(made.Points.FamilyP, found.family_p);
  for (std::size_t i = 0; found.points != nullptr && i < made.Surface.Points.size(); ++i)
  {
    Copy(made.Surface.Points[i], found.points + 3 * i);
  }
}
} // namespace

ShapeSides SidesOf(std::vector<OrganModel> shapes, std::size_t count, bool turnsToMean)
{
  const bool arePairs = shapes.size() > count;
  for (std::size_t i = count; i < shapes.size(); ++i)
  {
    shapes[i] = MirroredTowards(shapes[i], shapes[i - count]);
  }
  if (turnsToMean)
  {
    ProcrustesResult result;
    RequireShapes(AlignByProcrustes(shapes, nullptr, {}, result));
    shapes = std::move(result.Aligned);
  }
  ShapeSides sides;
  if (!arePairs)
  {
    RequireShapes(MakeMirroredSides(shapes, turnsToMean, {}, sides));
    return sides;
  }
  const auto middle = shapes.begin() + static_cast<std::ptrdiff_t>(count);
  return {{shapes.begin(), middle}, {middle, shapes.end()}};
}
} // namespace palpate

using namespace palpate;

int palpate_find_asymmetry(const palpate_model* const* left, const palpate_model* const* right,
                           size_t count, int turns_to_mean, int frequency, int flips, uint64_t seed,
                           palpate_asymmetry* found, palpate_error* error)
{
  return Guarded(error, {{left, "left", count}, {found, "found"}},
                 [&]
                 {
                   if (frequency < 1 || frequency > 100 || flips < 1 || flips > 10000000)
                   {
                     SetError(error, "the frequency is not between 1 and 100, or the flips are "
                                     "not between 1 and 10,000,000");
                     return 0;
                   }
                   if (count < ShapeAsymmetry::FewestIndividuals)
                   {
                     SetError(error, "asymmetry needs at least 3 individuals");
                     return 0;
                   }
                   std::vector<OrganModel> shapes;
                   AddShapes(left, count, shapes);
                   AddShapes(right, count, shapes);
                   MakeAlike(shapes);
                   ShapeAsymmetry made;
                   RequireShapes(
                       FindShapeAsymmetry(SidesOf(std::move(shapes), count, turns_to_mean != 0),
                                          right != nullptr, frequency, {flips, seed, 0}, {}, made));
                   TakeAsymmetry(made, *found);
                   return 1;
                 });
}
