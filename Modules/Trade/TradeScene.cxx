#include "TradeScene.h"

#include "ContentDigest.h"
#include "DecimalText.h"
#include "FilterRun.h"
#include "FitStructure.h"
#include "InputError.h"
#include "ModelFile.h"
#include "Refusal.h"
#include "SceneLabels.h"
#include "SegmentationFile.h"
#include "SurfaceFile.h"
#include "VolumeFile.h"

#include <map>
#include <memory>
#include <utility>

namespace palpate
{
namespace
{
// Segmentations are read once, however many structures they hold.
class TradeReader
{
public:
  std::shared_ptr<const Segmentation> SegmentationOf(const std::filesystem::path& file)
  {
    std::shared_ptr<const Segmentation>& kept = this->Segmentations[file];
    kept = kept != nullptr ? kept : std::make_shared<const Segmentation>(ReadSegmentation(file));
    return kept;
  }

  TradeStructure Read(const SceneStructure& asked)
  {
    TradeStructure structure;
    structure.Source.Name = TitleOf(asked);
    structure.Source.File = asked.File;
    structure.Source.Smoothing = asked.Smoothing;
    structure.Asked = asked;
    std::string part;
    switch (asked.Source())
    {
    case SceneSource::Label:
    {
      const auto voxels = this->SegmentationOf(asked.File);
      structure.Source.Is = TradeSource::Mask{voxels, SegmentOf(asked, *voxels)};
      part = "label " + asked.Labels.front();
      break;
    }
    case SceneSource::IsoValue:
      structure.Source.Is =
          TradeSource::Image{std::make_shared<const Volume>(ReadVolume(asked.File)), *asked.Iso};
      part = "iso " + SignificantText(*asked.Iso);
      break;
    case SceneSource::Model:
      structure.Source.Is = ModelOf(asked.File);
      break;
    case SceneSource::Surface:
      structure.Source.Is = ReadSurface(asked.File);
      break;
    }
    structure.Content = this->DigestOf(asked.File) + " " + part;
    return structure;
  }

private:
  static TradeSource::Model ModelOf(const std::filesystem::path& file)
  {
    const ModelDocument document = ReadModel(file);
    const auto* model = std::get_if<SphericalHarmonicModel>(&document.Surface);
    if (model == nullptr)
    {
      Refuse(file, "is a parametric surface, which has no radius to touch",
             "write it as a surface (palpate convert) and measure that");
    }
    return std::make_shared<const SphericalHarmonicModel>(*model);
  }

  const std::string& DigestOf(const std::filesystem::path& file)
  {
    std::string& known = this->Digests[file];
    if (known.empty())
    {
      ContentDigest digest;
      digest.AddContent(file);
      known = digest.Text();
    }
    return known;
  }

  std::map<std::filesystem::path, std::shared_ptr<const Segmentation>> Segmentations;
  std::map<std::filesystem::path, std::string> Digests;
};
} // namespace

std::vector<TradeStructure> ReadTradeScene(const SceneSettings& scene,
                                           const ProgressFunction& progress)
{
  SceneSettings touched = scene;
  for (SceneStructure& structure : touched.Structures)
  {
    structure.IsVisible = structure.IsForbidden = false;
  }
  TradeReader reader;
  touched = ResolveLabels(touched, false,
                          [&reader](const std::filesystem::path& file)
                          { return reader.SegmentationOf(file); });
  std::vector<TradeStructure> structures;
  for (const SceneStructure& asked : touched.Structures)
  {
    if (!progress(0.0, "reading"))
    {
      throw Cancelled();
    }
    if (asked.IsTouchable)
    {
      structures.push_back(reader.Read(asked));
    }
  }
  if (structures.empty())
  {
    throw InputError("the scene lets nothing be touched, so there is nothing to measure; say "
                     "\"touched\": true of a structure");
  }
  return structures;
}
} // namespace palpate
