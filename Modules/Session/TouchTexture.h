#pragma once

#include "PalpateSessionModule.h"
#include "Progress.h"
#include "SurfaceTexture.h"

#include <filesystem>
#include <memory>

namespace palpate
{
/// A texture of at most `amplitude` (N) from an image's intensities round a structure that lies
/// within `boundsWorld` (mm). Keeps all of the image in memory. Throws InputError, and Cancelled.
PALPATESESSION_EXPORT std::shared_ptr<const SurfaceTexture>
MakeTouchTexture(const std::filesystem::path& image, const Eigen::AlignedBox3d& boundsWorld,
                 double amplitude, const ProgressFunction& progress);
} // namespace palpate
