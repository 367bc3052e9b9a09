#pragma once

#include "PalpateSceneModule.h"
#include "SceneEffect.h"

namespace palpate
{
/// Texture: a small force from the intensities of an image (see SurfaceTexture). Only the part of
/// the image where tool and structure can meet is kept in memory.
PALPATESCENE_EXPORT SceneEffectKind TextureKind();
} // namespace palpate
