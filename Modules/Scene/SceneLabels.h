#pragma once

#include "PalpateSceneModule.h"
#include "SceneSettings.h"
#include "Segmentation.h"

#include <functional>
#include <memory>

namespace palpate
{
/// Returns the segmentation of a file, reading it if needed.
using SegmentationReader =
    std::function<std::shared_ptr<const Segmentation>(const std::filesystem::path& file)>;

/// Expands each entry of a scene into one structure per label, with the label's number, and its
/// name and colour if the entry gives none, or in a scene of several segmentations, whose
/// labels may have no names, its file's name; gives every structure an id. Entries that need no
/// product (nothing is displayed unless `isSeen`) are kept as they are, and their files are not
/// read. Throws InputError if a file lacks a label.
PALPATESCENE_EXPORT SceneSettings ResolveLabels(const SceneSettings& scene, bool isSeen,
                                                const SegmentationReader& read);

/// The segments of a structure, resolved or not. Throws InputError if one is missing.
PALPATESCENE_EXPORT std::vector<Segment> SegmentsOf(const SceneStructure& structure,
                                                    const Segmentation& segmentation);

/// The segment of a resolved structure. Throws InputError if there is none.
PALPATESCENE_EXPORT const Segment& SegmentOf(const SceneStructure& structure,
                                             const Segmentation& segmentation);
} // namespace palpate
