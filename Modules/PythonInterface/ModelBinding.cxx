#include "ModelBinding.h"

#include "Arrays.h"
#include "GridArray.h"
#include "Results.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <vector>

namespace py = pybind11;

namespace palpate
{
namespace
{
// (degree + 1)^2 for some degree; else ValueError.
int DegreeOfCount(py::ssize_t count)
{
  const int degree = static_cast<int>(std::lround(std::sqrt(static_cast<double>(count)))) - 1;
  if (degree < 0 || static_cast<py::ssize_t>(degree + 1) * (degree + 1) != count)
  {
    throw py::value_error("coefficients: there have to be (degree + 1)^2 of them for each radius "
                          "or coordinate, and there are " +
                          std::to_string(count));
  }
  return degree;
}

BoundModel CreateModel(const py::object& given, const py::object& center)
{
  const py::array array = RealArray(given, "coefficients");
  const py::array_t<double, py::array::c_style | py::array::forcecast> values(array);
  if (array.ndim() == 2 && array.shape(0) == 3)
  {
    const int degree = DegreeOfCount(array.shape(1));
    return {Owned<palpate_model>(Call(palpate_model_create_surface, degree, values.data()))};
  }
  if (array.ndim() != 1)
  {
    throw py::value_error("coefficients: the shape has to be (n,), or (3, n) for three "
                          "coordinates, and is " +
                          std::string(py::str(array.attr("shape"))));
  }
  const auto middle = center.is_none() ? std::array<double, 3>{} : TripleOf(center, "center");
  const int degree = DegreeOfCount(array.shape(0));
  return {Owned<palpate_model>(Call(palpate_model_create, degree, values.data(), middle.data()))};
}

BoundModel FitPoints(const py::object& given, int degree, const py::object& center)
{
  const VectorArray points(given, "points");
  std::array<double, 3> middle{};
  if (center.is_none())
  {
    for (std::size_t i = 0; i < 3 * points.Count(); ++i)
    {
      middle[i % 3] += points.Data()[i] / static_cast<double>(points.Count());
    }
  }
  else
  {
    middle = TripleOf(center, "center");
  }
  const py::gil_scoped_release others;
  return {Owned<palpate_model>(
      Call(palpate_model_fit, points.Data(), points.Count(), middle.data(), degree))};
}

py::object Complete(const py::object& givenPoints, const py::object& givenNormals,
                    const std::optional<std::filesystem::path>& prior, double sigma,
                    const py::object& center, const py::object& givenStrokes,
                    const py::object& givenOutside, const BoundModel* known)
{
  constexpr int DeviationFrequency = 8;
  const VectorArray points(givenPoints, "points");
  std::optional<VectorArray> normals;
  if (!givenNormals.is_none())
  {
    normals.emplace(givenNormals, "normals");
  }
  py::array_t<std::int32_t, py::array::c_style | py::array::forcecast> strokes;
  if (!givenStrokes.is_none())
  {
    strokes = decltype(strokes)(RealArray(givenStrokes, "strokes"));
  }
  py::array_t<bool, py::array::c_style | py::array::forcecast> outside;
  if (!givenOutside.is_none())
  {
    outside = decltype(outside)(RealArray(givenOutside, "outside"));
  }
  const auto isOther = [&points](std::size_t count) { return count != points.Count(); };
  if ((normals && isOther(normals->Count())) ||
      (!givenStrokes.is_none() && isOther(static_cast<std::size_t>(strokes.size()))) ||
      (!givenOutside.is_none() && isOther(static_cast<std::size_t>(outside.size()))))
  {
    throw py::value_error("normals, strokes and outside: there has to be one for each point");
  }
  const auto middle = center.is_none() ? std::array<double, 3>{} : TripleOf(center, "center");
  const std::string file = prior ? prior->string() : std::string();
  Numbers deviations(static_cast<py::ssize_t>(palpate_mesh_point_count(DeviationFrequency)));
  Numbers next(std::vector<py::ssize_t>{6, 3});
  double* const deviation = deviations.mutable_data();
  double* const places = next.mutable_data();
  const std::int32_t* const numbers = givenStrokes.is_none() ? nullptr : strokes.data();
  const auto* const beyond =
      givenOutside.is_none() ? nullptr : reinterpret_cast<const std::uint8_t*>(outside.data());
  BoundModel model;
  {
    const py::gil_scoped_release others;
    model.Handle.reset(Call(palpate_complete_organ, points.Data(),
                            normals ? normals->Data() : nullptr, numbers, beyond, points.Count(),
                            prior ? file.c_str() : nullptr, sigma,
                            center.is_none() ? nullptr : middle.data(),
                            known != nullptr ? known->Handle.get() : nullptr, deviation, places));
  }
  return Result("Completion", std::move(model), deviations, next);
}

void Deprecated(const std::string& message)
{
  if (PyErr_WarnEx(PyExc_DeprecationWarning, message.c_str(), 1) != 0)
  {
    throw py::error_already_set();
  }
}

// Up to version 0.2 the kinds had other names.
bool IsRadialKind(const std::string& kind)
{
  const bool isFormerRadial = kind == "star-shaped";
  if (isFormerRadial || kind == "parametric")
  {
    Deprecated("kind='" + kind + "' is now kind='" + (isFormerRadial ? "radial" : "surface") + "'");
    return isFormerRadial;
  }
  if (kind != "surface" && kind != "radial")
  {
    throw py::value_error("kind: has to be 'surface' or 'radial', and is '" + kind + "'");
  }
  return kind == "radial";
}

BoundModel FitToMask(const py::object& given, int degree, const std::string& kind,
                     const GridArguments& place)
{
  const bool isRadial = IsRadialKind(kind);
  const py::array array = RealArray(given, "mask");
  const GridPlace grid = PlaceOfGrid(array, "mask", place);
  const py::array_t<bool, py::array::f_style | py::array::forcecast> inside(array);
  static_assert(sizeof(bool) == 1, "NumPy's booleans are bytes");
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(inside.data());
  const py::gil_scoped_release others;
  return {
      Owned<palpate_model>(Call(palpate_model_fit_mask, bytes, grid.Size.data(), grid.Origin.data(),
                                grid.Spacing.data(), grid.Axes.data(), degree, isRadial ? 1 : 0))};
}

BoundModel ReadGivenModel(const std::filesystem::path& path)
{
  const std::string name = path.string();
  const py::gil_scoped_release others;
  return {Owned<palpate_model>(Call(palpate_model_read, name.c_str()))};
}

void WriteGivenModel(const BoundModel& model, const std::filesystem::path& path)
{
  const std::string name = path.string();
  const py::gil_scoped_release others;
  Call(palpate_model_write, model.Handle.get(), name.c_str());
}

void Evaluate(const BoundModel& model, const VectorArray& directions,
              const palpate_evaluation& results)
{
  const py::gil_scoped_release others;
  Call(palpate_model_evaluate, model.Handle.get(), directions.Data(), directions.Count(), &results);
}

// One array of results, of this shape for each direction.
Numbers EvaluateOne(const BoundModel& model, const py::object& given,
                    double* palpate_evaluation::*wanted, const std::vector<py::ssize_t>& shape)
{
  const VectorArray directions(given, "directions");
  auto array = directions.Results(shape);
  palpate_evaluation results{};
  results.*wanted = array.mutable_data();
  Evaluate(model, directions, results);
  return array;
}

py::object Curvature(const BoundModel& model, const py::object& given)
{
  const VectorArray directions(given, "directions");
  auto mean = directions.Results();
  auto gaussian = directions.Results();
  auto principal = directions.Results({2});
  auto tangents = directions.Results({2, 3});
  palpate_evaluation results{};
  results.mean_curvatures = mean.mutable_data();
  results.gaussian_curvatures = gaussian.mutable_data();
  results.principal_curvatures = principal.mutable_data();
  results.principal_directions = tangents.mutable_data();
  Evaluate(model, directions, results);
  return Result("Curvature", mean, gaussian, principal, tangents);
}

py::object Nearest(const BoundModel& model, const py::object& given)
{
  const VectorArray queries(given, "points");
  auto points = queries.Results({3});
  auto normals = queries.Results({3});
  auto distances = queries.Results();
  double* const point = points.mutable_data();
  double* const normal = normals.mutable_data();
  double* const distance = distances.mutable_data();
  {
    const py::gil_scoped_release others;
    for (std::size_t i = 0; i < queries.Count(); ++i)
    {
      Call(palpate_model_nearest, model.Handle.get(), queries.Data() + 3 * i, point + 3 * i,
           normal + 3 * i, distance + i);
    }
  }
  return Result("Nearest", points, normals, distances);
}

py::object Mesh(const BoundModel& model, int frequency)
{
  const auto count = static_cast<py::ssize_t>(palpate_mesh_point_count(frequency));
  const auto faces = static_cast<py::ssize_t>(palpate_mesh_triangle_count(frequency));
  Numbers points(std::vector<py::ssize_t>{count, 3});
  Numbers normals(std::vector<py::ssize_t>{count, 3});
  py::array_t<std::int32_t> triangles(std::vector<py::ssize_t>{faces, 3});
  double* const point = points.mutable_data();
  double* const normal = normals.mutable_data();
  std::int32_t* const triangle = triangles.mutable_data();
  {
    const py::gil_scoped_release others;
    Call(palpate_model_mesh, model.Handle.get(), frequency, point, normal, triangle);
  }
  return Result("Mesh", points, normals, triangles);
}

py::object Measures(const BoundModel& model)
{
  palpate_body body{};
  {
    const py::gil_scoped_release others;
    Call(palpate_model_body, model.Handle.get(), &body);
  }
  Numbers axes(std::vector<py::ssize_t>{3, 3});
  std::copy_n(body.axes, 9, axes.mutable_data());
  return Result("Measures", body.volume, body.area, Numbers(3, body.centroid),
                Numbers(3, body.semi_axes), axes);
}

Numbers Spectrum(const BoundModel& model)
{
  Numbers powers(palpate_model_degree(model.Handle.get()) + 1);
  Call(palpate_model_spectrum, model.Handle.get(), powers.mutable_data());
  return powers;
}

Numbers Coefficients(const BoundModel& model)
{
  const auto count = palpate_model_coefficients(model.Handle.get(), nullptr, 0);
  const bool isRadial = palpate_model_is_radial(model.Handle.get()) != 0;
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(count)};
  if (!isRadial)
  {
    shape = {3, static_cast<py::ssize_t>(count / 3)};
  }
  Numbers values(shape);
  palpate_model_coefficients(model.Handle.get(), values.mutable_data(), count);
  return values;
}

Numbers Center(const BoundModel& model)
{
  Numbers center(3);
  palpate_model_center(model.Handle.get(), center.mutable_data());
  return center;
}

std::string Representation(const BoundModel& model)
{
  const palpate_model* handle = model.Handle.get();
  return std::string("<palpate.Model: ") +
         (palpate_model_is_radial(handle) != 0 ? "radial" : "surface") + ", degree " +
         std::to_string(palpate_model_degree(handle)) +
         (palpate_model_yields(handle) != 0 ? ", yields>" : ">");
}

using ModelClass = py::class_<BoundModel>;

void AddProperties(ModelClass& type)
{
  type.def_property_readonly(
          "degree",
          [](const BoundModel& model) { return palpate_model_degree(model.Handle.get()); },
          "Degree of the spherical harmonics.")
      .def_property_readonly(
          "is_radial",
          [](const BoundModel& model) { return palpate_model_is_radial(model.Handle.get()) != 0; },
          "Whether the model is a radius around a centre; else it is three coordinates.")
      .def_property_readonly(
          "is_star_shaped",
          [](const BoundModel& model)
          {
            Deprecated("is_star_shaped is now is_radial");
            return palpate_model_is_radial(model.Handle.get()) != 0;
          },
          "The former name of is_radial.")
      .def_property_readonly(
          "yields",
          [](const BoundModel& model) { return palpate_model_yields(model.Handle.get()) != 0; },
          "Whether the model has an elasticity, which its file brings.")
      .def_property_readonly("coefficients", &Coefficients,
                             "A copy, mm: (n,), or (3, n) of a surface model, at l (l + 1) + m; "
                             "real, orthonormal, without the Condon-Shortley phase.")
      .def_property_readonly("center", &Center,
                             "(3,), mm: the centre, or the mean of a surface model.");
}

void AddEvaluations(ModelClass& type)
{
  type.def(
          "points",
          [](const BoundModel& model, const py::object& directions)
          { return EvaluateOne(model, directions, &palpate_evaluation::points, {3}); },
          py::arg("directions"),
          "(n, 3), mm: points of the surface along directions (n, 3) from the centre, or at these "
          "parameters; directions have any length.")
      .def(
          "normals",
          [](const BoundModel& model, const py::object& directions)
          { return EvaluateOne(model, directions, &palpate_evaluation::normals, {3}); },
          py::arg("directions"), "(n, 3): unit normals of the surface, outwards.")
      .def(
          "radii",
          [](const BoundModel& model, const py::object& directions)
          { return EvaluateOne(model, directions, &palpate_evaluation::radii, {}); },
          py::arg("directions"), "(n,), mm: radii of a radial model.")
      .def(
          "gradients",
          [](const BoundModel& model, const py::object& directions)
          { return EvaluateOne(model, directions, &palpate_evaluation::gradients, {3}); },
          py::arg("directions"),
          "(n, 3), mm/rad: gradients of a radial model's radius over the unit sphere.")
      .def("curvature", &Curvature, py::arg("directions"),
           "Curvature of the surface; a sphere of radius a has the mean curvature 1/a.")
      .def("nearest", &Nearest, py::arg("points"),
           "The surface's points nearest to points (n, 3), mm. The first call prepares the search, "
           "which may take seconds for a surface model.")
      .def("mesh", &Mesh, py::arg("frequency") = 20, "A closed mesh of 10 frequency^2 + 2 points.")
      .def("measures", &Measures, "Volume, area, centroid and semi-axes.")
      .def("spectrum", &Spectrum,
           "(degree + 1,), mm^2: sum of the squared coefficients of each degree.")
      .def("write", &WriteGivenModel, py::arg("path"),
           "Writes a .json, a .coef (SPHARM-PDM; always a surface model) or a .csv.");
}
} // namespace

void BindModels(py::module_& module)
{
  ModelClass type(module, "Model",
                  "An organ's surface as spherical harmonics, in mm, patient LPS. Immutable.\n\n"
                  "coefficients: (n,) of a radius around `center`, or (3, n) of three coordinates, "
                  "with n = (degree + 1)^2.");
  type.def(py::init(&CreateModel), py::arg("coefficients"), py::arg("center") = py::none())
      .def("__repr__", &Representation);
  AddProperties(type);
  AddEvaluations(type);
  module.def("fit_points", &FitPoints, py::arg("points"), py::arg("degree") = 12,
             py::arg("center") = py::none(),
             "Fits a radial model to points (n, 3) of a surface, mm, by least squares.\n\n"
             "center: (3,), inside; the mean of the points unless given.");
  module.def(
      "complete", &Complete, py::arg("points"), py::arg("normals") = py::none(),
      py::arg("prior") = py::none(), py::arg("sigma") = 1.0, py::arg("center") = py::none(),
      py::kw_only(), py::arg("strokes") = py::none(), py::arg("outside") = py::none(),
      py::arg("known") = py::none(),
      "Completes an organ's surface from a few touched points (n, 3), mm.\n\n"
      "normals: (n, 3), 0 for a point without. prior: a file of palpate cohort --prior; else "
      "the organ is smooth.\n"
      "sigma: standard deviation of the points, mm. center: (3,), near the organ's; the "
      "middle of the points unless given.\n"
      "strokes: (n,): points of the same number above 0 share an offset. outside: (n,), "
      "bool: the organ does not reach that far.\n"
      "known: the model of the other organ that a prior of palpate cohort --known relates to. With "
      "a prior of surface models, normals point outwards.");
  module.def(
      "fit_mask",
      [](const py::object& mask, int degree, const std::string& kind, const py::object& spacing,
         const py::object& origin, const py::object& direction, const py::object& affine) {
        return FitToMask(mask, degree, kind, {spacing, origin, direction, affine});
      },
      py::arg("mask"), py::arg("degree") = 20, py::arg("kind") = "surface", py::kw_only(),
      py::arg("spacing") = py::none(), py::arg("origin") = py::none(),
      py::arg("direction") = py::none(), py::arg("affine") = py::none(),
      "Fits a model to a mask (i, j, k), inside where not 0. Small parts that are far from the "
      "largest are left out.\n\n"
      "kind: 'surface' for any shape, or 'radial' for star-shaped ones.\n"
      "spacing: (3,), mm. origin: (3,), mm, of the centre of voxel 0, 0, 0. direction: (3, 3), "
      "whose columns are the axes.\n"
      "affine: (4, 4) instead, from index to mm in patient LPS.");
  module.def("read_model", &ReadGivenModel, py::arg("path"),
             "Reads a model from Palpate's .json or SPHARM-PDM's .coef.");
}
} // namespace palpate
