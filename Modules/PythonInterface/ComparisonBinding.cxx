#include "ComparisonBinding.h"

#include "Arrays.h"
#include "Call.h"
#include "GridArray.h"
#include "ModelBinding.h"
#include "Results.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace py = pybind11;

namespace palpate
{
namespace
{
using Compared = Owned<palpate_compared>;

Compared OfMask(const py::object& given, const char* name, const GridArguments& place)
{
  const py::array array = RealArray(given, name);
  const GridPlace grid = PlaceOfGrid(array, name, place);
  const py::array_t<bool, py::array::f_style | py::array::forcecast> inside(array);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(inside.data());
  const py::gil_scoped_release others;
  return Compared(Call(palpate_compared_of_mask, bytes, grid.Size.data(), grid.Origin.data(),
                       grid.Spacing.data(), grid.Axes.data()));
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

// A Model, a Mask, a mesh (points and triangles), or an array: a mask on the grid of the call.
Compared BodyOf(const py::object& given, const char* name, const GridArguments& place)
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
                   given.attr("affine")});
  }
  if (py::hasattr(given, "points") && py::hasattr(given, "triangles"))
  {
    return OfMesh(given.attr("points"), given.attr("triangles"));
  }
  if (py::isinstance<py::tuple>(given) && py::len(given) == 2)
  {
    return OfMesh(given[py::int_(0)], given[py::int_(1)]);
  }
  return OfMask(given, name, place);
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

py::object DistancesFrom(const palpate_distances& found)
{
  return Result("Distances", found.mean, found.rms, found.percentile95, found.maximum,
                found.signed_mean);
}

Numbers Pair(const double numbers[2])
{
  return Numbers(2, numbers);
}

py::object Compare(const py::object& first, const py::object& reference,
                   const py::object& givenTolerances, const GridArguments& place)
{
  const py::array given = RealArray(
      givenTolerances.is_none() ? py::make_tuple(1.0, 2.0, 3.0) : givenTolerances, "tolerances");
  const py::array_t<double, py::array::c_style | py::array::forcecast> tolerances(given);
  const Compared one = BodyOf(first, "first", place);
  const Compared other = BodyOf(reference, "reference", place);
  Numbers surfaceDice(tolerances.size());
  Numbers oneDistances(static_cast<py::ssize_t>(palpate_compared_point_count(one.get())));
  Numbers otherDistances(static_cast<py::ssize_t>(palpate_compared_point_count(other.get())));
  palpate_comparison found{};
  const double* limits = tolerances.data();
  const auto count = static_cast<std::size_t>(tolerances.size());
  double* const dice = surfaceDice.mutable_data();
  double* const there = oneDistances.mutable_data();
  double* const back = otherDistances.mutable_data();
  {
    const py::gil_scoped_release others;
    Call(palpate_compare, one.get(), other.get(), limits, count, &found, dice, there, back);
  }
  return Result("Comparison", found.dice, found.jaccard, Pair(found.volumes), Pair(found.areas),
                DistancesFrom(found.both), DistancesFrom(found.to_reference),
                DistancesFrom(found.to_first), found.hausdorff95, surfaceDice,
                Numbers(6, found.side_bias), SurfaceOf(one, oneDistances),
                SurfaceOf(other, otherDistances));
}
} // namespace

void BindComparisons(py::module_& module)
{
  module.def(
      "compare",
      [](const py::object& first, const py::object& reference, const py::object& tolerances,
         const py::object& spacing, const py::object& origin, const py::object& direction,
         const py::object& affine) {
        return Compare(first, reference, tolerances, {spacing, origin, direction, affine});
      },
      py::arg("first"), py::arg("reference"), py::kw_only(), py::arg("tolerances") = py::none(),
      py::arg("spacing") = py::none(), py::arg("origin") = py::none(),
      py::arg("direction") = py::none(), py::arg("affine") = py::none(),
      "Compares two bodies: Dice, Jaccard, distances, normalised surface Dice, bias by side.\n\n"
      "first, reference: a Model; a mask (i, j, k), inside where not 0; a Mask, which has a grid "
      "of "
      "its own; or a mesh, as Mesh or (points, triangles). Distances from models are exact; what "
      "an "
      "open mesh has not is NaN.\n"
      "tolerances: mm, of the surface Dice; 1, 2 and 3 unless given.\n"
      "spacing, origin, direction, affine: the grid of masks that are arrays, as for fit_mask.");
}
} // namespace palpate
