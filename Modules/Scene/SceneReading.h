#pragma once

#include "PalpateSceneModule.h"
#include "SceneMove.h"
#include "ScenePlan.h"

#include <filesystem>
#include <sstream>
#include <string>

namespace palpate
{
/// Nodes that read a file, and move what it has: one per file and move, for any number of
/// structures.
PALPATESCENE_EXPORT SceneNode VolumeNode(const std::filesystem::path& file,
                                         const std::string& series, LeftHandedAxes leftHanded,
                                         const SceneStamps& stamps, const SceneMove& move = {});
PALPATESCENE_EXPORT SceneNode SegmentationNode(const std::filesystem::path& file,
                                               LeftHandedAxes leftHanded, const SceneStamps& stamps,
                                               const SceneMove& move = {});
/// Reads a model as a completed fit, with its surface. One that yields is not moved.
PALPATESCENE_EXPORT SceneNode ModelNode(const std::filesystem::path& file,
                                        const SceneStamps& stamps, const SceneMove& move = {});
PALPATESCENE_EXPORT SceneNode SurfaceNode(const std::filesystem::path& file,
                                          const SceneStamps& stamps, const SceneMove& move = {});
/// Reads a tool's surface; prepares it for cutting if the scene drills any structure.
PALPATESCENE_EXPORT SceneNode ToolNode(const SceneSettings& scene, const SceneStamps& stamps);

/// A text that differs if any of the values differs.
template <typename... Values>
std::string SceneKey(const std::string& start, const Values&... values)
{
  std::ostringstream text;
  text << std::hexfloat << start;
  ((text << '|' << values), ...);
  return text.str();
}
} // namespace palpate
