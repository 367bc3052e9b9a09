#pragma once

#include "PalpateSceneModule.h"
#include "Segmentation.h"
#include "TouchContact.h"

namespace palpate
{
/// The best estimate of the shape of a structure's mask (MakeMaskShape, all components, cavities
/// filled) as a tricubic field, finer than thick slices, with MaskShapeSettings::Smoothing. As a
/// reference: no representation that can be touched in a scene is made this way. Throws FilterError
/// if it cannot be made.
PALPATESCENE_EXPORT TouchContact MakeShapeContact(const Segmentation& segmentation,
                                                  const Segment& structure, double smoothing);
} // namespace palpate
