#pragma once

#include "FieldRenderer.h"

class vtkRenderer;
class vtkVolume;
class vtkVolumeMapper;

namespace palpate
{
/// The view of a renderer's camera and lights, a volume's matrix and property, and a mapper's
/// clipping planes, for an image of `width` x `height` pixels over the whole viewport, without
/// appearances and scene depths.
PALPATEVOLUMERENDERING_EXPORT FieldView MakeSceneView(vtkRenderer* renderer, vtkVolume* volume,
                                                      vtkVolumeMapper* mapper, int width,
                                                      int height);

/// The depth buffer over a renderer's viewport, resampled for an image of `width` x `height`
/// pixels.
PALPATEVOLUMERENDERING_EXPORT std::vector<float> ReadSceneDepths(vtkRenderer* renderer, int width,
                                                                 int height);
} // namespace palpate
