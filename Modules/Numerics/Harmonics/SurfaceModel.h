#pragma once

#include "ParametricSphericalSurface.h"
#include "SphericalHarmonicModel.h"

#include <cstddef>
#include <variant>
#include <vector>

namespace palpate
{
/// A surface of spherical harmonics, star-shaped or parametric (patient LPS, mm).
using SurfaceModel = std::variant<SphericalHarmonicModel, ParametricSphericalSurface>;

int DegreeOf(const SurfaceModel& model) noexcept;
/// Numbers that describe the shape; those of a parametric surface are three per harmonic.
std::size_t CoefficientCountOf(const SurfaceModel& model) noexcept;
/// The centre of a star-shaped model; the mean over the parameter sphere of a parametric one (mm).
Vector3 CenterOf(const SurfaceModel& model) noexcept;
/// Sum of squared coefficients (mm^2) of each degree 0..L, over the coordinates of a parametric
/// surface. Allocates.
std::vector<double> PowerSpectrumOf(const SurfaceModel& model);
} // namespace palpate
