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
/// A tool of any shape: a closed surface from a file (mm, in the tool's own frame, its tip or
/// centre at the origin as the file has it). Immutable once read, for any thread.
class PALPATESCENE_EXPORT SurfaceTool
{
public:
  /// Reads the file once and prepares Touching for that many points, and Cutting where `cuts`.
  /// Throws InputError for malformed files and for surfaces that are not closed.
  static std::shared_ptr<const SurfaceTool> Read(const std::filesystem::path& file, int points,
                                                 bool cuts);

  /// What touches: `count` of the surface's points, as far from each other as they can be.
  ToolShape Touching(int count) const;
  /// What cuts: all that is inside. Throws InputError where the surface has no inside.
  CutTool Cutting() const;

  std::size_t Bytes() const;

private:
  SurfaceTool(std::filesystem::path file, vtkSmartPointer<vtkPolyData> surface);
  CutTool SampleCut() const;

  std::filesystem::path Source;
  vtkSmartPointer<vtkPolyData> Surface;
  std::vector<vtkIdType> FarPoints; // each the farthest from all before it
  std::optional<CutTool> Cut;       // none: not prepared, or without an inside
};

/// The points of a tool's shell: its own number, or one that is enough for organs.
PALPATESCENE_EXPORT int ShellPointsOf(const TouchToolSettings& settings);

/// The surface of the settings' tool: what was read of it already, or else its file.
PALPATESCENE_EXPORT std::shared_ptr<const SurfaceTool> SurfaceOf(const TouchToolSettings& settings,
                                                                 bool cuts);
} // namespace palpate
