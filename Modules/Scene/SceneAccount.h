#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// Something that a scene may need: what was made, at what price, or why it was not.
struct SceneItem
{
  std::string Is; ///< in words; empty where it was not made
  std::uintmax_t Bytes = 0;
  double Seconds = 0.0;
  std::string WhyNot; ///< empty where it was made
};

/// One structure of a scene; where its file was not opened, one entry of the scene file.
struct SceneStructureAccount
{
  std::string Name;
  std::filesystem::path File;
  SceneItem Contact; ///< to feel it by; with reading off a file what it is made from
  SceneItem Drawing;
};

/// A file that a scene names. Its bytes are those on disk.
struct SceneFileAccount
{
  std::filesystem::path File;
  SceneItem Reading;
};

/// What was made of a scene, for what, and what was not and why.
struct SceneAccount
{
  std::vector<SceneFileAccount> Files;
  std::vector<SceneStructureAccount> Structures;
  SceneItem Servo; ///< trackers, and an index of what is where
};
} // namespace palpate
