#pragma once

#include "CutTool.h"
#include "PalpateSceneModule.h"
#include "SceneSettings.h"
#include "ToolShape.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace palpate
{
/// A tool of any shape: a closed surface from a file (mm, in the tool's own frame, whose origin is
/// the tip or centre as the file has it). Immutable after reading; any thread.
class PALPATESCENE_EXPORT SurfaceTool
{
public:
  /// Reads the file and prepares Touching for that many points, and Cutting if `cuts`. Throws
  /// InputError for malformed files and for surfaces that are not closed.
  static std::shared_ptr<const SurfaceTool> Read(const std::filesystem::path& file, int points,
                                                 bool cuts);

  /// Contact shape: `count` points of the surface, spaced as far apart as possible.
  ToolShape Touching(int count) const;
  /// Cutting shape: the volume inside. Throws InputError if the surface encloses no volume.
  CutTool Cutting() const;

  std::size_t Bytes() const;

private:
  SurfaceTool(std::filesystem::path file, vtkSmartPointer<vtkPolyData> surface);
  CutTool SampleCut() const;

  std::filesystem::path Source;
  vtkSmartPointer<vtkPolyData> Surface;
  vtkSmartPointer<vtkPolyData> Dense; // with as many points as touch; the same if it has them
  std::vector<vtkIdType> FarPoints;   // each the farthest from all before it
  std::optional<CutTool> Cut;         // none: not prepared, or no enclosed volume
};

/// Number of points of a tool's shell: as set, or a default that suffices for organs.
PALPATESCENE_EXPORT int ShellPointsOf(const TouchToolSettings& settings);

/// The surface of the settings' tool: already read, or read from its file now.
PALPATESCENE_EXPORT std::shared_ptr<const SurfaceTool> SurfaceOf(const TouchToolSettings& settings,
                                                                 bool cuts);
} // namespace palpate
