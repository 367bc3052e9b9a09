#pragma once

#include "PalpateFiltersModule.h"
#include "RadialModel.h"

#include <cstdint>

namespace palpate
{
/// A body with the size and the main features of a prostate, for phantoms with known answers:
/// semi-axes of 24 mm (left-right), 20 mm (front-back) and 22 mm (up-down), flattened where the
/// rectum lies (+y, patient LPS), narrower towards the apex (-z), plus bumps of degrees 2 to 8 that
/// differ with `seed` (standard deviation of the radius about 1 mm, falling with the degree).
///
/// The shape is projected onto the harmonics up to `degree` >= 0, so the returned model is exact by
/// definition: its coefficients are the ground truth.
PALPATEFILTERS_EXPORT RadialModel MakeProstateLikeModel(int degree, std::uint64_t seed,
                                                        const Vector3& centerWorld);
} // namespace palpate
