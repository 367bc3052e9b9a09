#include "InfoReport.h"

#include "DecimalText.h"
#include "JsonSchema.h"
#include "ScreenText.h"
#include "TextTable.h"

#include "vtkMatrix3x3.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

namespace palpate
{
namespace
{
using nlohmann::json;

constexpr std::size_t LongestName = 40; // leaves space for the numbers

const std::vector<std::string>& NotesOf(const ImageContent& content)
{
  return content.Labels ? content.Labels->Notes : content.Image->Notes;
}

// The image with the geometry, the file's type and range.
vtkImageData* ImageOf(const ImageContent& content)
{
  return content.Image ? content.Image->Image : content.Labels->Layers.front();
}

std::string Joined(const double* values, int count, const char* separator)
{
  std::ostringstream text;
  for (int i = 0; i < count; ++i)
  {
    // Rounding gives many directions and origins a negative zero.
    text << (i == 0 ? "" : separator) << (values[i] == 0.0 ? 0.0 : values[i]);
  }
  return text.str();
}

std::string AxisText(vtkImageData* image, int axis)
{
  const vtkMatrix3x3* direction = image->GetDirectionMatrix();
  const double column[3] = {direction->GetElement(0, axis), direction->GetElement(1, axis),
                            direction->GetElement(2, axis)};
  return "(" + Joined(column, 3, ", ") + ")";
}

// Integers as they are, others in the precision of the file: 0.9999999 is not shown as 1.
std::string ValueText(vtkImageData* image, double value)
{
  switch (image->GetScalarType())
  {
  case VTK_FLOAT:
    return ExactText(static_cast<float>(value));
  case VTK_DOUBLE:
    return ExactText(value);
  default:
    return std::to_string(std::llround(value));
  }
}

TextTable GeometryTable(const ImageContent& content)
{
  vtkImageData* image = ImageOf(content);
  const int* size = image->GetDimensions();
  const double* range = image->GetScalarRange();
  TextTable table;
  table.AddRow(
      {"  holds", Printable(content.Kind +
                            (content.KindReason.empty() ? "" : " (" + content.KindReason + ")"))});
  table.AddRow({"  size", std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
                              std::to_string(size[2]) + " voxels"});
  table.AddRow({"  spacing", Joined(image->GetSpacing(), 3, " x ") + " mm"});
  table.AddRow({"  origin", "(" + Joined(image->GetOrigin(), 3, ", ") + ") mm, patient LPS"});
  table.AddRow({"  axes", AxisText(image, 0) + " " + AxisText(image, 1) + " " + AxisText(image, 2) +
                              " in patient LPS"});
  table.AddRow({"  values", std::string(image->GetScalarTypeAsString()) + ", " +
                                ValueText(image, range[0]) + " to " + ValueText(image, range[1])});
  return table;
}

TextTable TableOfLabels(const Segmentation& segmentation,
                        const std::vector<LabelStatistics>& labels)
{
  const bool layered = segmentation.Layers.size() > 1;
  TextTable table;
  table.AddRow({"  label", "name", layered ? "layer" : "", "voxels", "ml", "border", "components",
                "cavities", "cavity ml"});
  table.AlignRight({0, 2, 3, 4, 6, 7, 8});
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    const Segment& segment = segmentation.Segments[i];
    const LabelStatistics& statistics = labels[i];
    table.AddRow({std::to_string(segment.Label), Shortened(Printable(segment.Name), LongestName),
                  layered ? std::to_string(segment.Layer) : "", std::to_string(statistics.Voxels),
                  FixedText(statistics.Milliliters, 3),
                  statistics.TouchesBorder() ? statistics.FacesText() : "-",
                  std::to_string(statistics.ComponentVoxels.size()),
                  std::to_string(statistics.CavityVoxels.size()),
                  FixedText(statistics.CavityMilliliters, 3)});
  }
  return table;
}

json GeometryJson(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  const double* spacing = image->GetSpacing();
  const double* origin = image->GetOrigin();
  json axes = json::array();
  for (int axis = 0; axis < 3; ++axis)
  {
    const vtkMatrix3x3* direction = image->GetDirectionMatrix();
    axes.push_back({direction->GetElement(0, axis), direction->GetElement(1, axis),
                    direction->GetElement(2, axis)});
  }
  return {{"frame", "patient LPS"},
          {"size", {size[0], size[1], size[2]}},
          {"spacing_mm", {spacing[0], spacing[1], spacing[2]}},
          {"origin_mm", {origin[0], origin[1], origin[2]}},
          {"axes", axes}};
}

json LabelJson(const Segment& segment, const LabelStatistics& statistics)
{
  return {{"label", segment.Label},
          {"name", segment.Name},
          {"value", segment.Value},
          {"layer", segment.Layer},
          {"color", segment.Color},
          {"voxels", statistics.Voxels},
          {"ml", statistics.Milliliters},
          {"bounds_index", statistics.BoundsIndex},
          {"touches_border", statistics.TouchesBorder()},
          {"border_faces", statistics.FacesText()},
          {"component_voxels", statistics.ComponentVoxels},
          {"cavity_voxels", statistics.CavityVoxels},
          {"cavity_ml", statistics.CavityMilliliters}};
}

// Names may come from files that are not UTF-8.
std::string OneLine(const json& object)
{
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}
} // namespace

std::string InfoReport::Text() const
{
  std::string text = Printable(this->Input) + '\n' + GeometryTable(this->Content).Text();
  for (const std::string& note : NotesOf(this->Content))
  {
    text += "  note: " + Printable(note) + '\n';
  }
  if (this->Content.Labels)
  {
    text += TableOfLabels(*this->Content.Labels, this->Labels).Text();
  }
  return text + '\n';
}

std::string InfoReport::Json() const
{
  vtkImageData* image = ImageOf(this->Content);
  const double* range = image->GetScalarRange();
  json object{{JsonSchemaKey, JsonSchemaVersion},
              {"input", this->Input},
              {"status", "ok"},
              {"kind", this->Content.Kind},
              {"kind_reason", this->Content.KindReason},
              {"geometry", GeometryJson(image)},
              {"type", image->GetScalarTypeAsString()},
              {"range", {range[0], range[1]}},
              {"notes", NotesOf(this->Content)}};
  if (this->Content.Labels)
  {
    object["layers"] = this->Content.Labels->Layers.size();
    object["labels"] = json::array();
    for (std::size_t i = 0; i < this->Labels.size(); ++i)
    {
      object["labels"].push_back(LabelJson(this->Content.Labels->Segments[i], this->Labels[i]));
    }
  }
  return OneLine(object);
}

std::string InfoReport::FailureJson(const std::string& input, const std::string& status,
                                    const std::string& message)
{
  return OneLine({{JsonSchemaKey, JsonSchemaVersion},
                  {"input", input},
                  {"status", status},
                  {"message", message}});
}
} // namespace palpate
