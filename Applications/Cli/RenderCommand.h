#pragma once

#include "CaseTally.h"
#include "Command.h"
#include "FitOptions.h"
#include "ImageOptions.h"
#include "SceneRenderer.h"
#include "Segmentation.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace palpate::cli
{
/// `palpate render FILE...`: one image of surfaces, models and segmentations in space, with
/// slices and iso-surfaces of a volume.
class RenderCommand : public Command
{
public:
  std::string Name() const override { return "render"; }
  std::string Summary() const override
  {
    return "Draw surfaces, models, segmentations and slices into a PNG image";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  void DeclareLook(CLI::App& app);
  void AddFile(const std::filesystem::path& file, SceneRenderer& scene, Console& console);
  void TakeFile(const std::filesystem::path& file, SceneRenderer& scene, CaseTally& tally,
                Console& console);
  void AddSegmentation(const std::filesystem::path& file, SceneRenderer& scene, Console& console);
  /// As triangles, one surface per structure.
  void AddMeshes(const Segmentation& segmentation, const std::vector<Segment>& structures,
                 SceneRenderer& scene, Console& console) const;
  /// As fields, by ray casting.
  void AddFields(const Segmentation& segmentation, const std::vector<Segment>& structures,
                 SceneRenderer& scene, Console& console) const;
  void AddVolume(SceneRenderer& scene, Console& console);
  void AddIsoSurfaces(vtkImageData* image, SceneRenderer& scene, Console& console);
  void AddIsoSurfacesWithin(vtkImageData* image, SceneRenderer& scene, Console& console) const;
  FieldInterpolation FieldKind() const;
  void ColorByArray(SceneRenderer& scene) const;
  SceneRenderer::Color NextColor();

  std::vector<std::string> Inputs;
  FitOptions Options;
  std::filesystem::path Output;
  std::string VolumePath;
  ImageOptions Images;
  std::vector<std::string> Slices;
  std::vector<double> IsoValues;
  std::string Interpolation = "linear";
  std::string WithinPath;
  std::vector<std::string> WithinLabels;
  bool IsSubVoxel = false;
  double Smoothing = 1.0;
  std::pair<int, int> Size{800, 800};
  std::string View = "oblique";
  std::string Background = "white";
  std::string ArrayName;
  double Opacity = 1.0;
  std::size_t ColorCount = 0;
};
} // namespace palpate::cli
