#include "GridArray.h"

#include "Arrays.h"

#include <cmath>
#include <limits>
#include <string>

namespace py = pybind11;

namespace palpate
{
namespace
{
using Matrix = py::array_t<double, py::array::c_style | py::array::forcecast>;

Matrix SquareOf(const py::object& given, const char* name, py::ssize_t rows)
{
  const py::array array = RealArray(given, name);
  if (array.ndim() != 2 || array.shape(0) != rows || array.shape(1) != rows)
  {
    const std::string side = std::to_string(rows);
    throw py::value_error(std::string(name) + ": the shape has to be (" + side + ", " + side +
                          "), and is " + std::string(py::str(array.attr("shape"))));
  }
  return Matrix(array);
}

// Columns of the upper left 3 x 3 are the axes; `place.Axes` has them as rows.
void TakeAxes(const Matrix& columns, GridPlace& place)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int coordinate = 0; coordinate < 3; ++coordinate)
    {
      place.Axes[static_cast<std::size_t>(3 * axis + coordinate)] = columns.at(coordinate, axis);
    }
  }
}

void TakeAffine(const py::object& given, GridPlace& place)
{
  const Matrix affine = SquareOf(given, "affine", 4);
  TakeAxes(affine, place);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    double* const row = &place.Axes[3 * axis];
    const double length = std::hypot(row[0], row[1], row[2]);
    place.Spacing[axis] = length;
    place.Origin[axis] = affine.at(static_cast<py::ssize_t>(axis), 3);
    for (int coordinate = 0; coordinate < 3; ++coordinate)
    {
      row[coordinate] /= length;
    }
  }
}

bool IsLeftHanded(const std::array<double, 9>& a)
{
  const double determinant = a[0] * (a[4] * a[8] - a[5] * a[7]) -
                             a[1] * (a[3] * a[8] - a[5] * a[6]) +
                             a[2] * (a[3] * a[7] - a[4] * a[6]);
  return determinant < 0.0;
}
} // namespace

GridPlace PlaceOfGrid(const py::array& values, const char* name, const GridArguments& arguments)
{
  if (values.ndim() != 3)
  {
    throw py::value_error(std::string(name) + ": the shape has to be (i, j, k), and is " +
                          std::string(py::str(values.attr("shape"))));
  }
  GridPlace place{{}, {}, {1.0, 1.0, 1.0}, {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}};
  for (int axis = 0; axis < 3; ++axis)
  {
    if (values.shape(axis) > std::numeric_limits<int>::max())
    {
      throw py::value_error(std::string(name) + ": an axis has too many voxels");
    }
    place.Size[static_cast<std::size_t>(axis)] = static_cast<int>(values.shape(axis));
  }
  const auto& [spacing, origin, direction, affine] = arguments;
  if (!affine.is_none())
  {
    if (!spacing.is_none() || !origin.is_none() || !direction.is_none())
    {
      throw py::value_error("give an affine matrix, or spacing, origin and direction, not both");
    }
    TakeAffine(affine, place);
    return place;
  }
  place.Spacing = spacing.is_none() ? place.Spacing : TripleOf(spacing, "spacing");
  place.Origin = origin.is_none() ? place.Origin : TripleOf(origin, "origin");
  if (!direction.is_none())
  {
    TakeAxes(SquareOf(direction, "direction", 3), place);
  }
  return place;
}

py::array RightHanded(const py::array& values, GridPlace& place)
{
  if (!IsLeftHanded(place.Axes))
  {
    return values;
  }
  for (std::size_t coordinate = 0; coordinate < 3; ++coordinate)
  {
    place.Origin[coordinate] += (place.Size[0] - 1) * place.Spacing[0] * place.Axes[coordinate];
    place.Axes[coordinate] = -place.Axes[coordinate];
  }
  return py::array(values[py::slice(py::none(), py::none(), py::int_(-1))]);
}
} // namespace palpate
