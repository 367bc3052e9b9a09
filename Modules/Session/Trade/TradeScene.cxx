#include "TradeScene.h"

#include "ContentDigest.h"
#include "DecimalText.h"
#include "FilterRun.h"
#include "FitStructure.h"
#include "InputError.h"
#include "ModelFile.h"
#include "Refusal.h"
#include "SceneFiles.h"
#include "SurfaceFile.h"

#include <map>
#include <memory>
#include <utility>

namespace palpate
{
namespace
{
class SceneReader
{
public:
  explicit SceneReader(std::vector<TradeStructure>& structures) : Structures(structures) {}

  void Read(const TouchStructureSettings& asked)
  {
    const std::filesystem::path& file = asked.File;
    if (asked.Iso)
    {
      this->Add(asked, CaseNameOf(file), TradeSource::Image{this->Files.VolumeOf(file), *asked.Iso},
                "iso " + SignificantText(*asked.Iso));
    }
    else if (IsModelFile(file))
    {
      this->Add(asked, file.stem().string(), this->ModelOf(file), {});
    }
    else if (IsSurfaceFile(file))
    {
      this->Add(asked, file.stem().string(), this->Files.SurfaceOf(file), {});
    }
    else
    {
      this->ReadSegmentation(asked);
    }
  }

private:
  using Is = decltype(TradeSource::Is);

  void Add(const TouchStructureSettings& asked, const std::string& name, Is is,
           const std::string& part)
  {
    TradeStructure structure;
    structure.Source.Name = asked.Name.empty() ? name : asked.Name;
    structure.Source.File = asked.File;
    structure.Source.Is = std::move(is);
    structure.Source.Smoothing = asked.Smoothing;
    structure.Asked = asked;
    structure.Content = this->DigestOf(asked.File) + " " + part;
    this->Structures.push_back(std::move(structure));
  }

  TradeSource::Model ModelOf(const std::filesystem::path& file)
  {
    const ModelDocument document = this->Files.ModelOf(file);
    const auto* model = std::get_if<SphericalHarmonicModel>(&document.Surface);
    if (model == nullptr)
    {
      Refuse(file, "is a parametric surface, which has no radius to touch",
             "write it as a surface (palpate convert) and measure that");
    }
    return std::make_shared<const SphericalHarmonicModel>(*model);
  }

  void ReadSegmentation(const TouchStructureSettings& asked)
  {
    const auto voxels = this->Files.SegmentationOf(asked.File);
    std::vector<Segment> segments = voxels->Segments;
    if (!asked.Labels.empty())
    {
      segments.clear();
      for (const std::string& label : asked.Labels)
      {
        segments.push_back(voxels->Find(label));
      }
    }
    for (const Segment& segment : segments)
    {
      const std::string label = "label " + std::to_string(segment.Label);
      this->Add(asked, segment.Name.empty() ? label : segment.Name,
                TradeSource::Mask{voxels, segment}, label);
    }
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

  std::vector<TradeStructure>& Structures;
  SceneFiles Files;
  std::map<std::filesystem::path, std::string> Digests;
};
} // namespace

std::vector<TradeStructure> ReadTradeScene(const TouchSettings& scene,
                                           const ProgressFunction& progress)
{
  std::vector<TradeStructure> structures;
  SceneReader reader(structures);
  for (const TouchStructureSettings& asked : scene.Structures)
  {
    if (!progress(0.0, "reading"))
    {
      throw Cancelled();
    }
    if (asked.IsTouched)
    {
      reader.Read(asked);
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
