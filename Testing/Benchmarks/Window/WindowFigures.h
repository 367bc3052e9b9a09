#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace palpate::bench
{
/// Growth of the resident memory by opening three volumes.
struct VolumeMemory
{
  std::int64_t VolumeBytes = 0; ///< voxels of all three in their files' own type
  std::int64_t GrowthBytes = 0; ///< from a window that has drawn a tiny volume
};

/// Times of a window with 116 structures, ms: until the window is idle again.
struct StructureTimes
{
  double List = 0.0;
  double Search = 0.0;
  double ShowAll = 0.0;
  double ShowNone = 0.0;
  double Opened = 0.0;   ///< from the file to surfaces of all of them, drawn
  double Modelled = 0.0; ///< from the file to models of all of them
};

/// Time from the start of a process, ms.
struct StartTimes
{
  double Window = 0.0; ///< to a window that can be used
  double Head = 0.0;   ///< to four views of the Colin 27 head, given as an argument
};

/// Each throws std::runtime_error if its result is wrong.
VolumeMemory MeasureVolumeMemory();
StructureTimes MeasureStructures();
/// Starts `program --start` some times; the shortest.
StartTimes MeasureStart(const std::string& program);
/// In that process: opens a window and the head, prints a line after each picture.
void DrawFirstPictures();
} // namespace palpate::bench
