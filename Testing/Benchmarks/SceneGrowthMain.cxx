// PalpateScenes FILE: measures what scenes of many structures take, and writes it as JSON; see
// Utilities/scenes.sh.
#include "MachineName.h"
#include "SceneGrowth.h"

#include <exception>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

namespace
{
nlohmann::json Measured()
{
  nlohmann::json ticks;
  for (const palpate::bench::TickGrowthRow& row : palpate::bench::MeasureTickGrowth())
  {
    ticks.push_back({{"structures", row.Structures},
                     {"median_ns", row.MedianNanoseconds},
                     {"p999_ns", row.RareNanoseconds},
                     {"max_ns", row.LongestNanoseconds},
                     {"publish_s", row.PublishSeconds},
                     {"bytes_each", row.BytesPerStructure}});
  }
  nlohmann::json scenes;
  for (const palpate::bench::SceneGrowthRow& row : palpate::bench::MeasureSceneGrowth())
  {
    scenes.push_back({{"scene", row.Scene},
                      {"structures", row.Structures},
                      {"touched", row.Touched},
                      {"files_read", row.FilesRead},
                      {"read_s", row.ReadSeconds},
                      {"make_s", row.MakeSeconds},
                      {"bytes", row.Bytes},
                      {"servo_bytes", row.ServoBytes},
                      {"resident_mib", row.ResidentMebibytes},
                      {"tick_us", row.TickMicroseconds}});
  }
  return {{"machine", palpate::MachineName()},
          {"compiler", std::string("GCC ") + __VERSION__},
          {"ticks", ticks},
          {"scenes", scenes}};
}
} // namespace

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "usage: PalpateScenes FILE.json\n";
    return 2;
  }
  try
  {
    std::ofstream file(argv[1]);
    file << Measured().dump(2) << '\n';
    return file.good() ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
