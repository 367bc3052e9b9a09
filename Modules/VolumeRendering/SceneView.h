#pragma once

#include "FieldRenderer.h"

class vtkRenderer;
class vtkVolume;
class vtkVolumeMapper;

namespace palpate
{
/// What a renderer's camera, lights and viewport, a volume's place and property, and a mapper's
/// clipping and cropping make of a picture of `width` x `height` pixels over the whole viewport. No
/// looks and no scene depths. Cropping planes are in the image's own axes, mm: origin + spacing
/// times index, without the direction.
PALPATEVOLUMERENDERING_EXPORT FieldView MakeSceneView(vtkRenderer* renderer, vtkVolume* volume,
                                                      vtkVolumeMapper* mapper,
                                                      const FieldGrid& grid, int width, int height);

/// What the depth buffer has over a renderer's viewport, for a picture of `width` x `height`
/// pixels.
PALPATEVOLUMERENDERING_EXPORT std::vector<float> ReadSceneDepths(vtkRenderer* renderer, int width,
                                                                 int height);
} // namespace palpate
