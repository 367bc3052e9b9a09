#include "StudyPlan.h"

#include "CaseText.h"
#include "FilterRun.h"
#include "InputError.h"
#include "SceneField.h"
#include "SteadyClock.h"
#include "TouchStandIns.h"

#include <algorithm>
#include <array>
#include <sstream>

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

StudyProduct WithStandIns(TouchContact contact, const ProgressFunction& progress)
{
  AddStandIns(contact, progress);
  return std::make_shared<const TouchContact>(std::move(contact));
}

// The tool that a product is made with: its surface is the second input, where it has one.
TouchToolSettings ToolWith(const Inputs& inputs, TouchToolSettings settings)
{
  settings.Surface = inputs.size() > 1 ? ProductAs<SurfaceTool>(&inputs[1]) : nullptr;
  return settings;
}

// "prostate: touched by its sub-voxel field, because it is not star-shaped: ..."
std::string AdviceOf(const StudyStructure& structure, const std::string& instead,
                     const std::string& reason)
{
  const bool isPredicate = reason.rfind("is ", 0) == 0 || reason.rfind("has ", 0) == 0;
  return TitleOf(structure) + ": " + instead + ", because " + (isPredicate ? "it " : "") + reason;
}

// The nodes of one structure.
class StructurePlan
{
public:
  // `tool` is the key of the tool's surface, empty where that is not from a file.
  StructurePlan(const StudyState& state, const StudyStructure& structure, std::string segmentation,
                std::string tool, const StudyLookup& lookup, std::vector<StudyNode>& nodes)
      : State(state), Structure(structure), Fit(state.Fit),
        SegmentationKey(std::move(segmentation)), ToolKey(std::move(tool)), Lookup(lookup),
        Nodes(nodes), First(nodes.size())
  {
    const auto trade =
        this->IsMeasured() ? ProductAs<StudyTrade>(lookup(this->TradeKey())) : nullptr;
    this->Feel = FeelOf(state, structure, trade.get());
    if (structure.IsDrilled())
    {
      this->Feel.Representation = TouchRepresentation::SubVoxel;
      this->Feel.Interpolation = FieldInterpolation::Trilinear;
    }
    this->Fit.Degree = this->Feel.Degree;
  }

  void Add()
  {
    const bool isSeenAsTouched =
        this->Structure.IsVisible && this->Structure.Appearance == StudyAppearance::Automatic;
    if (this->Structure.IsTouchable || isSeenAsTouched)
    {
      this->AddRepresentation();
    }
    if (this->Structure.IsVisible)
    {
      this->AddAppearance();
    }
  }

  std::string FieldKey() const
  {
    return KeyOf(this->SegmentationKey, "field", this->Structure.Label,
                 static_cast<int>(this->Feel.Interpolation), this->State.FieldSmoothing,
                 this->Structure.IsDrilled() ? "inside" : "");
  }

  // What the dial goes by. Nothing else is held up by it.
  void AddTrade()
  {
    if (!this->IsMeasured())
    {
      return;
    }
    this->AddNode(StudyStep::Trade, this->TradeKey(), this->WithToolKey(this->SegmentationKey),
                  [label = this->Structure.Label, settings = this->State.Tool,
                   smoothing = this->State.FieldSmoothing](const Inputs& inputs,
                                                           const ProgressFunction& progress)
                  {
                    const auto segmentation = ProductAs<Segmentation>(inputs.data());
                    const Segment& segment = segmentation->Find(std::to_string(label));
                    // Not by the state's name, which the key has not.
                    TradeSource source{segment.Name.empty() ? "label " + std::to_string(label)
                                                            : segment.Name,
                                       segmentation->Source,
                                       {},
                                       smoothing};
                    source.Is = TradeSource::Mask{segmentation, segment};
                    const SteadyClock clock;
                    return std::make_shared<const StudyTrade>(
                        MeasureStudyTrade(source, ToolWith(inputs, settings), clock, progress));
                  });
  }

private:
  using Making = decltype(StudyNode::Make);

  bool IsMeasured() const
  {
    return this->Structure.IsTouchable && this->State.Dial != StudyDial::ByHand;
  }

  std::string TradeKey() const
  {
    return this->KeyWithTool(
        KeyOf(this->SegmentationKey, "trade", this->Structure.Label, this->State.FieldSmoothing));
  }

  std::string KeyWithTool(const std::string& start) const
  {
    const TouchToolSettings& tool = this->State.Tool;
    const Vector3& axes = tool.SemiAxes;
    return KeyOf(start, static_cast<int>(tool.Kind), tool.Radius, tool.Length, axes.x(), axes.y(),
                 axes.z(), tool.Points, this->ToolKey);
  }

  // Inputs of what is made with the tool.
  std::vector<std::string> WithToolKey(const std::string& input) const
  {
    return this->ToolKey.empty() ? std::vector<std::string>{input}
                                 : std::vector<std::string>{input, this->ToolKey};
  }

  void AddRepresentation()
  {
    switch (this->Feel.Representation)
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

  // What is to be seen and may not be what is touched.
  void AddAppearance()
  {
    switch (this->Structure.Appearance)
    {
    case StudyAppearance::Automatic:
      break;
    case StudyAppearance::Model:
    case StudyAppearance::ErrorMap:
      this->AddModel();
      break;
    case StudyAppearance::Surface:
      this->AddSurface();
      break;
    case StudyAppearance::SubVoxel:
      this->AddField();
      break;
    }
  }

  // Once, whatever it is wanted for. What is asked for again is asked for by name: then nothing
  // does its work.
  std::string AddNode(StudyStep step, const std::string& key, const std::string& input, Making make)
  {
    return this->AddNode(step, key, std::vector<std::string>{input}, std::move(make));
  }
  std::string AddNode(StudyStep step, const std::string& key, std::vector<std::string> inputs,
                      Making make)
  {
    const auto own = this->Nodes.begin() + static_cast<std::ptrdiff_t>(this->First);
    const auto there = std::find_if(own, this->Nodes.end(),
                                    [&key](const StudyNode& node) { return node.Key == key; });
    if (there != this->Nodes.end() && !key.empty())
    {
      there->Advice.clear();
      return key;
    }
    this->Nodes.push_back(
        {step, this->Structure.Label, key, std::move(inputs), {}, {}, std::move(make)});
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
              fit.IsRobust, fit.MinimumDice);
    return this->AddNode(StudyStep::Model, key, samples,
                         [fit](const Inputs& inputs, const ProgressFunction& progress)
                         {
                           return std::make_shared<const FitResult>(
                               MakeFitModel(*ProductAs<FitSamples>(inputs.data()), fit, progress));
                         });
  }

  std::string AddField()
  {
    return this->AddNode(
        StudyStep::Field, this->FieldKey(), this->SegmentationKey,
        [label = this->Structure.Label,
         form = FieldForm(this->Feel.Interpolation, BrickSize::Cells8, this->Structure.IsDrilled()),
         smoothing = this->State.FieldSmoothing](const Inputs& inputs,
                                                 const ProgressFunction& progress) -> StudyProduct
        {
          const auto segmentation = ProductAs<Segmentation>(inputs.data());
          const Segment& segment = segmentation->Find(std::to_string(label));
          try
          {
            return MakeSegmentField(*segmentation, {segment}, form, smoothing, progress);
          }
          catch (const FilterError& error)
          {
            throw InputError(CaseSentence(segmentation->Source, segment, error.what()));
          }
        });
  }

  // Why a node of this structure has failed; empty where it has not, or not yet.
  std::string ReasonAt(std::size_t node) const
  {
    const StudyProduct* product = this->Lookup(this->Nodes[node].Key);
    return product != nullptr ? ReasonOf(*product) : std::string();
  }

  // By harmonics, and by something else once any stage of those has failed.
  void AddAutomatic()
  {
    const std::string model = this->AddModel();
    const std::size_t last = this->Nodes.size();
    std::string reason;
    for (std::size_t n = this->First; n < last && reason.empty(); ++n)
    {
      reason = this->ReasonAt(n);
    }
    if (reason.empty())
    {
      this->AddContact(model, this->ContactOfModel(), this->Lookup(model) != nullptr);
      return;
    }
    const bool hasSurface = this->ReasonAt(this->First).empty();
    const bool isTouched = this->Structure.IsTouchable;
    std::string instead = "shown by the surface of its mask";
    std::string replacement = this->Nodes[this->First].Key;
    if (isTouched || !hasSurface)
    {
      replacement = this->AddField();
      this->AddContact(replacement, this->ContactOfField());
      instead = isTouched ? "touched by its sub-voxel field" : "shown by its sub-voxel field";
    }
    this->Advise(last, AdviceOf(this->Structure, instead, reason), replacement);
  }

  // Unless what is to do the work of the nodes up to `last` fails too.
  void Advise(std::size_t last, const std::string& advice, const std::string& replacement)
  {
    const StudyProduct* product = this->Lookup(replacement);
    if (product == nullptr || FailureOf(*product).empty())
    {
      for (std::size_t n = this->First; n < last; ++n)
      {
        this->Nodes[n].Advice = advice;
        this->Nodes[n].Replacement = replacement;
      }
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
    const std::string key = this->KeyWithTool(KeyOf(contact, "cost"));
    this->AddNode(
        StudyStep::Cost, contact.empty() ? std::string() : key, this->WithToolKey(contact),
        [settings = this->State.Tool](const Inputs& inputs, const ProgressFunction& progress)
        {
          const SteadyClock clock;
          return std::make_shared<const TouchCost>(
              MeasureTouchCost(*ProductAs<TouchContact>(inputs.data()), ToolWith(inputs, settings),
                               clock, progress));
        });
  }

  Making ContactOfModel() const
  {
    return [](const Inputs& inputs, const ProgressFunction& progress) -> StudyProduct
    {
      const auto fit = ProductAs<FitResult>(inputs.data());
      return WithStandIns(MakeHarmonicContact(fit->Model, HarmonicContactMode::Nearest,
                                              EvaluationPrecision::Double, fit->Input),
                          progress);
    };
  }

  Making ContactOfSurface() const
  {
    return [](const Inputs& inputs, const ProgressFunction& progress) -> StudyProduct
    {
      const FitResult& found = ProductAs<FitSurface>(inputs.data())->Found;
      auto own = vtkSmartPointer<vtkPolyData>::New();
      own->ShallowCopy(found.Surface);
      return WithStandIns(MakeFacetContact(own, found.Input), progress);
    };
  }

  Making ContactOfField() const
  {
    return [isDrilled = this->Structure.IsDrilled(), file = this->State.SegmentationFile](
               const Inputs& inputs, const ProgressFunction&) -> StudyProduct
    {
      TouchContact contact = MakeFieldContact(ProductAs<ScalarField>(inputs.data()), 0, file);
      contact.IsDrillable = isDrilled;
      return std::make_shared<const TouchContact>(std::move(contact));
    };
  }

  const StudyState& State;
  const StudyStructure& Structure;
  FitSettings Fit;
  StudyFeel Feel;
  std::string SegmentationKey;
  std::string ToolKey;
  const StudyLookup& Lookup;
  std::vector<StudyNode>& Nodes;
  std::size_t First; ///< of the structure's own nodes
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
          {},
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
          {},
          {},
          make};
}

// Empty, with no node, where the tool's shape is not from a file.
std::string AddTool(const StudyState& state, const std::string& stamp,
                    std::vector<StudyNode>& nodes)
{
  if (state.Tool.Kind != TouchToolSettings::Shape::Surface)
  {
    return {};
  }
  const bool cuts = std::any_of(state.Structures.begin(), state.Structures.end(),
                                [](const StudyStructure& one) { return one.IsDrilled(); });
  const int points = ShellPointsOf(state.Tool);
  const std::string key = KeyOf("tool", state.Tool.File, stamp, points, cuts);
  const auto make =
      [file = state.Tool.File, points, cuts](const Inputs&, const ProgressFunction& progress)
  { return ReadUnlessCancelled([&] { return SurfaceTool::Read(file, points, cuts); }, progress); };
  nodes.push_back({StudyStep::Tool, 0, key, {}, {}, {}, make});
  return key;
}

// Of a forbidden structure from the drill, in the fields of these keys: those that cannot be made
// are not drilled.
StudyNode ProtectionNode(const StudyStructure& structure, const std::string& segmentation,
                         const std::vector<std::string>& fields, const StudyLookup& lookup)
{
  std::vector<std::string> inputs{segmentation};
  std::string key = KeyOf(segmentation, "protection", structure.Label);
  for (const std::string& field : fields)
  {
    const StudyProduct* product = lookup(field);
    if (product == nullptr || FailureOf(*product).empty())
    {
      inputs.push_back(field);
      key = KeyOf(key, field);
    }
  }
  const auto make = [label = structure.Label](const Inputs& made, const ProgressFunction& progress)
  {
    std::vector<std::shared_ptr<const ScalarField>> drilled;
    for (std::size_t n = 1; n < made.size(); ++n)
    {
      drilled.push_back(ProductAs<ScalarField>(&made[n]));
    }
    return std::make_shared<const StudyProtection>(
        MakeStudyProtection(*ProductAs<Segmentation>(made.data()), label, drilled, progress));
  };
  return {StudyStep::Protection, structure.Label, key, std::move(inputs), {}, {}, make};
}
} // namespace

const char* NameOf(StudyStep step)
{
  constexpr std::array<const char*, 12> Names{"volume",  "segmentation", "structures", "surface",
                                              "samples", "model",        "field",      "protection",
                                              "touch",   "cost",         "trade",      "tool"};
  return Names.at(static_cast<std::size_t>(step));
}

std::vector<StudyNode> PlanStudy(const StudyState& state, const StudyStamps& stamps,
                                 const StudyLookup& lookup)
{
  std::vector<StudyNode> nodes;
  if (!state.VolumeFile.empty())
  {
    nodes.push_back(VolumeNode(state, stamps.Volume));
  }
  const std::string tool = AddTool(state, stamps.Tool, nodes);
  if (state.SegmentationFile.empty())
  {
    return nodes;
  }
  nodes.push_back(SegmentationNode(state, stamps.Segmentation));
  const std::string segmentation = nodes.back().Key;
  std::vector<std::string> drilled;
  for (const StudyStructure& structure : state.Structures)
  {
    if (structure.IsVisible || structure.IsTouchable)
    {
      StructurePlan plan(state, structure, segmentation, tool, lookup, nodes);
      plan.Add();
      if (structure.IsDrilled())
      {
        drilled.push_back(plan.FieldKey());
      }
    }
  }
  for (const StudyStructure& structure : state.Structures)
  {
    if (structure.IsForbidden)
    {
      nodes.push_back(ProtectionNode(structure, segmentation, drilled, lookup));
    }
  }
  // Last: what is to be seen and felt comes before what is to be known of it.
  for (const StudyStructure& structure : state.Structures)
  {
    StructurePlan(state, structure, segmentation, tool, lookup, nodes).AddTrade();
  }
  return nodes;
}
} // namespace palpate
