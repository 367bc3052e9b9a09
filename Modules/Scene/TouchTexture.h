#pragma once

#include "PalpateSceneModule.h"
#include "Progress.h"
#include "SurfaceTexture.h"
#include "Volume.h"

#include <cstddef>
#include <memory>

namespace palpate
{
/// A texture and what it occupies.
struct TouchTexture
{
  std::shared_ptr<const SurfaceTexture> Feel;
  std::size_t Bytes = 0;
};

/// A texture of at most `amplitude` (N) from an image's intensities round a structure that lies
/// within `boundsWorld` (mm), felt by a tool whose surface is up to `reach` (mm) from its origin:
/// as much of the image is kept in memory as they can meet in. Throws InputError, and Cancelled.
PALPATESCENE_EXPORT TouchTexture MakeTouchTexture(const Volume& volume,
                                                  const Eigen::AlignedBox3d& boundsWorld,
                                                  double reach, double amplitude,
                                                  const ProgressFunction& progress);
} // namespace palpate
