#pragma once

#include <array>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace palpate
{
/// Where the voxels of an array indexed [i, j, k] are (patient LPS, mm), as the C interface has it.
struct GridPlace
{
  std::array<int, 3> Size{};
  std::array<double, 3> Origin{};
  std::array<double, 3> Spacing{};
  std::array<double, 9> Axes{}; ///< row i: the unit vector of axis i
};

/// What Python gives to place an array: spacing, origin and direction (columns are the axes), or an
/// affine matrix (4, 4) from index to world; each may be None.
struct GridArguments
{
  pybind11::object Spacing;
  pybind11::object Origin;
  pybind11::object Direction;
  pybind11::object Affine;
};

/// The place of an array; ValueError or TypeError if it has not three dimensions, or for an affine
/// matrix next to the others.
GridPlace PlaceOfGrid(const pybind11::array& values, const char* name,
                      const GridArguments& arguments);

/// Reverses the first axis of an array and of its place if the axes are left-handed.
pybind11::array RightHanded(const pybind11::array& values, GridPlace& place);
} // namespace palpate
