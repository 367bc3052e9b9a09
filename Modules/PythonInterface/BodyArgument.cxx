#include "BodyArgument.h"

#include "Arrays.h"
#include "ModelBinding.h"
#include "Results.h"

#include <cstdint>
#include <vector>

namespace py = pybind11;

namespace palpate
{
namespace
{
Compared OfMask(const py::object& given, const char* name, const GridArguments& place,
                MaskFunction make)
{
  const py::array array = RealArray(given, name);
  const GridPlace grid = PlaceOfGrid(array, name, place);
  const py::array_t<bool, py::array::f_style | py::array::forcecast> inside(array);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(inside.data());
  const py::gil_scoped_release others;
  return Compared(Call(make, bytes, grid.Size.data(), grid.Origin.data(), grid.Spacing.data(),
                       grid.Axes.data()));
}

Compared OfMesh(const py::object& givenPoints, const py::object& givenTriangles)
{
  const VectorArray points(givenPoints, "points");
  const std::vector<std::int32_t> triangles = TrianglesOf(givenTriangles, points.Count());
  const py::gil_scoped_release others;
  return Compared(Call(palpate_compared_of_mesh, points.Data(), points.Count(), triangles.data(),
                       triangles.size() / 3));
}

bool IsInput(const py::object& given, const char* type)
{
  return py::isinstance(given, py::module_::import("palpate._inputs").attr(type));
}
} // namespace

Compared BodyOf(const py::object& given, const char* name, const GridArguments& place,
                MaskFunction make)
{
  if (py::isinstance<BoundModel>(given))
  {
    const auto& model = given.cast<const BoundModel&>();
    const py::gil_scoped_release others;
    return Compared(Call(palpate_compared_of_model, model.Handle.get()));
  }
  if (IsInput(given, "Mask"))
  {
    return OfMask(given.attr("values"), name,
                  {given.attr("spacing"), given.attr("origin"), given.attr("direction"),
                   given.attr("affine")},
                  make);
  }
  if (py::hasattr(given, "points") && py::hasattr(given, "triangles"))
  {
    return OfMesh(given.attr("points"), given.attr("triangles"));
  }
  if (py::isinstance<py::tuple>(given) && py::len(given) == 2)
  {
    return OfMesh(given[py::int_(0)], given[py::int_(1)]);
  }
  return OfMask(given, name, place, make);
}

py::object SurfaceOf(const Compared& body, const Numbers& distances)
{
  const auto points = static_cast<py::ssize_t>(palpate_compared_point_count(body.get()));
  const auto faces = static_cast<py::ssize_t>(palpate_compared_triangle_count(body.get()));
  Numbers place(std::vector<py::ssize_t>{points, 3});
  py::array_t<std::int32_t> triangles(std::vector<py::ssize_t>{faces, 3});
  palpate_compared_surface(body.get(), place.mutable_data(), triangles.mutable_data());
  return Result("ComparedSurface", place, triangles, distances);
}
} // namespace palpate
