#pragma once

#include "ModelDocument.h"

#include <string>

namespace palpate
{
/// SPHARM-PDM's `.coef` text, `{ N,{x, y, z},` and so on to a closing brace: N = (L+1)^2 rows of
/// the three coordinates' coefficients in mm, in the row order and scale of ToSpharmPdm.
///
/// Frame: the format states none. SPHARM-PDM fits the coefficients to the points of its VTK
/// surfaces, which are RAS, so x and y change sign on reading and writing; this half turn preserves
/// orientation and digits.
///
/// A star-shaped model is written as the equal parametric surface of one degree more
/// (ParametricSphericalSurface::FromModel). The format has no centre and no provenance, and reading
/// always gives a parametric surface. Numbers are written in full precision, while SPHARM-PDM
/// itself writes six decimals; its reader accepts both.
/// Throws InputError if a number is not finite; `fileName` is used in messages.
std::string SurfaceToSpharmPdm(const SurfaceModel& surface, const std::string& fileName);

/// The surface of such a text. Throws InputError for any other text.
ParametricSphericalSurface SurfaceFromSpharmPdm(const std::string& text,
                                                const std::string& fileName);
} // namespace palpate
