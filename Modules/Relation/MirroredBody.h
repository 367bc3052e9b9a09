#pragma once

#include "ComparedBody.h"
#include "KernelProgress.h"
#include "Status.h"

namespace palpate
{
/// How a body's mirror image was brought onto another body.
struct MirrorMatch
{
  double Turn = 0.0;               ///< rad, between the two after mirroring at the sagittal plane
  Vector3 Shift = Vector3::Zero(); ///< of the mirror image's centroid, mm
};

/// Replaces a body by its mirror image at the sagittal plane x = 0, brought onto another one:
/// centroids on each other, then RegisterToSurface. A mask becomes its surface. Fails as that does.
Status MirrorOnto(const ComparedBody& fixed, const KernelProgress& progress, ComparedBody& body,
                  MirrorMatch& match);
} // namespace palpate
