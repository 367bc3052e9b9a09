#include "CorrectionBinding.h"

#include "Arrays.h"
#include "GridArray.h"
#include "ModelBinding.h"
#include "Results.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace palpate
{
namespace
{
using CorrectionBytes = py::array_t<bool, py::array::f_style | py::array::forcecast>;

// palpate.Correction.
struct BoundCorrection
{
  Owned<palpate_correction> Handle;
  std::array<int, 3> Size{}; // of a mask
};

BoundCorrection CorrectMask(const py::object& given, const py::object& barrier,
                            const GridArguments& place)
{
  const py::array array = RealArray(given, "start");
  const GridPlace grid = PlaceOfGrid(array, "start", place);
  const CorrectionBytes inside(array);
  std::optional<CorrectionBytes> closed;
  if (!barrier.is_none())
  {
    const py::array values = RealArray(barrier, "barrier");
    if (values.ndim() != 3 || !std::equal(grid.Size.begin(), grid.Size.end(), values.shape()))
    {
      throw py::value_error("barrier: the shape has to be that of the mask");
    }
    closed.emplace(values);
  }
  const auto bytes = [](const CorrectionBytes& voxels)
  { return reinterpret_cast<const std::uint8_t*>(voxels.data()); };
  const std::uint8_t* const wall = closed ? bytes(*closed) : nullptr;
  return {Owned<palpate_correction>(Call(palpate_correction_of_mask, bytes(inside), wall,
                                         grid.Size.data(), grid.Origin.data(), grid.Spacing.data(),
                                         grid.Axes.data())),
          grid.Size};
}

BoundCorrection CorrectStart(const py::object& start, const py::object& barrier,
                             const GridArguments& place)
{
  if (py::isinstance<BoundModel>(start))
  {
    const auto& model = start.cast<const BoundModel&>();
    return {Owned<palpate_correction>(Call(palpate_correction_of_model, model.Handle.get())), {}};
  }
  return CorrectMask(start, barrier, place);
}

palpate_pull GivenPull(const py::object& place, const std::optional<double>& by,
                       const py::object& to, const py::object& width)
{
  if (by.has_value() != to.is_none())
  {
    throw py::value_error("give a displacement, by, or a target, to");
  }
  palpate_pull pull{};
  const auto copy = [](const std::array<double, 3>& from, double* into)
  { std::copy(from.begin(), from.end(), into); };
  copy(TripleOf(place, "place"), pull.place);
  pull.displacement = by.value_or(0.0);
  if (!to.is_none())
  {
    pull.has_target = 1;
    copy(TripleOf(to, "to"), pull.target);
  }
  const Numbers widths(RealArray(width, "width"));
  if (widths.size() < 1 || widths.size() > 2)
  {
    throw py::value_error("width: one number, or two");
  }
  pull.width = widths.data()[0];
  pull.second_width = widths.size() == 2 ? widths.data()[1] : 0.0;
  return pull;
}

// Counts of points and triangles.
std::array<std::size_t, 2> CountsOf(const BoundCorrection& correction)
{
  std::array<std::size_t, 2> counts{};
  Call(palpate_correction_surface, correction.Handle.get(), &counts[0], &counts[1], nullptr,
       nullptr, nullptr, nullptr);
  return counts;
}

py::object SurfaceMesh(const BoundCorrection& correction)
{
  auto counts = CountsOf(correction);
  Numbers points(std::vector<py::ssize_t>{static_cast<py::ssize_t>(counts[0]), 3});
  Numbers normals(std::vector<py::ssize_t>{static_cast<py::ssize_t>(counts[0]), 3});
  py::array_t<std::int32_t> triangles(
      std::vector<py::ssize_t>{static_cast<py::ssize_t>(counts[1]), 3});
  Call(palpate_correction_surface, correction.Handle.get(), &counts[0], &counts[1],
       points.mutable_data(), normals.mutable_data(), nullptr, triangles.mutable_data());
  return Result("Mesh", points, normals, triangles);
}

Numbers CorrectionDisplacements(const BoundCorrection& correction)
{
  auto counts = CountsOf(correction);
  Numbers displacements(std::vector<py::ssize_t>{static_cast<py::ssize_t>(counts[0]), 3});
  Call(palpate_correction_surface, correction.Handle.get(), &counts[0], &counts[1], nullptr,
       nullptr, displacements.mutable_data(), nullptr);
  return displacements;
}

Numbers PreviewPull(const BoundCorrection& correction, const palpate_pull& pull)
{
  Numbers displacements(
      std::vector<py::ssize_t>{static_cast<py::ssize_t>(CountsOf(correction)[0]), 3});
  Call(palpate_correction_preview, correction.Handle.get(), &pull, displacements.mutable_data());
  return displacements;
}

CorrectionBytes MaskNow(const BoundCorrection& correction)
{
  const auto& [i, j, k] = correction.Size;
  CorrectionBytes inside(std::vector<py::ssize_t>{i, j, k});
  Call(palpate_correction_mask, correction.Handle.get(),
       reinterpret_cast<std::uint8_t*>(inside.mutable_data()));
  return inside;
}

using CorrectionClass = py::class_<BoundCorrection>;

void AddPulls(CorrectionClass& type)
{
  type.def(
          "pull",
          [](BoundCorrection& correction, const py::object& place, const std::optional<double>& by,
             const py::object& to, const py::object& width)
          {
            const palpate_pull pull = GivenPull(place, by, to, width);
            Call(palpate_correction_pull, correction.Handle.get(), &pull);
          },
          py::arg("place"), py::arg("by") = py::none(), py::kw_only(), py::arg("to") = py::none(),
          py::arg("width") = 8.0,
          "Pulls the surface at its point, as it is now, that is nearest to a place (3,), mm.\n\n"
          "by: mm outwards, inwards below 0; or to: (3,), where that point goes. width: mm, the "
          "standard deviation of the Gaussian along the surface, or two of which the mean is "
          "taken. Former pulls' places stay, but for those within half the width.")
      .def(
          "preview",
          [](const BoundCorrection& correction, const py::object& place,
             const std::optional<double>& by, const py::object& to, const py::object& width)
          { return PreviewPull(correction, GivenPull(place, by, to, width)); },
          py::arg("place"), py::arg("by") = py::none(), py::kw_only(), py::arg("to") = py::none(),
          py::arg("width") = 8.0, "The displacements, (n, 3), mm, if this pull were added.")
      .def(
          "undo",
          [](BoundCorrection& correction)
          { return palpate_correction_undo(correction.Handle.get()) != 0; },
          "Removes the last step; False if there is none.");
}

void AddEdits(CorrectionClass& type)
{
  type.def(
          "remove_islands",
          [](BoundCorrection& correction)
          { Call(palpate_correction_remove_islands, correction.Handle.get()); },
          "Removes all but the largest part of the mask.")
      .def(
          "fill",
          [](BoundCorrection& correction)
          { Call(palpate_correction_fill, correction.Handle.get()); },
          "Fills the cavities of the mask.")
      .def(
          "smooth",
          [](BoundCorrection& correction, double deviation)
          { Call(palpate_correction_smooth, correction.Handle.get(), deviation); },
          py::arg("deviation"), "Smooths the mask by a Gaussian, mm; its size stays.")
      .def(
          "cut",
          [](BoundCorrection& correction, const py::object& point, const py::object& normal)
          {
            Call(palpate_correction_cut, correction.Handle.get(), TripleOf(point, "point").data(),
                 TripleOf(normal, "normal").data());
          },
          py::arg("point"), py::arg("normal"),
          "Removes what lies beyond a plane, where its normal (3,) points to.");
}
} // namespace

void BindCorrections(py::module_& module)
{
  CorrectionClass type(module, "Correction",
                       "A mask or a model under correction: a function of the start and the list "
                       "of steps.");
  type.def(py::init(
               [](const py::object& start, const py::object& barrier, const py::object& spacing,
                  const py::object& origin, const py::object& direction, const py::object& affine) {
                 return CorrectStart(start, barrier, {spacing, origin, direction, affine});
               }),
           py::arg("start"), py::kw_only(), py::arg("barrier") = py::none(),
           py::arg("spacing") = py::none(), py::arg("origin") = py::none(),
           py::arg("direction") = py::none(), py::arg("affine") = py::none(),
           "start: a Model, or a mask (i, j, k), inside where not 0. barrier: as the mask; pulls "
           "add no voxel where it is not 0.\n"
           "spacing, origin, direction, affine: of a mask, as those of fit_mask.");
  AddPulls(type);
  AddEdits(type);
  type.def_property_readonly("surface", &SurfaceMesh,
                             "Mesh before the pulls since the last edit; its normals are rays of a "
                             "radial model.")
      .def_property_readonly("displacements", &CorrectionDisplacements,
                             "(n, 3), mm: of the surface's points, by the pulls.")
      .def_property_readonly("mask", &MaskNow, "(i, j, k), bool: the corrected mask.")
      .def_property_readonly(
          "model",
          [](const BoundCorrection& correction)
          {
            return BoundModel{
                Owned<palpate_model>(Call(palpate_correction_model, correction.Handle.get()))};
          },
          "The corrected Model.");
}
} // namespace palpate
