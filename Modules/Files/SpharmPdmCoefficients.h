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
/// A radial model is written as the equal surface model of one degree more
/// (SurfaceModel::FromModel). The format has no centre and no provenance, and reading
/// always gives a surface model. Numbers are written in full precision, while SPHARM-PDM
/// itself writes six decimals; its reader accepts both.
/// Throws InputError if a number is not finite; `fileName` is used in messages.
std::string SurfaceToSpharmPdm(const OrganModel& surface, const std::string& fileName);

/// The surface of such a text. Throws InputError for any other text.
SurfaceModel SurfaceFromSpharmPdm(const std::string& text, const std::string& fileName);
} // namespace palpate
