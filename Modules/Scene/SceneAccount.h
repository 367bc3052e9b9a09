#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// One product that a scene may need: its description and cost, or why it was not made.
struct SceneItem
{
  std::string Is; ///< description; empty if it was not made
  std::uintmax_t Bytes = 0;
  double Seconds = 0.0;
  std::string WhyNot; ///< empty if it was made
};

/// One structure of a scene, or one entry of the scene file if its file was not opened.
struct SceneStructureAccount
{
  std::string Name;
  std::filesystem::path File;
  SceneItem Contact; ///< its contact model; time without reading files
};

/// A file that a scene names. Its bytes are those on disk.
struct SceneFileAccount
{
  std::filesystem::path File;
  SceneItem Reading;
};

/// Everything that was made for a scene, and what was skipped and why.
struct SceneAccount
{
  std::vector<SceneFileAccount> Files;
  std::vector<SceneStructureAccount> Structures;
  SceneItem Servo; ///< trackers and a spatial index
};
} // namespace palpate
