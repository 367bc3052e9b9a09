#pragma once

#include "PalpateSceneModule.h"
#include "ScenePlan.h"

#include <filesystem>
#include <sstream>
#include <string>

namespace palpate
{
/// The nodes that read a file: one for each file, however many structures are made from it.
PALPATESCENE_EXPORT SceneNode VolumeNode(const std::filesystem::path& file,
                                         const std::string& series, LeftHandedAxes leftHanded,
                                         const SceneStamps& stamps);
PALPATESCENE_EXPORT SceneNode SegmentationNode(const std::filesystem::path& file,
                                               LeftHandedAxes leftHanded,
                                               const SceneStamps& stamps);
/// A model becomes a fit that is there already, with its surface.
PALPATESCENE_EXPORT SceneNode ModelNode(const std::filesystem::path& file,
                                        const SceneStamps& stamps);
PALPATESCENE_EXPORT SceneNode SurfaceNode(const std::filesystem::path& file,
                                          const SceneStamps& stamps);
/// A tool from a file, ready to cut where anything of the scene is drilled.
PALPATESCENE_EXPORT SceneNode ToolNode(const SceneSettings& scene, const SceneStamps& stamps);

/// A text that differs wherever one of the values does.
template <typename... Values>
std::string SceneKey(const std::string& start, const Values&... values)
{
  std::ostringstream text;
  text << std::hexfloat << start;
  ((text << '|' << values), ...);
  return text.str();
}
} // namespace palpate
