#include "FieldRepresentation.h"

#include "SceneLabels.h"
#include "StructurePlan.h"

namespace palpate
{
namespace
{
// A drilled structure also keeps the image that it was made from.
SceneProduct MakeContact(const SceneStructure& structure, const StructurePlan::Inputs& inputs)
{
  const auto field = ProductAs<ScalarField>(inputs.data());
  TouchContact contact = MakeFieldContact(field, 0, structure.File);
  if (inputs.size() > 1)
  {
    contact.Drilled.Field = field;
    if (const auto read = ProductAs<Segmentation>(&inputs[1]))
    {
      const Segment& segment = SegmentOf(structure, *read);
      contact.Drilled.Image = read->Layers[static_cast<std::size_t>(segment.Layer)];
      contact.Drilled.Label = segment.Value;
    }
    else
    {
      contact.Drilled.Image = ProductAs<Volume>(&inputs[1])->Image;
    }
  }
  return std::make_shared<const TouchContact>(std::move(contact));
}

std::vector<ContactSetting> Vary(const ContactSetting& standard, const TouchToolSettings& tool,
                                 int /*highestDegree*/)
{
  constexpr int FinePoints = 98; // of a tool
  std::vector<ContactSetting> settings{standard};
  for (const FieldInterpolation interpolation :
       {FieldInterpolation::Trilinear, FieldInterpolation::TricubicBSpline})
  {
    settings.push_back(standard);
    settings.back().Structure.Interpolation = interpolation;
  }
  const bool isPoint = tool.Kind == TouchToolSettings::Shape::Sphere && tool.Radius == 0.0;
  if (!isPoint)
  {
    for (const int points : {6, 26, FinePoints, 200})
    {
      settings.push_back(standard);
      settings.back().ToolPoints = points;
    }
    // A more accurate field is noticeable only with a finer tool.
    settings.push_back(standard);
    settings.back().Structure.Interpolation = FieldInterpolation::TricubicBSpline;
    settings.back().ToolPoints = FinePoints;
  }
  return Unique(settings);
}

bool IsLinear(const ContactSetting& setting)
{
  return setting.Structure.Interpolation == FieldInterpolation::Trilinear;
}
} // namespace

void PlanFieldContact(StructurePlan& plan)
{
  plan.AddContact(
      "field", plan.AddField(),
      [structure = plan.Settings()](const StructurePlan::Inputs& inputs, const ProgressFunction&)
      { return MakeContact(structure, inputs); });
}

SceneRepresentation FieldRepresentation()
{
  SceneRepresentation field;
  field.Name = field.Label = TouchRepresentation::SubVoxel;
  field.Sources = {SceneSource::Label, SceneSource::IsoValue};
  field.CanBeDrilled = true;
  field.Appearance = SceneAppearance::SubVoxel;
  field.PlanContact = PlanFieldContact;
  field.Describe = [](const ContactSetting& setting)
  {
    return std::string("sub-voxel, ") + (IsLinear(setting) ? "trilinear, " : "tricubic, ") +
           (setting.ToolPoints > 0 ? std::to_string(setting.ToolPoints) : "enough") +
           " tool points";
  };
  field.KeyOf = [](const ContactSetting& setting)
  {
    return std::string("sub-voxel/") + (IsLinear(setting) ? "linear/" : "cubic/") +
           std::to_string(setting.ToolPoints);
  };
  field.Vary = Vary;
  return field;
}
} // namespace palpate
