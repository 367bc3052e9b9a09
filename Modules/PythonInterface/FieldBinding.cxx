#include "FieldBinding.h"

#include "Arrays.h"
#include "GridArray.h"

namespace py = pybind11;

namespace palpate
{
namespace
{
BoundField CreateField(const py::object& given, double iso, const GridArguments& arguments)
{
  const py::array array = RealArray(given, "values");
  GridPlace grid = PlaceOfGrid(array, "values", arguments);
  const py::array_t<float, py::array::f_style | py::array::forcecast> values(
      RightHanded(array, grid));
  const float* const numbers = values.data();
  const py::gil_scoped_release others;
  return {Owned<palpate_field>(Call(palpate_field_create, grid.Size.data(), grid.Origin.data(),
                                    grid.Spacing.data(), grid.Axes.data(), numbers, iso))};
}

py::array_t<bool> Contains(const BoundField& field, const py::object& given)
{
  const VectorArray points(given, "points");
  auto results = points.Results<bool>();
  bool* const inside = results.mutable_data();
  {
    const py::gil_scoped_release others;
    for (std::size_t i = 0; i < points.Count(); ++i)
    {
      inside[i] = palpate_field_is_inside(field.Handle.get(), points.Data() + 3 * i) != 0;
    }
  }
  return results;
}
} // namespace

void BindFields(py::module_& module)
{
  py::class_<BoundField>(module, "Field",
                         "A volume as it is touched, between voxels: the object is where values "
                         "(i, j, k) are at least `iso`.\n\n"
                         "Placed as by fit_mask, in mm, patient LPS.")
      .def(py::init(
               [](const py::object& values, double iso, const py::object& spacing,
                  const py::object& origin, const py::object& direction, const py::object& affine) {
                 return CreateField(values, iso, {spacing, origin, direction, affine});
               }),
           py::arg("values"), py::arg("iso"), py::kw_only(), py::arg("spacing") = py::none(),
           py::arg("origin") = py::none(), py::arg("direction") = py::none(),
           py::arg("affine") = py::none())
      .def("contains", &Contains, py::arg("points"),
           "(n,) of bool: whether points (n, 3), mm, are inside the object.");
}
} // namespace palpate
