#include "StudyPlan.h"

#include "CaseText.h"
#include "FilterRun.h"
#include "InputError.h"
#include "SceneField.h"
#include "SteadyClock.h"

#include <array>
#include <sstream>
#include <system_error>

namespace palpate
{
namespace
{
using Inputs = std::vector<StudyProduct>;

// Whatever differs gives another text.
template <typename... Values>
std::string KeyOf(const std::string& start, const Values&... values)
{
  std::ostringstream text;
  text << std::hexfloat << start;
  ((text << '|' << values), ...);
  return text.str();
}

std::string CenterKey(const FitSettings& fit)
{
  if (!fit.GivenCenterWorld)
  {
    return std::to_string(static_cast<int>(fit.Center));
  }
  const auto& center = *fit.GivenCenterWorld;
  return KeyOf("at", center[0], center[1], center[2]);
}

std::string StampOf(const std::filesystem::path& file)
{
  std::error_code error;
  const auto time = std::filesystem::last_write_time(file, error);
  if (error)
  {
    return "absent";
  }
  const auto size = std::filesystem::file_size(file, error); // a folder has none
  return KeyOf("there", time.time_since_epoch().count(), error ? 0 : size);
}

// Reading cannot be told to stop; what is read is not wanted then.
template <typename Read>
StudyProduct ReadUnlessCancelled(const Read& read, const ProgressFunction& progress)
{
  if (!progress(0.0, "read"))
  {
    throw Cancelled();
  }
  return read();
}

// The nodes of one structure.
class StructurePlan
{
public:
  StructurePlan(const StudyState& state, const StudyStructure& structure, std::string segmentation,
                const StudyLookup& lookup, std::vector<StudyNode>& nodes)
      : State(state), Structure(structure), Fit(FitSettingsOf(state, structure)),
        SegmentationKey(std::move(segmentation)), Lookup(lookup), Nodes(nodes)
  {
  }

  void Add()
  {
    switch (this->Structure.Representation)
    {
    case TouchRepresentation::Harmonics:
      return this->AddContact(this->AddModel(), this->ContactOfModel());
    case TouchRepresentation::Facets:
      return this->AddContact(this->AddSurface(), this->ContactOfSurface());
    case TouchRepresentation::SubVoxel:
      return this->AddContact(this->AddField(), this->ContactOfField());
    case TouchRepresentation::Automatic:
      return this->AddAutomatic();
    }
  }

private:
  using Making = decltype(StudyNode::Make);

  std::string AddNode(StudyStep step, const std::string& key, const std::string& input, Making make)
  {
    this->Nodes.push_back({step, this->Structure.Label, key, {input}, std::move(make)});
    return key;
  }

  std::string AddSurface()
  {
    const std::string key =
        KeyOf(this->SegmentationKey, "surface", this->Structure.Label,
              static_cast<int>(this->Fit.Method), this->Fit.Smoothing, this->Fit.Component);
    return this->AddNode(StudyStep::Surface, key, this->SegmentationKey,
                         [label = this->Structure.Label,
                          fit = this->Fit](const Inputs& inputs, const ProgressFunction& progress)
                         {
                           const auto segmentation = ProductAs<Segmentation>(inputs.data());
                           const Segment& segment = segmentation->Find(std::to_string(label));
                           return std::make_shared<const FitSurface>(
                               MakeFitSurface(*segmentation, segment, fit, progress));
                         });
  }

  std::string AddSamples()
  {
    const std::string surface = this->AddSurface();
    const std::string key = KeyOf(surface, "samples", this->Fit.Frequency, CenterKey(this->Fit),
                                  this->Fit.MaximumHiddenPercent);
    return this->AddNode(StudyStep::Samples, key, surface,
                         [fit = this->Fit](const Inputs& inputs, const ProgressFunction& progress)
                         {
                           return std::make_shared<const FitSamples>(MakeFitSamples(
                               *ProductAs<FitSurface>(inputs.data()), fit, progress));
                         });
  }

  std::string AddModel()
  {
    const std::string samples = this->AddSamples();
    const FitSettings& fit = this->Fit;
    const std::string key =
        KeyOf(samples, "model", fit.Degree, fit.Tolerance.value_or(-1.0), fit.MaximumDegree,
              static_cast<int>(fit.Weight), static_cast<int>(fit.PenaltyKind), fit.Roughness,
              fit.MinimumDice);
    return this->AddNode(StudyStep::Model, key, samples,
                         [fit](const Inputs& inputs, const ProgressFunction& progress)
                         {
                           return std::make_shared<const FitResult>(
                               MakeFitModel(*ProductAs<FitSamples>(inputs.data()), fit, progress));
                         });
  }

  std::string AddField()
  {
    const std::string key =
        KeyOf(this->SegmentationKey, "field", this->Structure.Label,
              static_cast<int>(this->State.Interpolation), this->State.FieldSmoothing);
    return this->AddNode(
        StudyStep::Field, key, this->SegmentationKey,
        [label = this->Structure.Label, interpolation = this->State.Interpolation,
         smoothing = this->State.FieldSmoothing](const Inputs& inputs,
                                                 const ProgressFunction& progress) -> StudyProduct
        {
          const auto segmentation = ProductAs<Segmentation>(inputs.data());
          const Segment& segment = segmentation->Find(std::to_string(label));
          try
          {
            return MakeSegmentField(*segmentation, {segment}, interpolation, smoothing, progress);
          }
          catch (const FilterError& error)
          {
            throw InputError(CaseSentence(segmentation->Source, segment, error.what()));
          }
        });
  }

  // By harmonics, and by the field once any stage of those has failed.
  void AddAutomatic()
  {
    const std::size_t first = this->Nodes.size();
    const std::string model = this->AddModel();
    bool hasFailed = false;
    for (std::size_t n = first; n < this->Nodes.size(); ++n)
    {
      const StudyProduct* product = this->Lookup(this->Nodes[n].Key);
      hasFailed = hasFailed || (product != nullptr && !FailureOf(*product).empty());
    }
    if (hasFailed)
    {
      this->AddContact(this->AddField(), this->ContactOfField());
    }
    else
    {
      this->AddContact(model, this->ContactOfModel(), this->Lookup(model) != nullptr);
    }
  }

  void AddContact(const std::string& input, Making make, bool isDecided = true)
  {
    if (this->Structure.IsTouchable)
    {
      const std::string key =
          this->AddNode(StudyStep::Touch, isDecided ? KeyOf(input, "touch") : std::string(), input,
                        std::move(make));
      this->AddCost(key);
    }
  }

  void AddCost(const std::string& contact)
  {
    const TouchToolSettings& tool = this->State.Tool;
    const Vector3& axes = tool.SemiAxes;
    const std::string key = KeyOf(contact, "cost", static_cast<int>(tool.Kind), tool.Radius,
                                  tool.Length, axes.x(), axes.y(), axes.z(), tool.Points);
    this->AddNode(StudyStep::Cost, contact.empty() ? std::string() : key, contact,
                  [tool](const Inputs& inputs, const ProgressFunction& progress)
                  {
                    const SteadyClock clock;
                    return std::make_shared<const TouchCost>(MeasureTouchCost(
                        *ProductAs<TouchContact>(inputs.data()), tool, clock, progress));
                  });
  }

  Making ContactOfModel() const
  {
    return [](const Inputs& inputs, const ProgressFunction&) -> StudyProduct
    {
      const auto fit = ProductAs<FitResult>(inputs.data());
      return std::make_shared<const TouchContact>(
          MakeHarmonicContact(fit->Model, HarmonicContactMode::Nearest, fit->Input));
    };
  }

  Making ContactOfSurface() const
  {
    return [](const Inputs& inputs, const ProgressFunction&) -> StudyProduct
    {
      const FitResult& found = ProductAs<FitSurface>(inputs.data())->Found;
      auto own = vtkSmartPointer<vtkPolyData>::New();
      own->ShallowCopy(found.Surface);
      return std::make_shared<const TouchContact>(MakeFacetContact(own, found.Input));
    };
  }

  Making ContactOfField() const
  {
    return [interpolation = this->State.Interpolation, file = this->State.SegmentationFile](
               const Inputs& inputs, const ProgressFunction&) -> StudyProduct
    {
      return std::make_shared<const TouchContact>(
          MakeFieldContact(ProductAs<ScalarField>(inputs.data()), 0, interpolation, file));
    };
  }

  const StudyState& State;
  const StudyStructure& Structure;
  FitSettings Fit;
  std::string SegmentationKey;
  const StudyLookup& Lookup;
  std::vector<StudyNode>& Nodes;
};

StudyNode VolumeNode(const StudyState& state, const std::string& stamp)
{
  const VolumeChoice choice{state.DicomSeries, state.LeftHanded};
  const auto make =
      [file = state.VolumeFile, choice](const Inputs&, const ProgressFunction& progress)
  {
    return ReadUnlessCancelled(
        [&] { return std::make_shared<const Volume>(ReadVolume(file, choice)); }, progress);
  };
  return {StudyStep::Volume,
          0,
          KeyOf("volume", state.VolumeFile, stamp, choice.DicomSeries,
                static_cast<int>(choice.LeftHanded)),
          {},
          make};
}

StudyNode SegmentationNode(const StudyState& state, const std::string& stamp)
{
  const auto make = [file = state.SegmentationFile,
                     leftHanded = state.LeftHanded](const Inputs&, const ProgressFunction& progress)
  {
    return ReadUnlessCancelled(
        [&] { return std::make_shared<const Segmentation>(ReadSegmentation(file, leftHanded)); },
        progress);
  };
  return {StudyStep::Segmentation,
          0,
          KeyOf("segmentation", state.SegmentationFile, stamp, static_cast<int>(state.LeftHanded)),
          {},
          make};
}
} // namespace

const char* NameOf(StudyStep step)
{
  constexpr std::array<const char*, 9> Names{"volume",  "segmentation", "structures",
                                             "surface", "samples",      "model",
                                             "field",   "touch",        "cost"};
  return Names.at(static_cast<std::size_t>(step));
}

StudyStamps StampFiles(const StudyState& state)
{
  return {StampOf(state.VolumeFile), StampOf(state.SegmentationFile)};
}

std::vector<StudyNode> PlanStudy(const StudyState& state, const StudyStamps& stamps,
                                 const StudyLookup& lookup)
{
  std::vector<StudyNode> nodes;
  if (!state.VolumeFile.empty())
  {
    nodes.push_back(VolumeNode(state, stamps.Volume));
  }
  if (state.SegmentationFile.empty())
  {
    return nodes;
  }
  nodes.push_back(SegmentationNode(state, stamps.Segmentation));
  const std::string segmentation = nodes.back().Key;
  for (const StudyStructure& structure : state.Structures)
  {
    if (structure.IsVisible || structure.IsTouchable)
    {
      StructurePlan(state, structure, segmentation, lookup, nodes).Add();
    }
  }
  return nodes;
}
} // namespace palpate
