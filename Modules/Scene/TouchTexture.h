#pragma once

#include "PalpateSceneModule.h"
#include "SceneEffect.h"

namespace palpate
{
/// Texture: a small force by the intensities of an image (see SurfaceTexture). As much of the image
/// is kept in memory as the tool and the structure can meet in.
PALPATESCENE_EXPORT SceneEffectKind TextureKind();
} // namespace palpate
