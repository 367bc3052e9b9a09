#include "Arrays.h"

#include <algorithm>
#include <string>

namespace py = pybind11;

namespace palpate
{
namespace
{
std::string ShapeText(const py::array& array)
{
  return py::str(array.attr("shape"));
}

[[noreturn]] void RefuseShape(const char* name, const char* wanted, const py::array& array)
{
  throw py::value_error(std::string(name) + ": the shape has to be " + wanted + ", and is " +
                        ShapeText(array));
}
} // namespace

py::array RealArray(const py::object& given, const char* name)
{
  const py::array array = py::array::ensure(given);
  if (!array)
  {
    PyErr_Clear();
    throw py::type_error(std::string(name) + ": an array of real numbers is needed");
  }
  // Booleans, integers and floating point.
  if (std::string("biuf").find(array.dtype().kind()) == std::string::npos)
  {
    throw py::type_error(std::string(name) + ": an array of real numbers is needed, not of dtype " +
                         std::string(py::str(array.dtype())));
  }
  return array;
}

VectorArray::VectorArray(const py::object& given, const char* name)
{
  const py::array array = RealArray(given, name);
  this->IsSingle = array.ndim() == 1;
  if (array.ndim() < 1 || array.ndim() > 2 || array.shape(array.ndim() - 1) != 3)
  {
    RefuseShape(name, "(n, 3), or (3,) for one", array);
  }
  this->Vectors = this->IsSingle ? 1 : array.shape(0);
  this->Values = py::array_t<double, py::array::c_style | py::array::forcecast>(array);
}

std::array<double, 3> TripleOf(const py::object& given, const char* name)
{
  const py::array array = RealArray(given, name);
  if (array.ndim() != 1 || array.shape(0) != 3)
  {
    RefuseShape(name, "(3,)", array);
  }
  std::array<double, 3> triple{};
  const py::array_t<double, py::array::c_style | py::array::forcecast> values(array);
  std::copy_n(values.data(), 3, triple.begin());
  return triple;
}

std::vector<std::int32_t> TrianglesOf(const py::object& given, std::size_t pointCount)
{
  const py::array array = RealArray(given, "triangles");
  if (array.dtype().kind() != 'i' && array.dtype().kind() != 'u')
  {
    throw py::type_error("triangles: indices are integers, not of dtype " +
                         std::string(py::str(array.dtype())));
  }
  if (array.ndim() != 2 || array.shape(1) != 3)
  {
    RefuseShape("triangles", "(m, 3)", array);
  }
  const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> wide(array);
  std::vector<std::int32_t> triangles;
  triangles.reserve(static_cast<std::size_t>(wide.size()));
  for (py::ssize_t i = 0; i < wide.size(); ++i)
  {
    const std::int64_t index = wide.data()[i];
    if (index < 0 || static_cast<std::size_t>(index) >= pointCount)
    {
      throw py::value_error("triangles: index " + std::to_string(index) + " is not of one of the " +
                            std::to_string(pointCount) + " points");
    }
    triangles.push_back(static_cast<std::int32_t>(index));
  }
  return triangles;
}
} // namespace palpate
