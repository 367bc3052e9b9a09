#pragma once

#include "Status.h"
#include "SurfaceModel.h"
#include "SurfaceSamples.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// Where a surface model, fitted to the vertices of a mesh that does not cross itself, crosses
/// itself all the same, and what of the fit is to be changed there:
///
/// - where two sheets have grown through a gap, or through the thin wall that they bound, the
///   vertices of both are moved apart along their normals;
/// - where a sheet lies in pleats, since its parameters are spread too unevenly for its degree or
///   an edge is too sharp for it, the tangents are to be stiffer, the parameters more even and the
///   vertices smoother.
struct CrossingRemedy
{
  std::int64_t Crossings = 0;  ///< pairs of triangles, as drawn and as touched together
  std::vector<double> Shifts;  ///< of the mesh's vertices along their normals, mm
  std::vector<char> IsPleated; ///< whether a vertex is near a pleat

  bool HasPleats() const
  {
    return std::find(this->IsPleated.begin(), this->IsPleated.end(), 1) != this->IsPleated.end();
  }
};

/// Half the shortest wavelength of a surface of degree 1 or more on a sphere of its area, mm: about
/// the smallest feature that its degree resolves.
double HalfWavelengthOf(const SurfaceModel& surface);

/// `vertices` of the first samples are the mesh's. Sheets are moved by a twentieth of half the
/// surface's shortest wavelength at once, and as far around a crossing as it resolves: several
/// rounds of fits are needed. Looks at 200 crossings, of 20,000 that are counted at most, of each
/// of two tessellations. Fails for a surface that is not finite.
Status FindCrossingRemedy(const SurfaceModel& surface, const SurfaceSamples& samples,
                          std::size_t vertices, CrossingRemedy& remedy);
} // namespace palpate
