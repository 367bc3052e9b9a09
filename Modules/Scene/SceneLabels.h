#pragma once

#include "PalpateSceneModule.h"
#include "SceneSettings.h"
#include "Segmentation.h"

#include <functional>
#include <memory>

namespace palpate
{
/// Gives a segmentation, which the scene's files are read for.
using SegmentationReader =
    std::function<std::shared_ptr<const Segmentation>(const std::filesystem::path& file)>;

/// The scene with one structure for each label that its entries name, with its number, and its name
/// and colour where the entry gives none; and with an id for every structure. Entries of which
/// nothing is needed, where nothing is displayed unless `isSeen`, stay as they are, and their files
/// are not read. Throws InputError where a file has no such label.
PALPATESCENE_EXPORT SceneSettings ResolveLabels(const SceneSettings& scene, bool isSeen,
                                                const SegmentationReader& read);

/// The one segment that a resolved structure is made from. Throws InputError where there is none.
PALPATESCENE_EXPORT const Segment& SegmentOf(const SceneStructure& structure,
                                             const Segmentation& segmentation);
} // namespace palpate
