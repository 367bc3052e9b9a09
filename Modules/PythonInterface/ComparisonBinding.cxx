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

using MaskFunction = decltype(&palpate_compared_of_mask);

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

// A Model, a Mask, a mesh (points and triangles), or an array: a mask on the grid of the call.
Compared BodyOf(const py::object& given, const char* name, const GridArguments& place,
                MaskFunction make = palpate_compared_of_mask)
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

MaskFunction MakerOf(const std::string& definition)
{
  if (definition != "subvoxel" && definition != "ibsi")
  {
    throw py::value_error("definition is \"subvoxel\" or \"ibsi\"");
  }
  return definition == "ibsi" ? palpate_compared_of_mask : palpate_compared_of_mask_shape;
}

py::object ShapeOf(const py::object& given, const std::string& definition,
                   const GridArguments& place)
{
  const Compared body = BodyOf(given, "body", place, MakerOf(definition));
  palpate_shape shape{};
  Numbers thickness(static_cast<py::ssize_t>(palpate_compared_point_count(body.get())));
  double* const thick = thickness.mutable_data();
  {
    const py::gil_scoped_release others;
    Call(palpate_compared_shape, body.get(), &shape);
    Call(palpate_compared_thickness, body.get(), thick);
  }
  py::list members;
  for (const double* number = &shape.volume; number != shape.centroid; ++number)
  {
    members.append(*number);
  }
  members.append(Numbers(3, shape.centroid));
  members.append(Numbers(std::vector<py::ssize_t>{3, 3}, shape.axes));
  members.append(SurfaceOf(body, thickness));
  return py::module_::import("palpate._results").attr("Shape")(*members);
}

py::object Relate(const py::object& first, const py::object& second, double contact,
                  const py::object& givenMargins, const std::string& definition,
                  const GridArguments& place)
{
  const py::array given =
      RealArray(givenMargins.is_none() ? py::make_tuple(2.0, 5.0, 10.0) : givenMargins, "margins");
  const py::array_t<double, py::array::c_style | py::array::forcecast> margins(given);
  const MaskFunction make = MakerOf(definition);
  const Compared one = BodyOf(first, "first", place, make);
  const Compared other = BodyOf(second, "second", place, make);
  const std::vector<py::ssize_t> shape{margins.size(), 2};
  Numbers areas(shape);
  Numbers volumes(shape);
  palpate_relation found{};
  const double* limits = margins.data();
  const auto count = static_cast<std::size_t>(margins.size());
  double* const nearAreas = areas.mutable_data();
  double* const nearVolumes = volumes.mutable_data();
  {
    const py::gil_scoped_release others;
    Call(palpate_relate, one.get(), other.get(), contact, limits, count, &found, nearAreas,
         nearVolumes);
  }
  constexpr const char* Kinds[] = {"apart", "overlapping", "inside", "around"};
  return Result("Relation", Kinds[found.kind], found.distance, found.wall,
                Numbers(3, found.first_point), Numbers(3, found.second_point), found.shared_volume,
                Pair(found.contact_areas), areas, volumes, Numbers(3, found.offset),
                found.axes_angle);
}

constexpr const char* GridHelp =
    "spacing, origin, direction, affine: the grid of masks that are arrays, as for fit_mask.";
} // namespace

void BindRelations(py::module_& module)
{
  module.def(
      "shape",
      [](const py::object& body, const std::string& definition, const py::object& spacing,
         const py::object& origin, const py::object& direction, const py::object& affine) {
        return ShapeOf(body, definition, {spacing, origin, direction, affine});
      },
      py::arg("body"), py::kw_only(), py::arg("definition") = "subvoxel",
      py::arg("spacing") = py::none(), py::arg("origin") = py::none(),
      py::arg("direction") = py::none(), py::arg("affine") = py::none(),
      (std::string(
           "The shape features of the Image Biomarker Standardisation Initiative, principal axes, "
           "and the thickness at each point of the surface.\n\n"
           "body: as for compare; closed.\n"
           "definition: of masks, \"subvoxel\" for the shape behind their voxels, \"ibsi\" for the "
           "Initiative's own surface.\n") +
       GridHelp)
          .c_str());
  module.def(
      "relate",
      [](const py::object& first, const py::object& second, double contact,
         const py::object& margins, const std::string& definition, const py::object& spacing,
         const py::object& origin, const py::object& direction, const py::object& affine)
      {
        return Relate(first, second, contact, margins, definition,
                      {spacing, origin, direction, affine});
      },
      py::arg("first"), py::arg("second"), py::kw_only(), py::arg("contact") = 1.0,
      py::arg("margins") = py::none(), py::arg("definition") = "subvoxel",
      py::arg("spacing") = py::none(), py::arg("origin") = py::none(),
      py::arg("direction") = py::none(), py::arg("affine") = py::none(),
      (std::string("How two closed bodies lie to each other: least distance, contact areas, shares "
                   "within margins, shared volume, direction.\n\n"
                   "first, second: as for compare.\n"
                   "contact: mm; surfaces as near are in contact.\n"
                   "margins: mm, ascending; 2, 5 and 10 unless given.\n"
                   "definition: as for shape.\n") +
       GridHelp)
          .c_str());
}

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
