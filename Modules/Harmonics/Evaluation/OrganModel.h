#pragma once

#include "RadialModel.h"
#include "SurfaceModel.h"

#include <cstddef>
#include <variant>
#include <vector>

namespace palpate
{
/// An organ's surface in spherical harmonics, of either kind (patient LPS, mm).
using OrganModel = std::variant<RadialModel, SurfaceModel>;

int DegreeOf(const OrganModel& model) noexcept;
/// Numbers that describe the shape; those of a surface model are three per harmonic.
std::size_t CoefficientCountOf(const OrganModel& model) noexcept;
/// The centre of a radial model; the mean over the parameter sphere of a surface model (mm).
Vector3 CenterOf(const OrganModel& model) noexcept;
/// Sum of squared coefficients (mm^2) of each degree 0..L, over the coordinates of a surface
/// surface. Allocates.
std::vector<double> PowerSpectrumOf(const OrganModel& model);
} // namespace palpate
