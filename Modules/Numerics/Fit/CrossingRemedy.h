#pragma once

#include "ParametricSphericalSurface.h"
#include "Status.h"
#include "SurfaceSamples.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// Where a parametric surface, fitted to the vertices of a mesh that does not cross itself, crosses
/// itself all the same, and what of the fit is to be changed there:
///
/// - where two sheets have grown through the gap between them, or through the thin wall that they
/// bound,
///   the vertices of both are moved apart along their normals;
/// - where a sheet lies in pleats, since its parameters are spread too unevenly for its degree,
///   the tangents are to be stiffer and the parameters more even.
struct CrossingRemedy
{
  std::int64_t Crossings = 0;  ///< pairs of triangles of a tessellation of twice the degree
  std::vector<double> Shifts;  ///< of the mesh's vertices along their normals, mm
  std::vector<char> IsPleated; ///< whether a vertex is near a pleat
};

/// `vertices` of the first samples are the mesh's. Sheets are moved by a twentieth of half the
/// surface's shortest wavelength at once, and as far around a crossing as it resolves: several
/// rounds of fits are needed. Looks at 200 crossings, of 20,000 that are counted at most. Fails for
/// a surface that is not finite.
Status FindCrossingRemedy(const ParametricSphericalSurface& surface, const SurfaceSamples& samples,
                          std::size_t vertices, CrossingRemedy& remedy);
} // namespace palpate
