#pragma once

#include "ModelDocument.h"
#include "PalpateIOModule.h"

#include <string>

namespace palpate
{
/// SPHARM-PDM's `.coef` text, `{ N,{x, y, z},` and so on to a closing brace: N = (L+1)^2 rows of
/// the three coordinates' coefficients in mm, in the row order and scale of ToSpharmPdm.
///
/// Frame: the format states none. SPHARM-PDM fits the coefficients to the points of its VTK
/// surfaces, which are RAS, so x and y change their sign on the way in and out; that is a half turn
/// and keeps orientation and digits.
///
/// A star-shaped model is written as the parametric surface of one degree more that is equal to it
/// (ParametricSphericalSurface::FromModel). The format has no room for a centre or for provenance,
/// and what is read is always parametric. Numbers are written with all digits that their doubles
/// need, where SPHARM-PDM itself writes six decimals; its reader takes both.
/// Throws InputError where a number is not finite; `fileName` is named in messages.
PALPATEIO_EXPORT std::string SurfaceToSpharmPdm(const SurfaceModel& surface,
                                                const std::string& fileName);

/// The surface of such a text. Throws InputError on anything else.
PALPATEIO_EXPORT ParametricSphericalSurface SurfaceFromSpharmPdm(const std::string& text,
                                                                 const std::string& fileName);
} // namespace palpate
