#include "ModelHandle.h"

#include "BatchEvaluation.h"
#include "ErrorText.h"
#include "GridArgument.h"
#include "IcosahedronDirections.h"
#include "MaskModel.h"
#include "ModelConvention.h"
#include "ModelFile.h"
#include "ModelMeasures.h"
#include "RadialModelFit.h"
#include "ShapePriorFile.h"
#include "SphericalHarmonicBasis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace palpate
{
namespace
{
constexpr int MostFrequency = 1000;

palpate_model* HandleOf(OrganModel surface)
{
  return new palpate_model({std::move(surface), {}, nullptr});
}

const RadialModel* RadialOf(const palpate_model& model)
{
  return std::get_if<RadialModel>(&model.Document.Surface);
}

bool IsDegree(int degree, palpate_error* error)
{
  const bool isDegree = degree >= 0 && degree <= ModelConvention::MaximumDegree;
  if (!isDegree)
  {
    SetError(error, "a model's degree is from 0 to 1,000");
  }
  return isDegree;
}

bool IsFinite(const std::vector<double>& numbers)
{
  return std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); });
}

palpate_model* Radial(int degree, std::vector<double> coefficients, const Vector3& center,
                      palpate_error* error)
{
  if (!IsFinite(coefficients) || !center.allFinite())
  {
    SetError(error, "a coefficient or the centre is not finite");
    return nullptr;
  }
  return HandleOf(RadialModel(degree, std::move(coefficients), center));
}

void PlaceAt(const OrganModel& surface, const Vector3& direction, double* point, double* normal)
{
  const auto place = [&](const Vector3& where, const Vector3& outward)
  {
    Copy(where, point);
    if (normal != nullptr)
    {
      Copy(outward, normal);
    }
  };
  if (const auto* radial = std::get_if<RadialModel>(&surface))
  {
    place(radial->PointWorld(direction), radial->Normal(direction));
    return;
  }
  const auto& organ = std::get<SurfaceModel>(surface);
  place(organ.Point(direction), organ.Normal(direction));
}

void PrepareSearch(palpate_model& model)
{
  if (const RadialModel* radial = RadialOf(model))
  {
    model.RadialSearch =
        std::make_unique<const ClosestPointSearch>(std::make_shared<const RadialModel>(*radial));
    return;
  }
  model.SurfaceSearch = std::make_unique<const ClosestPointSearchOf<CenteredSurface>>(
      std::make_shared<const CenteredSurface>(std::get<SurfaceModel>(model.Document.Surface)));
}

template <typename Search>
int Nearest(const Search& search, const Vector3& query, double point[3], double normal[3],
            double* distance, palpate_error* error)
{
  const auto found = search.Nearest(query);
  if (found.State == Search::ClosestPoint::Outcome::BadInput)
  {
    SetError(error, "the point or the surface is not finite");
    return 0;
  }
  Copy(found.PointWorld, point);
  Copy(found.Normal, normal);
  *distance = found.SignedDistance;
  return 1;
}

constexpr int DeviationFrequency = 8;
constexpr int NextPlaces = 6;

std::vector<SurfaceTouch> TouchesOf(const double* points, const double* normals,
                                    const int32_t* strokes, const uint8_t* outside,
                                    std::size_t count, double sigma)
{
  std::vector<SurfaceTouch> touches(count);
  for (std::size_t n = 0; n < count; ++n)
  {
    touches[n] = {VectorOf(points + 3 * n), sigma};
    touches[n].Stroke = strokes != nullptr ? strokes[n] : 0;
    touches[n].IsOutside = outside != nullptr && outside[n] != 0;
    if (normals != nullptr && VectorOf(normals + 3 * n) != Vector3::Zero())
    {
      touches[n].Normal = VectorOf(normals + 3 * n);
    }
  }
  return touches;
}

Status Complete(CompletionRequest& request, const char* prior, const palpate_model* known,
                OrganCompletion& made)
{
  if (prior != nullptr)
  {
    request.Prior = ReadOrganPrior(prior);
  }
  if (known != nullptr)
  {
    request.Known.emplace();
    if (Status status = FindLogSurface(known->Document.Surface, *request.Known); !status.IsOk())
    {
      return Status::Failure("the known organ " + status.Message());
    }
  }
  request.Frequency = DeviationFrequency;
  request.NextCount = NextPlaces;
  Status status = CompleteOrgan(request, made);
  return status.IsOk() ? made.Judgement : status;
}
} // namespace
} // namespace palpate

using namespace palpate;

palpate_model* palpate_model_create(int degree, const double* coefficients, const double center[3],
                                    palpate_error* error)
{
  return Guarded(
      error, {{coefficients, "coefficients"}, {center, "center"}},
      [&]() -> palpate_model*
      {
        if (!IsDegree(degree, error))
        {
          return nullptr;
        }
        const std::size_t count = SphericalHarmonicBasis(degree).Size();
        return Radial(degree, {coefficients, coefficients + count}, VectorOf(center), error);
      });
}

palpate_model* palpate_model_create_surface(int degree, const double* coefficients,
                                            palpate_error* error)
{
  return Guarded(error, {{coefficients, "coefficients"}},
                 [&]() -> palpate_model*
                 {
                   if (!IsDegree(degree, error))
                   {
                     return nullptr;
                   }
                   const std::size_t count = SphericalHarmonicBasis(degree).Size();
                   std::array<std::vector<double>, 3> values;
                   for (std::size_t axis = 0; axis < values.size(); ++axis)
                   {
                     const double* const first = coefficients + axis * count;
                     values[axis] = std::vector<double>(first, first + count);
                     if (!IsFinite(values[axis]))
                     {
                       SetError(error, "a coefficient is not finite");
                       return nullptr;
                     }
                   }
                   return HandleOf(SurfaceModel(degree, values));
                 });
}

palpate_model* palpate_model_create_parametric(int degree, const double* coefficients,
                                               palpate_error* error)
{
  return palpate_model_create_surface(degree, coefficients, error);
}

palpate_model* palpate_model_fit(const double* points, size_t count, const double center[3],
                                 int degree, palpate_error* error)
{
  return Guarded(error, {{points, "points", count}, {center, "center"}},
                 [&]() -> palpate_model*
                 {
                   if (!IsDegree(degree, error))
                   {
                     return nullptr;
                   }
                   RadialSamples samples;
                   for (std::size_t i = 0; i < count; ++i)
                   {
                     const Vector3 from = VectorOf(points + 3 * i) - VectorOf(center);
                     samples.Directions.emplace_back(from.normalized());
                     samples.Radii.push_back(from.norm());
                     samples.Weights.push_back(1.0);
                   }
                   RadialModelFitOptions options;
                   options.Degree = degree;
                   RadialModelFitResult fit;
                   const Status status = FitRadialModel(samples, options, fit);
                   return Told(status, error) != 0
                              ? Radial(degree, fit.Coefficients, VectorOf(center), error)
                              : nullptr;
                 });
}

palpate_model* palpate_model_fit_mask(const uint8_t* inside, const int size[3],
                                      const double origin[3], const double spacing[3],
                                      const double axes[9], int degree, int is_radial,
                                      palpate_error* error)
{
  return Guarded(error,
                 {{inside, "inside"},
                  {size, "size"},
                  {origin, "origin"},
                  {spacing, "spacing"},
                  {axes, "axes"}},
                 [&]() -> palpate_model*
                 {
                   IndexToWorld toWorld;
                   const Status placed = PlaceGrid(size, origin, spacing, axes, toWorld);
                   if (Told(placed, error) == 0 || !IsDegree(degree, error))
                   {
                     return nullptr;
                   }
                   OrganModel model;
                   TopologyReport changes;
                   const Status status = FitMask(CroppedMask(inside, size, spacing), toWorld,
                                                 {degree, is_radial != 0}, model, &changes);
                   if (Told(status, error) == 0)
                   {
                     return nullptr;
                   }
                   palpate_model* handle = HandleOf(std::move(model));
                   handle->Changes = ChangeText(changes);
                   return handle;
                 });
}

palpate_model* palpate_complete(const double* points, const double* normals, const int32_t* strokes,
                                const uint8_t* outside, size_t count, const char* prior,
                                double sigma, const double center[3], double* deviations,
                                double* next, palpate_error* error)
{
  return palpate_complete_organ(points, normals, strokes, outside, count, prior, sigma, center,
                                nullptr, deviations, next, error);
}

palpate_model* palpate_complete_organ(const double* points, const double* normals,
                                      const int32_t* strokes, const uint8_t* outside, size_t count,
                                      const char* prior, double sigma, const double center[3],
                                      const palpate_model* known, double* deviations, double* next,
                                      palpate_error* error)
{
  return Guarded(error, {{points, "points", count}},
                 [&]() -> palpate_model*
                 {
                   if (count > SurfaceTouch::Most)
                   {
                     SetError(error, "there are more than 1,000 touched points");
                     return nullptr;
                   }
                   CompletionRequest request;
                   request.Touches = TouchesOf(points, normals, strokes, outside, count, sigma);
                   if (center != nullptr)
                   {
                     request.ClickWorld = VectorOf(center);
                   }
                   OrganCompletion made;
                   if (Told(Complete(request, prior, known, made), error) == 0)
                   {
                     return nullptr;
                   }
                   if (deviations != nullptr)
                   {
                     std::copy(made.Deviations.begin(), made.Deviations.end(), deviations);
                   }
                   for (std::size_t n = 0; next != nullptr && n < made.Next.size(); ++n)
                   {
                     Copy(made.Next[n], next + 3 * n);
                   }
                   return HandleOf(std::move(made.Model));
                 });
}

palpate_model* palpate_model_read(const char* path, palpate_error* error)
{
  return Guarded(error, {{path, "path"}}, [&] { return new palpate_model(ReadModel(path)); });
}

int palpate_model_write(const palpate_model* model, const char* path, palpate_error* error)
{
  return Guarded(error, {{model, "model"}, {path, "path"}},
                 [&]
                 {
                   WriteModel(path, model->Document);
                   return 1;
                 });
}

void palpate_model_free(palpate_model* model)
{
  delete model;
}

const char* palpate_model_changes(const palpate_model* model)
{
  return model != nullptr ? model->Changes.c_str() : "";
}

int palpate_model_degree(const palpate_model* model)
{
  return model != nullptr ? DegreeOf(model->Document.Surface) : 0;
}

int palpate_model_is_radial(const palpate_model* model)
{
  return model != nullptr && RadialOf(*model) != nullptr ? 1 : 0;
}

int palpate_model_is_star_shaped(const palpate_model* model)
{
  return palpate_model_is_radial(model);
}

int palpate_model_yields(const palpate_model* model)
{
  return model != nullptr && model->Document.Elasticity != nullptr ? 1 : 0;
}

size_t palpate_model_coefficients(const palpate_model* model, double* coefficients, size_t capacity)
{
  if (model == nullptr)
  {
    return 0;
  }
  capacity = coefficients != nullptr ? capacity : 0;
  std::size_t count = 0;
  const auto append = [&](const std::vector<double>& values)
  {
    const std::size_t left = capacity > count ? capacity - count : 0;
    std::copy_n(values.begin(), std::min(left, values.size()), coefficients + count);
    count += values.size();
  };
  if (const RadialModel* radial = RadialOf(*model))
  {
    append(radial->Coefficients());
    return count;
  }
  const auto& surface = std::get<SurfaceModel>(model->Document.Surface);
  for (int coordinate = 0; coordinate < 3; ++coordinate)
  {
    append(surface.Coefficients(coordinate));
  }
  return count;
}

void palpate_model_center(const palpate_model* model, double center[3])
{
  if (model != nullptr && center != nullptr)
  {
    Copy(CenterOf(model->Document.Surface), center);
  }
}

int palpate_model_point(const palpate_model* model, const double direction[3], double point[3],
                        double normal[3], palpate_error* error)
{
  if (!AreGiven({{model, "model"}, {direction, "direction"}, {point, "point"}, {normal, "normal"}},
                error))
  {
    return 0;
  }
  const Vector3 towards = VectorOf(direction);
  if (!towards.allFinite() || !(towards.stableNorm() > 0.0))
  {
    SetError(error, "the direction is zero or not finite");
    return 0;
  }
  PlaceAt(model->Document.Surface, towards.stableNormalized(), point, normal);
  return 1;
}

int palpate_model_evaluate(const palpate_model* model, const double* directions, size_t count,
                           const palpate_evaluation* results, palpate_error* error)
{
  return Guarded(
      error, {{model, "model"}, {directions, "directions", count}, {results, "results"}},
      [&]
      { return Told(EvaluateModel(model->Document.Surface, directions, count, *results), error); });
}

int palpate_model_body(const palpate_model* model, palpate_body* body, palpate_error* error)
{
  return Guarded(error, {{model, "model"}, {body, "body"}},
                 [&]
                 {
                   return std::visit(
                       [&](const auto& surface)
                       {
                         BodyMoments moments;
                         if (Told(MeasureBody(surface, moments), error) == 0)
                         {
                           return 0;
                         }
                         body->volume = moments.Volume;
                         body->area = AreaOf(surface);
                         Copy(moments.CentroidWorld, body->centroid);
                         Copy(moments.SemiAxes, body->semi_axes);
                         for (int axis = 0; axis < 3; ++axis)
                         {
                           Copy(moments.PrincipalAxes.col(axis), body->axes + 3 * axis);
                         }
                         return 1;
                       },
                       model->Document.Surface);
                 });
}

int palpate_model_spectrum(const palpate_model* model, double* spectrum, palpate_error* error)
{
  return Guarded(error, {{model, "model"}, {spectrum, "spectrum"}},
                 [&]
                 {
                   const std::vector<double> powers = PowerSpectrumOf(model->Document.Surface);
                   std::copy(powers.begin(), powers.end(), spectrum);
                   return 1;
                 });
}

int palpate_model_measure(const palpate_model* model, double* volume, double* area,
                          palpate_error* error)
{
  if (!AreGiven({{model, "model"}, {volume, "volume"}, {area, "area"}}, error))
  {
    return 0;
  }
  palpate_body body;
  const int isMeasured = palpate_model_body(model, &body, error);
  if (isMeasured != 0)
  {
    *volume = body.volume;
    *area = body.area;
  }
  return isMeasured;
}

int palpate_model_nearest(palpate_model* model, const double query[3], double point[3],
                          double normal[3], double* distance, palpate_error* error)
{
  return Guarded(error,
                 {{model, "model"},
                  {query, "query"},
                  {point, "point"},
                  {normal, "normal"},
                  {distance, "distance"}},
                 [&]
                 {
                   std::call_once(model->HasSearch, [&] { PrepareSearch(*model); });
                   const Vector3 from = VectorOf(query);
                   return model->RadialSearch != nullptr
                              ? Nearest(*model->RadialSearch, from, point, normal, distance, error)
                              : Nearest(*model->SurfaceSearch, from, point, normal, distance,
                                        error);
                 });
}

size_t palpate_mesh_point_count(int frequency)
{
  const auto f = static_cast<std::size_t>(std::clamp(frequency, 1, MostFrequency));
  return 10 * f * f + 2;
}

size_t palpate_mesh_triangle_count(int frequency)
{
  const auto f = static_cast<std::size_t>(std::clamp(frequency, 1, MostFrequency));
  return 20 * f * f;
}

int palpate_model_mesh(const palpate_model* model, int frequency, double* points, double* normals,
                       int32_t* triangles, palpate_error* error)
{
  return Guarded(error, {{model, "model"}, {points, "points"}, {triangles, "triangles"}},
                 [&]
                 {
                   if (frequency < 1 || frequency > MostFrequency)
                   {
                     SetError(error, "a mesh's frequency is from 1 to 1,000");
                     return 0;
                   }
                   const IcosahedronDirections sphere(frequency);
                   for (std::size_t i = 0; i < sphere.Directions().size(); ++i)
                   {
                     PlaceAt(model->Document.Surface, sphere.Directions()[i], points + 3 * i,
                             normals != nullptr ? normals + 3 * i : nullptr);
                   }
                   for (const auto& corners : sphere.Triangles())
                   {
                     triangles = std::copy(corners.begin(), corners.end(), triangles);
                   }
                   return 1;
                 });
}
