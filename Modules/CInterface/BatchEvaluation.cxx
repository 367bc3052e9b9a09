#include "BatchEvaluation.h"

#include "SurfaceCurvature.h"

#include <algorithm>
#include <array>
#include <string>
#include <variant>
#include <vector>

namespace palpate
{
namespace
{
// Directions evaluated at once: their samples stay in the cache.
constexpr std::size_t BatchSize = 128;

void Put(const Vector3& vector, double* array, std::size_t entry)
{
  if (array != nullptr)
  {
    std::copy_n(vector.data(), 3, array + 3 * entry);
  }
}
void Put(double number, double* array, std::size_t entry)
{
  if (array != nullptr)
  {
    array[entry] = number;
  }
}

template <typename Sample>
void PutPlace(const RadialModel& radial, const Vector3& u, const Sample& sample,
              const palpate_evaluation& results, std::size_t i)
{
  Put(radial.CenterWorld() + sample.Radius * u, results.points, i);
  Put((sample.Radius * u - sample.SurfaceGradient).normalized(), results.normals, i);
  Put(sample.Radius, results.radii, i);
  Put(sample.SurfaceGradient, results.gradients, i);
}
template <typename Sample>
void PutPlace(const SurfaceModel&, const Vector3&, const Sample& sample,
              const palpate_evaluation& results, std::size_t i)
{
  Put(sample.Point, results.points, i);
  Put(sample.First[0].cross(sample.First[1]).normalized(), results.normals, i);
}

void PutCurvature(const SurfaceCurvature& curvature, const palpate_evaluation& results,
                  std::size_t i)
{
  Put(curvature.Mean, results.mean_curvatures, i);
  Put(curvature.Gaussian, results.gaussian_curvatures, i);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    Put(curvature.Principal[axis], results.principal_curvatures, 2 * i + axis);
    Put(curvature.Directions[axis], results.principal_directions, 2 * i + axis);
  }
}
SurfaceCurvature Curvature(const Vector3& u, const RadialModel::SecondOrderSample& sample)
{
  return CurvatureAt(u, sample);
}
SurfaceCurvature Curvature(const Vector3&, const SurfaceModel::SecondOrderSample& sample)
{
  return CurvatureAt(sample);
}

bool WantsCurvature(const palpate_evaluation& results)
{
  return results.mean_curvatures != nullptr || results.gaussian_curvatures != nullptr ||
         results.principal_curvatures != nullptr || results.principal_directions != nullptr;
}

template <typename Surface>
void EvaluateBatches(const Surface& surface, const std::vector<Vector3>& units,
                     const palpate_evaluation& results)
{
  std::array<typename Surface::Sample, BatchSize> samples;
  std::array<typename Surface::SecondOrderSample, BatchSize> bent;
  const bool isBent = WantsCurvature(results);
  for (std::size_t begin = 0; begin < units.size(); begin += BatchSize)
  {
    const std::size_t count = std::min(BatchSize, units.size() - begin);
    const Vector3* batch = units.data() + begin;
    isBent ? surface.EvaluateSecondOrderBatch(batch, count, bent.data())
           : surface.EvaluateBatch(batch, count, samples.data());
    for (std::size_t i = 0; i < count; ++i)
    {
      if (isBent)
      {
        PutPlace(surface, batch[i], bent[i], results, begin + i);
        PutCurvature(Curvature(batch[i], bent[i]), results, begin + i);
      }
      else
      {
        PutPlace(surface, batch[i], samples[i], results, begin + i);
      }
    }
  }
}
} // namespace

Status EvaluateModel(const OrganModel& surface, const double* directions, std::size_t count,
                     const palpate_evaluation& results)
{
  if (std::holds_alternative<SurfaceModel>(surface) &&
      (results.radii != nullptr || results.gradients != nullptr))
  {
    return Status::Failure("only a radial model has radii and their gradients");
  }
  std::vector<Vector3> units(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Eigen::Map<const Vector3> direction(directions + 3 * i);
    if (!direction.allFinite() || !(direction.stableNorm() > 0.0))
    {
      return Status::Failure("direction " + std::to_string(i) + " is zero or not finite");
    }
    units[i] = direction.stableNormalized();
  }
  std::visit([&](const auto& kind) { EvaluateBatches(kind, units, results); }, surface);
  return Status::Success();
}
} // namespace palpate
