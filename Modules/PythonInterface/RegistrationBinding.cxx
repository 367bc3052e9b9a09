#include "RegistrationBinding.h"

#include "Arrays.h"
#include "BodyArgument.h"
#include "Results.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace py = pybind11;

namespace palpate
{
namespace
{
int KindOf(const std::string& kind)
{
  const std::array<const char*, 3> kinds{"rigid", "similarity", "affine"};
  const auto found = std::find(kinds.begin(), kinds.end(), kind);
  if (found == kinds.end())
  {
    throw py::value_error("kind is \"rigid\", \"similarity\" or \"affine\"");
  }
  return static_cast<int>(found - kinds.begin());
}

Numbers MapOf(const palpate_registration& found)
{
  return Numbers(std::vector<py::ssize_t>{4, 4}, found.map);
}

py::object RegisterLandmarks(const py::object& givenMoving, const py::object& givenFixed,
                             const std::string& kind, double noise)
{
  const VectorArray moving(givenMoving, "moving");
  const VectorArray fixed(givenFixed, "fixed");
  if (moving.Count() != fixed.Count())
  {
    throw py::value_error("moving: there are " + std::to_string(moving.Count()) +
                          " landmarks for " + std::to_string(fixed.Count()) + " fixed ones");
  }
  Numbers residuals(static_cast<py::ssize_t>(moving.Count()));
  Numbers weights(static_cast<py::ssize_t>(moving.Count()));
  palpate_registration found{};
  Call(palpate_register_landmarks, moving.Data(), fixed.Data(), moving.Count(), KindOf(kind), noise,
       &found, residuals.mutable_data(), weights.mutable_data());
  return Result("LandmarkRegistration", MapOf(found), found.rms, found.turn_error,
                found.shift_error, residuals, weights);
}

// Sixteen numbers, or none.
Numbers StartOf(const py::object& given)
{
  const Numbers start(given.is_none() ? py::array(Numbers(0)) : RealArray(given, "start"));
  const bool isMatrix = start.ndim() == 2 && start.shape(0) == 4 && start.shape(1) == 4;
  if (!given.is_none() && !isMatrix)
  {
    throw py::value_error("start: the shape has to be (4, 4), and is " +
                          std::string(py::str(start.attr("shape"))));
  }
  return start;
}

const double* PlaceOf(const Numbers& start)
{
  return start.size() > 0 ? start.data() : nullptr;
}

py::object SurfaceResult(const palpate_registration& found)
{
  return Result("PointRegistration", MapOf(found), found.rms, found.median, found.turn_error,
                found.shift_error, found.has_converged != 0);
}

py::object RegisterPoints(const py::object& given, const py::object& givenSurface,
                          const std::string& kind, double noise, const py::object& givenStart,
                          const GridArguments& place)
{
  const VectorArray points(given, "points");
  const Numbers start = StartOf(givenStart);
  const int of = KindOf(kind);
  const Compared surface = BodyOf(givenSurface, "surface", place, palpate_compared_of_mask_shape);
  palpate_registration found{};
  {
    const double* const from = PlaceOf(start);
    const py::gil_scoped_release others;
    Call(palpate_register_points, points.Data(), points.Count(), surface.get(), of, noise, from,
         &found);
  }
  return SurfaceResult(found);
}

py::object RegisterBodies(const py::object& givenMoving, const py::object& givenFixed,
                          const std::string& kind, double noise, const py::object& givenStart,
                          const GridArguments& place)
{
  const Numbers start = StartOf(givenStart);
  const int of = KindOf(kind);
  const Compared moving = BodyOf(givenMoving, "moving", place, palpate_compared_of_mask_shape);
  const Compared fixed = BodyOf(givenFixed, "fixed", place, palpate_compared_of_mask_shape);
  palpate_registration found{};
  {
    const double* const from = PlaceOf(start);
    const py::gil_scoped_release others;
    Call(palpate_register_bodies, moving.get(), fixed.get(), of, noise, from, &found);
  }
  return SurfaceResult(found);
}
} // namespace

void BindRegistrations(py::module_& module)
{
  module.def(
      "register_landmarks", &RegisterLandmarks, py::arg("moving"), py::arg("fixed"), py::kw_only(),
      py::arg("kind") = "rigid", py::arg("noise") = 0.0,
      "The map that brings landmarks closest to their partners; pairs that were exchanged or "
      "misplaced count little, from eight pairs on.\n\n"
      "moving, fixed: (n, 3), mm, in the same order.\n"
      "kind: \"rigid\", \"similarity\" or \"affine\".\n"
      "noise: standard deviation of a coordinate, mm; 0: judged by what remains.");
  module.def(
      "register_points",
      [](const py::object& points, const py::object& surface, const std::string& kind, double noise,
         const py::object& start, const py::object& spacing, const py::object& origin,
         const py::object& direction, const py::object& affine)
      {
        return RegisterPoints(points, surface, kind, noise, start,
                              {spacing, origin, direction, affine});
      },
      py::arg("points"), py::arg("surface"), py::kw_only(), py::arg("kind") = "rigid",
      py::arg("noise") = 0.0, py::arg("start") = py::none(), py::arg("spacing") = py::none(),
      py::arg("origin") = py::none(), py::arg("direction") = py::none(),
      py::arg("affine") = py::none(),
      "The map that brings points onto a surface, from a start near it.\n\n"
      "points: (n, 3), mm; with 40 or more the predicted errors are honest.\n"
      "surface: a body as for compare; a mask counts as the shape behind its voxels.\n"
      "kind, noise: as for register_landmarks.\n"
      "start: (4, 4), such as a LandmarkRegistration's map; where they are unless given.\n"
      "spacing, origin, direction, affine: the grid of masks that are arrays, as for fit_mask.");
  module.def(
      "register_bodies",
      [](const py::object& moving, const py::object& fixed, const std::string& kind, double noise,
         const py::object& start, const py::object& spacing, const py::object& origin,
         const py::object& direction, const py::object& affine) {
        return RegisterBodies(moving, fixed, kind, noise, start,
                              {spacing, origin, direction, affine});
      },
      py::arg("moving"), py::arg("fixed"), py::kw_only(), py::arg("kind") = "rigid",
      py::arg("noise") = 0.0, py::arg("start") = py::none(), py::arg("spacing") = py::none(),
      py::arg("origin") = py::none(), py::arg("direction") = py::none(),
      py::arg("affine") = py::none(),
      "The map that brings a body onto another one, by points of its surface, as palpate "
      "register.\n\n"
      "moving, fixed: bodies as for compare; masks count as the shapes behind their voxels.\n"
      "kind, noise: as for register_landmarks.\n"
      "start: (4, 4); their centroids onto each other unless given.\n"
      "spacing, origin, direction, affine: the grid of masks that are arrays, as for fit_mask.");
}
} // namespace palpate
