#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace palpate::bench
{
/// Ticks of a servo in a scene whose structures can all be touched; one is.
struct TickGrowthRow
{
  int Structures;
  double MedianNanoseconds; ///< of a tick, each the shortest of many strokes
  double RareNanoseconds;   ///< which 99.9 % of the ticks do not exceed
  double LongestNanoseconds;
  double PublishSeconds;    ///< to make what the servo needs
  double BytesPerStructure; ///< that this takes
};

/// A scene file of many structures, of which some are to be touched.
struct SceneGrowthRow
{
  std::string Scene;
  int Structures;
  int Touched;
  int FilesRead;
  double ReadSeconds;
  double MakeSeconds;
  std::uintmax_t Bytes;      ///< of what was made
  std::uintmax_t ServoBytes; ///< of what a servo has for it
  double ResidentMebibytes;  ///< by which the process grew meanwhile
  double TickMicroseconds;   ///< median over two seconds of touch
};

/// Some 20 s. Throw std::runtime_error where a scene cannot be made; the atlas is left out where it
/// is not installed.
std::vector<TickGrowthRow> MeasureTickGrowth();
std::vector<SceneGrowthRow> MeasureSceneGrowth();
} // namespace palpate::bench
