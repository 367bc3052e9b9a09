#include "ComparisonBinding.h"

#include "Arrays.h"
#include "BodyArgument.h"
#include "Results.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace py = pybind11;

namespace palpate
{
namespace
{
py::object DistancesFrom(const palpate_distances& found)
{
  return Result("Distances", found.mean, found.rms, found.percentile95, found.maximum,
                found.signed_mean);
}

Numbers Pair(const double numbers[2])
{
  return Numbers(2, numbers);
}

// Replaces the reference by its mirror image on the first, both as shapes.
py::object MirrorOnto(const py::object& first, const py::object& reference,
                      const GridArguments& place, Compared& mirrored)
{
  const Compared onto = BodyOf(first, "first", place, palpate_compared_of_mask_shape);
  const Compared shape = BodyOf(reference, "reference", place, palpate_compared_of_mask_shape);
  double turn = 0.0;
  double shift[3];
  {
    const py::gil_scoped_release others;
    mirrored.reset(Call(palpate_compared_mirror, shape.get(), onto.get(), &turn, shift));
  }
  return Result("Mirror", turn, Numbers(3, shift));
}

py::object Compare(const py::object& first, const py::object& reference,
                   const py::object& givenTolerances, bool mirror, const GridArguments& place)
{
  const py::array given = RealArray(
      givenTolerances.is_none() ? py::make_tuple(1.0, 2.0, 3.0) : givenTolerances, "tolerances");
  const py::array_t<double, py::array::c_style | py::array::forcecast> tolerances(given);
  const Compared one = BodyOf(first, "first", place);
  Compared other = BodyOf(reference, "reference", place);
  double measures[2];
  palpate_compared_measure(other.get(), &measures[0], &measures[1]);
  const py::object mirrored = mirror ? MirrorOnto(first, reference, place, other) : py::none();
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
  found.volumes[1] = measures[0]; // of the reference as it was given
  found.areas[1] = measures[1];
  return Result("Comparison", found.dice, found.jaccard, Pair(found.volumes), Pair(found.areas),
                DistancesFrom(found.both), DistancesFrom(found.to_reference),
                DistancesFrom(found.to_first), found.hausdorff95, surfaceDice,
                Numbers(6, found.side_bias), SurfaceOf(one, oneDistances),
                SurfaceOf(other, otherDistances), mirrored);
}

py::object Motion(const py::object& before, const py::object& after, const py::object& given,
                  const GridArguments& place)
{
  const VectorArray landmarks(given.is_none() ? Numbers(std::vector<py::ssize_t>{0, 3}) : given,
                              "landmarks");
  const Compared from = BodyOf(before, "before", place, palpate_compared_of_mask_shape);
  const Compared to = BodyOf(after, "after", place, palpate_compared_of_mask_shape);
  palpate_motion found{};
  Numbers moved = landmarks.Results({3});
  double* const places = moved.mutable_data();
  {
    const py::gil_scoped_release others;
    Call(palpate_compared_motion, from.get(), to.get(), landmarks.Data(), landmarks.Count(), &found,
         places);
  }
  return Result("Motion", found.turn, Numbers(3, found.shift), found.rest, moved);
}

MaskFunction MakerOf(const std::string& definition)
{
  if (definition != "subvoxel" && definition != "ibsi")
  {
    throw py::value_error("definition is \"subvoxel\" or \"ibsi\"");
  }
  return definition == "ibsi" ? palpate_compared_of_mask : palpate_compared_of_mask_shape;
}

using ThicknessFunction = decltype(&palpate_compared_thickness);

ThicknessFunction ThicknessBy(const std::string& rule)
{
  if (rule != "spheres" && rule != "rays")
  {
    throw py::value_error("thickness is \"spheres\" or \"rays\"");
  }
  return rule == "rays" ? palpate_compared_ray_thickness : palpate_compared_thickness;
}

py::object CalibreOf(const py::object& given, const std::string& definition,
                     const GridArguments& place)
{
  const Compared body = BodyOf(given, "body", place, MakerOf(definition));
  double length = 0.0;
  std::vector<palpate_section> sections;
  {
    const py::gil_scoped_release others;
    sections.resize(Call(palpate_compared_calibre, body.get(), nullptr, std::size_t{0}, &length));
    Call(palpate_compared_calibre, body.get(), sections.data(), sections.size(), &length);
  }
  const auto column = [&](std::size_t offset, py::ssize_t width)
  {
    const auto rows = static_cast<py::ssize_t>(sections.size());
    Numbers numbers(width > 1 ? std::vector{rows, width} : std::vector{rows});
    double* to = numbers.mutable_data();
    for (const palpate_section& one : sections)
    {
      to = std::copy_n(&one.along + offset, width, to);
    }
    return numbers;
  };
  return Result("Calibre", length, column(0, 1), column(1, 3), column(4, 3), column(7, 1),
                column(8, 1), column(9, 1));
}

py::object ShapeOf(const py::object& given, const std::string& definition, const std::string& rule,
                   const GridArguments& place)
{
  const ThicknessFunction thicknessBy = ThicknessBy(rule);
  const Compared body = BodyOf(given, "body", place, MakerOf(definition));
  palpate_shape shape{};
  Numbers thickness(static_cast<py::ssize_t>(palpate_compared_point_count(body.get())));
  double* const thick = thickness.mutable_data();
  {
    const py::gil_scoped_release others;
    Call(palpate_compared_shape, body.get(), &shape);
    Call(thicknessBy, body.get(), thick);
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
      [](const py::object& body, const std::string& definition, const std::string& thickness,
         const py::object& spacing, const py::object& origin, const py::object& direction,
         const py::object& affine) {
        return ShapeOf(body, definition, thickness, {spacing, origin, direction, affine});
      },
      py::arg("body"), py::kw_only(), py::arg("definition") = "subvoxel",
      py::arg("thickness") = "spheres", py::arg("spacing") = py::none(),
      py::arg("origin") = py::none(), py::arg("direction") = py::none(),
      py::arg("affine") = py::none(),
      (std::string(
           "The shape features of the Image Biomarker Standardisation Initiative, principal axes, "
           "and the thickness at each point of the surface.\n\n"
           "body: as for compare; closed.\n"
           "definition: of masks, \"subvoxel\" for the shape behind their voxels, \"ibsi\" for the "
           "Initiative's own surface.\n"
           "thickness: \"spheres\", the largest ball that touches the surface there from inside, "
           "or \"rays\", the inward normal up to the opposite side; NaN where it finds none.\n") +
       GridHelp)
          .c_str());
  module.def(
      "calibre",
      [](const py::object& body, const std::string& definition, const py::object& spacing,
         const py::object& origin, const py::object& direction, const py::object& affine) {
        return CalibreOf(body, definition, {spacing, origin, direction, affine});
      },
      py::arg("body"), py::kw_only(), py::arg("definition") = "subvoxel",
      py::arg("spacing") = py::none(), py::arg("origin") = py::none(),
      py::arg("direction") = py::none(), py::arg("affine") = py::none(),
      (std::string("The axis of one long tube and its sections, a quarter of its mean diameter "
                   "apart.\n\n"
                   "body, definition: as for shape.\n") +
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
         bool mirror, const py::object& spacing, const py::object& origin,
         const py::object& direction, const py::object& affine) {
        return Compare(first, reference, tolerances, mirror, {spacing, origin, direction, affine});
      },
      py::arg("first"), py::arg("reference"), py::kw_only(), py::arg("tolerances") = py::none(),
      py::arg("mirror") = false, py::arg("spacing") = py::none(), py::arg("origin") = py::none(),
      py::arg("direction") = py::none(), py::arg("affine") = py::none(),
      "Compares two bodies: Dice, Jaccard, distances, normalised surface Dice, bias by side.\n\n"
      "first, reference: a Model; a mask (i, j, k), inside where not 0; a Mask, which has a grid "
      "of "
      "its own; or a mesh, as Mesh or (points, triangles). Distances from models are exact; what "
      "an "
      "open mesh has not is NaN.\n"
      "tolerances: mm, of the surface Dice; 1, 2 and 3 unless given.\n"
      "mirror: whether the reference is replaced by its mirror image at the sagittal plane, "
      "brought "
      "onto the first: left against right.\n"
      "spacing, origin, direction, affine: the grid of masks that are arrays, as for fit_mask.");
  module.def(
      "motion",
      [](const py::object& before, const py::object& after, const py::object& landmarks,
         const py::object& spacing, const py::object& origin, const py::object& direction,
         const py::object& affine) {
        return Motion(before, after, landmarks, {spacing, origin, direction, affine});
      },
      py::arg("before"), py::arg("after"), py::kw_only(), py::arg("landmarks") = py::none(),
      py::arg("spacing") = py::none(), py::arg("origin") = py::none(),
      py::arg("direction") = py::none(), py::arg("affine") = py::none(),
      (std::string("How a body moved as a whole, and what that leaves.\n\n"
                   "before, after: as for compare; masks count as the shapes behind their voxels.\n"
                   "landmarks: (n, 3), mm, on the body before: they move with it.\n") +
       GridHelp)
          .c_str());
}
} // namespace palpate
