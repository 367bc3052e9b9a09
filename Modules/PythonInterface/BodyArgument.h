#pragma once

#include "Arrays.h"
#include "Call.h"
#include "GridArray.h"

#include <pybind11/pybind11.h>

namespace palpate
{
using Compared = Owned<palpate_compared>;
/// Makes a body of a mask: palpate_compared_of_mask, or palpate_compared_of_mask_shape.
using MaskFunction = decltype(&palpate_compared_of_mask);

/// A Model, a Mask, a mesh (points and triangles), or an array: a mask on the grid of the call.
Compared BodyOf(const pybind11::object& given, const char* name, const GridArguments& place,
                MaskFunction make = palpate_compared_of_mask);

/// Its surface with a number at each point, as palpate.ComparedSurface.
pybind11::object SurfaceOf(const Compared& body, const Numbers& distances);
} // namespace palpate
