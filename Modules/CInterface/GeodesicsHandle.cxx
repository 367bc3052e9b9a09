#include "GeodesicsHandle.h"

#include "ComparedHandle.h"
#include "ErrorText.h"
#include "ModelHandle.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
palpate_geodesics* Measured(const Status& status, SurfaceGeodesics surface, palpate_error* error)
{
  return Told(status, error) != 0 ? new palpate_geodesics{std::move(surface)} : nullptr;
}

Status CheckPlaces(std::initializer_list<const double*> places)
{
  const bool areFinite =
      std::all_of(places.begin(), places.end(),
                  [](const double* place) { return VectorOf(place).allFinite(); });
  return areFinite ? Status::Success() : Status::Failure("a place is not finite");
}

void CopyPoints(const std::vector<Vector3>& from, std::size_t capacity, double* into)
{
  for (std::size_t n = 0; into != nullptr && n < std::min(capacity, from.size()); ++n)
  {
    Copy(from[n], into + 3 * n);
  }
}
} // namespace
} // namespace palpate

using namespace palpate;

palpate_geodesics* palpate_geodesics_of_model(const palpate_model* model, palpate_error* error)
{
  return Guarded(error, {{model, "model"}},
                 [&]
                 {
                   SurfaceGeodesics surface;
                   const Status status =
                       SurfaceGeodesics::OfModel(model->Document.Surface, surface);
                   return Measured(status, std::move(surface), error);
                 });
}

palpate_geodesics* palpate_geodesics_of_body(const palpate_compared* body, palpate_error* error)
{
  return Guarded(error, {{body, "body"}},
                 [&]
                 {
                   SurfaceGeodesics surface;
                   const Status status = SurfaceGeodesics::OfMesh(body->Body.Surface(), surface);
                   return Measured(status, std::move(surface), error);
                 });
}

void palpate_geodesics_free(palpate_geodesics* surface)
{
  delete surface;
}

int palpate_geodesics_find(const palpate_geodesics* surface, const double from[3],
                           const double to[3], palpate_geodesic* found, double* path,
                           size_t capacity, size_t* path_count, palpate_error* error)
{
  return Guarded(error,
                 {{surface, "surface"},
                  {from, "from"},
                  {to, "to"},
                  {found, "found"},
                  {path_count, "path_count"}},
                 [&]
                 {
                   SurfaceGeodesics::Length length;
                   Status status = CheckPlaces({from, to});
                   if (status.IsOk())
                   {
                     status = surface->Surface.Find(VectorOf(from), VectorOf(to), {}, length);
                   }
                   if (Told(status, error) == 0)
                   {
                     return 0;
                   }
                   Copy(length.From, found->from);
                   Copy(length.To, found->to);
                   found->along = length.Along;
                   found->straight = length.Direct;
                   found->uncertainty =
                       length.Uncertainty.value_or(std::numeric_limits<double>::quiet_NaN());
                   *path_count = length.Points.size();
                   CopyPoints(length.Points, capacity, path);
                   return 1;
                 });
}

int palpate_geodesics_map(const palpate_geodesics* surface, const double from[3],
                          size_t* point_count, size_t* triangle_count, double* points,
                          int32_t* triangles, double* distances, palpate_error* error)
{
  return Guarded(error,
                 {{surface, "surface"},
                  {from, "from"},
                  {point_count, "point_count"},
                  {triangle_count, "triangle_count"}},
                 [&]
                 {
                   std::vector<double> lengths;
                   Status status = CheckPlaces({from});
                   if (status.IsOk() && distances != nullptr)
                   {
                     status = surface->Surface.Distances(VectorOf(from), {}, lengths);
                   }
                   if (Told(status, error) == 0)
                   {
                     return 0;
                   }
                   const IndexedMesh& mesh = surface->Surface.Mesh();
                   *point_count = mesh.Points.size();
                   *triangle_count = mesh.Triangles.size();
                   CopyPoints(mesh.Points, mesh.Points.size(), points);
                   std::copy(lengths.begin(), lengths.end(), distances);
                   for (std::size_t t = 0; triangles != nullptr && t < mesh.Triangles.size(); ++t)
                   {
                     std::copy(mesh.Triangles[t].begin(), mesh.Triangles[t].end(),
                               triangles + 3 * t);
                   }
                   return 1;
                 });
}
