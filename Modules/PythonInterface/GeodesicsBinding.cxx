#include "GeodesicsBinding.h"

#include "Arrays.h"
#include "BodyArgument.h"
#include "ModelBinding.h"
#include "Results.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace py = pybind11;

namespace palpate
{
namespace
{
// palpate.Geodesics.
struct BoundGeodesics
{
  Owned<palpate_geodesics> Handle;
};

BoundGeodesics MeasuredBody(const py::object& body, const GridArguments& place)
{
  if (py::isinstance<BoundModel>(body))
  {
    const auto& model = body.cast<const BoundModel&>();
    const py::gil_scoped_release others;
    return {Owned<palpate_geodesics>(Call(palpate_geodesics_of_model, model.Handle.get()))};
  }
  const Compared given = BodyOf(body, "body", place, palpate_compared_of_mask_shape);
  const py::gil_scoped_release others;
  return {Owned<palpate_geodesics>(Call(palpate_geodesics_of_body, given.get()))};
}

py::object ShortestPath(const BoundGeodesics& surface, const py::object& from, const py::object& to)
{
  const std::array<double, 3> start = TripleOf(from, "start");
  const std::array<double, 3> end = TripleOf(to, "end");
  palpate_geodesic found{};
  std::size_t count = 0;
  std::vector<double> path;
  {
    const py::gil_scoped_release others;
    std::size_t capacity = 4096; // points of most paths
    do
    {
      capacity = std::max(capacity, count);
      path.resize(3 * capacity);
      Call(palpate_geodesics_find, surface.Handle.get(), start.data(), end.data(), &found,
           path.data(), capacity, &count);
    } while (count > capacity);
  }
  Numbers points(std::vector<py::ssize_t>{static_cast<py::ssize_t>(count), 3});
  std::copy_n(path.begin(), 3 * count, points.mutable_data());
  return Result("Geodesic", found.along, found.straight, found.uncertainty, points);
}

py::object DistanceMap(const BoundGeodesics& surface, const py::object& from)
{
  const std::array<double, 3> start = TripleOf(from, "start");
  std::size_t points = 0;
  std::size_t triangles = 0;
  Call(palpate_geodesics_map, surface.Handle.get(), start.data(), &points, &triangles, nullptr,
       nullptr, nullptr);
  Numbers places(std::vector<py::ssize_t>{static_cast<py::ssize_t>(points), 3});
  Numbers distances(std::vector<py::ssize_t>{static_cast<py::ssize_t>(points)});
  py::array_t<std::int32_t> corners(
      std::vector<py::ssize_t>{static_cast<py::ssize_t>(triangles), 3});
  double* const ofPoints = places.mutable_data();
  double* const lengths = distances.mutable_data();
  std::int32_t* const ofTriangles = corners.mutable_data();
  {
    const py::gil_scoped_release others;
    Call(palpate_geodesics_map, surface.Handle.get(), start.data(), &points, &triangles, ofPoints,
         ofTriangles, lengths);
  }
  return Result("ComparedSurface", places, corners, distances);
}
} // namespace

void BindGeodesics(py::module_& module)
{
  py::class_<BoundGeodesics>(module, "Geodesics",
                             "Lengths along a surface: of a model on the model itself, of meshes "
                             "and masks along triangles.")
      .def(py::init(
               [](const py::object& body, const py::object& spacing, const py::object& origin,
                  const py::object& direction, const py::object& affine) {
                 return MeasuredBody(body, {spacing, origin, direction, affine});
               }),
           py::arg("body"), py::kw_only(), py::arg("spacing") = py::none(),
           py::arg("origin") = py::none(), py::arg("direction") = py::none(),
           py::arg("affine") = py::none(),
           "body: a Model, a Mask, a mesh (points and triangles), or an array: a mask, of which "
           "the shape is taken. spacing, origin, direction, affine: as those of fit_mask.")
      .def("path", &ShortestPath, py::arg("start"), py::arg("end"),
           "Geodesic between the surface's points nearest to two places (3,), mm.")
      .def("map", &DistanceMap, py::arg("start"),
           "ComparedSurface: the body's, or a model drawn finely; its distances run along the "
           "surface from the point nearest to a place (3,), mm.");
}
} // namespace palpate
