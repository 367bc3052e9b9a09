#pragma once

#include "Command.h"
#include "TouchRun.h"

#include <filesystem>
#include <string>
#include <vector>

namespace CLI
{
class Option;
}

namespace palpate::cli
{
/// `palpate touch SCENE|FILE...`: touches a scene with a device, without a window.
class TouchCommand : public Command
{
public:
  std::string Name() const override { return "touch"; }
  std::string Summary() const override
  {
    return "Touch a scene with a device or a simulated hand, and report forces and timing";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  void DeclareStructure(CLI::App& app);
  void DeclareRun(CLI::App& app);
  /// Of the scene file, or of the files and options.
  SceneSettings Settings() const;
  TouchScript Script() const;
  TouchResult RunWithPeer(const PreparedTouch& touch, TouchRunSettings& settings,
                          Console& console) const;
  int Touch(const PreparedTouch& touch, Console& console) const;
  int Replay(const PreparedTouch& touch, Console& console) const;
  void CheckDrilled(const PreparedTouch& touch) const;
  /// Returns whether everything was written; prints what was not.
  bool WriteDrilled(const PreparedTouch& touch, Console& console) const;
  void PrintSummary(const PreparedTouch& touch, const TouchResult& result, bool hasPage,
                    Console& console) const;

  /// Those of structures and the tool, which a scene states itself; owned by the CLI::App.
  std::vector<const CLI::Option*> StructureOptions;
  std::vector<std::string> Inputs;
  SceneStructure Structure; ///< of every input that is not a scene
  std::vector<std::string> Labels;
  std::vector<double> Iso; ///< none or one
  std::string Representation = "automatic";
  std::string Mode = "nearest";
  std::string Interpolation = "linear";
  TouchToolSettings Tool;
  double ToolLength = 0.0; // mm; 0: a sphere
  double ToolShaft = 0.0;  // mm; 0: a capsule
  std::string Device;
  std::string Firmware;
  double Rate = 0.0;         ///< Hz; 0: the scene's
  std::vector<double> Scale; ///< none or one
  std::string PathFile;
  std::string DrillScript;
  std::string DrillStateFile;
  std::vector<std::string> DrilledFiles;
  TouchScript Sweep;
  std::vector<double> Seconds; ///< none or one
  bool IsRealTime = false;
  std::string Peer; ///< that displays the touch; empty: none
  std::string ReplayFile;
  bool Json = false;
  std::filesystem::path OutputFolder;
};
} // namespace palpate::cli
